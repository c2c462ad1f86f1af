// Which techniques the image tests are run for: those that this machine can run.
#include "EveryTechnique.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
std::vector<std::string> TechniquesOfThisBuild()
{
  std::vector<std::string> ids;
  for (const TechniqueRow& row : TechniqueTable())
  {
    ids.emplace_back(row.Id);
  }
  return ids;
}
}

class TechniquesHere : public ::testing::TestWithParam<std::string>
{
};

TEST_P(TechniquesHere, AreRunByTheImageTests)
{
  const std::string reason = WhyNotHere(GetParam());
  if (!reason.empty())
  {
    GTEST_SKIP() << "not run for technique " << GetParam() << ": " << reason;
  }
  const std::vector<std::string> run = AllTechniques();
  EXPECT_EQ(std::count(run.begin(), run.end(), GetParam()), 1);
}

// What cannot run draws nothing and says why in one line, and the mapper goes on with others.
TEST_P(TechniquesHere, OrSayWhyNot)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  scene.Mapper->GlobalWarningDisplayOff();
  const FloatPicture picture = scene.Picture();
  const std::string reason = WhyNotHere(GetParam());
  EXPECT_EQ(scene.Mapper->GetUnsupported(), !reason.empty());
  const std::string said = "technique '" + GetParam() + "' cannot run here: " + reason;
  EXPECT_EQ(scene.Mapper->GetFailure(), reason.empty() ? "" : said);
  EXPECT_EQ(PixelAt(picture, 32, 32).Alpha > 0.1, reason.empty());
  scene.Mapper->SetTechnique("single-pass");
  EXPECT_GT(PixelAt(scene.Picture(), 32, 32).Alpha, 0.1);
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  scene.Mapper->GlobalWarningDisplayOn();
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, TechniquesHere, ::testing::ValuesIn(TechniquesOfThisBuild()), TestNameOf);
