// Pictures of transfer functions of a few straight pieces, which kernels compute, against those that
// they look up in a table, for every technique.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "vtkPlane.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// Its entries lie on the knots of all functions here, where a table has no error.
constexpr int FineTable = 4097;

// Nowhere transparent: of so many straight pieces between 0 and 1.
vtkSmartPointer<vtkVolumeProperty> Pieces(int pieces, double opacity)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkPiecewiseFunction> opacities;
  vtkNew<vtkColorTransferFunction> colors;
  for (int i = 0; i <= pieces; ++i)
  {
    const double share = static_cast<double>(i) / pieces;
    opacities->AddPoint(share, i % 2 == 0 ? 0.2 * opacity : opacity);
    colors->AddRGBPoint(share, 0.2 + 0.15 * i, i % 2 == 0 ? 0.9 : 0.1, 0.8 - 0.2 * i);
  }
  property->SetScalarOpacity(opacities);
  property->SetColor(colors);
  property->SetInterpolationTypeToLinear();
  return property;
}

bool Lists(const RenderScene& scene, const std::string& feature)
{
  return (" " + scene.Mapper->GetFeatures() + " ").find(" " + feature + " ") != std::string::npos;
}

// Slices read the table once for a fragment, and CUDA's kernels were never measured with ramps.
bool HasRamps(const std::string& technique)
{
  return HasSteps(technique) && !IsSliced(technique) && technique != "cuda";
}

class RampPictures : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "the exact technique has no tables";
    }
  }

  static std::unique_ptr<RenderScene> Make(vtkImageData* image, vtkVolumeProperty* property)
  {
    auto scene = std::make_unique<RenderScene>(GetParam(), image, property);
    scene->Mapper->SetIntegrator(1);
    scene->Mapper->SetOpenClStorage(1); // images, which have no rays side by side
    return scene;
  }

  static void ExpectSame(RenderScene& scene, int pieces, const std::string& what)
  {
    scene.Mapper->SetTableSize(0);
    const FloatPicture computed = scene.Picture();
    ASSERT_EQ(scene.Mapper->GetFailure(), "") << what;
    EXPECT_EQ(Lists(scene, "ramps"), HasRamps(GetParam())) << what;
    EXPECT_EQ(Lists(scene, "more-ramps"), HasRamps(GetParam()) && pieces > 2) << what;
    if (!HasRamps(GetParam()))
    {
      return; // both pictures are from tables, of which one misses the knots
    }
    scene.Mapper->SetTableSize(FineTable);
    const FloatPicture lookedUp = scene.Picture();
    EXPECT_FALSE(Lists(scene, "ramps")) << what;
    double worst = 0.0;
    for (std::size_t i = 0; i < lookedUp.Pixels.size(); ++i)
    {
      worst =
        std::max(worst, std::abs(static_cast<double>(computed.Pixels[i]) - lookedUp.Pixels[i]));
    }
    EXPECT_LE(worst, 1e-6) << what;
    EXPECT_GT(*std::max_element(lookedUp.Pixels.begin(), lookedUp.Pixels.end()), 0.05f) << what;
  }
};

vtkSmartPointer<vtkImageData> Waves(double spacingZ = 1.0)
{
  const auto image = MakeImage(
    21, 19, 17,
    [](double i, double j, double k)
    { return 0.5 + 0.5 * std::sin(0.4 * i) * std::cos(0.3 * j + 0.2 * k); },
    VTK_FLOAT);
  // The whole domain, so that the table's entries lie where FineTable says.
  vtkDataArray* values = image->GetPointData()->GetScalars();
  values->SetTuple1(0, 0.0);
  values->SetTuple1(1, 1.0);
  image->SetSpacing(1.0, 1.0, spacingZ);
  return image;
}
}

TEST_P(RampPictures, AreThoseOfTheTable)
{
  for (const int pieces : { 1, 2, 4 })
  {
    const auto scene = Make(Waves(), Pieces(pieces, 0.06));
    for (const int integrator : { 0, 1 })
    {
      for (const double step : { 0.37, 1.7 })
      {
        scene->Mapper->SetIntegrator(integrator);
        scene->Mapper->SetStepVoxels(step);
        ExpectSame(*scene, pieces,
          std::to_string(pieces) + " pieces, integrator " + std::to_string(integrator) + ", step " +
            std::to_string(step));
      }
    }
  }
}

TEST_P(RampPictures, HaveAllThatOtherPicturesHave)
{
  const auto property = Pieces(4, 0.06);
  const auto scene = Make(Waves(), property);
  property->ShadeOn();
  ExpectSame(*scene, 4, "shaded");
  property->ShadeOff();
  scene->Mapper->JitterOn();
  ExpectSame(*scene, 4, "jitter");
  scene->Mapper->JitterOff();
  scene->Mapper->SetTerminationThreshold(0.7);
  ExpectSame(*scene, 4, "rays that stop early");
  scene->Mapper->SetTerminationThreshold(0.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(10.0, 9.0, 8.0);
  plane->SetNormal(1.0, 0.5, -0.3);
  scene->Mapper->AddClippingPlane(plane);
  ExpectSame(*scene, 4, "clip plane");
  scene->Mapper->RemoveAllClippingPlanes();
  vtkCamera* camera = scene->Renderer->GetActiveCamera();
  camera->SetPosition(6.0, 9.0, 8.0);
  camera->SetFocalPoint(15.0, 10.0, 9.0);
  camera->SetClippingRange(0.1, 50.0);
  ExpectSame(*scene, 4, "the eye in the volume");
}

TEST_P(RampPictures, OfVoxelsThatAreNotCubes)
{
  const auto scene = Make(Waves(1.6), Pieces(2, 0.04));
  scene->Mapper->SetStepVoxels(0.6);
  ExpectSame(*scene, 2, "slices 1.6 apart");
  scene->LookFrom(0.1, 0.2, 1.0);
  ExpectSame(*scene, 2, "along them");
}

TEST_P(RampPictures, LeaveOutWhatIsHidden)
{
  const auto image = Waves();
  for (int i = 3000; i < 3040; ++i)
  {
    image->GetPointData()->GetScalars()->SetTuple1(i, std::nan(""));
  }
  const auto scene = Make(image, Pieces(2, 0.06));
  ExpectSame(*scene, 2, "hidden voxels");
}

// An edit that changes the form of the table, and one back: what is on the device follows.
TEST_P(RampPictures, FollowEditsToAndFro)
{
  const auto property = Pieces(2, 0.06);
  const auto scene = Make(Waves(), property);
  const FloatPicture before = scene->Picture();
  property->GetScalarOpacity()->AddPoint(0.52, 0.9);
  scene->Picture();
  EXPECT_FALSE(Lists(*scene, "ramps")) << "no longer thin, nor few pieces";
  property->GetScalarOpacity()->RemovePoint(0.52);
  EXPECT_EQ(scene->Picture().Pixels, before.Pixels);
  property->GetRGBTransferFunction()->AddRGBPoint(0.5, 1.0, 1.0, 1.0);
  const FloatPicture white = scene->Picture();
  EXPECT_NE(white.Pixels, before.Pixels);
  EXPECT_EQ(Lists(*scene, "ramps"), HasRamps(GetParam()));
}

// What the function is drawn by changes while the function does not.
TEST_P(RampPictures, GiveWayToTheTableAndComeBack)
{
  const auto property = Pieces(2, 0.06);
  const auto scene = Make(Waves(), property);
  const FloatPicture before = scene->Picture();
  scene->Mapper->SetStepVoxels(12.0);
  const FloatPicture coarse = scene->Picture();
  EXPECT_FALSE(Lists(*scene, "ramps")) << "steps are not thin";
  const auto fresh = Make(Waves(), property);
  fresh->Mapper->SetStepVoxels(12.0);
  EXPECT_EQ(fresh->Picture().Pixels, coarse.Pixels);
  scene->Mapper->SetStepVoxels(0.37);
  EXPECT_EQ(scene->Picture().Pixels, before.Pixels);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(RampPictures);
