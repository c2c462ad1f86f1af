#include "Scene/HomogeneousCells.h"

#include "EngineScene.h"
#include "Scene/CellMap.h"
#include "Scene/Features.h"
#include "Scene/PrefixTable.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// From 0 to 1 along x.
double Ramp(double i, double, double)
{
  return i / 32.0;
}

// One value up to the middle, then a ramp to 1.
double Bent(double i, double, double)
{
  return 0.25 + 0.75 * std::max(0.0, i - 16.0) / 16.0;
}

vtkSmartPointer<vtkVolumeProperty> Function(
  const std::vector<std::pair<double, double>>& opacities, double firstRed = 1.0)
{
  auto property = MakeConstantProperty(0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [value, at] : opacities)
  {
    opacity->AddPoint(value, at);
  }
  property->SetScalarOpacity(opacity);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, firstRed, 0.2, 0.1);
  color->AddRGBPoint(1.0, 1.0, 0.2, 0.1);
  property->SetColor(color);
  return property;
}

struct Found
{
  volumebench::Scene Scene;
  MacrocellGrid Grid;

  /// Of the row of cells along x that begins at the first.
  std::vector<int> Row() const
  {
    const std::vector<std::uint8_t> all = FindHomogeneousCells(this->Grid, this->Scene);
    return { all.begin(), all.begin() + this->Grid.Cells.x };
  }
};

Found InCellsOfFour(double (*field)(double, double, double), vtkVolumeProperty* property)
{
  Found found;
  found.Scene = MakeEngineScene(MakeImage(33, 33, 33, field, VTK_FLOAT), property);
  found.Scene.Sampling.StepsMayVary = true;
  found.Scene.Sampling.TerminationThreshold = 0.0;
  found.Grid = BuildMacrocellGrid(found.Scene.Volume, 4);
  return found;
}

// Clear, and from 0.375 on of one opacity.
const std::vector<std::pair<double, double>> Plateau = { { 0.0, 0.0 }, { 0.3, 0.0 }, { 0.35, 0.1 },
  { 1.0, 0.1 } };
}

TEST(HomogeneousCells, HoldOneValue)
{
  const Found found = InCellsOfFour(Bent, Function({ { 0.0, 0.0 }, { 1.0, 1.0 } }));
  EXPECT_EQ(found.Row(), (std::vector<int>{ 1, 1, 1, 1, 0, 0, 0, 0 }));
}

TEST(HomogeneousCells, OrOnlyValuesThatShowAlike)
{
  const Found found = InCellsOfFour(Ramp, Function(Plateau));
  EXPECT_EQ(found.Row(), (std::vector<int>{ 1, 1, 0, 1, 1, 1, 1, 1 }));
}

TEST(HomogeneousCells, AreNotThoseWhoseColourChanges)
{
  const Found found = InCellsOfFour(Ramp, Function(Plateau, 0.0));
  const std::vector<int> row = found.Row();
  EXPECT_EQ(std::accumulate(row.begin(), row.end(), 0), 0);
}

TEST(HomogeneousCells, AreNotThoseInWhichAnIntegralHoldsASpike)
{
  auto spiked = Plateau;
  spiked.insert(spiked.end() - 1, { { 0.7, 0.1 }, { 0.70001, 0.9 }, { 0.70002, 0.1 } });
  Found found = InCellsOfFour(Ramp, Function(spiked));
  // As if the table had missed it.
  std::vector<glm::vec4> entries(
    found.Scene.TransferFunction.Table.begin(), found.Scene.TransferFunction.Table.end());
  const auto above = static_cast<std::size_t>(0.36 * static_cast<double>(entries.size()));
  std::fill(entries.begin() + static_cast<std::ptrdiff_t>(above), entries.end(), entries[above]);
  found.Scene.TransferFunction.Table = std::move(entries);
  EXPECT_EQ(found.Row(), (std::vector<int>{ 1, 1, 0, 1, 1, 1, 1, 1 }));
  found.Scene.Sampling.Integration = Integrator::Segment;
  BuildPrefixTable(found.Scene.TransferFunction);
  EXPECT_EQ(found.Row(), (std::vector<int>{ 1, 1, 0, 1, 1, 0, 1, 1 }));
}

TEST(HomogeneousCells, OfAPlateauStayThoseOfItWithIntegrals)
{
  Found found = InCellsOfFour(Ramp, Function(Plateau));
  found.Scene.Sampling.Integration = Integrator::Segment;
  BuildPrefixTable(found.Scene.TransferFunction);
  EXPECT_EQ(found.Row(), (std::vector<int>{ 1, 1, 0, 1, 1, 1, 1, 1 }));
}

TEST(HomogeneousCells, LengthenStepsWhereTheyAreMany)
{
  const Found many = InCellsOfFour(Ramp, Function(Plateau));
  const CellMap cells = MapOccupiedCells(many.Grid, many.Scene);
  EXPECT_EQ(cells.FinestStepVoxels, many.Scene.Sampling.StepVoxels);
  EXPECT_NEAR(cells.HomogeneousShare, 5.0 / 6.0, 1e-12) << "of those that show anything";
  EXPECT_EQ(cells.Codes[0] >> 8, 0) << "empty";
  EXPECT_EQ(cells.Codes[2] >> 8, 1) << "steps as they are";
  EXPECT_EQ(cells.Codes[3] >> 8, 16) << "of any length";
  const Found few = InCellsOfFour(Ramp, Function({ { 0.0, 0.0 }, { 1.0, 1.0 } }));
  EXPECT_EQ(MapOccupiedCells(few.Grid, few.Scene).FinestStepVoxels, 0.0);
}

TEST(HomogeneousCells, AreTakenAsOthersForAReason)
{
  const auto whyOf = [](const std::function<void(Scene&)>& change)
  {
    Found found = InCellsOfFour(Ramp, Function(Plateau));
    change(found.Scene);
    const char* why = WhyNoHomogeneousCells(found.Scene);
    const CellMap cells = MapOccupiedCells(found.Grid, found.Scene);
    EXPECT_EQ(why == nullptr, cells.FinestStepVoxels > 0.0) << (why ? why : "");
    return std::string(why ? why : "none");
  };
  EXPECT_EQ(whyOf([](Scene&) {}), "none");
  EXPECT_EQ(whyOf([](Scene& s) { s.Sampling.StepsMayVary = false; }),
    "all steps of this technique are alike");
  EXPECT_EQ(
    whyOf([](Scene& s) { s.Sampling.ErrorTarget = 0.01; }), "steps follow the error target");
  EXPECT_EQ(whyOf([](Scene& s) { s.Lighting.Enabled = true; }), "gradients change what is seen");
  EXPECT_EQ(whyOf(
              [](Scene& s)
              {
                s.Sampling.TerminationThreshold = 0.01;
                s.TransferFunction.MaximumExtinction = 9.0;
              }),
    "rays may stop early in them");
  EXPECT_EQ(whyOf([](Scene& s) { s.Sampling.StepVoxels = 0.001; }), "rays have too many steps");
}
