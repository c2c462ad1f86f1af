// The table of stability cases, whom a case is meant for, and who is tried.
#include "Names.h"
#include "Stability/CaseTable.h"
#include "Stability/StabilityRun.h"
#include "Techniques/TechniqueTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace volumebench;

namespace
{
std::string ErrorOf(const StabilitySettings& settings)
{
  try
  {
    SubjectsOf(settings);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}
}

TEST(StabilityCases, AreNumberedWithoutGaps)
{
  const std::vector<StabilityCase>& cases = StabilityCases();
  ASSERT_GE(cases.size(), 40u);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    EXPECT_EQ(cases[i].Number, static_cast<int>(i) + 1);
    EXPECT_FALSE(cases[i].Title.empty());
    EXPECT_FALSE(cases[i].Expectation.empty());
    EXPECT_GT(cases[i].Limit, 0.0) << cases[i].Title;
    EXPECT_FALSE(cases[i].MeantFor.empty()) << "nobody has to pass " << cases[i].Title;
  }
  EXPECT_EQ(FindStabilityCase(8).Title, "Spikes");
  EXPECT_THROW(FindStabilityCase(0), std::runtime_error);
}

TEST(StabilityCases, AreMeantForIntegratorsAndNeverForPeers)
{
  const StabilityCase spikes = FindStabilityCase(8);
  EXPECT_TRUE(spikes.IsMeantFor({ "any", integrators::Segment, false }));
  EXPECT_FALSE(spikes.IsMeantFor({ "any", integrators::Left, false }));
  EXPECT_TRUE(spikes.IsMeantFor({ "any", NoIntegrator, false }));
  EXPECT_FALSE(spikes.IsMeantFor({ "vtk-gpu", NoIntegrator, true }));
}

TEST(StabilitySubjects, AreAllTechniquesIntegratorsAndPeersByDefault)
{
  const std::vector<Subject> subjects = SubjectsOf({});
  const auto peers = std::count_if(
    subjects.begin(), subjects.end(), [](const Subject& subject) { return subject.Peer; });
  EXPECT_EQ(peers, 2);
  for (const TechniqueRow& row : TechniqueTable())
  {
    EXPECT_TRUE(std::any_of(subjects.begin(), subjects.end(),
      [&row](const Subject& subject) { return subject.Technique == row.Id && !subject.Peer; }))
      << row.Id;
  }
}

TEST(StabilitySubjects, AreWhatIsAskedFor)
{
  StabilitySettings settings;
  settings.Techniques = { "slices", "reference", "vtk-gpu" };
  settings.Integrators = { integrators::Left, integrators::Midpoint };
  const std::vector<Subject> subjects = SubjectsOf(settings);
  ASSERT_EQ(subjects.size(), 4u);
  EXPECT_EQ(subjects[1].Integrator, integrators::Midpoint);
  EXPECT_EQ(subjects[2].Integrator, NoIntegrator);
  EXPECT_FALSE(subjects[2].Peer);
  EXPECT_TRUE(subjects[3].Peer);
}

TEST(StabilitySubjects, UnknownNamesAreTold)
{
  StabilitySettings settings;
  settings.Techniques = { "warp" };
  EXPECT_NE(ErrorOf(settings).find("'warp'"), std::string::npos);
  settings.Techniques = { "slices" };
  settings.Integrators = { 77 };
  EXPECT_NE(ErrorOf(settings).find("integrator 77"), std::string::npos);
}
