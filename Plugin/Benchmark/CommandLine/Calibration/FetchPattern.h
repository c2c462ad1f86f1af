// Where the fetches of a calibration go, and what they must sum to.
//
// The volume is a cube whose values grow linearly along all axes, so that a trilinear fetch has a
// known value anywhere. Pixel (x, y) of a picture sums the fetches at
//   (x mod Side, y mod Side, 0) + Origin + p PassShift + i DirectionAt(x mod Side, y mod Side)
// in voxels, for each pass p and each i below Length. No point leaves the cube.
#ifndef volumebench_FetchPattern_h
#define volumebench_FetchPattern_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace volumebench
{
enum class FetchKind
{
  Trilinear,
  Texel, // the nearest voxel
  Table  // linear in a table of RGBA, at the x + z of a point
};

enum class FetchOrder
{
  Axis,    // along z: the friendliest to caches
  Oblique, // along (1, 1, 2), at length 1
  Rays     // of a caster in perspective: each pixel in a direction of its own, at about length 1
};

/// As calibrations call it.
const char* FetchOrderName(FetchOrder order);

struct FetchPattern
{
  FetchKind Kind = FetchKind::Trilinear;
  int Entries = 0; // voxels on each axis, or entries of the table
  int Side = 0;    // pixels of a tile on each axis
  int Length = 0;  // fetches of a pass
  int Passes = 0;
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 PassShift{ 0.0 };
  glm::dvec3 Direction{ 0.0 };  // of the first pixel of a tile
  glm::dvec3 DirectionX{ 0.0 }; // its change from one pixel to the next
  glm::dvec3 DirectionY{ 0.0 };

  glm::dvec3 DirectionAt(glm::dvec2 inTile) const
  {
    return this->Direction + inTile.x * this->DirectionX + inTile.y * this->DirectionY;
  }

  /// Fetches of one pixel.
  long long FetchesPerPixel() const { return static_cast<long long>(this->Length) * this->Passes; }
};

/// A pattern of about 256 fetches a pixel; `entries` is at least 16, for a table at least 1024.
FetchPattern MakeFetchPattern(FetchKind kind, FetchOrder order, int entries);

/// How values are stored; a value v in [0, 1] is Scale * v there.
template <typename Texel>
struct TexelScale;
template <>
struct TexelScale<std::uint8_t>
{
  static constexpr double Scale = 255.0;
};
template <>
struct TexelScale<std::uint16_t>
{
  static constexpr double Scale = 65535.0;
};
template <>
struct TexelScale<float>
{
  static constexpr double Scale = 1.0;
};

/// The value in [0, 1], without rounding, at a point whose coordinates, weighted so that the
/// farthest corner has 3 (entries - 1), have this sum.
double CalibrationValue(double coordinateSum, int entries);

/// The cube's texels, x fastest; one more at the end, since a pair of 16-bit texels is read at
/// once.
template <typename Texel>
std::vector<Texel> CalibrationVolume(int entries);

/// The sum that a pixel must have, where `scale` is the largest value of the stored type.
double ExpectedSum(const FetchPattern& pattern, glm::ivec2 pixel, double scale);

/// Checks some of the pixels of a picture of sums, `stride` floats a pixel. Throws
/// std::runtime_error that says `what` is wrong when a sum is off by half a fetch or more, as it is
/// with one fetch too few or too many.
void CheckSums(const FetchPattern& pattern, glm::ivec2 size, const std::vector<float>& sums,
  int stride, double scale, const char* what);
}

#endif
