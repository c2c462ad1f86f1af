#include "VoxelOrder/TurnPolicy.h"
#include "VoxelOrder/ViewClass.h"

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace volumebench;

namespace
{
using Path = std::vector<glm::dvec3>;

glm::dvec3 ForwardAt(double degrees, double elevation = 0.0)
{
  return { std::sin(glm::radians(degrees)), std::tan(glm::radians(elevation)),
    std::cos(glm::radians(degrees)) };
}

int TurnsOfPolicy(const Path& path)
{
  TurnPolicy policy;
  return static_cast<int>(std::count_if(
    path.begin(), path.end(), [&](const glm::dvec3& view) { return policy.TurnsFor(view); }));
}

int TurnsOfPaper(const Path& path)
{
  bool turned = false;
  int turns = 0;
  for (const glm::dvec3& view : path)
  {
    turns += IsUnfavourable(view) != turned;
    turned = IsUnfavourable(view);
  }
  return turns;
}

// What losses and turns cost on a path, in frames.
double CostOfPolicy(const Path& path, const TurnPrices& prices)
{
  TurnPolicy policy(prices);
  double cost = 0.0;
  for (const glm::dvec3& view : path)
  {
    cost += policy.TurnsFor(view) ? prices.TurnFrames : 0.0;
    cost += std::max(policy.LossOf(view, policy.GetQuarterTurns()), 0.0);
  }
  return cost;
}

// The least that they can cost for one who knows the whole path.
double LeastCost(const Path& path, const TurnPrices& prices)
{
  const TurnPolicy policy(prices);
  double cost[2] = { 0.0, prices.TurnFrames };
  for (const glm::dvec3& view : path)
  {
    for (const int turns : { 0, 1 })
    {
      cost[turns] += std::max(policy.LossOf(view, turns), 0.0);
    }
    const double stay[2] = { cost[0], cost[1] };
    cost[0] = std::min(stay[0], stay[1] + prices.TurnFrames);
    cost[1] = std::min(stay[1], stay[0] + prices.TurnFrames);
  }
  return std::min(cost[0], cost[1]);
}

Path RandomPath(unsigned int seed, double mostDegreesPerFrame)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> change(-1.0, 1.0);
  Path path;
  double degrees = 180.0 * change(random);
  for (int frame = 0; frame < 2000; ++frame)
  {
    degrees += mostDegreesPerFrame * change(random);
    path.push_back(ForwardAt(degrees));
  }
  return path;
}
}

TEST(TurnPolicy, TurnsAtMostOnceWhereThePaperTurnsEveryFrame)
{
  for (const double swing : { 0.5, 3.0, 8.0, 20.0 })
  {
    for (const double corner : { 45.0, 135.0, 225.0, 315.0 })
    {
      Path path;
      for (int frame = 0; frame < 400; ++frame)
      {
        path.push_back(ForwardAt(corner + (frame % 2 == 0 ? swing : -swing)));
      }
      EXPECT_GE(TurnsOfPaper(path), 399) << corner;
      EXPECT_LE(TurnsOfPolicy(path), 1) << corner << " +- " << swing;
    }
  }
}

// A turn round the volume by degrees: four changes, as the paper has them, and none missed.
TEST(TurnPolicy, TurnsAsOftenAsThePaperOnAnOrbit)
{
  Path path;
  for (int degrees = 0; degrees < 360; ++degrees)
  {
    path.push_back(ForwardAt(degrees));
  }
  EXPECT_EQ(TurnsOfPaper(path), 4);
  EXPECT_EQ(TurnsOfPolicy(path), 4);
}

TEST(TurnPolicy, TurnsSoonForAViewStraightAlongX)
{
  TurnPolicy policy;
  int frames = 1;
  while (!policy.TurnsFor({ 1.0, 0.0, 0.0 }))
  {
    ASSERT_LT(++frames, 10);
  }
  EXPECT_EQ(frames, 2); // twice the price of a turn, which is one frame
  EXPECT_EQ(policy.GetQuarterTurns(), 1);
  for (int frame = 0; frame < 100; ++frame)
  {
    EXPECT_FALSE(policy.TurnsFor({ 1.0, 0.0, 0.0 }));
  }
}

// A view along y gains nothing by a turn, and its angle about y means nothing.
TEST(TurnPolicy, LeavesAloneWhatLooksAlongY)
{
  Path path;
  for (int frame = 0; frame < 1000; ++frame)
  {
    path.push_back(ForwardAt(37.0 * frame, 89.99));
  }
  path.emplace_back(0.0, -1.0, 0.0);
  EXPECT_GT(TurnsOfPaper(path), 100);
  EXPECT_EQ(TurnsOfPolicy(path), 0);
}

// The bound of Borodin, Linial & Saks for two states, up to what the beginning adds.
TEST(TurnPolicy, CostsAtMostThreeTimesWhatTheFutureWouldHaveSaved)
{
  for (const double price : { 0.3, 1.0, 7.0 })
  {
    for (const double speed : { 2.0, 15.0, 90.0 })
    {
      for (unsigned int seed = 0; seed < 20; ++seed)
      {
        const TurnPrices prices{ price, 1.0, 5.0 };
        const Path path = RandomPath(seed, speed);
        EXPECT_LE(CostOfPolicy(path, prices),
          3.0 * LeastCost(path, prices) + 3.0 * price + 2.0 * prices.MostLost)
          << "price " << price << ", degrees per frame " << speed << ", seed " << seed;
      }
    }
  }
}

TEST(TurnPolicy, BeginsAnewAfterAReset)
{
  TurnPolicy policy;
  EXPECT_FALSE(policy.TurnsFor({ 1.0, 0.0, 0.0 }));
  policy.Reset();
  EXPECT_FALSE(policy.TurnsFor({ 1.0, 0.0, 0.0 }));
  EXPECT_TRUE(policy.TurnsFor({ 1.0, 0.0, 0.0 }));
  policy.Reset();
  EXPECT_EQ(policy.GetQuarterTurns(), 0);
}
