#include "VolumePainter.h"

#include "Bricks/VolumeShare.h"
#include "Gpu/GlContextGuard.h"
#include "Scene/CameraBuilder.h"
#include "Scene/CellMap.h"
#include "Scene/FrameRate.h"
#include "Scene/FromVtk.h"
#include "Scene/PictureStamp.h"
#include "Techniques/TechniqueTable.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
// Says which block an error is about.
template <typename Action>
auto InBlock(const std::string& name, const Action& action)
{
  try
  {
    return action();
  }
  catch (const UnsupportedError&)
  {
    throw;
  }
  catch (const AbortedError&)
  {
    throw;
  }
  catch (const SceneError& error)
  {
    throw SceneError(name.empty() ? error.what() : "in block " + name + ", " + error.what());
  }
}

// Whether all points and cells have a number in 32 bits.
bool IsNumbered(vtkDataObject* input)
{
  constexpr vtkIdType Limit = vtkIdType(1) << 32;
  auto* image = vtkImageData::SafeDownCast(input);
  return image && image->GetNumberOfPoints() < Limit;
}

SelectionMark WithoutIds(const SelectionMark& mark)
{
  return { mark.BeginsSelection, SelectionMark::Content::Color, mark.Color, 0 };
}

// A pixel's maximum, minimum or mean over several blocks is not one picture over another.
void RefuseBlendingOfBlocks(vtkVolumeBenchMapper* mapper, std::size_t blocks)
{
  const int mode = mapper->GetBlendMode();
  if (blocks > 1 && mode != vtkVolumeMapper::COMPOSITE_BLEND &&
    mode != vtkVolumeBenchMapper::GRADIENT_BLEND)
  {
    throw SceneError("the input has " + std::to_string(blocks) +
      " blocks; only the blend modes Composite and Gradient can be drawn block by block");
  }
  if (blocks > 1 && mapper->GetShow() != vtkVolumeBenchMapper::Picture)
  {
    throw SceneError(
      "the input has " + std::to_string(blocks) + " blocks; samples per pixel can be shown of one");
  }
}
}

void VolumePainter::ReleaseGpu()
{
  if (this->Window && !this->Parts.empty())
  {
    this->Window->MakeCurrent();
  }
  this->Window ? this->Selection.Release() : this->Selection.Forget();
  this->Window ? this->Offscreen.Release() : this->Offscreen.Forget();
  this->Window ? this->Depth.Release() : this->Depth.Forget();
  this->Window ? this->Timer.Release() : this->Timer.Forget();
  this->Window ? this->Frames.Release() : this->Frames.Forget();
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    if (this->Window)
    {
      part->Technique->Release();
    }
    else
    {
      part->Technique->Forget();
    }
  }
  this->Window = nullptr;
}

vtkOpenGLRenderWindow* VolumePainter::GetWindow() const
{
  return this->Window;
}

void VolumePainter::UseTechnique(const std::string& id)
{
  if (!this->Parts.empty() && id == this->TechniqueId)
  {
    return;
  }
  if (!FindTechnique(id))
  {
    throw SceneError(WhyNoTechnique(id));
  }
  this->ReleaseGpu();
  this->Parts.clear();
  this->TechniqueId = id;
}

void VolumePainter::UseWindow(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    throw SceneError("the render window is not an OpenGL window");
  }
  if (this->Window && this->Window != window)
  {
    this->ReleaseGpu();
    window->MakeCurrent();
  }
  this->Window = window;
}

void VolumePainter::UseBlocks(const std::vector<Block>& blocks)
{
  while (this->Parts.size() > blocks.size())
  {
    this->Parts.back()->Technique->Release();
    this->Parts.pop_back();
  }
  while (this->Parts.size() < blocks.size())
  {
    auto part = std::make_unique<Part>();
    part->Technique = FindTechnique(this->TechniqueId)->Create();
    this->Parts.push_back(std::move(part));
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    this->Parts[i]->Name = blocks[i].Name;
  }
}

std::vector<VolumePainter::PartScene> VolumePainter::ScenesBackToFront(vtkVolumeBenchMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const glm::ivec4& viewport, double stepFactor)
{
  const std::vector<Block> blocks = BlocksOf(mapper->GetDataObjectInput());
  RefuseBlendingOfBlocks(mapper, blocks.size());
  this->UseBlocks(blocks);
  const std::string reason = this->Parts.front()->Technique->WhyUnsupported(this->Window);
  if (!reason.empty())
  {
    throw UnsupportedError("technique '" + this->TechniqueId + "' cannot run here: " + reason);
  }
  ScalarRange range{ HUGE_VAL, -HUGE_VAL };
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const ScalarRange own = InBlock(blocks[i].Name,
      [&] { return this->Parts[i]->Builder.RangeOf(mapper, volume, blocks[i].Image); });
    range = { std::min(range.Low, own.Low), std::max(range.High, own.High) };
  }
  const RenderTarget target{ viewport, ReadGlLimits().Texture,
    this->Parts.front()->Technique->StepsMayVary(), stepFactor };
  const Camera camera = BuildCamera(renderer, viewport);
  std::vector<PartScene> scenes;
  for (const std::size_t i : BackToFront(blocks, camera, FromVtk(volume->GetMatrix())))
  {
    Part* part = this->Parts[i].get();
    InBlock(part->Name,
      [&]
      {
        scenes.push_back(
          { part, part->Builder.Build(mapper, renderer, volume, blocks[i].Image, range, target) });
        Scene& scene = scenes.back().Scene;
        if (scene.Share && !part->Technique->DrawsShares())
        {
          ClipToShare(scene);
        }
        if (const std::optional<VolumeRoom> room = part->Technique->RoomFor(scene))
        {
          DivideIntoBricks(scene, *room);
        }
      });
  }
  return scenes;
}

void VolumePainter::PrepareAll(const std::vector<PartScene>& scenes)
{
  for (const PartScene& scene : scenes)
  {
    InBlock(scene.Drawn->Name, [&] { scene.Drawn->Technique->Prepare(scene.Scene, this->Window); });
  }
}

void VolumePainter::RenderAll(const std::vector<PartScene>& scenes, vtkVolumeBenchMapper* mapper)
{
  double done = 0.0;
  for (const PartScene& scene : scenes)
  {
    const auto all = static_cast<double>(scenes.size());
    scene.Drawn->Technique->SetProgress(
      [mapper, done, all](double share) { mapper->UpdateProgress((done + share) / all); });
    done += 1.0;
    InBlock(scene.Drawn->Name, [&] { scene.Drawn->Technique->Render(scene.Scene, this->Window); });
  }
}

std::vector<VolumePainter::PartScene> VolumePainter::ArrangeFrame(vtkVolumeBenchMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const glm::ivec4& viewport, glm::ivec4& drawn)
{
  const auto arrange = [&](const Coarseness& coarse)
  {
    drawn =
      coarse.Reduction > 1 ? ReducedPicture::ViewportOf(viewport, coarse.Reduction) : viewport;
    return this->ScenesBackToFront(mapper, renderer, volume, drawn, coarse.StepFactor);
  };
  std::vector<PartScene> scenes = arrange(this->Frames.Begin(mapper, this->Window));
  return this->Frames.IsPreview(mapper, this->Window, this->StampOf(scenes))
    ? arrange(this->Frames.BeginPreview(mapper, this->Window))
    : scenes;
}

void VolumePainter::Draw(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  this->UseTechnique(mapper->GetTechnique());
  this->UseWindow(renderer);
  const bool timed = mapper->GetTimeFrames() && !WantsInteractiveFrames(this->Window);
  if (timed)
  {
    this->Timer.Start();
  }
  const glm::ivec4 viewport = ReadGlViewport(this->Window);
  glm::ivec4 drawn;
  const std::vector<PartScene> scenes =
    this->ArrangeFrame(mapper, renderer, volume, viewport, drawn);
  // All blocks are ready before the first is drawn, so that a failure leaves no part of a picture.
  this->PrepareAll(scenes);
  this->Frames.Draw(this->Window, viewport, drawn, [&] { this->RenderAll(scenes, mapper); });
  this->Frames.End();
  for (const PartScene& scene : scenes)
  {
    scene.Drawn->Features = scene.Drawn->Technique->GetFeatures();
    const auto& cells = scene.Scene.Skipping.Cells;
    scene.Drawn->ExpectedError = cells ? cells->ExpectedError : 0.0;
    scene.Drawn->LeftOut = FeaturesLeftOut(scene.Scene, scene.Drawn->Features);
  }
  this->FullScaleSamples = mapper->GetShow() == vtkVolumeBenchMapper::Picture
    ? std::numeric_limits<double>::quiet_NaN()
    : volumebench::FullScaleSamples(scenes.front().Scene);
  if (timed && !this->Frames.IsCoarse())
  {
    this->Timer.Stop();
  }
}

void VolumePainter::Mark(
  vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, const SelectionMark& mark)
{
  this->UseTechnique(mapper->GetTechnique());
  this->UseWindow(renderer);
  const glm::ivec4 viewport = ReadGlViewport(this->Window);
  std::vector<PartScene> scenes =
    this->ScenesBackToFront(mapper, renderer, volume, { 0, 0, viewport.z, viewport.w });
  for (PartScene& scene : scenes)
  {
    scene.Scene.Measurement = {};
    scene.Scene.Clip.OpaqueGeometry = true; // in a selection pass all props leave their depth
  }
  // Later passes may find the depth of the first, where the volume would be behind its own mark.
  if (mark.BeginsSelection)
  {
    this->PrepareAll(scenes);
    this->Offscreen.Draw(this->Window, viewport, [&] { this->RenderAll(scenes, mapper); });
  }
  for (PartScene& scene : scenes)
  {
    scene.Scene.Camera.Viewport = viewport;
    const bool hasIds = IsNumbered(mapper->GetDataObjectInput()) && !scene.Scene.Share;
    this->Selection.Mark(
      scene.Scene, this->Offscreen, this->Window, hasIds ? mark : WithoutIds(mark));
  }
}

void VolumePainter::DrawOffscreen(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer,
  vtkVolume* volume, const std::string& technique, const Measurement& measurement)
{
  this->UseTechnique(technique);
  this->UseWindow(renderer);
  const glm::ivec4 viewport = ReadGlViewport(this->Window);
  std::vector<PartScene> scenes =
    this->ScenesBackToFront(mapper, renderer, volume, { 0, 0, viewport.z, viewport.w });
  for (PartScene& scene : scenes)
  {
    scene.Scene.Measurement = measurement;
    scene.Scene.Sampling.Method = ReferenceMethod::CellExact;
  }
  this->PrepareAll(scenes);
  this->Offscreen.Draw(this->Window, viewport,
    [&]
    {
      this->RenderAll(scenes, mapper);
      glFinish();
    });
}

FloatPicture VolumePainter::ReadOffscreen()
{
  const GlContextGuard guard(this->Window);
  return this->Offscreen.Read();
}

ChangeStamp VolumePainter::StampOf(const std::vector<PartScene>& scenes) const
{
  ChangeStamp stamp = std::hash<std::string>{}(this->TechniqueId);
  for (const PartScene& scene : scenes)
  {
    ExtendStamp(stamp, PictureStampOf(scene.Scene));
  }
  return stamp;
}

ChangeStamp VolumePainter::StampOf(
  vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  this->UseTechnique(mapper->GetTechnique());
  this->UseWindow(renderer);
  const GlContextGuard guard(this->Window);
  const glm::ivec4 viewport = ReadGlViewport(this->Window);
  const std::vector<PartScene> scenes = this->ScenesBackToFront(mapper, renderer, volume, viewport);
  ChangeStamp stamp = this->StampOf(scenes);
  if (std::any_of(scenes.begin(), scenes.end(),
        [](const PartScene& scene) { return scene.Scene.Clip.OpaqueGeometry; }))
  {
    this->Depth.Capture(this->Window, viewport);
    for (const float depth : this->Depth.Read(viewport))
    {
      ExtendStamp(stamp, depth);
    }
  }
  return stamp;
}
}
