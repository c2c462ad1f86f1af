// A volume that the device does not take at once: its picture in bricks is that of the whole.
#include "ConformanceScene.h"
#include "EveryTechnique.h"
#include "SceneChanges.h"

#include "Error/ImageError.h"
#include "Techniques/Technique.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtk_glew.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Mebibyte = 1024.0 * 1024.0;
constexpr int Dims[3] = { 49, 41, 33 };

// Two hills with nothing between them.
double TwoHills(double i, double j, double k)
{
  const double near = std::hypot(i - 10.0, j - 12.0, k - 22.0);
  const double far = std::hypot(i - 36.0, j - 27.0, k - 12.0);
  return std::max(0.0, 1.0 - std::min(near / 12.0, far / 14.0)) * (1.0 + 0.2 * std::sin(i + k));
}

vtkSmartPointer<vtkImageData> HillsWithHoles()
{
  auto image = MakeImage(Dims[0], Dims[1], Dims[2], TwoHills, VTK_FLOAT);
  for (const vtkIdType hole : { 12 + 49 * (12 + 41 * 20), 30 + 49 * (25 + 41 * 12), 16 })
  {
    image->GetPointData()->GetArray("field")->SetTuple1(hole, vtkMath::Nan());
  }
  return image;
}

struct Variation
{
  std::string Name;
  SceneChange Arrange;
  std::function<vtkSmartPointer<vtkImageData>()> Image = []
  { return MakeImage(Dims[0], Dims[1], Dims[2], TwoHills, VTK_FLOAT); };
  double Most = 1e-4; // by which a channel of a pixel may differ
};

Variation WithIntegrator(int integrator, double step, bool jitter)
{
  return { IntegratorText(integrator, jitter), SampledBy(integrator, step, jitter) };
}

Variation WithBlendMode(int mode)
{
  return { "blend mode " + std::to_string(mode),
    [=](RenderScene& scene) { scene.Mapper->SetBlendMode(mode); } };
}

// Rays of pixels along a face of two bricks: texel 24 begins there, half a voxel before its middle.
void LookAlongAFace(RenderScene& scene)
{
  scene.LookAlongZ(16.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(23.75, 19.75, 16.0);
  scene.Renderer->GetActiveCamera()->SetPosition(23.75, 19.75, 90.0);
  scene.Renderer->ResetCameraClippingRange();
}

void HideByASphere(RenderScene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(30.0, 22.0, 20.0);
  sphere->SetRadius(9.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

void CutAndCrop(RenderScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(14.0, 10.0, 10.0);
  plane->SetNormal(0.9, 0.3, -0.2);
  scene.Mapper->AddClippingPlane(plane);
  scene.Mapper->SetCropping(1);
  scene.Mapper->SetCroppingRegionPlanes(12.0, 37.5, 9.0, 30.0, 5.0, 25.0);
  scene.Mapper->SetCroppingRegionFlagsToFence();
}

vtkSmartPointer<vtkImageData> HillsOfCells()
{
  auto points = MakeImage(Dims[0] - 1, Dims[1] - 1, Dims[2] - 1, TwoHills, VTK_FLOAT);
  auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(Dims);
  cells->SetSpacing(1.0, 1.3, 0.8);
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  return cells;
}

std::vector<Variation> SamplingVariations()
{
  return { WithIntegrator(0, 0.37, true), WithIntegrator(1, 3.0, false),
    WithIntegrator(2, 1.7, false), WithIntegrator(2, 0.8, true), WithIntegrator(3, 1.7, true),
    { "no skipping",
      [](RenderScene& scene)
      {
        scene.Mapper->SetSkipping(false);
        scene.Mapper->SetRaySetUp(0);
      } } };
}

std::vector<Variation> SceneVariations()
{
  return { { "from inside", LookFromInside }, { "along a face", LookAlongAFace },
    { "lit", ShadeByGradients }, { "hidden", HideByASphere }, { "cut", CutAndCrop },
    { "NaN", [](RenderScene& scene) { scene.Mapper->SetIntegrator(2); }, HillsWithHoles },
    { "cells",
      [](RenderScene& scene) { scene.Volume->GetProperty()->SetInterpolationTypeToNearest(); },
      HillsOfCells } };
}

std::vector<Variation> BlendVariations()
{
  return { WithBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND),
    WithBlendMode(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND),
    WithBlendMode(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND),
    WithBlendMode(vtkVolumeBenchMapper::GRADIENT_BLEND) };
}

double Apart(const FloatPicture& a, const FloatPicture& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.Pixels.size(); ++i)
  {
    most = std::max(most, std::abs(static_cast<double>(a.Pixels[i]) - b.Pixels[i]));
  }
  return most;
}

bool IsInBricks(const RenderScene& scene)
{
  return (" " + scene.Mapper->GetFeatures() + " ").find(" bricks ") != std::string::npos;
}

constexpr double VolumeBytes = 4.0 * Dims[0] * Dims[1] * Dims[2];

// Half of the volume, of which bricks are a quarter: most stay, some are sent for every picture.
constexpr double TightBudgetMiB = 0.5 * VolumeBytes / Mebibyte;
}

class Bricks : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "reads the volume where it is";
    }
  }

  void ExpectTheWhole(const std::vector<Variation>& variations)
  {
    for (const Variation& variation : variations)
    {
      RenderScene scene(GetParam(), variation.Image(), HillsProperty());
      scene.Mapper->SetWorkGroupShape("8x8"); // which is best would be found by trying
      variation.Arrange(scene);
      scene.Mapper->SetSliceOrder(variations.size() % 2); // both are drawn front to back by bricks
      const FloatPicture whole = scene.Picture();
      ASSERT_EQ(scene.Mapper->GetFailure(), "");
      ASSERT_FALSE(IsInBricks(scene));
      scene.Mapper->SetMemoryBudgetMiB(TightBudgetMiB);
      const FloatPicture inBricks = scene.Picture();
      ASSERT_EQ(scene.Mapper->GetFailure(), "") << variation.Name;
      ASSERT_TRUE(IsInBricks(scene)) << variation.Name;
      EXPECT_LE(Apart(inBricks, whole), variation.Most) << variation.Name;
      EXPECT_GT(Apart(whole, FloatPicture{ 0, 0, std::vector<float>(whole.Pixels.size()) }), 0.02)
        << variation.Name << " shows nothing";
      EXPECT_EQ(scene.Picture().Pixels, inBricks.Pixels) << variation.Name << ", drawn again";
    }
  }
};

TEST_P(Bricks, LookLikeTheWholeWithEveryIntegrator)
{
  this->ExpectTheWhole(SamplingVariations());
}

TEST_P(Bricks, LookLikeTheWholeInEveryScene)
{
  this->ExpectTheWhole(SceneVariations());
}

TEST_P(Bricks, LookLikeTheWholeInEveryBlendMode)
{
  this->ExpectTheWhole(BlendVariations());
}

TEST_P(Bricks, KeepTheErrorTarget)
{
  auto image = MakeImage(Dims[0], Dims[1], Dims[2], TwoHills, VTK_FLOAT);
  RenderScene exact("reference", image, HillsProperty());
  RenderScene scene(GetParam(), image, HillsProperty());
  constexpr double Target = 1e-3;
  scene.Mapper->SetErrorTarget(Target);
  scene.Mapper->SetMemoryBudgetMiB(TightBudgetMiB);
  const FloatPicture picture = scene.Picture();
  ASSERT_EQ(scene.Mapper->GetFailure(), "");
  ASSERT_TRUE(IsInBricks(scene));
  EXPECT_LE(CompareImages(picture, exact.Picture()).Rmse, Target);
}

TEST_P(Bricks, CountEverySampleOnce)
{
  RenderScene scene(
    GetParam(), MakeImage(Dims[0], Dims[1], Dims[2], TwoHills, VTK_FLOAT), HillsProperty());
  scene.Mapper->SetSkipping(false);
  scene.Mapper->SetCountSamples(true);
  const FloatPicture whole = scene.Picture();
  scene.Mapper->SetMemoryBudgetMiB(TightBudgetMiB);
  const FloatPicture inBricks = scene.Picture();
  ASSERT_TRUE(IsInBricks(scene));
  double most = 0.0;
  for (std::size_t i = 0; i < whole.Pixels.size(); i += 4) // red: samples taken
  {
    most = std::max<double>(most, std::abs(whole.Pixels[i] - inBricks.Pixels[i]));
  }
  EXPECT_EQ(most, 0.0);
}

TEST_P(Bricks, TakeNoMoreThanTheBudgetAndNothingForEmptySpace)
{
  // One hill in a corner: of the bricks round it none is sent.
  auto image = MakeImage(
    Dims[0], Dims[1], Dims[2],
    [](double i, double j, double k) { return std::max(0.0, 1.0 - std::hypot(i, j, k) / 8.0); },
    VTK_FLOAT);
  RenderScene scene(GetParam(), image, HillsProperty());
  scene.Picture();
  const double whole = static_cast<double>(scene.Mapper->GetSetUpCosts().BytesOnDevice);
  scene.Mapper->SetMemoryBudgetMiB(0.9 * VolumeBytes / Mebibyte);
  scene.Picture();
  ASSERT_TRUE(IsInBricks(scene));
  const double corner = static_cast<double>(scene.Mapper->GetSetUpCosts().BytesOnDevice);
  // Beside the voxels there is now the picture that the bricks make.
  constexpr double PictureBytes = 16.0 * RenderScene::Size * RenderScene::Size;
  EXPECT_LT(corner - PictureBytes, whole - 0.4 * VolumeBytes);

  scene.Mapper->SetSkipping(false);
  scene.Picture();
  const double all = static_cast<double>(scene.Mapper->GetSetUpCosts().BytesOnDevice);
  EXPECT_GT(all, corner);
  EXPECT_LT(all - PictureBytes, whole + 0.1 * VolumeBytes);
}

TEST_P(Bricks, TooLargeForTheBudgetAreRefusedWithTheBytes)
{
  RenderScene scene(
    GetParam(), MakeImage(Dims[0], Dims[1], Dims[2], TwoHills, VTK_FLOAT), HillsProperty());
  scene.Mapper->GlobalWarningDisplayOff();
  scene.Mapper->SetMemoryBudgetMiB(1.0 / 1024.0);
  const FloatPicture nothing = scene.Picture();
  scene.Mapper->GlobalWarningDisplayOn();
  EXPECT_EQ(*std::max_element(nothing.Pixels.begin(), nothing.Pixels.end()), 0.0f);
  const std::string failure = scene.Mapper->GetFailure();
  EXPECT_NE(failure.find("needs " + std::to_string(static_cast<int>(VolumeBytes)) + " bytes"),
    std::string::npos)
    << failure;
  EXPECT_NE(failure.find("the memory budget is 1024 bytes"), std::string::npos) << failure;
  scene.Mapper->SetMemoryBudgetMiB(0.0);
  scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
}

TEST_P(Bricks, DrawAVolumeThatIsLongerThanTexturesMayBe)
{
  GLint longest = 0;
  {
    RenderScene any(GetParam(), MakeImage(3, 3, 3, TwoHills, VTK_FLOAT), HillsProperty());
    any.Window->Render();
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longest);
  }
  auto image = MakeImage(
    longest + 100, 9, 9,
    [](double i, double j, double k)
    { return 0.5 + 0.4 * std::sin(0.3 * i + 0.5 * j) * std::cos(0.4 * k + 0.01 * i); },
    VTK_FLOAT);
  const double thickness = longest / 10.0;
  image->SetSpacing(1.0, thickness, thickness);
  RenderScene exact("reference", image, HillsProperty(0.25 / thickness));
  RenderScene scene(GetParam(), image, HillsProperty(0.25 / thickness));
  const FloatPicture picture = scene.Picture();
  ASSERT_EQ(scene.Mapper->GetFailure(), "");
  EXPECT_EQ(IsInBricks(scene), GetParam() != "opencl" && GetParam() != "cuda");
  EXPECT_LE(CompareImages(picture, exact.Picture()).Rmse, 2e-3);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Bricks);
