// Lost contexts, changed windows, changed data, and a GL state that is left as found.
#include "EveryTechnique.h"
#include "Error/ImageError.h"
#include "StateChecker.h"

#include "vtkOpenGLRenderWindow.h"

using namespace volumebench;
using namespace volumebench::test;

class Windows : public EveryTechnique
{
};

TEST_P(Windows, GlStateIsLeftAsFound)
{
  for (const int setUp : { 0, 1 })
  {
    RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
    vtkNew<StateChecker> mapper;
    mapper->SetTechnique(GetParam().c_str());
    mapper->SetRaySetUp(setUp);
    mapper->SetInputData(MakeImage(12, 10, 8, Bumpy));
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    ASSERT_FALSE(mapper->Before.empty());
    EXPECT_EQ(mapper->Before, mapper->After);
    EXPECT_EQ(mapper->Error, static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST_P(Windows, GlStateIsLeftAsFoundByEveryModeAndTarget)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  vtkNew<StateChecker> mapper;
  mapper->SetTechnique(GetParam().c_str());
  mapper->SetInputData(MakeImage(12, 10, 8, Bumpy));
  scene.Volume->SetMapper(mapper);
  const auto check = [&](const std::string& what)
  {
    scene.Window->Render();
    EXPECT_EQ(mapper->Before, mapper->After) << what;
    EXPECT_EQ(mapper->Error, static_cast<GLenum>(GL_NO_ERROR)) << what;
    EXPECT_EQ(mapper->GetFailure(), "") << what;
  };
  for (const int mode : std::array<int, 5>{ vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
         vtkVolumeBenchMapper::GRADIENT_BLEND, vtkVolumeMapper::COMPOSITE_BLEND })
  {
    mapper->SetBlendMode(mode);
    check("blend mode " + std::to_string(mode));
  }
  for (const int order : { 0, 1 })
  {
    for (const int target : { 1, 2, 0 })
    {
      mapper->SetSliceOrder(order);
      mapper->SetSliceTarget(target);
      check("order " + std::to_string(order) + " target " + std::to_string(target));
    }
  }
  mapper->CountSamplesOn();
  check("counting");
  mapper->CountSamplesOff();
  mapper->TimeStagesOn();
  check("timing");
}

TEST_P(Windows, ContextLossIsSurvived)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture before = scene.Picture();
  scene.Window->Finalize();
  const FloatPicture after = scene.Picture();
  EXPECT_EQ(before.Pixels, after.Pixels);
}

TEST_P(Windows, MapperMovesToAnotherWindow)
{
  RenderScene first(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture before = first.Picture();
  RenderScene second(GetParam(), MakeImage(3, 3, 3, Bumpy), BumpyProperty());
  second.Volume->SetMapper(first.Mapper);
  second.Renderer->SetActiveCamera(first.Renderer->GetActiveCamera());
  const FloatPicture there = second.Picture();
  const FloatPicture back = first.Picture();
  EXPECT_EQ(before.Pixels, there.Pixels);
  EXPECT_EQ(before.Pixels, back.Pixels);
}

TEST_P(Windows, MapperOutlivesItsWindow)
{
  vtkNew<vtkVolumeBenchMapper> mapper;
  FloatPicture before;
  auto image = MakeImage(12, 10, 8, Bumpy);
  for (int window = 0; window < 2; ++window)
  {
    RenderScene scene(GetParam(), image, BumpyProperty());
    mapper->SetTechnique(GetParam().c_str());
    mapper->SetInputData(image);
    scene.Volume->SetMapper(mapper);
    const FloatPicture picture = scene.Picture();
    if (window > 0)
    {
      EXPECT_EQ(before.Pixels, picture.Pixels);
    }
    before = picture;
  }
}

TEST_P(Windows, ChangedDataAndFunctionsAreDrawn)
{
  auto image = MakeImage(5, 5, 5, [](double, double, double) { return 1.0; });
  auto property = MakeLinearExtinctionProperty(0.1, 0.0, 4.0);
  RenderScene scene(GetParam(), image, property);
  const double box[6] = { 0, 4, 0, 4, 0, 4 };
  const double length = RayOfPixel(scene.Renderer, box, 32, 32, RenderScene::Size).Length();
  const auto depth = [&] { return -std::log1p(-PixelAt(scene.Picture(), 32, 32).Alpha); };
  EXPECT_NEAR(depth(), 0.1 * length, 1e-4);
  image->GetPointData()->GetScalars()->Fill(3.0);
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_NEAR(depth(), 0.3 * length, 1e-4);
  property->SetScalarOpacityUnitDistance(2.0);
  EXPECT_NEAR(depth(), 0.15 * length, 1e-4);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  property->GetScalarOpacity()->AddPoint(4.0, 0.0);
  EXPECT_EQ(PixelAt(scene.Picture(), 32, 32).Alpha, 0.0f);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Windows);
