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
/// A ray at its three finest step sizes: h, h / 2 and h / 4.
struct MidpointRay
{
  glm::dvec4 Whole{ 0.0 };
  glm::dvec4 Half{ 0.0 };
  glm::dvec4 Quarter{ 0.0 };
  double Evaluations = 0.0;

  /// Second-order extrapolation of the two finest.
  glm::dvec4 Extrapolated() const { return this->Quarter + (this->Quarter - this->Half) / 3.0; }
};

struct MidpointSteps
{
  double Largest = 1.0 / 64.0;   // voxels: h where that is fine enough
  double Smallest = 1.0 / 512.0; // of the finest step, however far it is from enough
  double Tolerance = 3.0e-7;     // by which the two finest may differ in a channel
};

/// Halves h until the two finest steps agree, and those before them to eight times as much: peaks
/// of a function that no step meets would let any two agree by chance. Maximum and Minimum have no
/// order: they take the extreme of all samples.
MidpointRay CastMidpoint(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, const MidpointSteps& steps);
}

#endif
