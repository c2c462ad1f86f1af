// Ray casting in a compute shader, whose picture is blended over the window (Sans & Carmona 2016).
#ifndef volumebench_ComputeRayCast_h
#define volumebench_ComputeRayCast_h

#include "Techniques/OpenGlTechnique.h"
#include "Techniques/WorkGroupChoice.h"

#include <glm/vec2.hpp>

namespace volumebench
{
class ComputeRayCast : public OpenGlTechnique
{
public:
  bool StepsMayVary() const override { return true; }
  bool DrawsShares() const override { return true; }
  std::string WhyUnsupported(vtkOpenGLRenderWindow* window) const override;

protected:
  void Compile(const Scene& scene) override;
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;
  void ReleaseOwn() override;
  void ForgetOwn() override;
  std::size_t GetOwnBytes() const override
  {
    return this->Faces.GetBytes() + this->Picture.GetBytes();
  }

private:
  const GlProgram& RayCastOf(glm::ivec2 workGroup);

  /// Casts the rays of a part of the picture.
  void Dispatch(vtkOpenGLRenderWindow* window, glm::ivec2 workGroup, const PicturePart& part);

  /// The scene's shape, or for Auto the fastest of a few.
  glm::ivec2 ChooseWorkGroup(
    const Scene& scene, vtkOpenGLRenderWindow* window, const PicturePart& part);

  BoxFaces Faces;
  OffscreenTarget Picture;
};
}

#endif
