#include "Flip.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

// A contrast sensitivity function is a sum of Gaussians exp(-pi^2 x^2 / Width) of the angle x in
// degrees.
struct SensitivityTerm
{
  double Height;
  double Width;
};
constexpr SensitivityTerm Achromatic = { 1.0, 0.0047 };
constexpr SensitivityTerm RedGreen = { 1.0, 0.0053 };
constexpr SensitivityTerm BlueYellow[2] = { { 34.1, 0.04 }, { 13.5, 0.025 } };

constexpr float ColorExponent = 0.7f;
constexpr float CompressedShare = 0.4f;   // of the largest colour difference ...
constexpr float CompressedTarget = 0.95f; // ... is stretched over this part of the scale
constexpr double FeatureWidthDegrees = 0.082;
constexpr float FeatureExponent = 0.5f;

struct OpponentPlanes
{
  Plane Luminance;
  Plane RedGreen;
  Plane BlueYellow;
};

double SigmaPixels(const SensitivityTerm& term, double pixelsPerDegree)
{
  return std::sqrt(term.Width / (2.0 * Pi * Pi)) * pixelsPerDegree;
}

OpponentPlanes ToOpponent(const ScreenPicture& picture)
{
  const std::size_t count = picture.Pixels.size() / 3;
  const Plane empty{ picture.Width, picture.Height, std::vector<float>(count) };
  OpponentPlanes planes{ empty, empty, empty };
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::vec3 color = OpponentColor(RelativeXyz(LinearRgb(picture.Pixels.data() + 3 * i)));
    planes.Luminance.Values[i] = color.x;
    planes.RedGreen.Values[i] = color.y;
    planes.BlueYellow.Values[i] = color.z;
  }
  return planes;
}

Plane SeenThrough(const Plane& plane, const SensitivityTerm& term, double pixelsPerDegree)
{
  const Kernel kernel =
    GaussianKernel(SigmaPixels(term, pixelsPerDegree), FlipRadius(pixelsPerDegree));
  return Convolved(plane, kernel, kernel);
}

// What a Gaussian of the blue-yellow sensitivity adds up to over the pixels of its window.
double Weight(const SensitivityTerm& term, double pixelsPerDegree)
{
  const int radius = FlipRadius(pixelsPerDegree);
  const double sigma = SigmaPixels(term, pixelsPerDegree);
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i)
  {
    sum += std::exp(-0.5 * i * i / (sigma * sigma));
  }
  return term.Height * std::sqrt(Pi / term.Width) * sum * sum;
}

Plane SeenBlueYellow(const Plane& plane, double pixelsPerDegree)
{
  Plane sum = SeenThrough(plane, BlueYellow[0], pixelsPerDegree);
  const Plane second = SeenThrough(plane, BlueYellow[1], pixelsPerDegree);
  const double first = Weight(BlueYellow[0], pixelsPerDegree);
  const auto share = static_cast<float>(first / (first + Weight(BlueYellow[1], pixelsPerDegree)));
  for (std::size_t i = 0; i < sum.Values.size(); ++i)
  {
    sum.Values[i] = share * sum.Values[i] + (1.0f - share) * second.Values[i];
  }
  return sum;
}

// L*a*b* with less colour where it is dark (Hunt effect).
glm::vec3 HuntLab(const glm::vec3& linearRgb)
{
  const glm::vec3 lab = Lab(RelativeXyz(linearRgb));
  return { lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z };
}

float HybridDistance(const glm::vec3& a, const glm::vec3& b)
{
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

std::vector<glm::vec3> SeenColors(const OpponentPlanes& planes, double pixelsPerDegree)
{
  const Plane luminance = SeenThrough(planes.Luminance, Achromatic, pixelsPerDegree);
  const Plane redGreen = SeenThrough(planes.RedGreen, RedGreen, pixelsPerDegree);
  const Plane blueYellow = SeenBlueYellow(planes.BlueYellow, pixelsPerDegree);
  std::vector<glm::vec3> colors(luminance.Values.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const glm::vec3 opponent(luminance.Values[i], redGreen.Values[i], blueYellow.Values[i]);
    const glm::vec3 rgb = LinearRgbOfXyz(XyzOfOpponentColor(opponent));
    colors[i] = HuntLab(glm::clamp(rgb, 0.0f, 1.0f));
  }
  return colors;
}

float Stretched(float difference)
{
  static const float largest =
    std::pow(HybridDistance(HuntLab({ 0, 1, 0 }), HuntLab({ 0, 0, 1 })), ColorExponent);
  const float compressed = CompressedShare * largest;
  const float power = std::pow(difference, ColorExponent);
  if (power < compressed)
  {
    return CompressedTarget * power / compressed;
  }
  return CompressedTarget +
    (1.0f - CompressedTarget) * (power - compressed) / (largest - compressed);
}

double FeatureSigma(double pixelsPerDegree)
{
  return 0.5 * FeatureWidthDegrees * pixelsPerDegree;
}

int FeatureRadius(double pixelsPerDegree)
{
  return static_cast<int>(std::ceil(3.0 * FeatureSigma(pixelsPerDegree)));
}

// A derivative of a Gaussian, its positive weights summing to 1 and its negative ones to -1.
template <typename Shape>
Kernel DerivativeKernel(double pixelsPerDegree, Shape shape)
{
  const int radius = FeatureRadius(pixelsPerDegree);
  const double sigma = FeatureSigma(pixelsPerDegree);
  std::vector<double> weights;
  double positive = 0.0;
  double negative = 0.0;
  for (int i = -radius; i <= radius; ++i)
  {
    const double ratio = i / sigma;
    weights.push_back(shape(ratio) * std::exp(-0.5 * ratio * ratio));
    (weights.back() > 0.0 ? positive : negative) += weights.back();
  }
  Kernel kernel;
  for (const double weight : weights)
  {
    kernel.push_back(static_cast<float>(weight / (weight > 0.0 ? positive : -negative)));
  }
  return kernel;
}

// The length of the vector of both derivatives of the luminance, as a share of white's.
std::vector<float> FeatureStrength(
  const Plane& luminance, const Kernel& derivative, const Kernel& smooth)
{
  const Plane across = Convolved(luminance, derivative, smooth);
  const Plane along = Convolved(luminance, smooth, derivative);
  std::vector<float> strength(across.Values.size());
  for (std::size_t i = 0; i < strength.size(); ++i)
  {
    strength[i] = std::hypot(across.Values[i], along.Values[i]) / 116.0f;
  }
  return strength;
}

std::vector<float> FeatureDifference(
  const Plane& picture, const Plane& reference, double pixelsPerDegree)
{
  const Kernel smooth =
    GaussianKernel(FeatureSigma(pixelsPerDegree), FeatureRadius(pixelsPerDegree));
  const Kernel edge = DerivativeKernel(pixelsPerDegree, [](double x) { return -x; });
  const Kernel point = DerivativeKernel(pixelsPerDegree, [](double x) { return x * x - 1.0; });
  std::vector<float> largest(picture.Values.size(), 0.0f);
  for (const Kernel* kernel : { &edge, &point })
  {
    const std::vector<float> ours = FeatureStrength(picture, *kernel, smooth);
    const std::vector<float> truth = FeatureStrength(reference, *kernel, smooth);
    for (std::size_t i = 0; i < largest.size(); ++i)
    {
      largest[i] = std::max(largest[i], std::abs(ours[i] - truth[i]));
    }
  }
  for (float& value : largest)
  {
    value = std::pow(std::min(value / std::sqrt(2.0f), 1.0f), FeatureExponent);
  }
  return largest;
}
}

int FlipRadius(double pixelsPerDegree)
{
  const double widest = SigmaPixels(BlueYellow[0], pixelsPerDegree);
  return static_cast<int>(std::ceil(3.0 * widest));
}

Plane Flip(const ScreenPicture& picture, const ScreenPicture& reference, double pixelsPerDegree)
{
  const OpponentPlanes ours = ToOpponent(picture);
  const OpponentPlanes truth = ToOpponent(reference);
  const std::vector<glm::vec3> colors = SeenColors(ours, pixelsPerDegree);
  const std::vector<glm::vec3> trueColors = SeenColors(truth, pixelsPerDegree);
  const std::vector<float> features =
    FeatureDifference(ours.Luminance, truth.Luminance, pixelsPerDegree);
  Plane result{ picture.Width, picture.Height, std::vector<float>(colors.size()) };
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const float color = Stretched(HybridDistance(colors[i], trueColors[i]));
    result.Values[i] = color > 0.0f ? std::pow(color, 1.0f - features[i]) : 0.0f;
  }
  return result;
}
}
