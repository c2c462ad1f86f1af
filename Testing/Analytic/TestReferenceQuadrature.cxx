// The parts that the cell-exact reference is made of, one by one, against closed forms.
#include "Reference/CellWalk.h"
#include "Reference/KnotPieces.h"
#include "Reference/SegmentQuadrature.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace volumebench;

namespace
{
using Function = std::function<double(double)>;

RaySum Integrate(const Function& tau, const Function& color, double begin, double end)
{
  RaySum sum;
  IntegratePiece([&](double t) { return glm::dvec4(color(t), 0.5, 0.0, tau(t)); }, begin, end, sum);
  return sum;
}

Function Constant(double value)
{
  return [value](double) { return value; };
}

// Colour c0 + c1 t in a medium of extinction k over [0, 1]; a series where 1 / k cancels.
double LinearColor(double c0, double c1, double k)
{
  const double mean =
    k < 1e-3 ? k * (0.5 - k * (1.0 / 3.0 - k / 8.0)) : 1.0 / k - (1.0 + 1.0 / k) * std::exp(-k);
  return c0 * -std::expm1(-k) + c1 * mean;
}

double Trilinear(const std::array<double, 8>& c, const glm::dvec3& p)
{
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    sum += c[i] * (i & 1 ? p.x : 1.0 - p.x) * (i & 2 ? p.y : 1.0 - p.y) * (i & 4 ? p.z : 1.0 - p.z);
  }
  return sum;
}
}

TEST(SegmentQuadrature, HomogeneousSlabIsExactFromThinToStiff)
{
  for (int exponent = -8; exponent <= 8; ++exponent)
  {
    const double tau = std::pow(10.0, exponent);
    const RaySum sum = Integrate(Constant(tau), Constant(0.75), 0.25, 2.25);
    const double opacity = -std::expm1(-2.0 * tau);
    EXPECT_NEAR(sum.Pixel().w, opacity, 1e-14 * opacity) << tau;
    EXPECT_NEAR(sum.Pixel().x, 0.75 * opacity, 1e-14 * opacity) << tau;
  }
}

TEST(SegmentQuadrature, LinearExtinctionIsExact)
{
  for (const double k : { 1e-4, 0.1, 1.0, 10.0, 1e4 })
  {
    const RaySum sum = Integrate([k](double t) { return k * t; }, Constant(1.0), 0.0, 1.0);
    EXPECT_NEAR(sum.Pixel().w, -std::expm1(-0.5 * k), 1e-14) << k;
    EXPECT_NEAR(sum.Pixel().x, -std::expm1(-0.5 * k), 1e-14) << k;
  }
}

TEST(SegmentQuadrature, LinearColourMeetsItsClosedFormFromThinToStiff)
{
  for (int exponent = -6; exponent <= 6; ++exponent)
  {
    const double k = std::pow(10.0, exponent);
    const RaySum sum = Integrate(
      Constant(k), [](double t) { return 0.2 + 0.6 * t; }, 0.0, 1.0);
    EXPECT_NEAR(sum.Pixel().x, LinearColor(0.2, 0.6, k), 1e-10) << k;
    EXPECT_NEAR(sum.Pixel().y, 0.5 * sum.Pixel().w, 1e-14) << "the other channel is constant";
  }
}

TEST(SegmentQuadrature, ErrorStaysWithinTheBoundThatItStates)
{
  const auto tau = [](double t) { return 3.0 + 3.0 * std::sin(9.0 * t); };
  const auto depth = [](double t) { return 3.0 * t + (1.0 - std::cos(9.0 * t)) / 3.0; };
  // Colour exp(A) makes the integral the optical depth itself.
  const auto color = [&](double t) { return std::exp(depth(t)); };
  for (const double tolerance : { 1e-4, 1e-7, 1e-10 })
  {
    RaySum sum;
    sum.Tolerance = tolerance;
    IntegratePiece([&](double t) { return glm::dvec4(color(t), 0, 0, tau(t)); }, 0.0, 1.0, sum);
    EXPECT_LE(std::abs(sum.Pixel().x - depth(1.0)), 1e-13 + sum.Bound) << tolerance;
    EXPECT_LE(sum.Bound, 64.0 * tolerance);
  }
}

TEST(SegmentQuadrature, KinksWithinAPieceAreFound)
{
  const RaySum sum = Integrate([](double t) { return std::abs(t - 0.3); }, Constant(1.0), 0.0, 1.0);
  EXPECT_NEAR(sum.Depth, 0.5 * (0.09 + 0.49), 1e-10);
  EXPECT_GT(sum.Evaluations, 20.0);
}

TEST(SegmentQuadrature, KeepsAConstantColourInAnyMedium)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-6.0, 6.0);
  for (int trial = 0; trial < 50; ++trial)
  {
    RaySum sum;
    for (int piece = 0; piece < 20; ++piece)
    {
      const double first = std::pow(10.0, exponent(random));
      const double last = std::pow(10.0, exponent(random));
      IntegratePiece([&](double t)
        { return glm::dvec4(0.75, 0.1, 1.0, first + t * (last - first)); },
        0.0, 1.0, sum);
    }
    EXPECT_NEAR(sum.Color.x, 0.75 * sum.Pixel().w, 1e-13);
    EXPECT_NEAR(sum.Color.y, 0.1 * sum.Pixel().w, 1e-13);
  }
}

TEST(SegmentQuadrature, SplitRayEqualsTheWhole)
{
  const auto tau = [](double t) { return 1.5 + std::sin(5.0 * t + 0.3); };
  const auto color = [](double t) { return 0.5 + 0.4 * std::cos(3.0 * t); };
  const RaySum whole = Integrate(tau, color, 0.0, 1.0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial)
  {
    const double split = place(random);
    const RaySum front = Integrate(tau, color, 0.0, split);
    const RaySum back = Integrate(tau, color, split, 1.0);
    EXPECT_NEAR(front.Color.x + front.Passing * back.Color.x, whole.Color.x, 1e-10);
    EXPECT_NEAR(front.Depth + back.Depth, whole.Depth, 1e-11);
  }
}

TEST(SegmentQuadrature, OpaqueMediaShowTheColourOfTheirFront)
{
  const RaySum sum = Integrate(
    Constant(1e9), [](double t) { return 0.2 + 0.6 * t; }, 0.0, 1.0);
  EXPECT_NEAR(sum.Color.x, 0.2, 1e-8);
  EXPECT_TRUE(sum.IsOpaque());
  EXPECT_LT(sum.Evaluations, 2000.0);
}

TEST(FieldCubic, IsTheTrilinearFieldAlongTheRay)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int trial = 0; trial < 200; ++trial)
  {
    std::array<double, 8> corners;
    std::generate(corners.begin(), corners.end(), [&] { return any(random); });
    const glm::dvec3 from(any(random), any(random), any(random));
    const glm::dvec3 direction(any(random), any(random), any(random));
    const FieldCubic cubic = CubicInCell(corners, from, direction);
    for (const double t : { 0.0, 0.3, 1.0, 1.7 })
    {
      EXPECT_NEAR(cubic.At(t), Trilinear(corners, from + t * direction), 1e-13);
    }
  }
}

TEST(FieldCubic, DiagonalOfTheProductCell)
{
  // s = xyz and tau = s: the optical depth of the diagonal is sqrt(3) / 4.
  const double side = 1.0 / std::sqrt(3.0);
  const FieldCubic cubic =
    CubicInCell({ 0, 0, 0, 0, 0, 0, 0, 1 }, glm::dvec3(0.0), glm::dvec3(side));
  RaySum sum;
  IntegratePiece(
    [&](double t) { return glm::dvec4(1.0, 1.0, 1.0, cubic.At(t)); }, 0.0, std::sqrt(3.0), sum);
  EXPECT_NEAR(sum.Pixel().w, -std::expm1(-std::sqrt(3.0) / 4.0), 1e-14);
}

TEST(KnotPieces, CoverTheRayEachInItsOwnPiece)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int pieces = 0;
  for (int trial = 0; trial < 500; ++trial)
  {
    const FieldCubic cubic{ any(random), 3.0 * any(random), 6.0 * any(random), 6.0 * any(random) };
    std::vector<double> knots(trial % 7);
    std::generate(knots.begin(), knots.end(), [&] { return any(random); });
    std::sort(knots.begin(), knots.end());
    double reached = 0.0;
    ForEachKnotPiece(cubic, 1.3, knots,
      [&](double begin, double end, std::size_t piece)
      {
        EXPECT_EQ(begin, reached);
        EXPECT_LT(begin, end);
        reached = end;
        ++pieces;
        for (const double share : { 0.01, 0.5, 0.99 })
        {
          const double value = cubic.At(begin + share * (end - begin));
          EXPECT_TRUE(piece == 0 || value >= knots[piece - 1] - 1e-14);
          EXPECT_TRUE(piece == knots.size() || value <= knots[piece] + 1e-14);
        }
        return true;
      });
    EXPECT_EQ(reached, 1.3);
  }
  EXPECT_GT(pieces, 1500);
}

TEST(KnotPieces, AConstantOnAKnotBelongsAboveIt)
{
  std::size_t found = 99;
  ForEachKnotPiece({ 0.5 }, 1.0, { 0.25, 0.5, 0.75 },
    [&](double, double, std::size_t piece)
    {
      found = piece;
      return true;
    });
  EXPECT_EQ(found, 2u);
}

TEST(CellWalk, PartsLieInOneCellAndCoverTheRay)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const CellBorders& borders : { CellBorders{ 0.0, 1.0 }, { 0.5, 1.0 }, { 0.0, 0.5 } })
  {
    for (int trial = 0; trial < 100; ++trial)
    {
      glm::dvec3 direction(any(random), any(random), any(random));
      direction[trial % 4 == 3 ? 0 : trial % 4] *= trial % 2; // some run along an axis
      direction = glm::normalize(direction + glm::dvec3(0.0, 0.0, 1e-3));
      const glm::dvec3 origin = 5.0 * glm::dvec3(any(random), any(random), any(random));
      double reached = -3.0;
      WalkCells(origin, direction, -3.0, 7.0, borders,
        [&](double begin, double end)
        {
          EXPECT_EQ(begin, reached);
          EXPECT_LT(begin, end);
          reached = end;
          const glm::dvec3 middle = origin + 0.5 * (begin + end) * direction;
          const glm::dvec3 cell = glm::floor((middle - borders.First) / borders.Spacing);
          for (const double t : { begin, end })
          {
            const glm::dvec3 inCell =
              (origin + t * direction - borders.First) / borders.Spacing - cell;
            EXPECT_GE(std::min({ inCell.x, inCell.y, inCell.z }), -1e-12);
            EXPECT_LE(std::max({ inCell.x, inCell.y, inCell.z }), 1.0 + 1e-12);
          }
          return true;
        });
      EXPECT_EQ(reached, 7.0);
    }
  }
}
