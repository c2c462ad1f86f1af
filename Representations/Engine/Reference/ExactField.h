// The values of a volume as they are in its array, in double precision and relative to the range
// that Volume::Mapping gives them: stored values are of the order of 1 whatever the data are.
//
// Texel space: texel (i, j, k) has its middle at the position (i, j, k), whether its value is a
// point's or a cell's; beyond the outermost middles the field goes on as a constant.
#ifndef volumebench_ExactField_h
#define volumebench_ExactField_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <array>
#include <vector>

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT ExactField
{
public:
  ExactField() = default;

  /// Channels are numbered as in the volume: the last is the one that opacity is looked up by.
  /// Values that are not finite become 0; Volume::HasBlanks tells that there are such.
  explicit ExactField(const Volume& volume);

  /// Values at the corners of the cell between the texels `cell` and `cell` + 1, x fastest.
  std::array<double, 8> Corners(const glm::ivec3& cell, int channel) const;

  double Texel(const glm::ivec3& texel, int channel) const;

  /// Interpolated, or of the nearest texel, as the volume has it.
  double At(const glm::dvec3& position, int channel) const;

  bool IsNearest() const { return this->Nearest; }

private:
  glm::ivec3 Clamped(const glm::ivec3& texel) const;
  std::size_t IndexOf(const glm::ivec3& texel, int channel) const;
  double Stored(std::size_t index, int channel) const;

  glm::ivec3 Size{ 0 };
  std::size_t TexelCount = 0;
  bool Nearest = false;
  std::array<ValueMapping, 4> Mappings; // by channel
  // One of the two, channel by channel: singles when they hold every value of the array exactly.
  std::vector<float> Singles;  // as in the array
  std::vector<double> Doubles; // stored values
};
}

#endif
