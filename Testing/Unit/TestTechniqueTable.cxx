#include "Techniques/TechniqueTable.h"

#include <gtest/gtest.h>

#include <set>

using namespace volumebench;

TEST(TechniqueTable, ListsSinglePassUnderItsContractNames)
{
  const TechniqueRow* row = FindTechnique("single-pass");
  ASSERT_NE(row, nullptr);
  EXPECT_STREQ(row->Label, "Volume Single Pass");
  EXPECT_EQ(FindTechnique("Volume Single Pass"), nullptr);
}

TEST(TechniqueTable, EveryRowCreatesATechniqueOfItsOwnName)
{
  std::set<std::string> ids;
  std::set<std::string> labels;
  for (const TechniqueRow& row : TechniqueTable())
  {
    EXPECT_NE(row.Create(), nullptr) << row.Id;
    EXPECT_NE(TechniqueIds().find(row.Id), std::string::npos);
    ids.insert(row.Id);
    labels.insert(row.Label);
  }
  EXPECT_EQ(ids.size(), TechniqueTable().size());
  EXPECT_EQ(labels.size(), TechniqueTable().size());
}

// What a build leaves out is tried by the Recipe test, whose build has no CUDA.
TEST(TechniqueTable, UnknownIdsAreAnsweredByThoseThereAre)
{
  const std::string message = WhyNoTechnique("abacus", ", and peers");
  EXPECT_EQ(message, "there is no technique 'abacus'; known are " + TechniqueIds() + ", and peers");
}
