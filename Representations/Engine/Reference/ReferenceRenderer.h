// Renders a scene in double precision on all cores: the picture that errors are measured against.
// The cell-exact reference is exact up to rounding and an estimated quadrature error; Midpoint
// checks it. Both take what a scene shows and ignore how its Sampling says it should be sampled.
// Gradient opacity is read from its table of 1024 factors, as every technique does.
#ifndef volumebench_ReferenceRenderer_h
#define volumebench_ReferenceRenderer_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <functional>
#include <memory>
#include <vector>

namespace volumebench
{
struct ReferenceOptions
{
  ReferenceMethod Method = ReferenceMethod::CellExact;
  double Tolerance = 1.0e-9;      // CellExact: estimated error that a ray may have
  double StepVoxels = 1.0 / 64.0; // Midpoint: the largest of its steps
  int PixelsPerRay = 1;           // of each axis; more draws a coarse picture
};

/// What the volume covers of the window. With Scene::Measurement::CountSamples the pixels hold
/// counts as CountSamples has them: evaluations of field and transfer function, 0, whether the ray
/// stopped.
struct ReferencePicture
{
  glm::ivec4 Rectangle{
    0
  };             // x, y, width, height in window pixels; the pixels lie in it row by row
  int Width = 0; // of the picture: that of the rectangle over PixelsPerRay, rounded up
  int Height = 0;
  std::vector<glm::dvec4> Pixels; // premultiplied RGBA, bottom row first
  double LargestBound = 0.0;      // estimated error of the worst pixel
  double Order = 0.0;             // Midpoint: order of convergence that was observed; NaN if none
  double Evaluations = 0.0;
  bool Complete = false; // false: aborted, and the pixels mean nothing
};

/// Is told the share of rows done, on the calling thread; returns false to abort.
using ReferenceProgress = std::function<bool(double share)>;

class VOLUMEBENCHENGINE_EXPORT ReferenceRenderer
{
public:
  ReferenceRenderer();
  ~ReferenceRenderer();

  /// Makes what is kept of the scene's data from picture to picture. Throws SceneError.
  void Prepare(const Scene& scene);

  ///@{
  /// What the making took when it was last done: of the values, of the transfer function.
  double GetFieldMs() const;
  double GetFunctionMs() const;
  ///@}

  /// `windowDepth` is the depth of opaque geometry for each pixel of the viewport; null when there
  /// is none. Throws SceneError. Prepares first if that was not done.
  ReferencePicture Render(const Scene& scene, const ReferenceOptions& options = {},
    const std::vector<float>* windowDepth = nullptr, const ReferenceProgress& progress = {});

private:
  struct Kept;
  std::unique_ptr<Kept> Data;
};
}

#endif
