// Ray casting in one fragment-shader pass over the box's pixels (Maas & Overhoff 2015, "single
// pass"; Nikolov 2015, "GLSL").
#ifndef volumebench_SinglePass_h
#define volumebench_SinglePass_h

#include "Techniques/OpenGlTechnique.h"

namespace volumebench
{
class SinglePass : public OpenGlTechnique
{
public:
  bool StepsMayVary() const override { return true; }
  bool DrawsShares() const override { return true; }

protected:
  void Compile(const Scene& scene) override;
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;

private:
  const GlProgram& Program();
};
}

#endif
