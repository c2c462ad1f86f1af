// Ray casting in three passes: where rays enter the box, their directions, the march (Kruger &
// Westermann 2003, as in Maas & Overhoff 2015, "multi-pass").
#ifndef volumebench_MultiPass_h
#define volumebench_MultiPass_h

#include "Techniques/OpenGlTechnique.h"

namespace volumebench
{
class MultiPass : public OpenGlTechnique
{
public:
  bool StepsMayVary() const override { return true; }
  bool DrawsShares() const override { return true; }

protected:
  FeatureSet FeaturesFor(const Scene& scene) const override;
  void Compile(const Scene& scene) override;
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;
  void ReleaseOwn() override { this->Faces.Release(); }
  void ForgetOwn() override { this->Faces.Forget(); }
  std::size_t GetOwnBytes() const override { return this->Faces.GetBytes(); }

private:
  BoxFaces Faces;
};
}

#endif
