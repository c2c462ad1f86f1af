// The cell-exact reference against the midpoint one, which shares no loop with it, over random
// small volumes and every feature that a scene may have.
#include "EngineScene.h"
#include "Reference/ReferenceRenderer.h"

#include "vtkUnsignedCharArray.h"
#include "vtkVolumeMapper.h"

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <random>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Pixels = 12;
constexpr double Smooth = 2e-7;     // second order, at 1/256 voxel
constexpr double FirstOrder = 3e-4; // where a step belongs to one side of a border or the other

// What is drawn: random values, a function with points at random places, a random oblique view.
struct RandomScene
{
  explicit RandomScene(unsigned seed, int type = VTK_FLOAT)
    : Random(seed)
  {
    std::uniform_int_distribution<int> size(2, 6);
    const int nx = size(this->Random);
    const int ny = size(this->Random);
    const int nz = size(this->Random);
    const double top = type == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
    this->Image = MakeImage(
      nx, ny, nz, [&](double, double, double) { return this->Share() * top; }, type);
    this->Image->SetSpacing(0.5 + this->Share(), 0.5 + this->Share(), 0.5 + this->Share());
    this->Property = MakeConstantProperty(0.1);
    vtkNew<vtkPiecewiseFunction> opacity;
    vtkNew<vtkColorTransferFunction> color;
    for (int i = 0; i < 5; ++i)
    {
      // Not too close: the midpoint rule needs several steps from point to point.
      opacity->AddPoint((i + 0.6 * this->Share()) / 5.0 * top, 0.7 * this->Share());
      color->AddRGBPoint(
        (i + 0.6 * this->Share()) / 5.0 * top, this->Share(), this->Share(), this->Share());
    }
    this->Property->SetScalarOpacity(opacity);
    this->Property->SetColor(color);
  }

  double Share() { return std::uniform_real_distribution<double>(0.0, 1.0)(this->Random); }

  Scene Build(bool dependent = false)
  {
    Scene scene = MakeEngineScene(this->Image, this->Property, dependent);
    const glm::dvec3 middle(scene.Volume.VoxelToWorld[3]);
    const double size = this->Image->GetLength();
    const glm::dvec3 aside(
      this->Share() - 0.5, this->Share() - 0.5, this->Share() > 0.5 ? 1.0 : -1.0);
    LookFromTo(scene, middle + 2.0 * size * aside, middle, 0.5 * size, Pixels, this->Share() > 0.5);
    return scene;
  }

  std::mt19937 Random;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkVolumeProperty> Property;
};

struct Agreement
{
  double Rmse = 0.0;
  double MeanAlpha = 0.0;
  double ExactBound = 0.0;
};

Agreement Compare(const Scene& scene, double stepVoxels = 1.0 / 256.0)
{
  const ReferencePicture exact = ReferenceRenderer().Render(scene);
  const ReferencePicture midpoint =
    ReferenceRenderer().Render(scene, { ReferenceMethod::Midpoint, 1e-9, stepVoxels });
  Agreement agreement;
  EXPECT_EQ(exact.Pixels.size(), midpoint.Pixels.size());
  for (std::size_t i = 0; i < exact.Pixels.size(); ++i)
  {
    const glm::dvec4 difference = exact.Pixels[i] - midpoint.Pixels[i];
    agreement.Rmse += glm::dot(difference, difference);
    agreement.MeanAlpha += exact.Pixels[i].w;
  }
  const auto count = static_cast<double>(exact.Pixels.size());
  agreement.Rmse = std::sqrt(agreement.Rmse / (4.0 * count));
  agreement.MeanAlpha /= count;
  agreement.ExactBound = exact.LargestBound;
  return agreement;
}

void ExpectAgreement(const Scene& scene, double most, const char* what)
{
  const Agreement agreement = Compare(scene);
  EXPECT_LE(agreement.Rmse, most) << what;
  EXPECT_GT(agreement.MeanAlpha, 0.01) << what << ": there is nothing to compare";
  EXPECT_LE(agreement.ExactBound, 1e-8) << what;
}

void AddLights(Scene& scene)
{
  scene.Lighting.Enabled = true;
  scene.Lighting.Lights = { { glm::dvec4(1.0, 2.0, 3.0, 0.0), glm::dvec3(1.0, 0.9, 0.8) },
    { glm::dvec4(9.0, -5.0, 4.0, 1.0), glm::dvec3(0.5) } };
}
}

class TwoReferences : public ::testing::TestWithParam<unsigned>
{
};

TEST_P(TwoReferences, AgreeOnRandomVolumes)
{
  // White noise is the roughest that trilinear data can be: the midpoint rule is good to 1e-6
  // there.
  for (const int type : { VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_DOUBLE })
  {
    ExpectAgreement(RandomScene(GetParam(), type).Build(), Smooth, "composite");
  }
}

TEST_P(TwoReferences, AgreeOnProjections)
{
  Scene scene = RandomScene(GetParam()).Build();
  scene.Compositing.Mode = BlendMode::Average;
  ExpectAgreement(scene, Smooth, "average");
  // Sampling misses an extreme by what the field changes within half a step.
  scene.Compositing.Mode = BlendMode::Maximum;
  ExpectAgreement(scene, FirstOrder, "maximum");
  scene.Compositing.Mode = BlendMode::Minimum;
  ExpectAgreement(scene, FirstOrder, "minimum");
}

TEST_P(TwoReferences, AgreeOnGradients)
{
  Scene scene = RandomScene(GetParam()).Build();
  scene.Compositing.Mode = BlendMode::Gradient;
  ExpectAgreement(scene, Smooth, "gradient");
}

TEST_P(TwoReferences, AgreeOnLighting)
{
  Scene scene = RandomScene(GetParam()).Build();
  AddLights(scene);
  ExpectAgreement(scene, Smooth, "lit");
  scene.Lighting.Damping = 0.3;
  ExpectAgreement(scene, Smooth, "lit and damped");
}

TEST_P(TwoReferences, AgreeOnGradientOpacity)
{
  RandomScene random(GetParam());
  vtkNew<vtkPiecewiseFunction> factor;
  factor->AddPoint(0.1, 0.0);
  factor->AddPoint(1.0, 1.0);
  random.Property->SetGradientOpacity(factor);
  ExpectAgreement(random.Build(), Smooth, "gradient opacity");
}

TEST_P(TwoReferences, AgreeOnNearestValues)
{
  RandomScene random(GetParam());
  random.Property->SetInterpolationTypeToNearest();
  ExpectAgreement(random.Build(), FirstOrder, "nearest");
}

TEST_P(TwoReferences, AgreeOnComponents)
{
  for (const int components : { 2, 4 })
  {
    RandomScene random(GetParam());
    auto scalars = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_FLOAT));
    scalars->SetName("field");
    scalars->SetNumberOfComponents(components);
    scalars->SetNumberOfTuples(random.Image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      for (int component = 0; component < components; ++component)
      {
        scalars->SetComponent(i, component, random.Share());
      }
    }
    random.Image->GetPointData()->SetScalars(scalars);
    ExpectAgreement(random.Build(true), Smooth, components == 2 ? "two" : "four");
  }
}

TEST_P(TwoReferences, AgreeOnHiddenParts)
{
  RandomScene random(GetParam());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(random.Image->GetNumberOfPoints());
  ghosts->Fill(0);
  ghosts->SetValue(ghosts->GetNumberOfTuples() / 2, vtkDataSetAttributes::HIDDENPOINT);
  random.Image->GetPointData()->AddArray(ghosts);
  Scene scene = random.Build();
  ASSERT_TRUE(scene.Volume.HasBlanks());
  const Agreement agreement = Compare(scene);
  EXPECT_LE(agreement.Rmse, FirstOrder);
}

TEST_P(TwoReferences, AgreeOnCropping)
{
  RandomScene random(GetParam());
  Scene scene = random.Build();
  const glm::dvec3 high = 2.0 * glm::dvec3(scene.Volume.VoxelToWorld[3]);
  scene.Clip.CropLow = 0.21 * high;
  scene.Clip.CropHigh = 0.73 * high;
  scene.Clip.Crop = true;
  ExpectAgreement(scene, Smooth, "box");
  scene.Clip.Crop = false;
  scene.Clip.CropRegionFlags = VTK_CROP_INVERTED_FENCE;
  ExpectAgreement(scene, Smooth, "regions");
  scene.Clip.CropRegionFlags = 0;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, -1.5));
  scene.Clip.Planes.emplace_back(normal, -glm::dot(normal, 0.5 * high));
  ExpectAgreement(scene, Smooth, "plane");
}

INSTANTIATE_TEST_SUITE_P(Seeds, TwoReferences, ::testing::Range(1u, 7u));

TEST(MidpointReference, ShowsItsOrderOnSmoothData)
{

  auto property = MakeLinearExtinctionProperty(0.1, 0.0, 4.0, 2);
  Scene scene = MakeEngineScene(MakeImage(12, 10, 8, Bumpy), property);
  const glm::dvec3 middle(scene.Volume.VoxelToWorld[3]);
  LookFromTo(scene, middle + glm::dvec3(13.0, 9.0, 21.0), middle, 6.0, 24, false);
  const ReferencePicture midpoint =
    ReferenceRenderer().Render(scene, { ReferenceMethod::Midpoint });
  EXPECT_NEAR(midpoint.Order, 2.0, 0.3);
  EXPECT_GT(midpoint.LargestBound, 0.0);
  EXPECT_LE(midpoint.LargestBound, 1e-5);
  EXPECT_LE(Compare(scene).Rmse, 1e-7);
}
