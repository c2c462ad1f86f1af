// When to turn a volume's voxels. Misaki, Ino & Hagihara 2017 turn them whenever the view crosses
// 45 degrees, so a camera that trembles there turns them in every frame; deciding by the history of
// the view is the future work that they name. Here it is a task system of two states (Borodin,
// Linial & Saks 1992): a frame that the other order would draw faster loses some time, the more the
// further the view is past 45 degrees, and the voxels are turned once these losses, less what the
// present order has won since, reach twice the price of a turn. Whatever the path, losses and turns
// then cost at most three times what they would with its future known; and views close to 45
// degrees or along y, for which both orders are alike, turn nothing.
#ifndef volumebench_TurnPolicy_h
#define volumebench_TurnPolicy_h

#include "VolumeBenchEngineModule.h"

#include <glm/vec3.hpp>

namespace volumebench
{
struct TurnPrices
{
  double TurnFrames = 1.0;  // what a turn costs, in frames with the right order
  double MostLost = 1.0;    // frames that a view straight along x loses by the wrong order
  double BandDegrees = 5.0; // to both sides of 45, where neither order is taken for the better one
};

class VOLUMEBENCHENGINE_EXPORT TurnPolicy
{
public:
  explicit TurnPolicy(const TurnPrices& prices = {})
    : Prices(prices)
  {
  }

  /// Takes in the view of one frame, its direction in the space of the grid, and returns whether
  /// the voxels are to be turned by a quarter before it is drawn.
  bool TurnsFor(const glm::dvec3& forward);

  /// Turns so far, modulo 4.
  int GetQuarterTurns() const { return this->QuarterTurns; }

  /// For a volume that has been uploaded anew, in the order of its grid.
  void Reset();

  /// Frames that a view loses by voxels turned by so many quarters; negative where it wins them.
  double LossOf(const glm::dvec3& forward, int quarterTurns) const;

private:
  TurnPrices Prices;
  int QuarterTurns = 0;
  double Lost = 0.0;
};
}

#endif
