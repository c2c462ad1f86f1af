// Ray casting in one fragment-shader pass over the box's pixels (Maas & Overhoff 2015, "single
// pass"; Nikolov 2015, "GLSL").
#ifndef volumebench_SinglePass_h
#define volumebench_SinglePass_h

#include "Gpu/GlProgram.h"
#include "Gpu/OpaqueDepth.h"
#include "Gpu/SceneTextures.h"
#include "Techniques/Technique.h"

#include <map>
#include <memory>

namespace volumebench
{
class SinglePass : public Technique
{
public:
  void Prepare(const Scene& scene, vtkOpenGLRenderWindow* window) override;
  void Render(const Scene& scene, vtkOpenGLRenderWindow* window) override;
  SetUpCosts GetSetUpCosts() const override;
  FeatureSet GetFeatures() const override { return this->Features; }
  void Release() override;
  void Forget() override;

private:
  const GlProgram& ProgramFor(const FeatureSet& features);
  void UploadBlock(const Scene& scene);
  void Draw(const Scene& scene, vtkOpenGLRenderWindow* window);

  SceneTextures Textures;
  OpaqueDepth Depth;
  std::map<unsigned long, std::unique_ptr<GlProgram>> Programs; // by feature bits
  FeatureSet Features;
  double CompileMs = 0.0;
  unsigned int SceneBuffer = 0;
  unsigned int VertexArray = 0; // empty: the vertex stage makes its own positions
};
}

#endif
