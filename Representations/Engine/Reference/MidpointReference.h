// The second reference, for checking the first: the midpoint rule in double precision over equal
// steps, with Richardson's extrapolation. It shares rays and values at a point with the first and
// nothing of how a ray is put together: no cells, no cubics, no knots.
//
// Trilinear data and transfer functions have kinks between the steps, so the error of one step size
// is a second-order term with a share that depends on where the kinks fall. The order that is
// observed over a whole picture tells whether extrapolation gained anything.
#ifndef volumebench_MidpointReference_h
#define volumebench_MidpointReference_h

#include "Reference/ReferenceScene.h"

namespace volumebench
{
/// A ray at three step sizes: h, h / 2 and h / 4.
struct MidpointRay
{
  glm::dvec4 Whole{ 0.0 };
  glm::dvec4 Half{ 0.0 };
  glm::dvec4 Quarter{ 0.0 };
  double Evaluations = 0.0;

  /// Second-order extrapolation of the two finest.
  glm::dvec4 Extrapolated() const { return this->Quarter + (this->Quarter - this->Half) / 3.0; }
};

/// `stepVoxels` is h. Maximum and Minimum have no order: they take the extreme of all samples.
MidpointRay CastMidpoint(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double stepVoxels);
}

#endif
