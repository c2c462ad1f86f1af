#include "Techniques/Slices.h"

#include "Gpu/GlRoom.h"
#include "Scene/CellMap.h"
#include "Scene/PackScene.h"
#include "Stopwatch.h"
#include "Techniques/Gathering.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>

namespace volumebench
{
namespace
{
constexpr GLuint CornerAttribute = 0; // layout(location) in Slices.vert

// Sums and extreme values need all their digits, whatever target the scene asks for.
GLenum TargetFormat(const Scene& scene, const FeatureSet& features)
{
  if (ProjectsValue(features) || Has(features, Feature::SampleCount))
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
}

FeatureSet Slices::FeaturesFor(const Scene& scene) const
{
  // Fragments know nothing of those before them, and no ray is set up.
  FeatureSet features = FeaturesNeededBy(scene);
  features.reset(static_cast<std::size_t>(Feature::Termination));
  features.reset(static_cast<std::size_t>(Feature::Compensation)); // batches do it
  features.reset(static_cast<std::size_t>(Feature::TightBox));     // the tiles do these two
  features.reset(static_cast<std::size_t>(Feature::Skipping));
  features.reset(static_cast<std::size_t>(Feature::Ramps)); // a fragment would read all for one step
  features.reset(static_cast<std::size_t>(Feature::MoreRamps));
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

void Slices::Compile(const Scene& scene)
{
  this->ProgramOf({ "Viewport.vert", "SlabRays.frag" });
  this->ProgramOf({ "Slices.vert", "Slices.frag" });
  this->ProgramOf({ "Viewport.vert", "SlicesBatch.frag" });
  this->ProgramOf({ "Viewport.vert", scene.Brick ? "Picture.frag" : "Finish.frag" });
}

// The slabs that may touch what is drawn, one more at either end for rounding and for jitter, which
// moves slabs by up to one.
SlabRange Slices::SlabsOf(const Scene& scene, const SliceView& view)
{
  const SlabSeries& slabs = view.Slabs;
  if (!scene.Brick)
  {
    return { 0, slabs.Count };
  }
  const glm::dvec3 middle = 0.5 * (scene.Brick->SeenHigh + scene.Brick->SeenLow);
  const glm::dvec3 half = 0.5 * (scene.Brick->SeenHigh - scene.Brick->SeenLow);
  const double depth = view.MiddleDepth + glm::dot(view.DepthGradient, middle) - slabs.First;
  const double reach = glm::dot(glm::abs(view.DepthGradient), half);
  const double last = slabs.Count;
  const double first = std::floor((depth - reach) / slabs.Spacing) - 1.0;
  const double end = std::ceil((depth + reach) / slabs.Spacing) + 1.0;
  const int from = static_cast<int>(std::clamp(first, 0.0, last));
  return { from, static_cast<int>(std::clamp(end, 0.0, last)) - from };
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
  const SlabRange drawn = SlabsOf(scene, view.Slices);
  const SlabRange part{ drawn.First - range.First, drawn.Count };
  tiled ? this->OrderTiles(part, backToFront) : this->OrderPolygons(part, backToFront);
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

void Slices::OrderTiles(const SlabRange& part, bool backToFront)
{
  constexpr int Corners = 4;
  const std::vector<int>& firsts = this->Tiles.GetFirsts();
  const int begin = std::max(0, part.First);
  const int end = std::min(static_cast<int>(firsts.size()) - 1, part.First + part.Count);
  this->Firsts.clear();
  for (int i = begin; i < end; ++i)
  {
    const int slab = backToFront ? end - 1 - (i - begin) : i;
    for (int first = firsts[slab]; first < firsts[slab + 1]; first += Corners)
    {
      this->Firsts.push_back(first);
    }
  }
  this->Counts.assign(this->Firsts.size(), Corners);
}

void Slices::OrderPolygons(const SlabRange& part, bool backToFront)
{
  const std::vector<int>& counts = this->Polygons.GetCounts();
  const int begin = std::max(0, part.First);
  const int end = std::min(static_cast<int>(counts.size()), part.First + part.Count);
  this->Firsts.clear();
  this->Counts.clear();
  for (int i = begin; i < end; ++i)
  {
    const int slab = backToFront ? end - 1 - (i - begin) : i;
    if (counts[slab] > 0)
    {
      this->Firsts.push_back(slab * SlicePolygons::SlotCorners);
      this->Counts.push_back(counts[slab]);
    }
  }
}

void Slices::SetBlending(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  BlendAsGathered(window, this->GetFeatures(), scene.Sampling.Slices.BackToFront);
}

void Slices::DrawRays(const Scene& scene, const SlabSeries& slabs, vtkOpenGLRenderWindow* window,
  const glm::ivec4& rectangle)
{
  const OffscreenScope scope(window);
  const glm::ivec4 box = BoxRectangle(scene);
  this->Rays.Resize(glm::ivec2(box.z, box.w), GL_RGBA32F);
  this->Rays.Bind(window, box, scene.Camera.Viewport);
  TextureUnits units(window);
  const GlProgram& program = this->ProgramOf({ "Viewport.vert", "SlabRays.frag" });
  this->BindWithScene(program, window, units);
  program.SetNumbers(
    "slabSeries", static_cast<float>(slabs.First), static_cast<float>(slabs.Spacing));
  BlendOff(window);
  const glm::ivec4 part(rectangle.x - box.x, rectangle.y - box.y, rectangle.z, rectangle.w);
  this->DrawTriangle(window, &part);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
}

void Slices::DrawPolygons(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  const GlProgram& program = this->ProgramOf({ "Slices.vert", "Slices.frag" });
  TextureUnits units(window);
  this->BindWithScene(program, window, units);
  program.SetUnit("slabRayTexture", units.Attach(this->Rays.GetTexture()));
  program.SetNumbers("slabSeries", static_cast<float>(this->View.Slices.Slabs.First),
    static_cast<float>(this->View.Slices.Slabs.Spacing));
  this->SetBlending(scene, window);
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_CULL_FACE);
  const glm::ivec4 box = BoxRectangle(scene);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rectangle.x - box.x, rectangle.y - box.y, rectangle.z, rectangle.w);
  glBindVertexArray(this->CornerArray);
  glMultiDrawArrays(GL_TRIANGLE_FAN, this->Firsts.data(), this->Counts.data(),
    static_cast<GLsizei>(this->Firsts.size()));
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
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

void Slices::DrawSlabs(const Scene& scene, const SliceView& slices, vtkOpenGLRenderWindow* window,
  const glm::ivec4& rectangle)
{
  const glm::ivec4 box = BoxRectangle(scene);
  const glm::ivec4& viewport = scene.Camera.Viewport;
  TileView view;
  view.Slices = slices;
  view.Cells = this->LeavesTilesOut() ? scene.Skipping.Cells->Stamp : 0;
  view.MovedSlabs = MovesBorders(this->GetFeatures()) ? 1 : 0;
  view.Viewport = viewport;
  view.Rectangle = box;
  const std::vector<SlabRange> batches =
    BatchesOf(view.Slices.Slabs.Count, scene.Sampling.Slices.BackToFront);
  const glm::ivec2 size(box.z, box.w);
  const glm::vec4 empty = EmptyRay(this->GetFeatures());
  const OffscreenScope scope(window);
  this->Target.Resize(size, TargetFormat(scene, this->GetFeatures()));
  this->Target.Bind(window, box, viewport);
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
          this->DrawPolygons(scene, window, rectangle);
          return;
        }
        this->Batch.Resize(size, TargetFormat(scene, this->GetFeatures()));
        this->Batch.Bind(window, box, viewport);
        OffscreenTarget::Clear(empty);
        this->DrawPolygons(scene, window, rectangle);
        this->Target.Bind(window, box, viewport);
        this->MergeBatch(scene, window);
      });
  }
}

void Slices::Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  // The spacing is that of the whole box, so that leaving parts out moves no sample.
  const glm::ivec4 box = BoxRectangle(scene);
  const SliceView view = MakeSliceView(scene, this->GetNumbers(), box);
  this->GetFrameStages().OnDevice(
    "rays", [&] { this->DrawRays(scene, view.Slabs, window, rectangle); });
  this->DrawSlabs(scene, view, window, rectangle);
  if (scene.Brick)
  {
    this->DisplayPicture(window, this->Target.GetTexture(), rectangle);
  }
  else
  {
    this->Finish(window, this->Target.GetTexture(), { box.x, box.y }, rectangle);
  }
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
