#include "Scene/CellMap.h"

#include "EngineScene.h"
#include "Scene/CellDistances.h"
#include "Scene/Majorant.h"
#include "Scene/PrefixTable.h"

#include <gtest/gtest.h>

#include <random>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
vtkSmartPointer<vtkVolumeProperty> PropertyWithPeak(double from, double to, double high)
{
  auto property = MakeConstantProperty(0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(from, 0.0);
  opacity->AddPoint(0.5 * (from + to), 0.5);
  opacity->AddPoint(to, 0.0);
  opacity->AddPoint(high, 0.0);
  property->SetScalarOpacity(opacity);
  return property;
}

Scene RampScene(vtkVolumeProperty* property)
{
  const auto image = MakeImage(
    33, 17, 17, [](double i, double, double) { return i / 32.0; }, VTK_FLOAT);
  return MakeEngineScene(image, property);
}

int DistanceByForce(
  const std::vector<CellKind>& kinds, const glm::ivec3& cells, const glm::ivec3& cell)
{
  const auto kindAt = [&](int x, int y, int z) { return kinds[x + cells.x * (y + cells.y * z)]; };
  int nearest = 255;
  for (int z = 0; z < cells.z; ++z)
  {
    for (int y = 0; y < cells.y; ++y)
    {
      for (int x = 0; x < cells.x; ++x)
      {
        if (kindAt(x, y, z) != kindAt(cell.x, cell.y, cell.z))
        {
          nearest = std::min(nearest,
            std::max({ std::abs(x - cell.x), std::abs(y - cell.y), std::abs(z - cell.z) }));
        }
      }
    }
  }
  return nearest;
}
}

TEST(CellMap, DistancesAreThoseOfAllPairs)
{
  std::mt19937 generator(7);
  for (const glm::ivec3 cells :
    { glm::ivec3(13, 9, 7), glm::ivec3(40, 3, 2), glm::ivec3(1, 31, 1), glm::ivec3(2, 1, 33) })
  {
    for (const double share : { 0.0, 0.002, 0.02, 0.3, 0.9, 1.0 })
    {
      std::vector<CellKind> kinds(cells.x * cells.y * cells.z);
      std::bernoulli_distribution occupied(share);
      for (CellKind& kind : kinds)
      {
        kind = occupied(generator) ? CellKind::Occupied : CellKind::Empty;
      }
      const std::vector<std::uint8_t> distances = DistancesToOtherKinds(kinds, cells);
      ASSERT_EQ(distances.size(), kinds.size());
      for (int i = 0; i < static_cast<int>(kinds.size()); ++i)
      {
        const glm::ivec3 cell(i % cells.x, (i / cells.x) % cells.y, i / (cells.x * cells.y));
        ASSERT_EQ(distances[i], DistanceByForce(kinds, cells, cell)) << "share " << share;
      }
    }
  }
}

TEST(CellMap, DistancesEndAtWhatAByteHolds)
{
  std::vector<CellKind> kinds(400, CellKind::Empty);
  kinds[0] = CellKind::Occupied;
  const std::vector<std::uint8_t> distances = DistancesToOtherKinds(kinds, { 400, 1, 1 });
  EXPECT_EQ(distances[1], 1);
  EXPECT_EQ(distances[254], 254);
  EXPECT_EQ(distances[399], 255);
}

TEST(CellMap, OccupiedBoxHoldsTheCellsThatShow)
{
  const auto property = PropertyWithPeak(0.55, 0.7, 1.0);
  Scene scene = RampScene(property);
  const CellMap map = MapOccupiedCells(BuildMacrocellGrid(scene.Volume, 4), scene);
  // Values from 0.55 to 0.7 lie between texels 17.6 and 22.4: cells 4 and 5 of 8.
  EXPECT_EQ(map.OccupiedLow, glm::dvec3(16.0 - 16.0, -8.0, -8.0));
  EXPECT_EQ(map.OccupiedHigh, glm::dvec3(24.0 - 16.0, 8.0, 8.0));
  EXPECT_DOUBLE_EQ(map.OccupiedShare, 2.0 / 8.0);
  EXPECT_EQ(map.Codes[0], 4) << "empty, four cells from an occupied one";
  EXPECT_EQ(map.Codes[4], 256 + 1);
  EXPECT_EQ(map.Codes[7], 2);
}

TEST(CellMap, NothingOccupiedIsNothing)
{
  Scene scene = RampScene(PropertyWithPeak(2.0, 3.0, 4.0));
  const CellMap map = MapOccupiedCells(BuildMacrocellGrid(scene.Volume, 8), scene);
  EXPECT_EQ(map.OccupiedShare, 0.0);
  EXPECT_EQ(map.OccupiedLow, map.OccupiedHigh);
}

TEST(CellMap, ExtremesBoundTheCells)
{
  Scene scene = RampScene(PropertyWithPeak(0.2, 0.4, 1.0));
  const MacrocellGrid grid = BuildMacrocellGrid(scene.Volume, 8);
  scene.Compositing.Mode = BlendMode::Maximum;
  const CellMap largest = MapExtremes(grid, scene);
  scene.Compositing.Mode = BlendMode::Minimum;
  const CellMap smallest = MapExtremes(grid, scene);
  for (std::size_t i = 0; i < grid.Ranges.size(); ++i)
  {
    EXPECT_GE(largest.Extremes[i], grid.Ranges[i].y);
    EXPECT_LE(largest.Extremes[i], grid.Ranges[i].y + 1e-5f);
    EXPECT_LE(smallest.Extremes[i], grid.Ranges[i].x);
    EXPECT_GE(smallest.Extremes[i], grid.Ranges[i].x - 1e-5f);
  }
}

TEST(Majorant, BoundsTheTableOverAnyRangeAndTightly)
{
  Scene scene = RampScene(PropertyWithPeak(0.3, 0.5, 1.0));
  const Majorant majorant(scene);
  const TransferFunction& function = scene.TransferFunction;
  const int last = static_cast<int>(function.Table.size()) - 1;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> any(-0.1, 1.1);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double a = any(generator);
    const double b = trial % 3 == 0 ? a : any(generator);
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    const auto entry = [&](double value, double shift)
    {
      const double data = value; // stored values of this scene are its data's
      const double place = (data - function.Low) / (function.High - function.Low) * last + shift;
      return std::clamp(static_cast<int>(std::floor(place)), 0, last);
    };
    float inside = 0.0f;
    float around = 0.0f;
    for (int i = entry(low, 1.0); i <= entry(high, 0.0); ++i)
    {
      inside = std::max(inside, function.Table[i].w);
    }
    for (int i = entry(low, -1.0); i <= entry(high, 2.0); ++i)
    {
      around = std::max(around, function.Table[i].w);
    }
    const float bound = majorant.Of(static_cast<float>(low), static_cast<float>(high));
    ASSERT_GE(bound, inside) << low << " " << high;
    ASSERT_LE(bound, around) << low << " " << high;
  }
}

TEST(Majorant, IsNoneOfAValueWhereTheFunctionBegins)
{
  Scene scene = RampScene(MakeLinearExtinctionProperty(0.3, 0.0, 1.0, 65));
  const Majorant majorant(scene);
  EXPECT_EQ(majorant.Of(0.0f, 0.0f), 0.0f) << "air has exactly the value that the ramp begins at";
  EXPECT_GT(majorant.Of(0.0f, 0.01f), 0.0f);
  EXPECT_EQ(majorant.Of(-1.0f, 0.0f), 0.0f);
  EXPECT_GT(majorant.Of(1.0f, 1.0f), 0.0f);
  EXPECT_GT(majorant.Of(1.5f, 2.0f), 0.0f) << "beyond the table goes on what its end has";
}

TEST(Majorant, SeesAPeakBetweenTwoEntriesOfTheTable)
{
  const double at = 0.5 + 0.4 / 4095.0;
  Scene scene = RampScene(PropertyWithPeak(at - 1e-6, at + 1e-6, 1.0));
  scene.TransferFunction = BuildTransferFunction(
    PropertyWithPeak(at - 1e-6, at + 1e-6, 1.0), scene.Volume.FiniteRange, { 16384, 512 });
  const Majorant blind(scene);
  EXPECT_EQ(blind.Of(0.49f, 0.51f), 0.0f) << "the table alone does not see it";
  BuildPrefixTable(scene.TransferFunction);
  const Majorant majorant(scene);
  EXPECT_GT(majorant.Of(0.49f, 0.51f), 0.0f);
  EXPECT_EQ(majorant.Of(0.0f, 0.49f), 0.0f);
  EXPECT_EQ(majorant.Of(0.51f, 1.0f), 0.0f);
}
