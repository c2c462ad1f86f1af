#include "Techniques/MultiPass.h"

namespace volumebench
{
FeatureSet MultiPass::FeaturesFor(const Scene& scene) const
{
  // Its rays come from the faces of the box, whatever the scene asks of techniques with a choice.
  FeatureSet features = FeaturesNeededBy(scene);
  return features.set(static_cast<std::size_t>(Feature::RasterisedSetUp));
}

void MultiPass::Compile(const Scene&)
{
  this->BoxFacePrograms();
  this->ProgramOf({ "Viewport.vert", "MultiPass.frag" });
}

void MultiPass::Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  this->FillBoxFaces(scene, window, rectangle, this->Faces);
  const GlProgram& march = this->ProgramOf({ "Viewport.vert", "MultiPass.frag" });
  TextureUnits units(window);
  this->BindWithScene(march, window, units);
  march.SetUnit("entryPointTexture", units.Attach(this->Faces.GetEntryPoints()));
  march.SetUnit("rayDirectionTexture", units.Attach(this->Faces.GetDirections()));
  this->BlendPicture(window);
  this->GetFrameStages().OnDevice("march", [&] { this->DrawTriangle(window, &rectangle); });
}
}
