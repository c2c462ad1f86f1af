// The opacity and colour functions of a volume property, read in double precision.
#ifndef volumebench_PropertyFunctions_h
#define volumebench_PropertyFunctions_h

#include "Scene/Scene.h"

#include <glm/vec4.hpp>

#include <set>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

namespace volumebench
{
/// Throws SceneError that begins "the NAME function" when a number of a point is not finite.
void CheckPoints(vtkPiecewiseFunction* function, const char* name);

class PropertyFunctions
{
public:
  /// Of component 0. Throws SceneError when a function has no points, or one that is not
  /// finite or of no colour.
  explicit PropertyFunctions(vtkVolumeProperty* property);

  /// Whether values outside the points take the value at the nearest of them.
  bool Clamping() const;

  ///@{
  /// Values of the points.
  std::set<double> OpacityKnots() const;
  std::set<double> ColorKnots() const;
  ///@}

  /// Where any of them may jump or have a kink, ascending: points, and midpoints of bent parts.
  std::vector<double> Knots() const;

  ///@{
  /// At `size` values, equally spaced from low to high; colours as red, green, blue in turn. A
  /// single one is in the middle.
  std::vector<double> SampleOpacity(double low, double high, int size) const;
  std::vector<double> SampleColor(double low, double high, int size) const;
  std::vector<glm::dvec4> Sample(double low, double high, int size) const; // rgb, opacity
  ///@}

  glm::dvec4 At(double value) const { return this->Sample(value, value, 1).front(); }

  /// Changes with either function.
  ChangeStamp GetStamp() const;

private:
  vtkPiecewiseFunction* Opacity = nullptr;
  vtkColorTransferFunction* Color = nullptr; // null when gray
  vtkPiecewiseFunction* Gray = nullptr;
};
}

#endif
