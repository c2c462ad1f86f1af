// The macrocells of a volume and what was measured of them, kept while the volume is the same.
#ifndef volumebench_MacrocellCache_h
#define volumebench_MacrocellCache_h

#include "Scene/MacrocellGrid.h"

#include <memory>
#include <utility>
#include <vector>

namespace volumebench
{
class MacrocellCache
{
public:
  /// The grid of the scene's volume, of the cells that its sampling asks for.
  const MacrocellGrid& GridOf(const Scene& scene);

  /// How fast the values of each of its cells change: FieldChanges.h.
  const std::vector<glm::vec2>& ChangesOf(const Scene& scene);

  /// Of the grid of that scene.
  static ChangeStamp StampOf(const Scene& scene);

  /// Milliseconds that measuring took since the last call.
  double TakeMs() { return std::exchange(this->Ms, 0.0); }

private:
  MacrocellGrid Grid; // of the volume with GridStamp
  ChangeStamp GridStamp = 0;
  std::vector<glm::vec2> Changes; // of the grid with ChangesStamp
  ChangeStamp ChangesStamp = 0;
  double Ms = 0.0;
};
}

#endif
