// Ray casting in CUDA, whose picture is blended over the window (Sans & Carmona 2016; Volt; Misaki,
// Ino & Hagihara 2017). What needs no display is in CudaRays.
#ifndef volumebench_CudaRayCast_h
#define volumebench_CudaRayCast_h

#include "CUDA/CudaGlBuffer.h"
#include "CUDA/CudaRays.h"
#include "Techniques/OpenGlTechnique.h"

namespace volumebench
{
class CudaRayCast : public OpenGlTechnique
{
public:
  std::string WhyNoDevice() const override { return CudaDevice::WhyNone(); }
  std::string GetDeviceName() const override { return CudaDevice::Description(); }
  SetUpCosts GetSetUpCosts() const override;
  bool DrawsShares() const override { return true; }
  std::optional<VolumeRoom> RoomFor(const Scene& scene) const override;

protected:
  FeatureSet FeaturesFor(const Scene& scene) const override;
  bool ReadsTextures() const override { return false; }
  void Compile(const Scene& scene) override;
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;
  void ReleaseOwn() override;
  void ForgetOwn() override;
  std::size_t GetOwnBytes() const override;

private:
  void DrawShared(const Scene& scene, glm::ivec2 size, const PicturePart& part);
  void DrawThroughHost(const Scene& scene, glm::ivec2 size, const PicturePart& part);
  void CopyDepth(const Scene& scene);

  /// Casts, and notes the time if the frame is timed.
  void Cast(const Scene& scene, CUdeviceptr picture, CUdeviceptr depth, const PicturePart& part);

  /// Fills a part of the picture's texture from memory, or from an offset in the buffer that is
  /// bound.
  void SendPart(glm::ivec2 size, const PicturePart& part, const void* texels);

  CudaRays Rays;
  CudaGlBuffer SharedPicture;
  CudaGlBuffer SharedDepth;
  CudaBuffer HostPicture; // of the transfer through the host, as HostDepth
  CudaBuffer HostDepth;
  GlTexture Picture; // as large as the box on the screen
  glm::ivec2 PictureSize{ 0 };
};
}

#endif
