#include "KernelCompilers.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>

using namespace volumebench;

namespace
{
struct NamedFeatures
{
  std::string Name;
  FeatureSet Features;
};

// No feature, and if the entry has any each one alone and all of them.
std::vector<NamedFeatures> FeatureSetsToTry(const std::string& entry)
{
  std::vector<NamedFeatures> sets = { { "no feature", {} } };
  if (!HasFeatures(entry))
  {
    return sets;
  }
  for (const FeatureRow& row : FeatureTable())
  {
    FeatureSet alone;
    alone.set(static_cast<std::size_t>(row.Bit));
    sets.push_back({ row.Name, alone });
  }
  sets.push_back({ "all features", FeatureSet().set() });
  return sets;
}

std::string CaseName(const testing::TestParamInfo<std::string>& info)
{
  std::string name = info.param;
  for (char& c : name)
  {
    c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  }
  return name;
}

class Kernels : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    const std::string reason = WhyNotCompiled(this->GetParam());
    if (!reason.empty())
    {
      GTEST_SKIP() << reason;
    }
  }
};

class BrokenKernels : public Kernels
{
};
}

TEST_P(Kernels, CompileWithNoFeatureEachAndAll)
{
  for (const NamedFeatures& set : FeatureSetsToTry(this->GetParam()))
  {
    const KernelVerdict verdict = CompileKernel(this->GetParam(), set.Features);
    EXPECT_TRUE(verdict.Accepted) << this->GetParam() << " with " << set.Name << ":\n"
                                  << verdict.Log;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Kernels, testing::ValuesIn(KernelEntries()), CaseName);

// The fault is in an included file and behind a feature, so that this also shows that includes,
// features and line numbers reach the compiler.
TEST_P(BrokenKernels, AreRejectedByFileAndLine)
{
  FeatureSet crop;
  crop.set(static_cast<std::size_t>(Feature::Crop));
  const KernelVerdict without = CompileKernel(this->GetParam(), {});
  EXPECT_TRUE(without.Accepted) << without.Log;
  const KernelVerdict with = CompileKernel(this->GetParam(), crop);
  EXPECT_FALSE(with.Accepted);
  const std::regex place(R"re(Broken/Undeclared\.h[:(]6\b)re");
  EXPECT_TRUE(std::regex_search(with.Log, place)) << with.Log;
  EXPECT_NE(with.Log.find("notDeclared"), std::string::npos) << with.Log;
}

INSTANTIATE_TEST_SUITE_P(Every, BrokenKernels,
  testing::Values(
    "Broken/Broken.frag", "Broken/Broken.cl", "Broken/Broken.cu", "Broken/Broken.cxx"),
  CaseName);

TEST(KernelInstance, UndefinesEveryFeature)
{
  std::ifstream file(SOURCE_FOLDER "/Representations/Engine/Scene/KernelInstance.h");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  for (const FeatureRow& row : FeatureTable())
  {
    EXPECT_NE(text.find(std::string("#undef ") + row.Define + "\n"), std::string::npos)
      << row.Define << " would leak from one instance into the next";
  }
}
