// Ray casting in OpenCL, on a graphics card or a CPU, whose picture is blended over the window
// (Sans & Carmona 2016).
#ifndef volumebench_OpenClRayCast_h
#define volumebench_OpenClRayCast_h

#include "OpenCl/OpenClScene.h"
#include "Techniques/OpenGlTechnique.h"
#include "Techniques/WorkGroupChoice.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace volumebench
{
struct ViewClass;

class OpenClRayCast : public OpenGlTechnique
{
public:
  std::string WhyNoDevice() const override { return WhyNoOpenClDevice(); }
  /// The device of "Auto".
  std::string GetDeviceName() const override;
  SetUpCosts GetSetUpCosts() const override;
  bool DrawsShares() const override { return true; }
  std::optional<VolumeRoom> RoomFor(const Scene& scene) const override;

protected:
  /// SIMD rays are the choice of this technique.
  FeatureSet FeaturesFor(const Scene& scene) const override;
  bool ReadsTextures() const override { return false; }
  void Compile(const Scene& scene) override;
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;
  void ReleaseOwn() override;
  void ForgetOwn() override;
  std::size_t GetOwnBytes() const override;

private:
  /// The session that the scene's device has for the current context of OpenGL. What another one
  /// holds is given up.
  OpenClSession& SessionFor(const OpenClDevice& device);

  /// Casts a part straight into the picture's texture.
  void CastShared(const Scene& scene, const PicturePart& part);

  /// Takes the kernel for views of this class, and whether it had to be compiled.
  bool CompileFor(const Scene& scene, const ViewClass& view);

  /// Casts the rays of a part in work groups of this shape and waits until they are done. Returns
  /// what the kernel took, in milliseconds.
  double Cast(const PicturePart& part, glm::ivec2 workGroup);

  void ReleaseOpenCl();
  void SendDepth(const glm::ivec4& viewport);

  /// What is cast at a time: all of a part on a graphics card. A processor casts bands of whole
  /// rows of work groups that stay in its cache until they are sent, so that the picture is not
  /// twice in its memory.
  std::vector<PicturePart> BandsOf(const PicturePart& part, int groupRows) const;

  /// Maps what was cast and sends it to the texture.
  void Transfer(const PicturePart& part);

  glm::ivec2 ChooseWorkGroup(const Scene& scene, const PicturePart& part);

  std::shared_ptr<OpenClSession> Shared; // with OpenGL, where the device can
  GlContext SharedContext;
  OpenClSession* Session = nullptr; // of the device in use
  cl_kernel Kernel = nullptr;       // the session's
  std::string KernelDefines;        // that it was specialised with
  glm::ivec2 Tile{ 1 };             // pixels of a work item
  glm::ivec2 WorkGroup{ 0 };        // work items; 0: to be chosen
  OpenClScene Data;
  OpenClMemory Depth; // of opaque geometry, as large as the viewport
  cl_int DepthWidth = 0;
  OpenClMemory Target; // the picture's texture, where it is shared
  OpenClMemory Result; // else the part that was cast, row by row
  GlTexture Picture;   // as large as the box on the screen
  glm::ivec2 PictureSize{ 0 };
  double CompileMs = std::numeric_limits<double>::quiet_NaN();
};
}

#endif
