// The cell-exact reference as a technique: rendered in double precision on the processor's cores,
// then blended over the window as a texture. It has no step, no integrator and no early
// termination: what it leaves out of a ray cannot be seen in double precision either. While the
// window asks for interactive frames it draws every fourth ray of each axis, each as exact as ever.
#ifndef volumebench_Reference_h
#define volumebench_Reference_h

#include "Reference/ReferenceRenderer.h"
#include "Scene/KernelScene.h"
#include "Techniques/OpenGlTechnique.h"

#include <vector>

namespace volumebench
{
class Reference : public OpenGlTechnique
{
public:
  /// Upload and tables: what is made of the volume and of its functions, on the host.
  SetUpCosts GetSetUpCosts() const override;

protected:
  FeatureSet FeaturesFor(const Scene& scene) const override;
  bool ReadsTextures() const override { return false; }
  bool ReadsTexels() const override { return false; }
  bool LeavesSpaceOut() const override { return false; }
  void Compile(const Scene& scene) override;

  /// Throws AbortedError when the window's abort check says so.
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;
  void ReleaseOwn() override;
  void ForgetOwn() override;
  std::size_t GetOwnBytes() const override;

private:
  /// All that a picture depends on.
  struct Key
  {
    SceneBlock64 Numbers{};
    ChangeStamp VolumeStamp = 0;
    ChangeStamp FunctionStamp = 0;
    FeatureSet Features;
    ReferenceMethod Method = ReferenceMethod::CellExact;
    double StepVoxels = 0.0;        // of the method Midpoint
    std::vector<float> WindowDepth; // empty without opaque geometry

    bool operator==(const Key& other) const;
  };

  Key KeyOf(const Scene& scene);
  void Cast(const Scene& scene, vtkOpenGLRenderWindow* window, const Key& key);
  void Upload();

  ReferenceRenderer Renderer;
  Key Shown; // of what is in the texture
  int PixelsPerRay = 0;
  ReferencePicture Picture;
  GlTexture Texture;
};
}

#endif
