#include "Techniques/SinglePass.h"

namespace volumebench
{
const GlProgram& SinglePass::Program()
{
  const bool faces = Has(this->GetFeatures(), Feature::RasterisedSetUp);
  // Rays begin at the entry into the volume's box wherever their pixel is found, so that skipping
  // does not move their samples.
  return this->ProgramOf({ faces ? "BoxFaces.vert" : "Viewport.vert", "SinglePass.frag" },
    faces ? "#define FACES_OF_OCCUPIED\n" : "");
}

void SinglePass::Compile(const Scene&)
{
  this->Program();
}

void SinglePass::Draw(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  TextureUnits units(window);
  this->BindWithScene(this->Program(), window, units);
  this->BlendPicture(window);
  if (Has(this->GetFeatures(), Feature::RasterisedSetUp))
  {
    // Back faces: they are there also when the camera is inside.
    this->DrawBoxFaces(scene, window, true);
  }
  else
  {
    this->DrawTriangle(window, &rectangle);
  }
}
}
