// What scenes compile: each function, uniform and number of the scene that belongs to a feature is
// in the text if the scene needs that feature, and only then.
#include "KernelCompilers.h"

#include "Scene/CellMap.h"

#include <gtest/gtest.h>

#include <functional>
#include <regex>

using namespace volumebench;

namespace
{
struct FeatureWord
{
  const char* Word;
  std::vector<Feature> Owners; // any of which brings it
};

const std::vector<FeatureWord>& FeatureWords()
{
  using F = Feature;
  static const std::vector<FeatureWord> words = {
    { "prefixTexture", { F::Segment } },
    { "classifyBetween", { F::Segment } },
    { "scene.prefixUnits", { F::Segment } },
    { "frontOfProfile", { F::StiffSteps } },
    { "segmentTexture", { F::PreIntegrated } },
    { "classifySegment", { F::PreIntegrated } },
    { "jitterOf", { F::Jitter } },
    { "hashOf", { F::Jitter } },
    { "isFinished", { F::Termination } },
    { "march.lost", { F::Compensation } },
    { "opaqueDepthTexture", { F::OpaqueDepth } },
    { "viewDepthOfWindowDepth", { F::OpaqueDepth } },
    { "clipToCrop", { F::Crop, F::CropRegions } },
    { "isInCropRegions", { F::CropRegions } },
    { "scene.cropRegions", { F::CropRegions } },
    { "nextBorder", { F::CropRegions } },
    { "clipToPlanes", { F::ClipPlanes } },
    { "scene.clipPlane", { F::ClipPlanes } },
    { "blankingTexture", { F::Blanking } },
    { "isBlank", { F::Blanking } },
    { "isHidden", { F::Blanking, F::CropRegions } },
    { "litColor", { F::Lighting } },
    { "scene.lightPosition", { F::Lighting } },
    { "differenceAt", { F::Lighting, F::GradientOpacity } },
    { "gradientOpacityTexture", { F::GradientOpacity } },
    { "gradientOpacityOf", { F::GradientOpacity } },
    { "texelAt", { F::OpacityChannel, F::DirectColor } },
    { "classifyColor", { F::OpacityChannel } },
    { "valueContribution", { F::MaximumBlend, F::MinimumBlend, F::AverageBlend } },
    { "changeAlong", { F::GradientBlend } },
    { "sampleColor", { F::SampleView } },
    { "viridis", { F::SampleView } },
    { "clipToOccupied", { F::TightBox } },
    { "scene.occupiedLow", { F::TightBox } },
    { "scene.oneColor", { F::OneColor } },
    { "stepsInBrick", { F::Bricks } },
    { "scene.brickLow", { F::Bricks } },
    { "cellRayOf", { F::Skipping } },
    { "scene.cells", { F::Skipping } },
    { "lengthOfNext", { F::AdaptiveSteps, F::HomogeneousCells } },
    { "march.rest", { F::AdaptiveSteps, F::HomogeneousCells } },
    { "gradedWidthOf", { F::AdaptiveSteps, F::HomogeneousCells } },
  };
  return words;
}

bool Holds(const std::string& text, const std::string& word)
{
  // The preprocessor puts spaces round a dot.
  const std::string pattern = std::regex_replace(word, std::regex("\\."), R"re(\s*\.\s*)re");
  return std::regex_search(text, std::regex("\\b" + pattern + "\\b"));
}

struct NamedScene
{
  const char* Name;
  std::function<void(Scene&)> Change;
};

void MakeHalfEmpty(Scene& scene)
{
  auto cells = std::make_shared<CellMap>();
  cells->Codes = { 1, 257 };
  cells->OccupiedShare = 0.5;
  cells->OccupiedHigh = { 10.0, 10.0, 10.0 };
  scene.Skipping.Cells = cells;
}

void CrossHomogeneousCells(Scene& scene)
{
  MakeHalfEmpty(scene);
  auto cells = std::make_shared<CellMap>(*scene.Skipping.Cells);
  cells->FinestStepVoxels = 0.25;
  scene.Skipping.Cells = cells;
}

void GradeSteps(Scene& scene)
{
  CrossHomogeneousCells(scene);
  scene.Sampling.ErrorTarget = 0.001;
  scene.Sampling.StepsMayVary = true;
}

void UseDarkSegments(Scene& scene)
{
  scene.Sampling.Integration = Integrator::Segment;
  scene.TransferFunction.MaximumExtinction = 100.0;
}

const std::vector<NamedScene>& Scenes()
{
  static const std::vector<NamedScene> scenes = {
    { "plain", [](Scene&) {} },
    { "Left", [](Scene& s) { s.Sampling.Integration = Integrator::Left; } },
    { "thin Segment", [](Scene& s) { s.Sampling.Integration = Integrator::Segment; } },
    { "dark Segment", UseDarkSegments },
    { "PreIntegrated", [](Scene& s) { s.Sampling.Integration = Integrator::PreIntegrated; } },
    { "jitter", [](Scene& s) { s.Sampling.Jitter = true; } },
    { "long rays", [](Scene& s) { s.Sampling.StepVoxels = 0.001; } },
    { "deep rays",
      [](Scene& s)
      {
        s.TransferFunction.MaximumExtinction = 9.0;
        s.Sampling.TerminationThreshold = 0.01;
      } },
    { "opaque geometry", [](Scene& s) { s.Clip.OpaqueGeometry = true; } },
    { "crop box", [](Scene& s) { s.Clip.Crop = true; } },
    { "crop regions", [](Scene& s) { s.Clip.CropRegionFlags = 5; } },
    { "clip plane", [](Scene& s) { s.Clip.Planes.emplace_back(1.0); } },
    { "hidden voxels", [](Scene& s) { s.Volume.HasNonFinite = true; } },
    { "shading", [](Scene& s) { s.Lighting.Enabled = true; } },
    { "gradient opacity",
      [](Scene& s) {
        s.TransferFunction.GradientTable = { 0.0f, 1.0f };
      } },
    { "two components", [](Scene& s) { s.Volume.Channels = 2; } },
    { "four components", [](Scene& s) { s.Volume.Channels = 4; } },
    { "Maximum", [](Scene& s) { s.Compositing.Mode = BlendMode::Maximum; } },
    { "Average of shaded data with gradient opacity",
      [](Scene& s)
      {
        s.Compositing.Mode = BlendMode::Average;
        s.Lighting.Enabled = true;
        s.TransferFunction.GradientTable = { 0.0f, 1.0f };
      } },
    { "Gradient", [](Scene& s) { s.Compositing.Mode = BlendMode::Gradient; } },
    { "half empty", MakeHalfEmpty },
    { "steps of different lengths", GradeSteps },
    { "homogeneous cells", CrossHomogeneousCells },
    { "one colour", [](Scene& s) { s.TransferFunction.Color = glm::vec3(1.0f); } },
    { "bricks", [](Scene& s) { s.Bricks = std::make_shared<std::vector<Brick>>(1); } },
    { "samples shown", [](Scene& s) { s.Measurement.ShowSamples = true; } },
  };
  return scenes;
}
}

TEST(UnusedText, IsNotCompiledInAnyScene)
{
  FeatureSet tried;
  for (const NamedScene& named : Scenes())
  {
    Scene scene;
    scene.Volume.BoxHalf = glm::dvec3(20.0);
    scene.Sampling.SetUp = RaySetUp::Box;
    named.Change(scene);
    const FeatureSet features = FeaturesNeededBy(scene);
    tried |= features;
    const std::string text = PreprocessGlsl("SinglePass.frag", features);
    for (const FeatureWord& word : FeatureWords())
    {
      const bool needed = std::any_of(word.Owners.begin(), word.Owners.end(),
        [&features](Feature owner) { return Has(features, owner); });
      EXPECT_EQ(Holds(text, word.Word), needed) << word.Word << " in the scene " << named.Name;
    }
  }
  for (const FeatureWord& word : FeatureWords())
  {
    EXPECT_TRUE(std::any_of(word.Owners.begin(), word.Owners.end(),
      [&tried](Feature owner) { return Has(tried, owner); }))
      << "no scene here needs " << word.Word;
  }
}
