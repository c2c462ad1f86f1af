// A volume that several processes draw a share of each: their pictures, one over the other, are
// that of the whole.
#include "ConformanceScene.h"
#include "EveryTechnique.h"
#include "SceneChanges.h"

#include "Bricks/VolumeShare.h"
#include "Error/FloatPicture.h"
#include "Techniques/Technique.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Dims[3] = { 49, 41, 33 };
constexpr int Layers = 8;

double Waves(double i, double j, double k)
{
  return 0.5 + 0.3 * std::sin(0.5 * i) * std::cos(0.4 * j) + 0.2 * std::cos(0.6 * k + 0.1 * i);
}

/// A plane that cuts the volume in two: Slab as in GridShare, at 0.
using Plane = std::array<double, 4>;

double SideOf(const Plane& plane, const double index[3])
{
  return plane[0] * index[0] + plane[1] * index[1] + plane[2] * index[2] + plane[3];
}

// The points on one side of a plane and some beyond, and no others.
vtkSmartPointer<vtkImageData> PartOf(vtkImageData* whole, const Plane& plane, bool above)
{
  int extent[6] = { Dims[0], -1, Dims[1], -1, Dims[2], -1 };
  for (int corner = 0; corner < Dims[0] * Dims[1] * Dims[2]; ++corner)
  {
    const int index[3] = { corner % Dims[0], corner / Dims[0] % Dims[1],
      corner / Dims[0] / Dims[1] };
    const double place[3] = { double(index[0]), double(index[1]), double(index[2]) };
    if ((SideOf(plane, place) >= 0.0) == above)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        extent[2 * axis] = std::min(extent[2 * axis], std::max(0, index[axis] - Layers));
        extent[2 * axis + 1] =
          std::max(extent[2 * axis + 1], std::min(Dims[axis] - 1, index[axis] + Layers));
      }
    }
  }
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->ShallowCopy(whole);
  part->Crop(extent);
  GridShare share;
  std::copy_n(whole->GetExtent(), 6, share.Whole.begin());
  share.Slab = plane;
  share.SlabEnds[above ? 0 : 1] = 0.0;
  SetShare(part, share);
  return part;
}

FloatPicture Over(const FloatPicture& front, const FloatPicture& back)
{
  FloatPicture both = front;
  for (std::size_t i = 0; i < both.Pixels.size(); ++i)
  {
    both.Pixels[i] += (1.0f - front.Pixels[i / 4 * 4 + 3]) * back.Pixels[i];
  }
  return both;
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

struct Variation
{
  std::string Name;
  SceneChange Arrange;
  bool Steep = false;

  // By which a channel of a pixel may differ. Where opacity is steep it is that much for the
  // rounding of where samples lie.
  double Most() const { return this->Steep ? 2e-3 : 1e-4; }
};

vtkSmartPointer<vtkVolumeProperty> PropertyOf(const Variation& variation)
{
  auto property = HillsProperty();
  if (variation.Steep)
  {
    vtkNew<vtkPiecewiseFunction> wall;
    wall->AddPoint(0.0, 0.0);
    wall->AddPoint(0.6, 0.0);
    wall->AddPoint(0.7, 0.9);
    wall->AddPoint(1.0, 0.9);
    property->SetScalarOpacity(wall);
  }
  return property;
}

Variation WithIntegrator(int integrator, double step, bool jitter)
{
  return { IntegratorText(integrator, jitter), SampledBy(integrator, step, jitter) };
}

Variation Steep(Variation variation)
{
  variation.Name += ", steep";
  variation.Steep = true;
  return variation;
}

std::vector<Variation> Variations()
{
  return { WithIntegrator(0, 0.37, false), WithIntegrator(1, 4.0, true),
    Steep(WithIntegrator(1, 1.0, false)), Steep(WithIntegrator(2, 1.0, false)),
    WithIntegrator(3, 1.7, false), { "from inside", LookFromInside }, { "lit", ShadeByGradients },
    Steep({ "lit", ShadeByGradients }) };
}
}

class Shares : public EveryTechnique
{
protected:
  void ExpectTheWhole(const Plane& plane)
  {
    auto image = MakeImage(Dims[0], Dims[1], Dims[2], Waves, VTK_FLOAT);
    for (const Variation& variation : Variations())
    {
      RenderScene scene(GetParam(), image, PropertyOf(variation));
      scene.Mapper->SetWorkGroupShape("8x8"); // which is best would be found by trying
      variation.Arrange(scene);
      const FloatPicture whole = scene.Picture();
      double eye[3];
      image->TransformPhysicalPointToContinuousIndex(
        scene.Renderer->GetActiveCamera()->GetPosition(), eye);
      const bool above = SideOf(plane, eye) >= 0.0;
      std::vector<FloatPicture> shares;
      for (const bool side : { above, !above })
      {
        const auto part = PartOf(image, plane, side);
        ASSERT_LT(part->GetNumberOfPoints(), image->GetNumberOfPoints());
        scene.Mapper->SetInputData(part);
        shares.push_back(scene.Picture());
        ASSERT_EQ(scene.Mapper->GetFailure(), "") << variation.Name;
        EXPECT_GT(Apart(shares.back(), whole), 0.01) << variation.Name << " draws all";
      }
      EXPECT_LE(Apart(Over(shares[0], shares[1]), whole), variation.Most()) << variation.Name;
    }
  }
};

// One of four parts that meet in an edge along x, as ranks hold them: 1 is above in y, 2 in z.
vtkSmartPointer<vtkImageData> QuarterOf(vtkImageData* whole, int quarter)
{
  constexpr int Borders[3] = { 0, 20, 16 };
  GridShare share;
  int extent[6];
  whole->GetExtent(extent);
  std::copy_n(extent, 6, share.Whole.begin());
  for (int axis = 1; axis < 3; ++axis)
  {
    const bool above = (quarter & axis) != 0;
    share.Own[2 * axis + (above ? 0 : 1)] = Borders[axis];
    (above ? extent[2 * axis] : extent[2 * axis + 1]) = Borders[axis] + (above ? -4 : 4);
  }
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->ShallowCopy(whole);
  part->Crop(extent);
  SetShare(part, share);
  return part;
}

TEST_P(Shares, LookLikeTheWholeInQuarters)
{
  auto image = MakeImage(Dims[0], Dims[1], Dims[2], Waves, VTK_FLOAT);
  for (const Variation& variation :
    { WithIntegrator(1, 0.37, false), Steep(WithIntegrator(2, 0.37, false)) })
  {
    RenderScene scene(GetParam(), image, PropertyOf(variation));
    scene.Mapper->SetWorkGroupShape("8x8");
    variation.Arrange(scene);
    const FloatPicture whole = scene.Picture();
    FloatPicture all = whole;
    std::fill(all.Pixels.begin(), all.Pixels.end(), 0.0f);
    for (const int quarter : { 3, 2, 1, 0 }) // the eye is above in y and z
    {
      const auto part = QuarterOf(image, quarter);
      scene.Mapper->SetInputData(part);
      all = Over(all, scene.Picture());
      ASSERT_EQ(scene.Mapper->GetFailure(), "") << variation.Name;
    }
    EXPECT_LE(Apart(all, whole), variation.Most()) << variation.Name;
  }
}

TEST_P(Shares, LookLikeTheWholeAcrossAPlaneOfTheGrid)
{
  this->ExpectTheWhole({ 1.0, 0.0, 0.0, -24.0 });
}

TEST_P(Shares, LookLikeTheWholeAcrossAnObliquePlane)
{
  this->ExpectTheWhole({ 3.0, 0.4, -0.5, -72.3 });
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Shares);
