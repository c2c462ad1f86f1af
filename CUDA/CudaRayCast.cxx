#include "CUDA/CudaRayCast.h"

#include "Scene/PackScene.h"

#include "vtkOpenGLRenderWindow.h"

#include <cstdint>

namespace volumebench
{
namespace
{
CudaGlBuffer::Registered RegisteredFor(const Scene& scene)
{
  return scene.Sampling.Transfer == PictureTransfer::RegisterEachFrame
    ? CudaGlBuffer::Registered::EachFrame
    : CudaGlBuffer::Registered::Once;
}

std::size_t TexelsBefore(glm::ivec2 size, const PicturePart& part)
{
  return static_cast<std::size_t>(part.First.y) * size.x + part.First.x;
}
}

FeatureSet CudaRayCast::FeaturesFor(const Scene& scene) const
{
  return CudaRays::FeaturesFor(scene);
}

std::optional<VolumeRoom> CudaRayCast::RoomFor(const Scene& scene) const
{
  return CudaScene::RoomFor(scene, CudaDevice::Get());
}

void CudaRayCast::Compile(const Scene& scene)
{
  this->Rays.Prepare(scene, this->GetFeatures());
  this->ProgramOf({ "Viewport.vert", "Picture.frag" });
}

void CudaRayCast::Draw(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  const glm::ivec4 box = BoxRectangle(scene);
  const glm::ivec2 size(box.z, box.w);
  const PicturePart part = PartOf(box, rectangle);
  if (scene.Measurement.TimeStages && this->Rays.HasTurned())
  {
    this->GetFrameStages().Add("voxels turned", this->Rays.GetTurnMs());
  }
  if (scene.Sampling.Transfer == PictureTransfer::ThroughHost)
  {
    this->DrawThroughHost(scene, size, part);
  }
  else
  {
    this->DrawShared(scene, size, part);
  }
  this->DisplayPicture(window, this->Picture, rectangle);
}

void CudaRayCast::Cast(
  const Scene& scene, CUdeviceptr picture, CUdeviceptr depth, const PicturePart& part)
{
  if (!scene.Measurement.TimeStages)
  {
    this->Rays.Cast(scene, picture, depth, part);
    return;
  }
  const CudaScope scope;
  CudaTimer timer;
  timer.Start();
  this->Rays.Cast(scene, picture, depth, part);
  timer.Stop();
  this->GetFrameStages().Add("rays", timer.ElapsedMs());
}

void CudaRayCast::CopyDepth(const Scene& scene)
{
  const glm::ivec4& viewport = scene.Camera.Viewport;
  this->SharedDepth.Resize(static_cast<std::size_t>(viewport.z) * viewport.w * sizeof(float));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->SharedDepth.GetHandle());
  this->GetDepth().GetTexture().Bind(GL_TEXTURE_2D);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  this->GetDepth().GetTexture().Unbind();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void CudaRayCast::DrawShared(const Scene& scene, glm::ivec2 size, const PicturePart& part)
{
  const CudaGlBuffer::Registered registered = RegisteredFor(scene);
  const bool hidden = Has(this->GetFeatures(), Feature::OpaqueDepth);
  if (hidden)
  {
    this->CopyDepth(scene);
  }
  this->SharedPicture.Resize(static_cast<std::size_t>(size.x) * size.y * sizeof(glm::vec4));
  if (hidden)
  {
    const CudaGlBuffer::Mapped picture(this->SharedPicture, registered);
    const CudaGlBuffer::Mapped depth(this->SharedDepth, registered);
    this->Cast(scene, picture.GetPointer(), depth.GetPointer(), part);
  }
  else
  {
    const CudaGlBuffer::Mapped picture(this->SharedPicture, registered);
    this->Cast(scene, picture.GetPointer(), 0, part);
  }
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->SharedPicture.GetHandle());
  const std::uintptr_t offset = TexelsBefore(size, part) * sizeof(glm::vec4);
  this->SendPart(size, part, reinterpret_cast<const void*>(offset));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void CudaRayCast::DrawThroughHost(const Scene& scene, glm::ivec2 size, const PicturePart& part)
{
  std::vector<glm::vec4> texels(static_cast<std::size_t>(size.x) * size.y);
  const std::size_t first = static_cast<std::size_t>(part.First.y) * size.x;
  const std::size_t rows = static_cast<std::size_t>(part.End.y - part.First.y) * size.x;
  {
    const CudaScope scope;
    if (Has(this->GetFeatures(), Feature::OpaqueDepth))
    {
      const std::vector<float> depth = this->GetDepth().Read(scene.Camera.Viewport);
      this->HostDepth.Send(depth.data(), depth.size() * sizeof(float));
    }
    this->HostPicture.Resize(texels.size() * sizeof(glm::vec4));
    this->Cast(scene, this->HostPicture.GetPointer(), this->HostDepth.GetPointer(), part);
    this->HostPicture.Read(&texels[first], first * sizeof(glm::vec4), rows * sizeof(glm::vec4));
  }
  this->SendPart(size, part, &texels[TexelsBefore(size, part)]);
}

void CudaRayCast::SendPart(glm::ivec2 size, const PicturePart& part, const void* texels)
{
  this->Picture.Bind(GL_TEXTURE_2D);
  if (size != this->PictureSize)
  {
    GLint bound = 0;
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &bound);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    this->Picture.SetSampling(false);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(bound));
    this->PictureSize = size;
  }
  const glm::ivec2 extent = part.End - part.First;
  glPixelStorei(GL_UNPACK_ROW_LENGTH, size.x);
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, part.First.x, part.First.y, extent.x, extent.y, GL_RGBA, GL_FLOAT, texels);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  this->Picture.Unbind();
}

SetUpCosts CudaRayCast::GetSetUpCosts() const
{
  SetUpCosts costs = this->Rays.GetSetUpCosts();
  costs.BytesOnDevice += this->GetOwnBytes();
  return costs;
}

std::size_t CudaRayCast::GetOwnBytes() const
{
  return this->SharedPicture.GetBytes() + this->SharedDepth.GetBytes() +
    this->HostPicture.GetBytes() + this->HostDepth.GetBytes() +
    static_cast<std::size_t>(this->PictureSize.x) * this->PictureSize.y * sizeof(glm::vec4);
}

void CudaRayCast::ReleaseOwn()
{
  this->SharedPicture.Release();
  this->SharedDepth.Release();
  this->Picture.Release();
  this->ForgetOwn();
}

void CudaRayCast::ForgetOwn()
{
  // What CUDA alone has lives on without OpenGL's context; what it shared went with it.
  this->SharedPicture.Forget();
  this->SharedDepth.Forget();
  this->Picture.Forget();
  this->HostPicture.Release();
  this->HostDepth.Release();
  this->Rays.Release();
  this->PictureSize = glm::ivec2(0);
}
}
