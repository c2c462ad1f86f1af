#include "Techniques/Reference.h"

#include "Gpu/GlRoom.h"
#include "Scene/FrameRate.h"
#include "Scene/PackScene.h"
#include "Techniques/Gathering.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

#include <chrono>
#include <cstring>

namespace volumebench
{
namespace
{
constexpr int InteractivePixelsPerRay = 4;

// The scene as this technique sees it: nothing of how others sample it.
Scene WithoutSampling(const Scene& scene)
{
  Scene plain = scene;
  plain.Sampling = {};
  plain.Sampling.Integration = Integrator::Left;
  plain.Sampling.SetUp = RaySetUp::Box;
  return plain;
}
}

FeatureSet Reference::FeaturesFor(const Scene& scene) const
{
  FeatureSet features = FeaturesNeededBy(WithoutSampling(scene));
  features.reset(static_cast<std::size_t>(Feature::Ramps)); // it has the function itself
  return features.reset(static_cast<std::size_t>(Feature::MoreRamps));
}

void Reference::Compile(const Scene& scene)
{
  if (scene.Measurement.ShowSamples && !scene.Measurement.CountSamples)
  {
    throw SceneError("the exact technique takes no samples along its rays that could be shown: "
                     "choose another technique, or show the picture");
  }
  this->Renderer.Prepare(scene);
  this->ProgramOf({ "Viewport.vert", "Picture.frag" });
}

bool Reference::Key::operator==(const Key& other) const
{
  return this->VolumeStamp == other.VolumeStamp && this->FunctionStamp == other.FunctionStamp &&
    this->Features == other.Features && this->Method == other.Method &&
    this->StepVoxels == other.StepVoxels && this->WindowDepth == other.WindowDepth &&
    std::memcmp(&this->Numbers, &other.Numbers, sizeof(this->Numbers)) == 0;
}

Reference::Key Reference::KeyOf(const Scene& scene)
{
  Key key;
  key.Numbers = PackScene(WithoutSampling(scene));
  key.VolumeStamp = scene.Volume.Stamp;
  key.FunctionStamp = scene.TransferFunction.Stamp;
  key.Features = this->GetFeatures();
  key.Method = scene.Sampling.Method;
  key.StepVoxels = key.Method == ReferenceMethod::Midpoint ? scene.Sampling.StepVoxels : 0.0;
  if (Has(key.Features, Feature::OpaqueDepth))
  {
    key.WindowDepth = this->GetDepth().Read(scene.Camera.Viewport);
  }
  return key;
}

void Reference::Cast(const Scene& scene, vtkOpenGLRenderWindow* window, const Key& key)
{
  const int wanted = WantsInteractiveFrames(window) ? InteractivePixelsPerRay : 1;
  if (this->Texture.IsCreated() && this->PixelsPerRay <= wanted && this->Shown == key)
  {
    return;
  }
  this->PixelsPerRay = InteractivePixelsPerRay + 1; // nothing is shown if this fails
  ReferenceOptions options;
  options.Method = key.Method;
  options.StepVoxels = key.StepVoxels;
  options.PixelsPerRay = wanted;
  this->Picture =
    this->Renderer.Render(scene, options, key.WindowDepth.empty() ? nullptr : &key.WindowDepth,
      [&](double share)
      {
        this->ReportProgress(share);
        return window->CheckAbortStatus() == 0;
      });
  window->MakeCurrent(); // whoever was told may have drawn elsewhere
  if (!this->Picture.Complete)
  {
    throw AbortedError("the picture was aborted before it was complete");
  }
  this->Upload();
  this->Shown = key;
  this->PixelsPerRay = wanted;
}

void Reference::Upload()
{
  const glm::ivec4& rectangle = this->Picture.Rectangle;
  const int pixelsPerRay = (rectangle.z + this->Picture.Width - 1) / this->Picture.Width;
  std::vector<glm::vec4> texels;
  texels.reserve(static_cast<std::size_t>(rectangle.z) * rectangle.w);
  for (int y = 0; y < rectangle.w; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(y / pixelsPerRay) * this->Picture.Width;
    for (int x = 0; x < rectangle.z; ++x)
    {
      texels.emplace_back(this->Picture.Pixels[row + x / pixelsPerRay]);
    }
  }
  this->Texture.Bind(GL_TEXTURE_2D);
  this->Texture.SetSampling(false);
  ForgetGlErrors();
  glTexImage2D(
    GL_TEXTURE_2D, 0, GL_RGBA32F, rectangle.z, rectangle.w, 0, GL_RGBA, GL_FLOAT, texels.data());
  this->Texture.Unbind();
  CheckGlRoom("a picture of " + std::to_string(rectangle.z) + " x " + std::to_string(rectangle.w) +
    " pixels");
}

void Reference::Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  this->Cast(scene, window, this->KeyOf(scene));
  this->GetFrameStages().Add(
    "rays", std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  const GlProgram& display = this->ProgramOf({ "Viewport.vert", "Picture.frag" });
  TextureUnits units(window);
  display.Bind(window);
  display.SetUnit("pictureTexture", units.Attach(this->Texture));
  BlendOver(window);
  this->GetFrameStages().OnDevice("display", [&] { this->DrawTriangle(window, &rectangle); });
}

void Reference::ReleaseOwn()
{
  this->Texture.Release();
}

void Reference::ForgetOwn()
{
  this->Texture.Forget();
}

SetUpCosts Reference::GetSetUpCosts() const
{
  SetUpCosts costs = this->OpenGlTechnique::GetSetUpCosts();
  costs.UploadMs = this->Renderer.GetFieldMs();
  costs.TablesMs = this->Renderer.GetFunctionMs();
  return costs;
}

std::size_t Reference::GetOwnBytes() const
{
  return this->Texture.IsCreated() ? static_cast<std::size_t>(this->Picture.Rectangle.z) *
      this->Picture.Rectangle.w * sizeof(glm::vec4)
                                   : 0;
}
}
