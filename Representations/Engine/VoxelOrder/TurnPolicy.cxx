#include "VoxelOrder/TurnPolicy.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
double TurnPolicy::LossOf(const glm::dvec3& forward, int quarterTurns) const
{
  const double size = glm::length(forward);
  const double level = std::hypot(forward.x, forward.z);
  if (!(level > 0.0))
  {
    return 0.0;
  }
  const double degrees = glm::degrees(std::atan2(std::abs(forward.x), std::abs(forward.z)));
  const double past = degrees - 45.0;
  const double beyondBand = std::max(std::abs(past) - this->Prices.BandDegrees, 0.0);
  const double share = beyondBand / (45.0 - this->Prices.BandDegrees);
  const double lost = this->Prices.MostLost * share * level / size;
  const bool turned = quarterTurns % 2 == 1;
  return (past > 0.0) == turned ? -lost : lost;
}

bool TurnPolicy::TurnsFor(const glm::dvec3& forward)
{
  const double loss = this->LossOf(forward, this->QuarterTurns);
  this->Lost = std::max(this->Lost + loss, 0.0);
  if (!(loss > 0.0) || this->Lost < 2.0 * this->Prices.TurnFrames)
  {
    return false;
  }
  this->Lost = 0.0;
  this->QuarterTurns = (this->QuarterTurns + 1) % 4;
  return true;
}

void TurnPolicy::Reset()
{
  this->QuarterTurns = 0;
  this->Lost = 0.0;
}
}
