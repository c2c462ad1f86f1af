#include "ColorDifference.h"

#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

double Radians(double degrees)
{
  return degrees * Pi / 180.0;
}

double SeventhPowerShare(double chroma)
{
  const double seventh = std::pow(chroma, 7.0);
  return std::sqrt(seventh / (seventh + std::pow(25.0, 7.0)));
}

double HueDegrees(double a, double b)
{
  if (a == 0.0 && b == 0.0)
  {
    return 0.0;
  }
  const double degrees = std::atan2(b, a) * 180.0 / Pi;
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

// The mean of two hues on the shorter arc between them.
double MeanHueDegrees(double first, double second)
{
  const double sum = first + second;
  if (std::abs(first - second) <= 180.0)
  {
    return 0.5 * sum;
  }
  return sum < 360.0 ? 0.5 * (sum + 360.0) : 0.5 * (sum - 360.0);
}

double HueStepDegrees(double from, double to)
{
  const double step = to - from;
  return step > 180.0 ? step - 360.0 : step < -180.0 ? step + 360.0 : step;
}

// How strongly hue and chroma differences in the blue act together.
double RotationTerm(double meanChroma, double meanHue)
{
  const double distance = (meanHue - 275.0) / 25.0;
  const double angle = 30.0 * std::exp(-distance * distance);
  return -std::sin(Radians(2.0 * angle)) * 2.0 * SeventhPowerShare(meanChroma);
}

double HueWeight(double meanHue)
{
  return 1.0 - 0.17 * std::cos(Radians(meanHue - 30.0)) + 0.24 * std::cos(Radians(2.0 * meanHue)) +
    0.32 * std::cos(Radians(3.0 * meanHue + 6.0)) - 0.20 * std::cos(Radians(4.0 * meanHue - 63.0));
}
}

double ColorDifference2000(const glm::dvec3& a, const glm::dvec3& b)
{
  const double plainChroma = 0.5 * (std::hypot(a.y, a.z) + std::hypot(b.y, b.z));
  const double stretch = 1.0 + 0.5 * (1.0 - SeventhPowerShare(plainChroma));
  const double chromaA = std::hypot(stretch * a.y, a.z);
  const double chromaB = std::hypot(stretch * b.y, b.z);
  const double hueA = HueDegrees(stretch * a.y, a.z);
  const double hueB = HueDegrees(stretch * b.y, b.z);

  const bool grey = chromaA * chromaB == 0.0;
  const double hueStep = grey ? 0.0 : HueStepDegrees(hueA, hueB);
  const double meanHue = grey ? hueA + hueB : MeanHueDegrees(hueA, hueB);
  const double meanChroma = 0.5 * (chromaA + chromaB);
  const double lightness = 0.5 * (a.x + b.x) - 50.0;

  const double lightnessScale =
    1.0 + 0.015 * lightness * lightness / std::sqrt(20.0 + lightness * lightness);
  const double chromaScale = 1.0 + 0.045 * meanChroma;
  const double hueScale = 1.0 + 0.015 * meanChroma * HueWeight(meanHue);
  const double dL = (b.x - a.x) / lightnessScale;
  const double dC = (chromaB - chromaA) / chromaScale;
  const double dH =
    2.0 * std::sqrt(chromaA * chromaB) * std::sin(Radians(0.5 * hueStep)) / hueScale;
  const double squares = dL * dL + dC * dC + dH * dH + RotationTerm(meanChroma, meanHue) * dC * dH;
  return std::sqrt(std::fmax(squares, 0.0));
}
}
