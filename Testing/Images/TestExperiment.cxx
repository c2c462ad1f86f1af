// The experiment of the benchmark filter: rows, errors, progress, abort.
#include "Contestant.h"
#include "EveryTechnique.h"
#include "Experiment.h"
#include "SmallExperiment.h"
#include "Stage.h"
#include "VtkSampleCounter.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
struct RayLengths
{
  double Sum = 0.0;
  int Rays = 0;
};

// Of all rays of the first error view, in voxels of edge 1.
RayLengths LengthsInCube(const ExperimentSettings& settings, const double bounds[6])
{
  const int frame = settings.Orbit.FramesPerTurn / 8;
  const CameraPose pose = OrbitPose(frame, settings.Orbit, bounds);
  vtkNew<vtkRenderer> renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(pose.Position);
  camera->SetFocalPoint(pose.FocalPoint);
  camera->SetViewUp(pose.ViewUp);
  camera->SetViewAngle(pose.ViewAngleDegrees);
  camera->SetClippingRange(1e-3, 1e6);
  RayLengths lengths;
  for (int y = 0; y < settings.Height; ++y)
  {
    for (int x = 0; x < settings.Width; ++x)
    {
      const double length = RayOfPixel(renderer, bounds, x, y, settings.Width).Length();
      lengths.Sum += length;
      lengths.Rays += length > 0.0 ? 1 : 0;
    }
  }
  return lengths;
}
}

class Experiments : public EveryTechnique
{
};

TEST_P(Experiments, OneRowPerRunWithItsError)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings(GetParam());
  settings.Techniques.emplace_back("vtk-gpu");
  settings.Integrators = { 0, 1 };
  settings.StepsVoxels = { 2.0, 0.5 };
  const auto results = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(results.size(), 5u);
  for (const RunResult& result : results)
  {
    EXPECT_EQ(result.Status, "ok") << result.Reason;
    EXPECT_GE(result.Frames, 1);
    EXPECT_GT(result.FrameMs.Median, 0.0);
    EXPECT_GT(result.GpuMs.Median, 0.0);
    EXPECT_LE(result.GpuMs.Median, result.FrameMs.Max);
    EXPECT_EQ(result.Error.Rmse > 0.0, HasSteps(result.Technique));
    EXPECT_EQ(result.Reference, "cell-exact float64");
    EXPECT_GT(result.ReferenceUncertainty, 0.0) << "two renderers do not agree to the last bit";
    EXPECT_GE(result.Error.Linf, result.Error.Rmse);
    EXPECT_LT(result.ReferenceUncertainty, 1e-5);
  }
  EXPECT_EQ(results[0].Integrator, "Left");
  EXPECT_EQ(results[4].Integrator, "");
  if (HasSteps(GetParam())) // a shorter step and the better integrator are closer to the reference
  {
    EXPECT_LT(results[1].Error.Rmse, results[0].Error.Rmse);
    EXPECT_LT(results[3].Error.Rmse, results[1].Error.Rmse);
  }
}

TEST_P(Experiments, ProgressGrowsToTheEnd)
{
  const SmallInput small;
  std::vector<double> shares;
  RunExperiment(SmallSettings(GetParam()), small.Input,
    [&](double share)
    {
      shares.push_back(share);
      return true;
    });
  ASSERT_GT(shares.size(), 3u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}

TEST_P(Experiments, AbortEndsItWithoutHalfMeasuredRows)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings(GetParam());
  settings.StepsVoxels = { 2.0, 1.0 };
  settings.Stop.RelativeNoise = 0.0;
  settings.Stop.TimeLimitS = 60.0;
  for (const int framesBeforeAbort : { 0, 2, 8 })
  {
    int calls = 0;
    const auto results =
      RunExperiment(settings, small.Input, [&](double) { return ++calls <= framesBeforeAbort; });
    EXPECT_TRUE(results.empty());
    EXPECT_LE(calls, framesBeforeAbort + 40) << "it went on after the abort";
  }
}

// A cube of one value, where no ray stops early. Casting takes as many samples as the ray
// has steps, the last of which may be a fraction. Slices divide the cube's depth evenly, at most a
// step apart on the axis of view and 4 % farther on the rays at the corners of the picture.
TEST_P(Experiments, CountsTheSamplesOfAConstantCube)
{
  SmallInput small;
  small.Image = MakeImage(17, 17, 17, [](double, double, double) { return 0.5; });
  small.Property = MakeConstantProperty(0.01);
  small.Input.Image = small.Image;
  small.Input.Property = small.Property;
  ExperimentSettings settings = SmallSettings(GetParam());
  settings.ErrorViews = 0;
  settings.Own.TerminationThreshold = 0.0; // else a projection stops at the largest value there is
  const RayLengths expected = LengthsInCube(settings, small.Image->GetBounds());
  const bool slicing = IsSliced(GetParam());
  for (const int mode : { 0, 1, 2, 3, vtkVolumeBenchMapper::GRADIENT_BLEND })
  {
    small.Input.BlendMode = mode;
    const auto results = RunExperiment(settings, small.Input, GoOn);
    ASSERT_EQ(results.size(), 1u);
    const SampleCount& samples = results[0].Samples;
    const double total = samples.Taken + samples.Skipped;
    EXPECT_GE(total, (slicing ? 0.96 : 0.999) * expected.Sum) << results[0].BlendMode;
    if (HasSteps(GetParam())) // else cells are counted, as many as the ray crosses
    {
      EXPECT_LE(total, (slicing ? 1.1 : 1.001) * expected.Sum + expected.Rays);
    }
    EXPECT_EQ(samples.RaysTerminated, 0.0);
  }
}

TEST_P(Experiments, StagesAreNamedAndTakeTime)
{
  const SmallInput small;
  const auto results = RunExperiment(SmallSettings(GetParam()), small.Input, GoOn);
  ASSERT_EQ(results.size(), 1u);
  for (const StageTime& stage : results[0].Stages)
  {
    EXPECT_FALSE(stage.Name.empty());
    EXPECT_GE(stage.Ms, 0.0) << stage.Name;
  }
  EXPECT_NE(results[0].Stages.size(), 1u) << "one stage is the frame itself";
}

TEST_P(Experiments, ErrorsTakeASizeOfTheirOwn)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings(GetParam());
  settings.ErrorWidth = 24;
  settings.ErrorHeight = 20;
  const auto results = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].ErrorWidth, 24);
  EXPECT_EQ(results[0].ErrorHeight, 20);
  EXPECT_EQ(results[0].Error.Rmse > 0.0, HasSteps(GetParam()));
}

TEST_P(Experiments, AVariantIsARowOfItsOwn)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings(GetParam());
  settings.Techniques.emplace_back("vtk-gpu");
  for (const char* threads : { "1", "4" })
  {
    settings.Variants.push_back({ GetParam(), { { "slice_threads", threads } } });
  }
  const auto results = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(SettingsJson(results[0].Settings), "{\"slice_threads\": 1}");
  EXPECT_EQ(SettingsJson(results[1].Settings), "{\"slice_threads\": 4}");
  EXPECT_TRUE(results[2].Settings.empty());
}

TEST_P(Experiments, RotatesForSeconds)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings(GetParam());
  settings.ErrorViews = 0;
  settings.Stop.DurationS = 0.3;
  const auto results = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_GE(results[0].Frames * results[0].FrameMs.Max, 300.0);
  EXPECT_TRUE(std::isnan(results[0].Error.Rmse)) << "no error was asked for";
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Experiments);

TEST(ExperimentSettings, NameWhatIsWrong)
{
  const auto messageOf = [](void (*spoil)(ExperimentSettings&))
  {
    ExperimentSettings settings = SmallSettings("single-pass");
    spoil(settings);
    try
    {
      CheckSettings(settings);
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(messageOf([](ExperimentSettings&) {}), "");
  EXPECT_NE(
    messageOf([](ExperimentSettings& s) { s.Width = 0; }).find("0 x 48"), std::string::npos);
  EXPECT_NE(messageOf([](ExperimentSettings& s) { s.StepsVoxels = { -1.0 }; }).find("step is -1"),
    std::string::npos);
  EXPECT_NE(messageOf([](ExperimentSettings& s) { s.Techniques.clear(); }).find("no technique"),
    std::string::npos);
  EXPECT_NE(
    messageOf([](ExperimentSettings& s) { s.ErrorWidth = 5; }).find("5 x 0"), std::string::npos);
  EXPECT_NE(messageOf([](ExperimentSettings& s) { s.Own.SliceThreads = 3; }).find("threads 3"),
    std::string::npos);
  EXPECT_NE(messageOf([](ExperimentSettings& s) { s.Integrators = { 5 }; }).find("integrator 5"),
    std::string::npos);
  EXPECT_NE(messageOf(
              [](ExperimentSettings& s) {
                s.Variants = { { "slices", {} } };
              })
              .find("'slices', which is not measured"),
    std::string::npos);
  EXPECT_NE(messageOf([](ExperimentSettings& s) { s.Reference = 2; }).find("reference 2"),
    std::string::npos);
  EXPECT_NE(messageOf([](ExperimentSettings& s) { s.ErrorViews = 99; }).find("99 error views"),
    std::string::npos);
}

TEST(ExperimentReferences, FineStepsGiveTheErrorsOfTheExactOne)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings("single-pass");
  const RunResult exact = RunExperiment(settings, small.Input, GoOn).front();
  settings.Reference = 1;
  settings.ReferenceStepVoxels = 1.0 / 32.0;
  const RunResult steps = RunExperiment(settings, small.Input, GoOn).front();
  EXPECT_EQ(exact.Reference, "cell-exact float64");
  EXPECT_EQ(steps.Reference, "single-pass Midpoint step 0.03125");
  EXPECT_GT(exact.Error.Rmse, 1e-4);
  EXPECT_NEAR(steps.Error.Rmse, exact.Error.Rmse, 0.05 * exact.Error.Rmse);
  EXPECT_GT(steps.ReferenceUncertainty, exact.ReferenceUncertainty);
}

TEST(ExperimentContestants, UnknownOnesAreNamedWithTheKnown)
{
  const SmallInput small;
  try
  {
    RunExperiment(SmallSettings("nix"), small.Input, GoOn);
    FAIL() << "no error";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("'nix'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("vtk-fixed-point"), std::string::npos);
  }
}

// VTK's mapper samples at both ends of a ray, or not, and stops none in such a thin cube.
TEST(ExperimentContestants, SamplesOfVtksGpuMapperAreThoseOfItsGeometry)
{
  SmallInput small;
  small.Image = MakeImage(17, 17, 17, [](double, double, double) { return 0.5; });
  small.Property = MakeConstantProperty(0.01);
  small.Input.Image = small.Image;
  small.Input.Property = small.Property;
  ExperimentSettings settings = SmallSettings("vtk-gpu");
  settings.ErrorViews = 0;
  for (const char* voxels : { "0.5", "0.25", "0.0625" })
  {
    settings.Variants.push_back({ "vtk-gpu", { { "sample_distance_voxels", voxels } } });
  }
  const RayLengths expected = LengthsInCube(settings, small.Image->GetBounds());
  const auto results = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(results.size(), 3u);
  for (const RunResult& result : results)
  {
    const double steps = expected.Sum / result.StepVoxels;
    EXPECT_GE(result.Samples.Taken, steps - expected.Rays) << result.StepVoxels;
    EXPECT_LE(result.Samples.Taken, steps + 2.0 * expected.Rays) << result.StepVoxels;
    EXPECT_EQ(result.Samples.Skipped, 0.0);
    EXPECT_TRUE(std::isnan(result.Samples.RaysTerminated)) << "VTK does not tell";
  }
}

TEST(ExperimentContestants, CountingSamplesLeavesVtksPictureAsItWas)
{
  const SmallInput small;
  Contestant peer("vtk-gpu", small.Input);
  peer.SetStepVoxels(0.5);
  Stage stage(48, 48);
  stage.Add(peer);
  stage.Show(peer);
  stage.Place(OrbitPose(1, {}, small.Image->GetBounds()));
  const std::vector<float> before = stage.Picture().Pixels;
  {
    const VtkSampleCounter counter(peer.GetVolume());
    EXPECT_NE(stage.Picture().Pixels, before);
  }
  EXPECT_EQ(stage.Picture().Pixels, before);
}

TEST(ExperimentContestants, AFinerSampleDistanceIsCloserToTheTruth)
{
  const SmallInput small;
  ExperimentSettings settings = SmallSettings("vtk-gpu");
  settings.Variants = { ParseVariant("vtk-gpu"),
    ParseVariant("vtk-gpu; sample_distance_voxels=0.0625") };
  const auto results = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_LT(results[1].Error.Rmse, 0.3 * results[0].Error.Rmse);
  EXPECT_EQ(SettingsJson(results[1].Settings), "{\"sample_distance_voxels\": 0.0625}");
}

TEST(ExperimentContestants, PeersSayWhichBlendModesTheyLack)
{
  SmallInput small;
  small.Input.BlendMode = vtkVolumeBenchMapper::GRADIENT_BLEND;
  ExperimentSettings settings = SmallSettings("vtk-gpu");
  settings.ErrorViews = 0;
  const auto gradient = RunExperiment(settings, small.Input, GoOn);
  ASSERT_EQ(gradient.size(), 1u);
  EXPECT_EQ(gradient[0].Status, "unsupported");
  EXPECT_NE(gradient[0].Reason.find("Gradient"), std::string::npos);
  EXPECT_EQ(gradient[0].BlendMode, "Gradient");
  for (const int mode : { 1, 2, 3 })
  {
    small.Input.BlendMode = mode;
    EXPECT_EQ(RunExperiment(settings, small.Input, GoOn)[0].Status, "ok") << mode;
  }
}
