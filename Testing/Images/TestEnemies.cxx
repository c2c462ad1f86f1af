// Input that invites a crash, a hang or a NaN: each must give a clean picture, an empty one, or one
// clear sentence that says what is wrong.
#include "EveryTechnique.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPlane.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_glew.h"

#include <limits>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Mode
{
  const char* Name;
  int BlendMode;
  int Integrator;
};

constexpr Mode Modes[] = { { "Composite", vtkVolumeMapper::COMPOSITE_BLEND, 1 },
  { "PreIntegrated", vtkVolumeMapper::COMPOSITE_BLEND, 3 },
  { "Maximum", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, 1 },
  { "Minimum", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, 1 },
  { "Average", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, 1 },
  { "Gradient", vtkVolumeBenchMapper::GRADIENT_BLEND, 1 } };

double One(double, double, double)
{
  return 1.0;
}

// Largest alpha of a picture all of whose pixels are colours: finite and within 0 to 1.
double LargestAlpha(RenderScene& scene)
{
  const FloatPicture picture = scene.Picture();
  scene.Window->MakeCurrent();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  float largest = 0.0f;
  int wrong = 0;
  for (std::size_t i = 0; i < picture.Pixels.size(); ++i)
  {
    const float value = picture.Pixels[i];
    wrong += !(value >= 0.0f && value <= 1.0f + 1e-6f);
    largest = i % 4 == 3 ? std::max(largest, value) : largest;
  }
  EXPECT_EQ(wrong, 0) << "values that are no colours";
  return largest;
}

class Quiet
{
public:
  Quiet() { vtkObject::GlobalWarningDisplayOff(); }
  ~Quiet() { vtkObject::GlobalWarningDisplayOn(); }
};
}

class Enemies : public EveryTechnique
{
protected:
  // Draws the image in every mode; `check` is told the mode's name and the largest alpha.
  void InEveryMode(
    vtkImageData* image, vtkVolumeProperty* property,
    const std::function<void(RenderScene&, const Mode&)>& check,
    const std::function<void(RenderScene&)>& arrange = [](RenderScene&) {})
  {
    RenderScene scene(GetParam(), image, property);
    arrange(scene);
    for (const Mode& mode : Modes)
    {
      SCOPED_TRACE(mode.Name);
      scene.Mapper->SetBlendMode(mode.BlendMode);
      scene.Mapper->SetIntegrator(mode.Integrator);
      check(scene, mode);
    }
  }
};

TEST_P(Enemies, OneVoxelThickInEveryForm)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    int points[3] = { 5, 5, 5 };
    points[axis] = 2;
    auto image = MakeImage(points[0], points[1], points[2], One);
    vtkNew<vtkDoubleArray> cells;
    cells->SetName("cells");
    cells->SetNumberOfTuples(image->GetNumberOfCells());
    cells->Fill(1.0);
    image->GetCellData()->AddArray(cells);
    for (const bool cellData : { axis == 1, axis != 2 })
    {
      SCOPED_TRACE("axis " + std::to_string(axis) + " cell data " + std::to_string(cellData));
      this->InEveryMode(
        image, MakeConstantProperty(0.5),
        [](RenderScene& scene, const Mode& mode)
        {
          const double alpha = LargestAlpha(scene);
          EXPECT_EQ(scene.Mapper->GetFailure(), "");
          const bool gradient = mode.BlendMode == vtkVolumeBenchMapper::GRADIENT_BLEND;
          EXPECT_EQ(alpha > 0.1, !gradient);
        },
        [&](RenderScene& scene)
        {
          if (cellData)
          {
            scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
            scene.Mapper->SelectScalarArray("cells");
          }
        });
    }
  }
}

TEST_P(Enemies, OnePointThickIsRefusedAndSaysSo)
{
  const Quiet quiet;
  for (int axis = 0; axis < 3; ++axis)
  {
    int points[3] = { 5, 5, 5 };
    points[axis] = 1;
    RenderScene scene(
      GetParam(), MakeImage(points[0], points[1], points[2], One), MakeConstantProperty(0.5));
    EXPECT_EQ(LargestAlpha(scene), 0.0);
    EXPECT_NE(scene.Mapper->GetFailure().find("one point thick"), std::string::npos);
  }
}

TEST_P(Enemies, AllCellsHidden)
{
  auto image = MakeImage(6, 6, 6, Bumpy);
  image->AllocateCellGhostArray()->Fill(vtkDataSetAttributes::HIDDENCELL);
  this->InEveryMode(image, BumpyProperty(),
    [](RenderScene& scene, const Mode&)
    {
      EXPECT_EQ(LargestAlpha(scene), 0.0);
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    });
}

TEST_P(Enemies, CroppingToNothing)
{
  this->InEveryMode(
    MakeImage(6, 6, 6, Bumpy), BumpyProperty(),
    [](RenderScene& scene, const Mode&)
    {
      EXPECT_EQ(LargestAlpha(scene), 0.0);
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    },
    [](RenderScene& scene)
    {
      scene.Mapper->CroppingOn();
      scene.Mapper->SetCroppingRegionPlanes(1.0, 3.0, 1.0, 3.0, 1.0, 3.0);
      scene.Mapper->SetCroppingRegionFlags(0);
    });
}

TEST_P(Enemies, CropBoxesWithoutThickness)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, One), MakeConstantProperty(0.2));
  scene.LookAlongZ(5.0);
  scene.Mapper->SetStepVoxels(0.25);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.0, 8.0, 0.0, 8.0, 3.0, 3.0);
  EXPECT_EQ(LargestAlpha(scene), 0.0);
  // Regions of thickness 0 hold nothing, and those on either side keep their place.
  scene.Mapper->SetCroppingRegionFlags(0777); // all that is below the planes of z
  EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-0.2 * 3.0), 1e-4);
  scene.Mapper->SetCroppingRegionFlags(0777 << 18);
  EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-0.2 * 5.0), 1e-4);
}

TEST_P(Enemies, ClipPlaneThatLeavesNothing)
{
  this->InEveryMode(
    MakeImage(6, 6, 6, Bumpy), BumpyProperty(),
    [](RenderScene& scene, const Mode&) { EXPECT_EQ(LargestAlpha(scene), 0.0); },
    [](RenderScene& scene)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.0, 0.0, 100.0);
      plane->SetNormal(0.0, 0.0, 1.0);
      scene.Mapper->AddClippingPlane(plane);
    });
}

TEST_P(Enemies, ClipPlaneWithoutANormal)
{
  RenderScene scene(GetParam(), MakeImage(6, 6, 6, One), MakeConstantProperty(0.2));
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  EXPECT_GT(LargestAlpha(scene), 0.1);
}

TEST_P(Enemies, SmallestWindows)
{
  RenderScene scene(GetParam(), MakeImage(6, 6, 6, Bumpy), BumpyProperty());
  for (const auto& [width, height] : { std::pair{ 1, 1 }, { 1, 64 }, { 64, 1 }, { 3, 2 } })
  {
    scene.Window->SetSize(width, height);
    EXPECT_GE(LargestAlpha(scene), 0.0);
    EXPECT_EQ(scene.Mapper->GetFailure(), "") << width << " x " << height;
  }
  scene.Window->SetSize(64, 64);
  EXPECT_GT(LargestAlpha(scene), 0.1);
}

TEST_P(Enemies, ViewportsWithoutPixels)
{
  RenderScene scene(GetParam(), MakeImage(6, 6, 6, Bumpy), BumpyProperty());
  vtkNew<vtkRenderer> whole;
  scene.Window->AddRenderer(whole);
  for (const double width : { 0.0, 1e-4 })
  {
    scene.Renderer->SetViewport(0.5, 0.0, 0.5 + width, 1.0);
    scene.Window->Render();
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
  }
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  EXPECT_GT(LargestAlpha(scene), 0.1);
}

TEST_P(Enemies, ConstantFields)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    for (const double value : { 0.0, 1.0 })
    {
      this->InEveryMode(MakeImage(
                          6, 6, 6, [=](double, double, double) { return value; }, type),
        MakeConstantProperty(0.5),
        [](RenderScene& scene, const Mode& mode)
        {
          const bool gradient = mode.BlendMode == vtkVolumeBenchMapper::GRADIENT_BLEND;
          EXPECT_EQ(LargestAlpha(scene) > 0.1, !gradient);
        });
    }
  }
}

TEST_P(Enemies, ValuesThatAreNotFinite)
{
  // Mostly NaN with infinities of both signs between; two layers are sound.
  const auto spoilt = [](double i, double j, double k)
  {
    const double bad[] = { std::nan(""), Infinity, -Infinity };
    return k < 2 ? Bumpy(i, j, k) : bad[static_cast<int>(i + 2 * j + k) % 3];
  };
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    this->InEveryMode(MakeImage(8, 8, 8, spoilt, type), BumpyProperty(),
      [](RenderScene& scene, const Mode&)
      {
        EXPECT_GT(LargestAlpha(scene), 1e-3);
        EXPECT_EQ(scene.Mapper->GetFailure(), "");
      });
  }
}

TEST_P(Enemies, MagnitudesThatOverflowAreHidden)
{
  auto image = MakeImage(8, 8, 8, One);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < 512; ++i)
  {
    const double value = i == 200 ? 1e300 : 0.5; // finite, but not so its square
    vectors->InsertNextTuple3(value, value, value);
  }
  image->GetPointData()->SetScalars(vectors);
  RenderScene scene(GetParam(), image, MakeConstantProperty(0.2));
  scene.Mapper->SetVectorMode(vtkVolumeBenchMapper::Magnitude);
  scene.Mapper->SetStepVoxels(0.25);
  scene.LookAlongZ(5.0);
  EXPECT_NEAR(LargestAlpha(scene), -std::expm1(-0.2 * 7.0), 1e-4);
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  // Point 200 is (0, 1, 3): the cells round it are missing.
  const FloatPicture picture = scene.Picture();
  int missing = 0;
  for (int pixel = 0; pixel < 64; ++pixel)
  {
    missing += std::abs(PixelAt(picture, 12, pixel).Alpha - -std::expm1(-0.2 * 5.0)) < 1e-4;
  }
  EXPECT_NEAR(missing, 2.0 * 6.4, 1.0);
}

TEST_P(Enemies, RangesAsWideAsDoublesAre)
{
  const double huge = std::numeric_limits<double>::max();
  auto image = MakeImage(
    5, 5, 5, [=](double i, double, double) { return (0.5 * i - 1.0) * huge; }, VTK_DOUBLE);
  this->InEveryMode(image, MakeConstantProperty(0.2),
    [](RenderScene& scene, const Mode&)
    {
      EXPECT_GT(LargestAlpha(scene), 0.01);
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    });
}

TEST_P(Enemies, OpaqueEverywhere)
{
  auto property = MakeConstantProperty(1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 1.0);
  opacity->AddPoint(4.0, 1.0);
  property->SetScalarOpacity(opacity);
  this->InEveryMode(MakeImage(6, 6, 6, Bumpy), property,
    [](RenderScene& scene, const Mode&)
    {
      EXPECT_NEAR(LargestAlpha(scene), 1.0, 1e-3);
      scene.Mapper->SetTerminationThreshold(0.001);
      EXPECT_NEAR(LargestAlpha(scene), 1.0, 2e-3);
      scene.Mapper->SetTerminationThreshold(0.0);
    });
}

TEST_P(Enemies, TransparentEverywhere)
{
  this->InEveryMode(MakeImage(6, 6, 6, Bumpy), MakeConstantProperty(0.0),
    [](RenderScene& scene, const Mode&)
    {
      EXPECT_EQ(LargestAlpha(scene), 0.0);
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    });
}

TEST_P(Enemies, OpacitiesOutsideZeroToOne)
{
  auto property = MakeConstantProperty(1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, -3.0);
  opacity->AddPoint(4.0, 7.0);
  property->SetScalarOpacity(opacity);
  this->InEveryMode(MakeImage(6, 6, 6, Bumpy), property,
    [](RenderScene& scene, const Mode&) { LargestAlpha(scene); });
}

TEST_P(Enemies, LightsInAwkwardPlaces)
{
  // Damped and shaded fields with edges, with a gradient opacity that is one point wide.
  auto property = BumpyProperty();
  property->ShadeOn();
  property->SetSpecular(1.0);
  property->SetSpecularPower(1000.0);
  vtkNew<vtkPiecewiseFunction> factor;
  factor->AddPoint(0.5, 0.7);
  property->SetGradientOpacity(factor);
  this->InEveryMode(
    MakeImage(6, 6, 6, Bumpy), property,
    [](RenderScene& scene, const Mode&)
    {
      EXPECT_GT(LargestAlpha(scene), 0.01);
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    },
    [](RenderScene& scene) { scene.Mapper->SetLightingDamping(1e-12); });
}

TEST_P(Enemies, StepsFromTheSmallestToTheLargest)
{
  const Quiet quiet;
  RenderScene scene(GetParam(), MakeImage(4, 4, 4, One), MakeConstantProperty(0.5));
  scene.LookAlongZ(2.5);
  const double alpha = -std::expm1(-0.5 * 3.0);
  for (const double step : { 1.0 / 1024.0, 1e3, 1e30 })
  {
    scene.Mapper->SetStepVoxels(step);
    EXPECT_NEAR(LargestAlpha(scene), alpha, 1e-4) << "step " << step;
  }
  for (const double step : { 1e-4, -1.0, Infinity })
  {
    scene.Mapper->SetStepVoxels(step);
    EXPECT_EQ(LargestAlpha(scene), 0.0);
    EXPECT_NE(scene.Mapper->GetFailure().find("the step is"), std::string::npos);
  }
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Enemies);
