#include "Scene/StepGrades.h"

#include "EngineScene.h"
#include "Scene/CellMap.h"
#include "Scene/FieldChanges.h"
#include "Scene/FunctionChanges.h"

#include <gtest/gtest.h>

#include <random>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
struct Graded
{
  volumebench::Scene Scene;
  MacrocellGrid Grid;
  std::vector<glm::vec2> Changes;

  StepGrades Grades() const { return GradeSteps(this->Grid, this->Changes, this->Scene); }
};

Graded Measured(double (*field)(double, double, double), vtkVolumeProperty* property, double target)
{
  Graded graded;
  graded.Scene = MakeEngineScene(MakeImage(33, 33, 33, field, VTK_FLOAT), property);
  graded.Scene.Sampling.ErrorTarget = target;
  graded.Scene.Sampling.StepVoxels = 1.0;
  graded.Grid = BuildMacrocellGrid(graded.Scene.Volume, 4);
  graded.Changes = MeasureFieldChanges(graded.Scene.Volume, graded.Grid);
  return graded;
}

double Ramp(double i, double, double)
{
  return i / 32.0;
}

// Flat, then bent: a parabola begins in the middle.
double Bend(double i, double, double)
{
  const double beyond = std::max(0.0, i - 16.0) / 16.0;
  return 0.25 + 0.75 * beyond * beyond;
}

vtkSmartPointer<vtkVolumeProperty> Hazy()
{
  return MakeLinearExtinctionProperty(0.05, 0.0, 1.0, 65);
}

// Opaque above the middle of the values, and clear below it.
vtkSmartPointer<vtkVolumeProperty> Wall()
{
  auto property = MakeConstantProperty(0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.5, 0.0);
  opacity->AddPoint(0.501, 0.2);
  opacity->AddPoint(1.0, 0.2);
  property->SetScalarOpacity(opacity);
  return property;
}
}

TEST(FieldChanges, AreThoseOfARampAndAParabola)
{
  const Graded ramp = Measured(Ramp, Hazy(), 0.001);
  for (const glm::vec2& change : ramp.Changes)
  {
    EXPECT_NEAR(change.x, 1.0 / 32.0, 1e-6);
    EXPECT_NEAR(change.y, 0.0, 1e-6);
  }
  const Graded bend = Measured(Bend, Hazy(), 0.001);
  const float perValue = static_cast<float>(
    bend.Scene.Volume.Mapping.Normalize(1.0) - bend.Scene.Volume.Mapping.Normalize(0.0));
  EXPECT_EQ(bend.Changes[0], glm::vec2(0.0f));
  // The fifth cell of eight has 0.75 ((n + 1)^2 - n^2) / 256 between its texels, n from 0 to 4.
  const double squares = 1.0 + 9.0 + 25.0 + 49.0 + 81.0;
  EXPECT_NEAR(bend.Changes[5 - 1].x, perValue * 0.75 / 256.0 * std::sqrt(squares / 5.0), 1e-6);
  EXPECT_NEAR(bend.Changes[6].y, perValue * 0.75 * 2.0 / 256.0, 1e-6);
}

TEST(FunctionChanges, AreMeansOverAnyRange)
{
  const Graded ramp = Measured(Ramp, Wall(), 0.001);
  const FunctionChanges changes(ramp.Scene);
  const auto& table = ramp.Scene.TransferFunction.Table;
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> any(0, static_cast<int>(table.size()) - 1);
  for (int trial = 0; trial < 200; ++trial)
  {
    const int a = any(generator);
    const int b = any(generator);
    const FunctionChanges::Range range{ std::min(a, b), std::max(a, b) };
    double mean = 0.0;
    float least = table[range.First].w;
    double apart = 0.0;
    double squares = 0.0;
    for (int i = range.First; i <= range.Last; ++i)
    {
      mean += table[i].w;
      least = std::min(least, table[i].w);
      const auto high = std::min<std::size_t>(i + 32, table.size() - 1);
      const double change = table[high].w - table[std::max(i - 32, 0)].w;
      apart += change;
      squares += change * change;
    }
    const int count = range.Last - range.First + 1;
    EXPECT_NEAR(changes.MeanExtinction(range), mean / count, 1e-9);
    EXPECT_EQ(changes.LeastExtinction(range), least);
    // There is one colour, so the four numbers of a pixel change in proportion.
    const double ofAll = 0.5 * glm::length(glm::vec4(glm::vec3(table[0]), 1.0f));
    EXPECT_NEAR(changes.First(range, 64.0), ofAll * apart / count, 1e-6);
    EXPECT_NEAR(changes.FirstSquare(range, 64.0), ofAll * ofAll * squares / count, 1e-6);
  }
}

TEST(FunctionChanges, OfAStraightFunctionHaveNoSecondDifference)
{
  auto property = MakeConstantProperty(0.0);
  const Graded ramp = Measured(Ramp, property, 0.001);
  Scene scene = ramp.Scene;
  std::vector<glm::vec4> entries(257);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    entries[i] = glm::vec4(1.0f, 1.0f, 1.0f, static_cast<float>(i) / 256.0f);
  }
  scene.TransferFunction.Table = std::move(entries);
  const FunctionChanges changes(scene);
  EXPECT_NEAR(changes.Second({ 100, 150 }, 40.0), 0.0, 1e-9);
  EXPECT_NEAR(changes.First({ 100, 150 }, 40.0), 40.0 / 256.0, 0.1 * 40.0 / 256.0);
  EXPECT_NEAR(changes.First({ 100, 150 }, 0.5), 0.5 / 256.0, 1e-9) << "straight between entries";
}

TEST(StepGrades, OfOneValueAreExactAndOthersGrowFinerWithTheTarget)
{
  int last = CoarsestGrade;
  for (const double target : { 1e-2, 1e-3, 1e-4 })
  {
    const StepGrades grades = Measured(Bend, Hazy(), target).Grades();
    EXPECT_EQ(grades.Grades[0], ExactGrade);
    EXPECT_LE(grades.Grades[7], last) << target;
    EXPECT_LE(grades.ExpectedError, target);
    last = grades.Grades[7];
  }
  EXPECT_LT(last, CoarsestGrade);
}

TEST(StepGrades, AreFinestWhereTheFunctionJumps)
{
  const StepGrades grades = Measured(Ramp, Wall(), 1e-3).Grades();
  EXPECT_EQ(grades.Grades[7], ExactGrade) << "behind the jump all is alike";
  EXPECT_LT(grades.Grades[4], 0) << "the fifth cell begins at the value 0.5";
}

TEST(StepGrades, TellThatATargetIsOutOfReach)
{
  const StepGrades grades = Measured(Ramp, Wall(), 1e-9).Grades();
  EXPECT_GT(grades.ExpectedError, 1e-9);
  EXPECT_EQ(grades.Grades[4], FinestGrade);
}

TEST(StepGrades, OfSegmentCrossAJumpWithLongerSteps)
{
  Graded ramp = Measured(Ramp, Wall(), 1e-3);
  const int midpoint = ramp.Grades().Grades[4];
  ramp.Scene.Sampling.Integration = Integrator::Segment;
  EXPECT_GT(ramp.Grades().Grades[4], midpoint) << "it finds the crossing within a step";
}

TEST(CellMap, DistancesOfGradesLeadToTheNearestCellThatAllowsLess)
{
  const Graded bend = Measured([](double i, double j, double k)
    { return 0.5 + 0.5 * std::sin(0.02 * i * j) * std::cos(0.03 * j * k); },
    MakeLinearExtinctionProperty(0.3, 0.2, 1.0, 65), 1e-3);
  const CellMap map = MapGradedCells(bend.Grid, bend.Changes, bend.Scene);
  const auto lengthAt = [&](int x, int y, int z)
  {
    const int kind = map.Codes[x + map.Cells.x * (y + map.Cells.y * z)] >> 8;
    return kind == 0 ? 1000 : kind;
  };
  std::set<int> kinds;
  for (int i = 0; i < static_cast<int>(map.Codes.size()); ++i)
  {
    const glm::ivec3 cell(
      i % map.Cells.x, i / map.Cells.x % map.Cells.y, i / map.Cells.x / map.Cells.y);
    int nearest = 255;
    for (int j = 0; j < static_cast<int>(map.Codes.size()); ++j)
    {
      const glm::ivec3 other(
        j % map.Cells.x, j / map.Cells.x % map.Cells.y, j / map.Cells.x / map.Cells.y);
      const glm::ivec3 apart = glm::abs(other - cell);
      const bool less = lengthAt(other.x, other.y, other.z) < lengthAt(cell.x, cell.y, cell.z);
      nearest = less ? std::min({ nearest, std::max({ apart.x, apart.y, apart.z }) }) : nearest;
    }
    ASSERT_EQ(map.Codes[i] & 255, nearest) << "cell " << i;
    kinds.insert(map.Codes[i] >> 8);
  }
  EXPECT_GE(kinds.size(), 4u);
  EXPECT_EQ(*std::find_if(kinds.begin(), kinds.end(), [](int kind) { return kind > 0; }), 1)
    << "the unit is the finest step that some cell has";
}
