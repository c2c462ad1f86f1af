#include "Techniques/Slices.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>
#include <chrono>

namespace volumebench
{
namespace
{
constexpr GLuint CornerAttribute = 0; // layout(location) in Slices.vert

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

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
  return features.reset(static_cast<std::size_t>(Feature::RasterisedSetUp));
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

void Slices::UpdatePolygons(const Scene& scene, const SliceView& view, const SlabRange& range)
{
  const Clock::time_point begin = Clock::now();
  const int threads = this->ThreadsFor(scene, range.Count);
  const bool known =
    this->CornerBuffer && view == this->View && range == this->Range && threads == this->Threads;
  if (!known)
  {
    this->Polygons.Tessellate(view, range, threads);
    this->View = view;
    this->Range = range;
    this->Threads = threads;
  }
  this->OrderPolygons(scene.Sampling.Slices.BackToFront);
  this->GetFrameStages().Add("tessellation", MillisecondsSince(begin));
  this->GetFrameStages().OnDevice("upload",
    [&]
    {
      if (!known)
      {
        this->UploadPolygons();
      }
    });
}

void Slices::UploadPolygons()
{
  if (!this->CornerBuffer)
  {
    glGenBuffers(1, &this->CornerBuffer);
    glGenVertexArrays(1, &this->CornerArray);
  }
  glBindVertexArray(this->CornerArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->CornerBuffer);
  const std::vector<SliceCorner>& corners = this->Polygons.GetCorners();
  glBufferData(
    GL_ARRAY_BUFFER, corners.size() * sizeof(SliceCorner), corners.data(), GL_STREAM_DRAW);
  glVertexAttribPointer(CornerAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(SliceCorner), nullptr);
  glEnableVertexAttribArray(CornerAttribute);
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
  this->Rays.Resize(glm::ivec2(rectangle.z, rectangle.w), GL_RGBA32F);
  this->Rays.Bind(window, rectangle, scene.Camera.Viewport);
  TextureUnits units(window);
  this->BindWithScene(this->ProgramOf({ "Viewport.vert", "SlabRays.frag" }), window, units);
  BlendOff(window);
  this->DrawTriangle(window, nullptr);
}

void Slices::DrawPolygons(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlProgram& program = this->ProgramOf({ "Slices.vert", "Slices.frag" });
  TextureUnits units(window);
  this->BindWithScene(program, window, units);
  program.SetUnit("slabRayTexture", units.Attach(this->Rays.GetTexture()));
  program.SetNumbers("slabSeries", static_cast<float>(this->View.Slabs.First),
    static_cast<float>(this->View.Slabs.Spacing));
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

void Slices::DrawSlabs(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  const SliceView view = MakeSliceView(scene, rectangle);
  const std::vector<SlabRange> batches =
    BatchesOf(view.Slabs.Count, scene.Sampling.Slices.BackToFront);
  const glm::ivec4& viewport = scene.Camera.Viewport;
  const glm::ivec2 size(rectangle.z, rectangle.w);
  const glm::vec4 empty = EmptyRay(this->GetFeatures());
  const OffscreenScope scope(window);
  this->Target.Resize(size, TargetFormat(scene, this->GetFeatures()));
  this->Target.Bind(window, rectangle, viewport);
  OffscreenTarget::Clear(empty);
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
  this->DrawSlabs(scene, window, rectangle);
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
