// How many samples the picture that a view shows takes, as far as it is known.
#ifndef volumebench_SamplesTaken_h
#define volumebench_SamplesTaken_h

#include <limits>
#include <string>

namespace volumebench
{
/// NaN unless the view shows the picture that the numbers belong to.
struct SamplesTaken
{
  double Taken = std::numeric_limits<double>::quiet_NaN();
  double PerRay = std::numeric_limits<double>::quiet_NaN(); // that meets the volume
  std::string Text; // one line that says all of it, or why there is nothing to say
};
}

#endif
