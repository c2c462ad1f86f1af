#include "Techniques/ComputeRayCast.h"

#include "Scene/PackScene.h"

#include "Techniques/WorkGroupChoice.h"
#include "VoxelOrder/ViewClass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

#include <glm/common.hpp>

namespace volumebench
{
namespace
{
constexpr GLuint PictureUnit = 0;

std::string WorkGroupDefines(glm::ivec2 shape)
{
  return "#define WORK_GROUP_WIDTH " + std::to_string(shape.x) + "\n#define WORK_GROUP_HEIGHT " +
    std::to_string(shape.y) + "\n";
}

// (0, 0) where the shape is to be found by measuring.
glm::ivec2 KnownWorkGroup(const Scene& scene)
{
  return scene.Sampling.Order == VoxelOrder::BlockShape
    ? BlockShapeOf(ViewClassOf(ScreenAxesOf(scene)))
    : scene.Sampling.WorkGroup;
}
}

std::string ComputeRayCast::WhyUnsupported(vtkOpenGLRenderWindow*) const
{
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor >= 43)
  {
    return {};
  }
  return "compute shaders need OpenGL 4.3, this context has " + std::to_string(major) + "." +
    std::to_string(minor);
}

const GlProgram& ComputeRayCast::RayCastOf(glm::ivec2 workGroup)
{
  return this->ProgramOf({ "RayCast.comp" }, WorkGroupDefines(workGroup));
}

void ComputeRayCast::Compile(const Scene& scene)
{
  if (Has(this->GetFeatures(), Feature::RasterisedSetUp))
  {
    this->BoxFacePrograms();
  }
  else
  {
    this->Faces.Release();
  }
  RefuseTurns(scene, "compute");
  const glm::ivec2 workGroup = KnownWorkGroup(scene);
  if (workGroup.x > 0)
  {
    this->RayCastOf(workGroup);
  }
  this->ProgramOf({ "Viewport.vert", "Picture.frag" });
}

void ComputeRayCast::Draw(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  if (Has(this->GetFeatures(), Feature::RasterisedSetUp))
  {
    this->FillBoxFaces(scene, window, rectangle, this->Faces);
  }
  const glm::ivec4 box = BoxRectangle(scene);
  this->Picture.Resize(glm::ivec2(box.z, box.w), GL_RGBA32F);
  const PicturePart part = PartOf(box, rectangle);
  const glm::ivec2 workGroup = this->ChooseWorkGroup(scene, window, part);
  this->GetFrameStages().OnDevice("dispatch", [&] { this->Dispatch(window, workGroup, part); });
  this->DisplayPicture(window, this->Picture.GetTexture(), rectangle);
}

void ComputeRayCast::Dispatch(
  vtkOpenGLRenderWindow* window, glm::ivec2 workGroup, const PicturePart& part)
{
  const GlProgram& program = this->RayCastOf(workGroup);
  TextureUnits units(window);
  this->BindWithScene(program, window, units);
  if (Has(this->GetFeatures(), Feature::RasterisedSetUp))
  {
    program.SetUnit("entryPointTexture", units.Attach(this->Faces.GetEntryPoints()));
    program.SetUnit("rayDirectionTexture", units.Attach(this->Faces.GetDirections()));
  }
  program.SetUnit("picture", PictureUnit);
  program.SetPair("firstTexel", part.First.x, part.First.y);
  program.SetPair("endTexel", part.End.x, part.End.y);
  glBindImageTexture(
    PictureUnit, this->Picture.GetTexture().GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  const glm::ivec2 groups = (part.End - part.First + workGroup - 1) / workGroup;
  glDispatchCompute(groups.x, groups.y, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  glBindImageTexture(PictureUnit, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
}

glm::ivec2 ComputeRayCast::ChooseWorkGroup(
  const Scene& scene, vtkOpenGLRenderWindow* window, const PicturePart& part)
{
  const glm::ivec2 fixed = KnownWorkGroup(scene);
  if (fixed.x > 0)
  {
    return fixed;
  }
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  GlTimer timer;
  const glm::ivec2 found = FindWorkGroup(scene, part,
    std::string(renderer ? renderer : "") + " " + this->GetFeatures().to_string(),
    [&](glm::ivec2 shape, const PicturePart& middle)
    {
      this->Dispatch(window, shape, { middle.First, middle.First + 1 }); // compiles and warms up
      timer.Start();
      this->Dispatch(window, shape, middle);
      timer.Stop();
      return timer.ElapsedMs();
    });
  timer.Release();
  return found;
}

void ComputeRayCast::ReleaseOwn()
{
  this->Faces.Release();
  this->Picture.Release();
}

void ComputeRayCast::ForgetOwn()
{
  this->Faces.Forget();
  this->Picture.Forget();
}
}
