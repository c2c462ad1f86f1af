#include "Scene/ExactTransferFunction.h"

#include "Scene/PropertyFunctions.h"
#include "Scene/TransferFunctionTable.h"

#include "vtkVolumeProperty.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr std::size_t SamplesPerCubic = 3;
constexpr std::size_t MostCubics = 1024;
constexpr double StraightTolerance = 1.0e-13;
constexpr double CubicTolerance = 1.0e-9;
// Samples keep this share of a piece away from its ends, where a function may jump.
constexpr double EndShare = 1.0e-7;

double LargestDifference(const glm::dvec4& a, const glm::dvec4& b)
{
  const glm::dvec4 difference = glm::abs(a - b);
  return std::max({ difference.x, difference.y, difference.z, difference.w });
}

// The cubic through four samples at 0, 1/3, 2/3 and 1.
glm::dvec4 Cubic(const glm::dvec4* samples, double share)
{
  const double t = 3.0 * share;
  return samples[0] * (-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0) +
    samples[1] * (t * (t - 2.0) * (t - 3.0) / 2.0) +
    samples[2] * (-t * (t - 1.0) * (t - 3.0) / 2.0) +
    samples[3] * (t * (t - 1.0) * (t - 2.0) / 6.0);
}

bool IsStraight(const std::vector<glm::dvec4>& samples)
{
  for (std::size_t i = 1; i + 1 < samples.size(); ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(samples.size() - 1);
    if (LargestDifference(samples[i], glm::mix(samples.front(), samples.back(), share)) >
      StraightTolerance)
    {
      return false;
    }
  }
  return true;
}

// Whether cubics over every second sample of `fine` pass through the others.
bool AreCubic(const std::vector<glm::dvec4>& coarse, const std::vector<glm::dvec4>& fine)
{
  const double perCoarse =
    static_cast<double>(coarse.size() - 1) / static_cast<double>(fine.size() - 1);
  for (std::size_t i = 1; i < fine.size(); i += 2)
  {
    const double position = static_cast<double>(i) * perCoarse;
    const auto cubic = static_cast<std::size_t>(position / SamplesPerCubic);
    const double share = position / SamplesPerCubic - static_cast<double>(cubic);
    if (LargestDifference(Cubic(&coarse[cubic * SamplesPerCubic], share), fine[i]) > CubicTolerance)
    {
      return false;
    }
  }
  return true;
}

// Samples of a smooth piece, as many as its shape asks for: 2 when it is straight, else 3 n + 1.
std::vector<glm::dvec4> SamplePiece(const PropertyFunctions& functions, double low, double high)
{
  std::vector<glm::dvec4> samples = functions.Sample(low, high, 3 * SamplesPerCubic + 1);
  if (IsStraight(samples))
  {
    return { samples.front(), samples.back() };
  }
  for (std::size_t cubics = 1;; cubics *= 2)
  {
    samples = functions.Sample(low, high, static_cast<int>(SamplesPerCubic * cubics + 1));
    const auto finer =
      functions.Sample(low, high, static_cast<int>(2 * SamplesPerCubic * cubics + 1));
    if (cubics >= MostCubics || AreCubic(samples, finer))
    {
      return finer;
    }
  }
}
}

ExactTransferFunction::ExactTransferFunction(vtkVolumeProperty* property)
  : UnitDistance(CheckedUnitDistance(property))
{
  const PropertyFunctions functions(property);
  this->Knots = functions.Knots();
  const double margin = this->Knots.back() - this->Knots.front() + 1.0;
  this->AddPiece({}, { functions.At(this->Knots.front() - margin) });
  for (std::size_t i = 1; i < this->Knots.size(); ++i)
  {
    const double width = this->Knots[i] - this->Knots[i - 1];
    const double low = this->Knots[i - 1] + EndShare * width;
    const double high = this->Knots[i] - EndShare * width;
    const std::vector<glm::dvec4> samples = SamplePiece(functions, low, high);
    this->AddPiece({ low, high - low, samples.size() / SamplesPerCubic }, samples);
  }
  this->AddPiece({}, { functions.At(this->Knots.back() + margin) });
}

void ExactTransferFunction::AddPiece(const Piece& piece, const std::vector<glm::dvec4>& samples)
{
  this->Pieces.push_back(piece);
  this->Pieces.back().First = this->Samples.size();
  this->Pieces.back().Transparent = std::all_of(
    samples.begin(), samples.end(), [](const glm::dvec4& sample) { return !(sample.w > 0.0); });
  this->Samples.insert(this->Samples.end(), samples.begin(), samples.end());
}

std::size_t ExactTransferFunction::PieceOf(double value) const
{
  return std::upper_bound(this->Knots.begin(), this->Knots.end(), value) - this->Knots.begin();
}

glm::dvec4 ExactTransferFunction::SampleOf(const Piece& piece, double value) const
{
  const glm::dvec4* samples = &this->Samples[piece.First];
  if (!(piece.Span > 0.0))
  {
    return samples[0];
  }
  // A value that rounding takes out of a narrow piece may lie many times its width away.
  const double share =
    std::clamp((value - piece.Begin) / piece.Span, -2.0 * EndShare, 1.0 + 2.0 * EndShare);
  if (piece.Cubics == 0)
  {
    return samples[0] + share * (samples[1] - samples[0]);
  }
  const auto last = static_cast<double>(piece.Cubics - 1);
  const double cubic = std::clamp(std::floor(share * static_cast<double>(piece.Cubics)), 0.0, last);
  return Cubic(samples + static_cast<std::size_t>(cubic) * SamplesPerCubic,
    share * static_cast<double>(piece.Cubics) - cubic);
}

glm::dvec4 ExactTransferFunction::InPiece(std::size_t piece, double value) const
{
  const glm::dvec4 sample = this->SampleOf(this->Pieces[piece], value);
  return { sample.x, sample.y, sample.z, ExtinctionOfOpacity(sample.w, this->UnitDistance) };
}

namespace
{
// Gauss-Legendre with eight points on [-1, 1].
constexpr std::array<double, 4> GaussNodes{ 0.18343464249564980, 0.52553240991632899,
  0.79666647741362674, 0.96028985649753623 };
constexpr std::array<double, 4> GaussWeights{ 0.36268378337836198, 0.31370664587788729,
  0.22238103445337447, 0.10122853629037626 };
constexpr double IntegralTolerance = 1.0e-12;

template <typename Function>
glm::dvec4 Gauss(const Function& function, double low, double high)
{
  const double middle = 0.5 * low + 0.5 * high;
  const double half = 0.5 * high - 0.5 * low;
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < GaussNodes.size(); ++i)
  {
    const double offset = half * GaussNodes[i];
    sum += GaussWeights[i] * (function(middle - offset) + function(middle + offset));
  }
  return half * sum;
}
}

// Opacities near 1 bend the extinction sharply: halves until both agree with the whole, to within
// `allowed`. That is absolute, since close to 1 the extinction has few digits.
glm::dvec4 ExactTransferFunction::IntegralInPiece(
  std::size_t piece, double low, double high, double allowed) const
{
  const auto function = [this, piece](double value)
  {
    const glm::dvec4 at = this->InPiece(piece, value);
    return glm::dvec4(glm::dvec3(at) * at.w, at.w);
  };
  const double middle = 0.5 * low + 0.5 * high;
  const glm::dvec4 whole = Gauss(function, low, high);
  const glm::dvec4 halves = Gauss(function, low, middle) + Gauss(function, middle, high);
  allowed = allowed < 0.0 ? IntegralTolerance * halves.w : allowed;
  if (!(LargestDifference(whole, halves) > allowed) || !(middle > low && middle < high))
  {
    return halves;
  }
  return this->IntegralInPiece(piece, low, middle, allowed) +
    this->IntegralInPiece(piece, middle, high, allowed);
}

glm::dvec4 ExactTransferFunction::Integral(double low, double high) const
{
  glm::dvec4 sum(0.0);
  std::size_t piece = this->PieceOf(low);
  while (low < high)
  {
    const double end = piece < this->Knots.size() ? std::min(this->Knots[piece], high) : high;
    if (end > low && !this->IsTransparent(piece))
    {
      sum += this->IntegralInPiece(piece, low, end, -1.0);
    }
    low = std::max(low, end);
    ++piece;
  }
  return sum;
}
}
