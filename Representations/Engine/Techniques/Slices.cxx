#include "Techniques/Slices.h"

#include "Gpu/GlRoom.h"
#include "Scene/CellMap.h"
#include "Scene/PackScene.h"
#include "Stopwatch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>

namespace volumebench
{
namespace
{
constexpr GLuint CornerAttribute = 0; // layout(location) in Slices.vert

bool Projects(const FeatureSet& features)
{
  return Has(features, Feature::MaximumBlend) || Has(features, Feature::MinimumBlend) ||
    Has(features, Feature::AverageBlend);
}

// Sums and extreme values need all their digits, whatever target the scene asks for.
GLenum TargetFormat(const Scene& scene, const FeatureSet& features)
{
  if (Projects(features) || Has(features, Feature::SampleCount))
  {
    return GL_RGBA32F;
  }
  switch (scene.Sampling.Slices.Target)
  {
    case SliceTarget::Float16:
      return GL_RGBA16F;
    case SliceTarget::Unsigned8:
      return GL_RGBA8;
    default:
      return GL_RGBA32F;
  }
}

// Slabs in batches: a picture of very many has its sums made in two stages, so that rounding does
// not gather, and needs no more memory than one batch.
std::vector<SlabRange> BatchesOf(int slabs, bool backToFront)
{
  constexpr int MostInBatch = 4096;
  std::vector<SlabRange> batches;
  for (int first = 0; first < slabs; first += MostInBatch)
  {
    batches.push_back({ first, std::min(MostInBatch, slabs - first) });
  }
  if (backToFront)
  {
    std::reverse(batches.begin(), batches.end());
  }
  return batches;
}

// emptyRay of Shared/Composite.h.
glm::vec4 EmptyRay(const FeatureSet& features)
{
  if (Has(features, Feature::SampleCount) || !Projects(features) ||
    Has(features, Feature::AverageBlend))
  {
    return glm::vec4(0.0f);
  }
  return { Has(features, Feature::MaximumBlend) ? -1.0e30f : 1.0e30f, 0.0f, 0.0f, 0.0f };
}
}

FeatureSet Slices::FeaturesFor(const Scene& scene) const
{
  // Fragments know nothing of those before them, and no ray is set up.
  FeatureSet features = FeaturesNeededBy(scene);
  features.reset(static_cast<std::size_t>(Feature::Termination));
  features.reset(static_cast<std::size_t>(Feature::Compensation)); // batches do it
  features.reset(static_cast<std::size_t>(Feature::TightBox));     // the tiles do these two
  features.reset(static_cast<std::size_t>(Feature::Skipping));
  return features.reset(static_cast<std::size_t>(Feature::RasterisedSetUp));
}

// A slab knows nothing of the extremes before it, so none can be left out for them.
FeatureSet Slices::HostFeaturesFor(const Scene& scene) const
{
  FeatureSet features;
  if (scene.Skipping.Cells && !scene.Skipping.Cells->Codes.empty())
  {
    for (const Feature feature : { Feature::TightBox, Feature::Skipping })
    {
      features.set(static_cast<std::size_t>(feature), Has(FeaturesNeededBy(scene), feature));
    }
  }
  return features;
}

bool Slices::LeavesTilesOut() const
{
  return Has(this->GetFeatures(), Feature::TightBox) || Has(this->GetFeatures(), Feature::Skipping);
}

void Slices::Compile(const Scene&)
{
  this->ProgramOf({ "Viewport.vert", "SlabRays.frag" });
  this->ProgramOf({ "Slices.vert", "Slices.frag" });
  this->ProgramOf({ "Viewport.vert", "SlicesBatch.frag" });
  this->ProgramOf({ "Viewport.vert", "SlicesDisplay.frag" });
}

int Slices::ThreadsFor(const Scene&, int) const
{
  return 1;
}

void Slices::UpdatePolygons(const Scene& scene, const TileView& view, const SlabRange& range)
{
  const Stopwatch watch;
  const int threads = this->ThreadsFor(scene, range.Count);
  const bool tiled = this->LeavesTilesOut();
  const bool known = this->CornerBuffer && view == this->View && range == this->Range &&
    threads == this->Threads && tiled == this->Tiled;
  if (!known)
  {
    tiled ? this->Tiles.Cover(view, *scene.Skipping.Cells, range, threads)
          : this->Polygons.Tessellate(view.Slices, range, threads);
    this->View = view;
    this->Range = range;
    this->Threads = threads;
    this->Tiled = tiled;
  }
  const bool backToFront = scene.Sampling.Slices.BackToFront;
  tiled ? this->OrderTiles(backToFront) : this->OrderPolygons(backToFront);
  this->GetFrameStages().Add("tessellation", watch.ElapsedMs());
  this->GetFrameStages().OnDevice("upload",
    [&]
    {
      if (!known)
      {
        this->UploadCorners(tiled ? this->Tiles.GetCorners() : this->Polygons.GetCorners());
      }
    });
}

void Slices::UploadCorners(const std::vector<SliceCorner>& corners)
{
  if (!this->CornerBuffer)
  {
    glGenBuffers(1, &this->CornerBuffer);
    glGenVertexArrays(1, &this->CornerArray);
  }
  const std::size_t bytes = corners.size() * sizeof(SliceCorner);
  const bool more = bytes > this->CornerBytes;
  if (more)
  {
    ForgetGlErrors();
  }
  this->CornerBytes = bytes;
  glBindVertexArray(this->CornerArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->CornerBuffer);
  glBufferData(
    GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->CornerBytes), corners.data(), GL_STREAM_DRAW);
  if (more) // asking at every frame would wait for the driver
  {
    this->CornerBytes = 0;
    CheckGlRoom("the corners of slices, " + std::to_string(bytes) + " bytes");
    this->CornerBytes = bytes;
  }
  glVertexAttribPointer(CornerAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(SliceCorner), nullptr);
  glEnableVertexAttribArray(CornerAttribute);
}

void Slices::OrderTiles(bool backToFront)
{
  constexpr int Corners = 4;
  const std::vector<int>& firsts = this->Tiles.GetFirsts();
  const int slabs = static_cast<int>(firsts.size()) - 1;
  this->Firsts.clear();
  for (int i = 0; i < slabs; ++i)
  {
    const int slab = backToFront ? slabs - 1 - i : i;
    for (int first = firsts[slab]; first < firsts[slab + 1]; first += Corners)
    {
      this->Firsts.push_back(first);
    }
  }
  this->Counts.assign(this->Firsts.size(), Corners);
}

void Slices::OrderPolygons(bool backToFront)
{
  const std::vector<int>& counts = this->Polygons.GetCounts();
  const int slabs = static_cast<int>(counts.size());
  this->Firsts.clear();
  this->Counts.clear();
  for (int i = 0; i < slabs; ++i)
  {
    const int slab = backToFront ? slabs - 1 - i : i;
    if (counts[slab] > 0)
    {
      this->Firsts.push_back(slab * SlicePolygons::SlotCorners);
      this->Counts.push_back(counts[slab]);
    }
  }
}

// The formulas of `accumulate` in Shared/Composite.h.
void Slices::SetBlending(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  const FeatureSet features = this->GetFeatures();
  BlendOver(window);
  if (Has(features, Feature::SampleCount) || Has(features, Feature::AverageBlend))
  {
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  else if (Projects(features))
  {
    const GLenum extreme = Has(features, Feature::MaximumBlend) ? GL_MAX : GL_MIN;
    state->vtkglBlendEquationSeparate(extreme, extreme);
  }
  else if (!scene.Sampling.Slices.BackToFront)
  {
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
}

void Slices::DrawRays(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  const OffscreenScope scope(window);
  const glm::ivec4 box = BoxRectangle(scene);
  this->Rays.Resize(glm::ivec2(box.z, box.w), GL_RGBA32F);
  this->Rays.Bind(window, box, scene.Camera.Viewport);
  TextureUnits units(window);
  this->BindWithScene(this->ProgramOf({ "Viewport.vert", "SlabRays.frag" }), window, units);
  BlendOff(window);
  const glm::ivec4 part(rectangle.x - box.x, rectangle.y - box.y, rectangle.z, rectangle.w);
  this->DrawTriangle(window, &part);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
}

void Slices::DrawPolygons(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlProgram& program = this->ProgramOf({ "Slices.vert", "Slices.frag" });
  TextureUnits units(window);
  this->BindWithScene(program, window, units);
  program.SetUnit("slabRayTexture", units.Attach(this->Rays.GetTexture()));
  program.SetNumbers("slabSeries", static_cast<float>(this->View.Slices.Slabs.First),
    static_cast<float>(this->View.Slices.Slabs.Spacing));
  this->SetBlending(scene, window);
  window->GetState()->vtkglDisable(GL_CULL_FACE);
  glBindVertexArray(this->CornerArray);
  glMultiDrawArrays(GL_TRIANGLE_FAN, this->Firsts.data(), this->Counts.data(),
    static_cast<GLsizei>(this->Firsts.size()));
  window->GetState()->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
}

// Slabs blended together are blended with others as if they were one.
void Slices::MergeBatch(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlProgram& program = this->ProgramOf({ "Viewport.vert", "SlicesBatch.frag" });
  TextureUnits units(window);
  this->BindWithScene(program, window, units);
  program.SetUnit("batchTexture", units.Attach(this->Batch.GetTexture()));
  this->SetBlending(scene, window);
  this->DrawTriangle(window, nullptr);
  window->GetState()->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
}

void Slices::DrawSlabs(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const glm::ivec4 rectangle = BoxRectangle(scene);
  const glm::ivec4& viewport = scene.Camera.Viewport;
  TileView view;
  // The spacing is that of the whole box, so that leaving parts out moves no sample.
  view.Slices = MakeSliceView(scene, this->GetNumbers(), rectangle);
  view.Cells = this->LeavesTilesOut() ? scene.Skipping.Cells->Stamp : 0;
  view.MovedSlabs = MovesBorders(this->GetFeatures()) ? 1 : 0;
  view.Viewport = viewport;
  view.Rectangle = rectangle;
  const std::vector<SlabRange> batches =
    BatchesOf(view.Slices.Slabs.Count, scene.Sampling.Slices.BackToFront);
  const glm::ivec2 size(rectangle.z, rectangle.w);
  const glm::vec4 empty = EmptyRay(this->GetFeatures());
  const OffscreenScope scope(window);
  this->Target.Resize(size, TargetFormat(scene, this->GetFeatures()));
  this->Target.Bind(window, rectangle, viewport);
  OffscreenTarget::Clear(empty);
  if (batches.size() == 1)
  {
    this->Batch.Release();
  }
  for (const SlabRange& batch : batches)
  {
    this->UpdatePolygons(scene, view, batch);
    this->GetFrameStages().OnDevice("drawing",
      [&]
      {
        if (batches.size() == 1)
        {
          this->DrawPolygons(scene, window);
          return;
        }
        this->Batch.Resize(size, TargetFormat(scene, this->GetFeatures()));
        this->Batch.Bind(window, rectangle, viewport);
        OffscreenTarget::Clear(empty);
        this->DrawPolygons(scene, window);
        this->Target.Bind(window, rectangle, viewport);
        this->MergeBatch(scene, window);
      });
  }
}

void Slices::Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  this->GetFrameStages().OnDevice("rays", [&] { this->DrawRays(scene, window, rectangle); });
  this->DrawSlabs(scene, window);
  const GlProgram& display = this->ProgramOf({ "Viewport.vert", "SlicesDisplay.frag" });
  TextureUnits units(window);
  this->BindWithScene(display, window, units);
  display.SetUnit("slicesTexture", units.Attach(this->Target.GetTexture()));
  BlendOver(window);
  this->GetFrameStages().OnDevice("display", [&] { this->DrawTriangle(window, &rectangle); });
}

void Slices::ReleaseOwn()
{
  this->Target.Release();
  this->Batch.Release();
  this->Rays.Release();
  if (this->CornerBuffer)
  {
    glDeleteBuffers(1, &this->CornerBuffer);
    glDeleteVertexArrays(1, &this->CornerArray);
  }
}

void Slices::ForgetOwn()
{
  this->Target.Forget();
  this->Batch.Forget();
  this->Rays.Forget();
  this->CornerBuffer = this->CornerArray = 0;
}
}
