// What cases along parallel rays share: the view along z whose pixels all lie inside the box, the
// scene with a linear colour, and noting what a picture measures.
#ifndef volumebench_StraightView_h
#define volumebench_StraightView_h

#include "Stability/Shot.h"
#include "Stability/Trial.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace volumebench
{
/// Share of the box's height that LookStraight shows, so that no pixel is at the border of the box.
constexpr double StraightShare = 0.9;

/// Looks along -z, or along z when `fromBelow`, in parallel projection at the middle of the box.
void LookStraight(Shot& shot, bool fromBelow = false);

/// World x of the middle of a pixel column under LookStraight from above.
double ColumnX(const Shot& shot, double x);

/// Draws and notes the worst difference from one expected pixel.
void NotePlain(Trial& trial, const Shot& shot, const glm::dvec4& expected, double limit,
  const std::string& what);

/// Notes how far the observed order of convergence is from the expected one; for Segment, which may
/// be better on smooth fields, how far it is below. Errors that are within
/// the rounding of a float picture from the first on have no order: then the last is noted instead.
void NoteOrder(Trial& trial, const std::vector<double>& errors, double order, double tolerance);

/// A colour that goes linearly from Begin where rays enter to Begin + Change where they leave, over
/// the length of 1.
struct ColorRamp
{
  glm::dvec3 Begin{ 0.9, 0.1, 0.5 };
  glm::dvec3 Change{ -0.7, 0.8, 0.0 };
};

/// The field is the distance from the upper side, 0 to 1, in so many cells.
vtkSmartPointer<vtkImageData> MakeColorRampImage(int cells);

vtkSmartPointer<vtkVolumeProperty> MakeColorRampProperty(const ColorRamp& ramp, double extinction);

/// Begin (1 - exp(-k)) + Change (1/k - (1 + 1/k) exp(-k)) and the opacity.
glm::dvec4 ColorRampPixel(const ColorRamp& ramp, double extinction);
}

#endif
