// The table of bad input and faults: for each technique and row the expected picture or the one
// line that says why there is none, and then the good scene again in the same window.
#include "EveryTechnique.h"
#include "HostileSession.h"

#include <set>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
using Case = std::tuple<std::string, Enemy>;

std::string CaseName(const ::testing::TestParamInfo<Case>& info)
{
  std::string name = std::get<1>(info.param).Name + ("__" + std::get<0>(info.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Enemies AllEnemies()
{
  Enemies all;
  for (const Enemies& group : { EnemiesOfSettings(), EnemiesOfData(), EnemiesOfFunctions(),
         EnemiesOfViews(), EnemiesOfMachines() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

class Hostile : public ::testing::TestWithParam<Case>
{
};
}

TEST_P(Hostile, PictureOrOneLine)
{
  const auto& [technique, enemy] = GetParam();
  HostileSession& session = HostileSession::Of(technique);
  session.ArrangeGood();
  enemy.Do(session);
  const bool concerned =
    enemy.Only.empty() || std::count(enemy.Only.begin(), enemy.Only.end(), technique) > 0;
  session.Expect(concerned ? enemy.Expected : enemy.Others);
  session.ExpectGood();
}

TEST(HostileTable, IsLargeAndNamesEachRowOnce)
{
  const Enemies all = AllEnemies();
  EXPECT_GE(all.size(), 60u);
  std::set<std::string> names;
  for (const Enemy& enemy : all)
  {
    EXPECT_TRUE(names.insert(enemy.Name).second) << enemy.Name;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, Hostile,
  ::testing::Combine(::testing::ValuesIn(AllTechniques()), ::testing::ValuesIn(AllEnemies())),
  CaseName);
