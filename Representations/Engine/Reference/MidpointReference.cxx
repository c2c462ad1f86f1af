#include "Reference/MidpointReference.h"

#include "Reference/CellExact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
// Colour and extinction per unit of the ray, point by point.
class PointSampler
{
public:
  PointSampler(const ReferenceScene& scene, const shared64::Ray& ray)
    : Scene(scene)
    , Ray(ray)
    , Origin(scene.TexelOrigin(ray))
  {
  }

  double ValueAt(double along) const { return this->At(this->Position(along)); }

  glm::dvec4 operator()(double along) const
  {
    const glm::dvec3 position = this->Position(along);
    glm::dvec4 at = this->Classified(position);
    if (this->Scene.Mode == BlendMode::Gradient)
    {
      at.w *= this->Scene.ChangeShare(this->ValueAt(along - 1.0), this->ValueAt(along + 1.0));
    }
    const bool lit = this->Scene.HasLighting && at.w > 0.0;
    if (this->Scene.HasGradientOpacity || lit)
    {
      const glm::dvec3 difference = this->Difference(position);
      at.w *= this->Scene.HasGradientOpacity ? this->Scene.GradientOpacityOf(difference) : 1.0;
      at = lit
        ? glm::dvec4(this->Scene.LitColor(this->Ray, along, glm::dvec3(at), difference), at.w)
        : at;
    }
    at.w *= this->Ray.lengthPerUnit;
    return at;
  }

private:
  glm::dvec3 Position(double along) const { return this->Origin + along * this->Ray.direction; }

  double At(const glm::dvec3& position) const
  {
    return this->Scene.Field.At(position, this->Scene.Channels - 1);
  }

  glm::dvec4 Classified(const glm::dvec3& position) const
  {
    const glm::dvec4 at = this->Scene.Function.At(this->At(position));
    const auto channel = [&](int i) { return this->Scene.Field.At(position, i); };
    switch (this->Scene.Channels)
    {
      case 2:
        return glm::dvec4(glm::dvec3(this->Scene.ColorFunction.At(channel(0))), at.w);
      case 4:
        return { channel(0), channel(1), channel(2), at.w };
      default:
        return at;
    }
  }

  glm::dvec3 Difference(const glm::dvec3& position) const
  {
    glm::dvec3 difference;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 shift(0.0);
      shift[axis] = 1.0;
      difference[axis] = this->At(position + shift) - this->At(position - shift);
    }
    return difference;
  }

  const ReferenceScene& Scene;
  const shared64::Ray& Ray;
  const glm::dvec3 Origin;
};

// Calls sample(along, width) in the middle of equal steps over all that is seen and not blank.
template <typename Sample>
double ForEachStep(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double step, const Sample& sample)
{
  double taken = 0.0;
  for (int part = 0; part < visible.Count; ++part)
  {
    const shared64::Interval& interval = visible.Parts[part];
    const double length = interval.end - interval.begin;
    const double count = std::ceil(length / step);
    for (double i = 0.0; i < count; i += 1.0)
    {
      const double along = interval.begin + (i + 0.5) * (length / count);
      if (!scene.IsBlank(ray, along))
      {
        sample(along, length / count);
        taken += 1.0;
      }
    }
  }
  return taken;
}

glm::dvec4 Composited(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double step, double& evaluations)
{
  const PointSampler sampler(scene, ray);
  glm::dvec3 color(0.0);
  double depth = 0.0;
  evaluations += ForEachStep(scene, ray, visible, step,
    [&](double along, double width)
    {
      const glm::dvec4 at = sampler(along);
      color += (std::exp(-depth) * -std::expm1(-at.w * width)) * glm::dvec3(at);
      depth += at.w * width;
    });
  return { color, -std::expm1(-depth) };
}

glm::dvec4 Projected(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double step, double& evaluations)
{
  const PointSampler sampler(scene, ray);
  const double sign = scene.Mode == BlendMode::Minimum ? -1.0 : 1.0;
  double extreme = -std::numeric_limits<double>::infinity();
  double integral = 0.0;
  double length = 0.0;
  evaluations += ForEachStep(scene, ray, visible, step,
    [&](double along, double width)
    {
      const double value = sampler.ValueAt(along);
      extreme = std::max(extreme, sign * value);
      integral += value * width;
      length += width;
    });
  if (!(length > 0.0))
  {
    return glm::dvec4(0.0);
  }
  return ProjectedPixel(
    scene, scene.Mode == BlendMode::Average ? integral / length : sign * extreme);
}
}

namespace
{
double LargestDifference(const glm::dvec4& a, const glm::dvec4& b)
{
  const glm::dvec4 difference = glm::abs(a - b);
  return std::max({ difference.x, difference.y, difference.z, difference.w });
}
}

MidpointRay CastMidpoint(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, const MidpointSteps& steps)
{
  const bool composites = scene.Mode == BlendMode::Composite || scene.Mode == BlendMode::Gradient;
  const auto cast = composites ? Composited : Projected;
  MidpointRay result;
  double finest = 0.25 * steps.Largest;
  result.Whole = cast(scene, ray, visible, 4.0 * finest, result.Evaluations);
  result.Half = cast(scene, ray, visible, 2.0 * finest, result.Evaluations);
  result.Quarter = cast(scene, ray, visible, finest, result.Evaluations);
  while (composites && 0.5 * finest >= steps.Smallest &&
    (LargestDifference(result.Half, result.Quarter) > steps.Tolerance ||
      LargestDifference(result.Whole, result.Half) > 8.0 * steps.Tolerance))
  {
    finest *= 0.5;
    result.Whole = result.Half;
    result.Half = result.Quarter;
    result.Quarter = cast(scene, ray, visible, finest, result.Evaluations);
  }
  return result;
}
}
