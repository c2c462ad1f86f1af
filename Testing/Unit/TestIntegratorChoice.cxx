#include "Scene/IntegratorChoice.h"

#include "EngineScene.h"
#include "Scene/FeatureWords.h"
#include "Scene/PrefixTable.h"
#include "Scene/StepGrades.h"

#include <gtest/gtest.h>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Texels = 33;

double Ramp(double i, double, double)
{
  return i / (Texels - 1.0);
}

double Waves(double i, double j, double k)
{
  return 0.5 + 0.5 * std::sin(0.9 * i) * std::cos(0.8 * j) * std::cos(0.7 * k);
}

double Blob(double i, double j, double k)
{
  const glm::dvec3 off(i - 13.0, j - 18.0, k - 15.0);
  return std::exp(-0.05 * glm::dot(off, off));
}

vtkSmartPointer<vtkVolumeProperty> Hazy()
{
  return MakeLinearExtinctionProperty(0.05, 0.0, 1.0, 65);
}

vtkSmartPointer<vtkVolumeProperty> WithOpacity(
  std::initializer_list<std::pair<double, double>> knots)
{
  auto property = MakeConstantProperty(0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& knot : knots)
  {
    opacity->AddPoint(knot.first, knot.second);
  }
  property->SetScalarOpacity(opacity);
  return property;
}

// Opaque above the middle of the values, and clear below it.
vtkSmartPointer<vtkVolumeProperty> Wall()
{
  return WithOpacity({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.501, 0.9 }, { 1.0, 0.9 } });
}

Scene SceneOf(double (*field)(double, double, double), vtkVolumeProperty* property,
  double stepVoxels = 1.0, double errorTarget = 0.0)
{
  Scene scene = MakeEngineScene(MakeImage(Texels, Texels, Texels, field, VTK_FLOAT), property);
  scene.Sampling.Integration = Integrator::Automatic;
  scene.Sampling.StepVoxels = stepVoxels;
  scene.Sampling.ErrorTarget = errorTarget;
  scene.Sampling.StepsMayVary = true;
  return scene;
}

Integrator ChosenFor(Scene scene)
{
  MacrocellCache cells;
  IntegratorChoice choice;
  choice.Choose(cells, scene);
  EXPECT_TRUE(scene.Sampling.ChoosesIntegrator);
  return scene.Sampling.Integration;
}

IntegratorErrors ErrorsOf(const Scene& scene)
{
  MacrocellCache cells;
  return ExpectErrors(cells.GridOf(scene), cells.ChangesOf(scene), scene);
}
}

TEST(IntegratorChoice, IsMidpointWhereLittleChangesOverAStep)
{
  EXPECT_EQ(ChosenFor(SceneOf(Ramp, Hazy())), Integrator::Midpoint);
}

TEST(IntegratorChoice, IsSegmentWhereTheFunctionJumpsWithinAStep)
{
  EXPECT_EQ(ChosenFor(SceneOf(Ramp, Wall())), Integrator::Segment);
}

TEST(IntegratorChoice, IsSegmentForPeaksBetweenTwoEntriesOfTheTable)
{
  const auto property =
    WithOpacity({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.50001, 0.9 }, { 0.50002, 0.0 }, { 1.0, 0.0 } });
  Scene scene = SceneOf(Ramp, property, 1.0 / 64.0);
  scene.TransferFunction =
    BuildTransferFunction(property, scene.Volume.FiniteRange, { 4094, 0 }, nullptr);
  ASSERT_EQ(scene.TransferFunction.MaximumExtinction, 0.0) << "the table knows the peak";
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment);
}

TEST(IntegratorChoice, DependsOnWhichValuesThereAre)
{
  // The wall is at a value that the field jumps over nowhere near.
  Scene scene = SceneOf([](double i, double, double) { return i < 16.5 ? 0.2 : 0.3; }, Hazy());
  EXPECT_EQ(ChosenFor(scene), Integrator::Midpoint);
  scene = SceneOf([](double i, double j, double) { return 0.2 + 0.01 * std::sin(i * j); }, Wall());
  EXPECT_EQ(ChosenFor(scene), Integrator::Midpoint) << "all values are clear";
}

TEST(IntegratorChoice, IsMidpointWhereNothingLiesBetweenTwoValues)
{
  Scene scene = SceneOf(Ramp, Wall());
  scene.Volume.Nearest = true;
  EXPECT_EQ(ChosenFor(scene), Integrator::Midpoint);
  for (const BlendMode mode : { BlendMode::Maximum, BlendMode::Minimum, BlendMode::Average })
  {
    scene = SceneOf(Ramp, Wall());
    scene.Compositing.Mode = mode;
    EXPECT_EQ(ChosenFor(scene), Integrator::Midpoint);
  }
  scene.Compositing.Mode = BlendMode::Gradient;
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment);
}

TEST(IntegratorChoice, IsSegmentWhereSeveralComponentsAreNotJudged)
{
  Scene scene = SceneOf(Ramp, Hazy());
  scene.Volume.Channels = 4;
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment);
}

TEST(IntegratorChoice, IsSegmentWhereJitterMovesSamplesOutOfTheMiddle)
{
  Scene scene = SceneOf(Ramp, Hazy());
  scene.Sampling.Jitter = true;
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment);
}

TEST(IntegratorChoice, IsTheSameOnAllRanksOfAVolumeThatTheyShare)
{
  Scene scene = SceneOf(Ramp, Hazy());
  scene.Share.emplace();
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment);
}

TEST(IntegratorChoice, DoesNotDependOnTheSizeOfMacrocells)
{
  for (int i = 0; i < 40; ++i)
  {
    const double step = 4.0 * std::pow(0.9, i);
    Scene scene = SceneOf(Blob, MakeLinearExtinctionProperty(0.5, 0.2, 1.0, 65), step);
    const Integrator chosen = ChosenFor(scene);
    for (const int edge : { 2, 8, 16, 64 })
    {
      scene.Sampling.MacrocellVoxels = edge;
      EXPECT_EQ(ChosenFor(scene), chosen) << "step " << step << ", edge " << edge;
    }
  }
}

TEST(IntegratorChoice, OfAnErrorTargetIsTheCheaperOne)
{
  EXPECT_EQ(ChosenFor(SceneOf(Ramp, Wall(), 1.0, 1.0e-3)), Integrator::Segment);
  EXPECT_EQ(ChosenFor(SceneOf(Ramp, Hazy(), 1.0, 1.0e-2)), Integrator::Midpoint);
  Scene scene = SceneOf(Ramp, Wall(), 1.0, 1.0e-3);
  scene.Sampling.StepsMayVary = false;
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment) << "without a target that can be kept";
  scene = SceneOf(Blob, MakeLinearExtinctionProperty(0.5, 0.2, 1.0, 65), 2.0);
  EXPECT_EQ(ChosenFor(scene), Integrator::Segment) << "so long a step";
  scene.Sampling.ErrorTarget = 1.0e-2;
  EXPECT_EQ(ChosenFor(scene), Integrator::Midpoint) << "with shorter steps, cheaper ones";
}

TEST(IntegratorChoice, LeavesWhatTheUserChose)
{
  for (const Integrator chosen :
    { Integrator::Left, Integrator::Midpoint, Integrator::Segment, Integrator::PreIntegrated })
  {
    Scene scene = SceneOf(Ramp, Wall());
    scene.Sampling.Integration = chosen;
    MacrocellCache cells;
    IntegratorChoice().Choose(cells, scene);
    EXPECT_EQ(scene.Sampling.Integration, chosen);
    EXPECT_FALSE(scene.Sampling.ChoosesIntegrator);
  }
}

TEST(IntegratorChoice, IsMadeAnewWhereItDependsOnWhatChanged)
{
  MacrocellCache cells;
  IntegratorChoice choice;
  const auto chosen = [&](Scene scene)
  {
    choice.Choose(cells, scene);
    return scene.Sampling.Integration;
  };
  const Scene hazy = SceneOf(Waves, Hazy());
  Scene wall = hazy;
  wall.TransferFunction = BuildTransferFunction(Wall(), wall.Volume.FiniteRange, {}, nullptr);
  EXPECT_EQ(chosen(hazy), Integrator::Midpoint);
  EXPECT_EQ(chosen(wall), Integrator::Segment);
  EXPECT_EQ(chosen(hazy), Integrator::Midpoint);
  Scene nearest = wall;
  nearest.Volume.Nearest = true;
  EXPECT_EQ(chosen(nearest), Integrator::Midpoint);
  EXPECT_EQ(chosen(wall), Integrator::Segment);
  choice.TakeMs();
  cells.TakeMs();
  EXPECT_EQ(chosen(wall), Integrator::Segment);
  EXPECT_EQ(choice.TakeMs(), 0.0) << "nothing has changed";
}

TEST(IntegratorChoice, IsWhatTheLeftOutListNames)
{
  Scene scene = SceneOf(Ramp, Hazy());
  MacrocellCache cells;
  IntegratorChoice().Choose(cells, scene);
  const auto whyNoSegment = [&scene]
  {
    for (const LeftOutFeature& row : FeaturesLeftOut(scene, FeaturesNeededBy(scene)))
    {
      if (row.Bit == Feature::Segment)
      {
        return std::string(row.Why);
      }
    }
    return std::string("used");
  };
  EXPECT_EQ(whyNoSegment(), "Midpoint suffices");
  scene.Volume.Nearest = true;
  EXPECT_EQ(whyNoSegment(), "values are not interpolated");
  scene.Compositing.Mode = BlendMode::Maximum;
  EXPECT_EQ(whyNoSegment(), "not chosen");
  scene.Compositing.Mode = BlendMode::Composite;
  scene.Sampling.Integration = Integrator::Segment;
  EXPECT_EQ(whyNoSegment(), "used");
}

TEST(ExpectErrors, FallsWithTheSquareOfTheStepAndIsZeroWhereNothingIsSeen)
{
  // Quadratic, and for the order of colours within a step with one power more.
  const IntegratorErrors coarse = ErrorsOf(SceneOf(Waves, Hazy(), 0.25));
  const IntegratorErrors fine = ErrorsOf(SceneOf(Waves, Hazy(), 0.125));
  EXPECT_GT(coarse.Midpoint, 0.0);
  EXPECT_GT(coarse.Midpoint / fine.Midpoint, 3.9);
  EXPECT_LT(coarse.Midpoint / fine.Midpoint, 6.0);
  const IntegratorErrors none = ErrorsOf(SceneOf(Waves, MakeConstantProperty(0.0), 0.5));
  EXPECT_EQ(none.Midpoint, 0.0);
  EXPECT_EQ(none.Segment, 0.0);
}
