// Emission and absorption along a smooth piece of a ray, to a tolerance: I = integral of C tau
// exp(-A) with A = integral of tau. Three Gauss-Legendre nodes, with Kronrod's four between them
// where those do not agree with the middle one, give the optical depth at the nodes by collocation,
// and the colour as a mean of the nodes' colours with weights >= 0 that sum to the opacity 1 -
// exp(-A): a medium of one colour keeps it, however stiff it is. A piece on which the rules
// disagree is halved, the front half first (after Novins & Arvo, VVS 1992, and Piessens et al.,
// QUADPACK, 1983).
#ifndef volumebench_SegmentQuadrature_h
#define volumebench_SegmentQuadrature_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace volumebench
{
/// exp(-x) for x >= 0, by a series where that has all digits: most pieces are thin.
inline double Decay(double x)
{
  constexpr double Thin = 0.03;
  if (x > Thin)
  {
    return std::exp(-x);
  }
  constexpr std::array<double, 6> Terms{ 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6, 1.0 / 7 };
  double series = 1.0;
  for (std::size_t i = Terms.size(); i-- > 0;)
  {
    series = 1.0 - x * Terms[i] * series;
  }
  return 1.0 - x * series;
}

/// What a ray has gathered.
struct RaySum
{
  glm::dvec3 Color{ 0.0 };    // premultiplied
  double Depth = 0.0;         // optical depth
  double Passing = 1.0;       // exp(-Depth)
  double Bound = 0.0;         // sum of the estimated errors of all pieces
  double Evaluations = 0.0;   // of the medium
  double Tolerance = 4.0e-12; // of a piece
  bool Smooth = true;         // no piece has a kink or jump within

  /// Nothing behind can change the sum in double precision.
  bool IsOpaque() const { return this->Passing < 1.0e-17; }

  glm::dvec4 Pixel() const { return { this->Color, -std::expm1(-this->Depth) }; }
};

/// One rule's result for a piece.
struct PieceSum
{
  double Depth = 0.0;
  double Opacity = 0.0;
  glm::dvec3 Color{ 0.0 }; // premultiplied
  double Mismatch = 0.0;   // of the sum of the weights and the opacity
};

/// Nodes x in (-1, 1), weights, and the integrals of the nodes' Lagrange polynomials from -1 to
/// each.
template <std::size_t Count>
struct NodeRule
{
  std::array<double, Count> Nodes;
  std::array<double, Count> Weights;
  std::array<std::array<double, Count>, Count> UpToNode; // [node][polynomial]
  std::array<double, Count> AtEnd;                       // the polynomials at 1

  NodeRule(const std::array<double, Count>& nodes, const std::array<double, Count>& weights)
    : Nodes(nodes)
    , Weights(weights)
  {
    for (std::size_t i = 0; i < Count; ++i)
    {
      const std::array<double, Count> powers = this->LagrangePowers(i);
      this->AtEnd[i] = std::accumulate(powers.begin(), powers.end(), 0.0);
      for (std::size_t node = 0; node < Count; ++node)
      {
        double integral = 0.0;
        for (std::size_t power = 0; power < Count; ++power)
        {
          const auto order = static_cast<double>(power + 1);
          integral +=
            powers[power] / order * (std::pow(nodes[node], order) - std::pow(-1.0, order));
        }
        this->UpToNode[node][i] = integral;
      }
    }
  }

  /// `at` holds colour and extinction per unit of the ray at the nodes of a piece of length 2 half.
  PieceSum Integrate(const std::array<glm::dvec4, Count>& at, double half) const
  {
    PieceSum sum;
    double weights = 0.0;
    glm::dvec3 color(0.0);
    for (std::size_t node = 0; node < Count; ++node)
    {
      double depth = 0.0;
      for (std::size_t i = 0; i < Count; ++i)
      {
        depth += this->UpToNode[node][i] * at[i].w;
      }
      const double weight =
        half * this->Weights[node] * at[node].w * Decay(half * std::max(depth, 0.0));
      weights += weight;
      color += weight * glm::dvec3(at[node]);
      sum.Depth += half * this->Weights[node] * at[node].w;
    }
    sum.Opacity = -std::expm1(-sum.Depth);
    // Where no node gets light at all, the front is seen.
    constexpr double NoLight = 1.0e-200;
    sum.Color =
      weights > NoLight ? (sum.Opacity / weights) * color : sum.Opacity * glm::dvec3(at.front());
    sum.Mismatch = std::abs(weights - sum.Opacity);
    return sum;
  }

private:
  // Coefficients of the i-th Lagrange polynomial by powers of x.
  std::array<double, Count> LagrangePowers(std::size_t i) const
  {
    std::array<double, Count> powers{ 1.0 };
    for (std::size_t other = 0; other < Count; ++other)
    {
      if (other == i)
      {
        continue;
      }
      const double scale = 1.0 / (this->Nodes[i] - this->Nodes[other]);
      for (std::size_t power = Count; power-- > 1;)
      {
        powers[power] = scale * (powers[power - 1] - this->Nodes[other] * powers[power]);
      }
      powers[0] *= -scale * this->Nodes[other];
    }
    return powers;
  }
};

inline const NodeRule<3> GaussRule(
  { -0.774596669241483377, 0.0, 0.774596669241483377 }, { 5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0 });
inline const NodeRule<7> KronrodRule(
  { -0.960491268708020283, -0.774596669241483377, -0.434243749346802558, 0.0, 0.434243749346802558,
    0.774596669241483377, 0.960491268708020283 },
  { 0.104656226026467265, 0.268488089868333441, 0.401397414775962223, 0.450916538658474142,
    0.401397414775962223, 0.268488089868333441, 0.104656226026467265 });

inline double LargestOf(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

template <std::size_t Count>
double ColorSpread(const std::array<glm::dvec4, Count>& at)
{
  glm::dvec3 low(at.front());
  glm::dvec3 high(low);
  for (const glm::dvec4& node : at)
  {
    low = glm::min(low, glm::dvec3(node));
    high = glm::max(high, glm::dvec3(node));
  }
  return LargestOf(high - low);
}

/// Error of a piece by a rule from its differences to a lesser one: the share that they differ by
/// is raised by what the better rule gains in order, through `gain`; at a kink it gains none.
template <typename Gain>
double PieceError(const PieceSum& better, double depthDifference, double colorDifference,
  double spread, const Gain& gain)
{
  const auto share = [&gain](double difference, double whole)
  { return whole > 0.0 ? whole * std::min(1.0, gain(difference / whole)) : 0.0; };
  return (1.0 - better.Opacity) * share(depthDifference, better.Depth) +
    share(colorDifference, better.Opacity) + spread * better.Mismatch;
}

/// What a kink between the outermost nodes and the ends may hide from both rules: the depth of the
/// triangle between what the nodes let expect at the ends and what is there.
template <typename Medium>
double HiddenError(
  const Medium& medium, double begin, double end, const std::array<glm::dvec4, 7>& at)
{
  glm::dvec4 atBegin(0.0);
  glm::dvec4 atEnd(0.0);
  const auto emitted = [](const glm::dvec4& node)
  { return glm::dvec4(node.w * glm::dvec3(node), node.w); };
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    atBegin += KronrodRule.AtEnd[i] * emitted(at[at.size() - 1 - i]);
    atEnd += KronrodRule.AtEnd[i] * emitted(at[i]);
  }
  const glm::dvec4 apart =
    glm::abs(emitted(medium(begin)) - atBegin) + glm::abs(emitted(medium(end)) - atEnd);
  const double gap = 0.5 * (end - begin) * (1.0 - KronrodRule.Nodes.back());
  return 0.5 * gap * std::max({ apart.x, apart.y, apart.z, apart.w });
}

inline void AddPiece(const PieceSum& piece, double error, RaySum& sum)
{
  sum.Color += sum.Passing * piece.Color;
  sum.Bound += sum.Passing * error;
  sum.Depth += piece.Depth;
  sum.Passing *= 1.0 - piece.Opacity;
}

/// Adds the piece from begin to end of a medium, a function of the distance that returns colour
/// (rgb) and extinction per unit of distance (w), smooth over the piece.
template <typename Medium>
void IntegratePiece(const Medium& medium, double begin, double end, RaySum& sum, int halvings = 0)
{
  constexpr int MostHalvings = 60;
  const double half = 0.5 * (end - begin);
  const double middle = begin + half;
  const auto at = [&](std::size_t node) { return medium(middle + half * KronrodRule.Nodes[node]); };
  const std::array<glm::dvec4, 3> few{ at(1), at(3), at(5) };
  const PieceSum rough = GaussRule.Integrate(few, half);
  sum.Evaluations += 3.0;
  // Rules of order 2 and 6: the share to the power 3, of which 2 are used and a factor is kept.
  const double roughError = PieceError(rough, std::abs(rough.Depth - 2.0 * half * few[1].w),
    LargestOf(rough.Color - rough.Opacity * glm::dvec3(few[1])), ColorSpread(few),
    [](double share) { return 100.0 * share * share; });
  if (sum.Smooth && rough.Depth > 0.0 && sum.Passing * roughError <= sum.Tolerance)
  {
    AddPiece(rough, roughError, sum);
    return;
  }
  const std::array<glm::dvec4, 7> all{ at(0), few[0], at(2), few[1], at(4), few[2], at(6) };
  const PieceSum fine = KronrodRule.Integrate(all, half);
  sum.Evaluations += 4.0;
  double fineError = PieceError(fine, std::abs(fine.Depth - rough.Depth),
    LargestOf(fine.Color - rough.Color), ColorSpread(all),
    [&sum](double share) { return sum.Smooth ? 200.0 * share * std::sqrt(200.0 * share) : share; });
  if (!sum.Smooth)
  {
    // A factor that is zero at all nodes may rise between them.
    constexpr int LeastHalvings = 3;
    const bool unseen = !(fine.Depth > 0.0) && halvings < LeastHalvings;
    fineError +=
      unseen ? std::numeric_limits<double>::infinity() : HiddenError(medium, begin, end, all);
    sum.Evaluations += 2.0;
  }
  const bool divisible = halvings < MostHalvings && begin < middle && middle < end;
  if (sum.Passing * fineError <= sum.Tolerance || !divisible)
  {
    AddPiece(fine, fineError, sum);
    return;
  }
  IntegratePiece(medium, begin, middle, sum, halvings + 1);
  if (!sum.IsOpaque())
  {
    IntegratePiece(medium, middle, end, sum, halvings + 1);
  }
}
}

#endif
