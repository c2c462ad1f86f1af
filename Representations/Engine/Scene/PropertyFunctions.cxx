#include "Scene/PropertyFunctions.h"

#include "Scene/NumberText.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace volumebench
{
namespace
{
// A point of a function: where it stands, and how the part up to the next is bent.
struct Point
{
  double Value;
  double Midpoint;
  double Sharpness;
};

std::vector<Point> PointsOf(vtkPiecewiseFunction* function)
{
  std::vector<Point> points;
  double node[4];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    points.push_back({ node[0], node[2], node[3] });
  }
  return points;
}

std::vector<Point> PointsOf(vtkColorTransferFunction* function)
{
  std::vector<Point> points;
  double node[6];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    points.push_back({ node[0], node[4], node[5] });
  }
  return points;
}

template <int Numbers, typename Function>
void CheckFinite(Function* function, const std::string& name)
{
  double node[Numbers];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    if (!std::all_of(node, node + Numbers, [](double number) { return std::isfinite(number); }))
    {
      throw SceneError("the " + name + " function has a point that is not finite: number " +
        std::to_string(i + 1) + " of " + std::to_string(function->GetSize()) + ", at " +
        NumberText(node[0]));
    }
  }
}

// Colours beyond 0 to 1 make pixels beyond them, which the compositing of several ranks takes as
// they are.
void CheckColors(vtkColorTransferFunction* function)
{
  constexpr double Rounding = 1.0e-6;
  double node[6];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    if (std::any_of(node + 1, node + 4,
          [](double share) { return share < -Rounding || share > 1.0 + Rounding; }))
    {
      throw SceneError(
        "the colour function has a colour that is not from 0 to 1: " + NumberText(node[1]) + ", " +
        NumberText(node[2]) + ", " + NumberText(node[3]) + " at " + NumberText(node[0]));
    }
  }
}

std::set<double> ValuesOf(const std::vector<Point>& points)
{
  std::set<double> values;
  for (const Point& point : points)
  {
    values.insert(point.Value);
  }
  return values;
}

// VTK bends a part round its midpoint, and jumps there when it is sharp.
void AddMidpoints(const std::vector<Point>& points, std::set<double>& knots)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Point& from = points[i - 1];
    if (from.Midpoint != 0.5 || from.Sharpness != 0.0)
    {
      knots.insert(from.Value + from.Midpoint * (points[i].Value - from.Value));
    }
  }
}
}

void CheckPoints(vtkPiecewiseFunction* function, const char* name)
{
  CheckFinite<4>(function, name);
}

PropertyFunctions::PropertyFunctions(vtkVolumeProperty* property)
  : Opacity(property->GetScalarOpacity(0))
{
  if (this->Opacity->GetSize() < 1)
  {
    throw SceneError("the opacity function has no points");
  }
  if (property->GetColorChannels(0) == 1)
  {
    this->Gray = property->GetGrayTransferFunction(0);
  }
  else
  {
    this->Color = property->GetRGBTransferFunction(0);
  }
  if ((this->Color ? this->Color->GetSize() : this->Gray->GetSize()) < 1)
  {
    throw SceneError("the colour function has no points");
  }
  CheckPoints(this->Opacity, "opacity");
  if (this->Color)
  {
    CheckFinite<6>(this->Color, "colour");
    CheckColors(this->Color);
  }
  else
  {
    CheckPoints(this->Gray, "colour");
  }
}

bool PropertyFunctions::Clamping() const
{
  return this->Opacity->GetClamping() &&
    (this->Color ? this->Color->GetClamping() != 0 : this->Gray->GetClamping() != 0);
}

std::set<double> PropertyFunctions::OpacityKnots() const
{
  return ValuesOf(PointsOf(this->Opacity));
}

std::set<double> PropertyFunctions::ColorKnots() const
{
  return ValuesOf(this->Color ? PointsOf(this->Color) : PointsOf(this->Gray));
}

std::vector<double> PropertyFunctions::Knots() const
{
  const std::vector<Point> opacity = PointsOf(this->Opacity);
  const std::vector<Point> color = this->Color ? PointsOf(this->Color) : PointsOf(this->Gray);
  std::set<double> knots = ValuesOf(opacity);
  const std::set<double> colorKnots = ValuesOf(color);
  knots.insert(colorKnots.begin(), colorKnots.end());
  AddMidpoints(opacity, knots);
  AddMidpoints(color, knots);
  return { knots.begin(), knots.end() };
}

std::vector<double> PropertyFunctions::SampleOpacity(double low, double high, int size) const
{
  std::vector<double> opacity(size);
  this->Opacity->GetTable(low, high, size, opacity.data());
  return opacity;
}

std::vector<double> PropertyFunctions::SampleColor(double low, double high, int size) const
{
  std::vector<double> color(std::size_t(3) * size);
  if (this->Color)
  {
    this->Color->GetTable(low, high, size, color.data());
    return color;
  }
  std::vector<double> gray(size);
  this->Gray->GetTable(low, high, size, gray.data());
  for (int i = 0; i < size; ++i)
  {
    std::fill_n(color.data() + std::ptrdiff_t(3) * i, 3, gray[i]);
  }
  return color;
}

std::vector<glm::dvec4> PropertyFunctions::Sample(double low, double high, int size) const
{
  const std::vector<double> opacity = this->SampleOpacity(low, high, size);
  const std::vector<double> color = this->SampleColor(low, high, size);
  std::vector<glm::dvec4> samples(size);
  for (int i = 0; i < size; ++i)
  {
    const double* rgb = color.data() + std::ptrdiff_t(3) * i;
    samples[i] = { rgb[0], rgb[1], rgb[2], opacity[i] };
  }
  return samples;
}

ChangeStamp PropertyFunctions::GetStamp() const
{
  ChangeStamp stamp = this->Opacity->GetMTime();
  ExtendStamp(stamp, this->Color ? this->Color->GetMTime() : this->Gray->GetMTime());
  return stamp;
}
}
