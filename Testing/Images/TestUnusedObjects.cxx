// Objects of OpenGL and OpenCL that only some feature needs are gone when it is no longer used.
#include "ConformanceScene.h"
#include "EveryTechnique.h"
#include "SentData.h"

#include "Techniques/Technique.h"

#include "vtkActor.h"
#include "vtkDataSetAttributes.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_glew.h"

#include <functional>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
struct Objects
{
  int Textures = 0;
  int Framebuffers = 0;
  int OpenCl = 0;        // buffers and images
  std::size_t Bytes = 0; // as the technique counts them

  bool operator==(const Objects& other) const
  {
    return this->Textures == other.Textures && this->Framebuffers == other.Framebuffers &&
      this->OpenCl == other.OpenCl && this->Bytes == other.Bytes;
  }
};

std::ostream& operator<<(std::ostream& out, const Objects& objects)
{
  return out << objects.Textures << " textures, " << objects.Framebuffers << " framebuffers, "
             << objects.OpenCl << " buffers and images of OpenCL, " << objects.Bytes << " bytes";
}

// All that the context has, VTK's own included, after a picture.
Objects ObjectsOf(RenderScene& scene)
{
  constexpr GLuint Names = 2048; // many more than are in use
  scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  scene.Window->MakeCurrent();
  Objects objects;
  for (GLuint name = 1; name < Names; ++name)
  {
    objects.Textures += glIsTexture(name) == GL_TRUE;
    objects.Framebuffers += glIsFramebuffer(name) == GL_TRUE;
  }
  objects.OpenCl = OpenClObjects();
  objects.Bytes = scene.Mapper->GetSetUpCosts().BytesOnDevice;
  return objects;
}

vtkSmartPointer<vtkImageData> Image()
{
  return MakeImage(
    17, 17, 17, [](double i, double j, double k) { return std::hypot(i, j, k) / 30.0; }, VTK_FLOAT);
}

class UnusedObjects : public EveryTechnique
{
protected:
  UnusedObjects()
    : Property(HillsProperty())
    , Scene(GetParam(), Image(), Property)
  {
    this->Scene.Mapper->SetSkipping(false);
    this->Scene.Mapper->SetRaySetUp(0);
  }

  using Change = std::function<void()>;

  // Switches a feature that has objects on and off.
  void ExpectNothingIsLeft(const std::string& feature, const Change& on, const Change& off)
  {
    ObjectsOf(this->Scene); // VTK makes some of its own for the first picture
    const Objects before = ObjectsOf(this->Scene);
    on();
    const Objects with = ObjectsOf(this->Scene);
    EXPECT_NE(
      (" " + this->Scene.Mapper->GetFeatures() + " ").find(" " + feature + " "), std::string::npos)
      << feature;
    EXPECT_GT(with.Textures + with.OpenCl, before.Textures + before.OpenCl)
      << feature << " needs no object";
    off();
    EXPECT_EQ(ObjectsOf(this->Scene), before) << "of " << feature;
  }

  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "the exact technique has one texture, its picture";
    }
    if (HasDeviceOfItsOwn(GetParam()))
    {
      GTEST_SKIP() << "objects of OpenGL are counted";
    }
  }

  vtkSmartPointer<vtkVolumeProperty> Property;
  RenderScene Scene;
};
}

TEST_P(UnusedObjects, OfIntegratorsAreReleased)
{
  for (const int integrator : { 2, 3 })
  {
    this->ExpectNothingIsLeft(
      integrator == 2 ? "segment" : "pre-integrated",
      [&] { this->Scene.Mapper->SetIntegrator(integrator); },
      [&] { this->Scene.Mapper->SetIntegrator(1); });
  }
}

TEST_P(UnusedObjects, OfBricksAreReleased)
{
  this->ExpectNothingIsLeft(
    "bricks", [&] { this->Scene.Mapper->SetMemoryBudgetMiB(0.017); },
    [&] { this->Scene.Mapper->SetMemoryBudgetMiB(0.0); });
}

TEST_P(UnusedObjects, OfGradientOpacityAreReleased)
{
  vtkNew<vtkPiecewiseFunction> factor;
  factor->AddPoint(0.0, 0.0);
  factor->AddPoint(0.1, 1.0);
  const Change on = [&] { this->Property->SetGradientOpacity(factor); };
  this->ExpectNothingIsLeft(
    "gradient-opacity", on, [&] { this->Property->SetGradientOpacity(nullptr); });
  const Change project = [&] { this->Scene.Mapper->SetBlendMode(3); };
  const Change composite = [&] { this->Scene.Mapper->SetBlendMode(0); };
  on();
  project();
  this->ExpectNothingIsLeft("gradient-opacity", composite, project);
}

TEST_P(UnusedObjects, OfOpaqueGeometryAreReleased)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 8.0);
  plane->SetPoint1(8.0, 0.0, 8.0);
  plane->SetPoint2(0.0, 8.0, 8.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  this->Scene.Renderer->AddActor(actor);
  // VTK keeps objects of an actor that was drawn once.
  actor->VisibilityOn();
  ObjectsOf(this->Scene);
  actor->VisibilityOff();
  this->ExpectNothingIsLeft(
    "opaque-depth", [&] { actor->VisibilityOn(); }, [&] { actor->VisibilityOff(); });
}

TEST_P(UnusedObjects, OfHiddenVoxelsAreReleased)
{
  const auto plain = Image();
  const auto hiding = Image();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(hiding->GetNumberOfPoints());
  ghosts->FillValue(0);
  ghosts->SetValue(1000, vtkDataSetAttributes::HIDDENPOINT);
  hiding->GetPointData()->AddArray(ghosts);
  this->Scene.Mapper->SetInputData(plain);
  this->ExpectNothingIsLeft(
    "blanking", [&] { this->Scene.Mapper->SetInputData(hiding); },
    [&] { this->Scene.Mapper->SetInputData(plain); });
}

TEST_P(UnusedObjects, OfSkippingAreReleased)
{
  if (IsSliced(GetParam()))
  {
    GTEST_SKIP() << "slices look up their tiles on the host";
  }
  this->Property->GetScalarOpacity()->RemoveAllPoints();
  this->Property->GetScalarOpacity()->AddPoint(0.6, 0.0);
  this->Property->GetScalarOpacity()->AddPoint(1.0, 0.5);
  this->Scene.Mapper->SetMacrocellVoxels(4);
  this->ExpectNothingIsLeft(
    "skipping", [&] { this->Scene.Mapper->SetSkipping(true); },
    [&] { this->Scene.Mapper->SetSkipping(false); });
}

TEST_P(UnusedObjects, OfTheRaySetUpAreReleased)
{
  if (GetParam() != "compute")
  {
    GTEST_SKIP() << "no objects of its own";
  }
  this->ExpectNothingIsLeft(
    "rasterised-set-up", [&] { this->Scene.Mapper->SetRaySetUp(1); },
    [&] { this->Scene.Mapper->SetRaySetUp(0); });
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(UnusedObjects);
