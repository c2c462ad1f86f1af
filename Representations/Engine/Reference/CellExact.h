// The first reference: the ray is walked cell by cell, and what the blend mode asks for is worked
// out of the cubics that the field is there (after Weiss & Westermann, "Analytic Ray Splitting for
// Controlled Precision DVR", 2021). No step, no table; only kinks that depend on the gradient are
// left to halving.
#ifndef volumebench_CellExact_h
#define volumebench_CellExact_h

#include "Reference/ReferenceScene.h"

namespace volumebench
{
/// The pixel of a ray, premultiplied.
struct ReferenceRay
{
  glm::dvec4 Pixel{ 0.0 };
  double Bound = 0.0;       // estimated error
  double Evaluations = 0.0; // of field and transfer function
  bool Stopped = false;     // since nothing behind could be seen
};

/// `tolerance` is the error that the quadrature of a ray may be estimated to have; ten times that
/// where colour or extinction depend on the gradient.
ReferenceRay CastCellExact(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double tolerance);

/// Colour and opacity of one value, as Maximum, Minimum and Average show it.
glm::dvec4 ProjectedPixel(const ReferenceScene& scene, double stored);
}

#endif
