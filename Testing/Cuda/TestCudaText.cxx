// The text of the CUDA kernel, run on the host, against the C++ dialect for the scenes of the image
// tests: to the last bit, since both do the same arithmetic on the same samples.
#include "../Images/ConformanceScene.h"
#include "HostScene.h"
#include "Scene/SceneBuilder.h"

#include <gtest/gtest.h>

#include <map>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Size = 32;

ConformanceScenes AllScenes()
{
  ConformanceScenes all;
  for (const auto& group : { ScenesOfViews(), ScenesOfArrays(), ScenesOfAppearance() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

struct Variant
{
  const char* Name;
  std::function<void(RenderScene&)> Change;
};

void HideHalfOfTheValues(RenderScene& render)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.7, 0.0);
  opacity->AddPoint(1.0, 0.9);
  render.Volume->GetProperty()->SetScalarOpacity(opacity);
  render.Mapper->SetMacrocellVoxels(4);
}

void UseOneColor(RenderScene& render)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.3, 0.6, 0.9);
  render.Volume->GetProperty()->SetColor(color);
}

// What scenes differ in besides what they show; tried on the first of them.
const std::vector<Variant>& Variants()
{
  static const std::vector<Variant> variants = {
    { "Left", [](RenderScene& r) { r.Mapper->SetIntegrator(0); } },
    { "Segment", [](RenderScene& r) { r.Mapper->SetIntegrator(2); } },
    { "PreIntegrated, jittered",
      [](RenderScene& r)
      {
        r.Mapper->SetIntegrator(3);
        r.Mapper->JitterOn();
      } },
    { "Midpoint, jittered", [](RenderScene& r) { r.Mapper->JitterOn(); } },
    { "steps for which rounding is compensated",
      [](RenderScene& r) { r.Mapper->SetStepVoxels(0.006); } },
    { "half empty", HideHalfOfTheValues },
    { "half empty, one colour, Segment, ends early",
      [](RenderScene& r)
      {
        HideHalfOfTheValues(r);
        UseOneColor(r);
        r.Mapper->SetIntegrator(2);
        r.Mapper->SetTerminationThreshold(0.01);
      } },
    { "one colour, PreIntegrated",
      [](RenderScene& r)
      {
        UseOneColor(r);
        r.Mapper->SetIntegrator(3);
      } },
    { "samples as colours",
      [](RenderScene& r) { r.Mapper->SetShow(vtkVolumeBenchMapper::SamplesPerPixel); } },
  };
  return variants;
}

// As the mapper would have it built, but without a window.
Scene BuildScene(RenderScene& render, vtkImageData* image)
{
  const RenderTarget target{ { 0, 0, Size, Size }, 16384 };
  SceneBuilder builder;
  const ScalarRange range = builder.RangeOf(render.Mapper, render.Volume, image);
  return builder.Build(render.Mapper, render.Renderer, render.Volume, image, range, target);
}

const CudaPair* PairOf(const FeatureSet& features)
{
  for (const CudaPair& pair : CudaPairs())
  {
    if (FeaturesOfDefines(pair.Defines) == features)
    {
      return &pair;
    }
  }
  return nullptr;
}
}

class CudaText : public ::testing::TestWithParam<ConformanceScene>
{
};

void ExpectSamePictures(const ConformanceScene& scene, const Variant& variant)
{
  const auto image = scene.Image();
  ASSERT_TRUE(image);
  RenderScene render("single-pass", image, scene.Property());
  render.Window->SetSize(Size, Size);
  scene.Arrange(render);
  render.Mapper->SetRaySetUp(0);
  render.Mapper->SetStepVoxels(scene.StepVoxels);
  variant.Change(render);
  const Scene built = BuildScene(render, image);
  const FeatureSet features = FeaturesNeededBy(built);
  const CudaPair* pair = PairOf(features);
  ASSERT_TRUE(pair) << "add to Testing/Cuda/CMakeLists.txt: " << DefinesOfFeatures(features);
  const HostScene host(built, features);
  const Picture cuda = pair->Cuda(host);
  EXPECT_EQ(cuda, pair->Cpp(host)) << variant.Name;
  double sum = 0.0;
  for (const glm::vec4& pixel : cuda)
  {
    ASSERT_TRUE(pixel.w >= 0.0f && pixel.w <= 1.00001f) << variant.Name;
    sum += pixel.w;
  }
  EXPECT_GT(sum, 1.0) << variant.Name << " shows nothing";
}

TEST_P(CudaText, DrawsWhatTheCppDialectDraws)
{
  ExpectSamePictures(GetParam(), { "as it is", [](RenderScene&) {} });
}

TEST(CudaTextVariants, DrawWhatTheCppDialectDraws)
{
  for (const Variant& variant : Variants())
  {
    SCOPED_TRACE(variant.Name);
    ExpectSamePictures(ScenesOfViews().front(), variant);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CudaText, ::testing::ValuesIn(AllScenes()),
  [](const auto& info) { return info.param.Name; });
