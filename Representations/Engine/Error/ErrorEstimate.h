// The error of the picture that a view shows, as far as it is known.
#ifndef volumebench_ErrorEstimate_h
#define volumebench_ErrorEstimate_h

#include <limits>
#include <string>

namespace volumebench
{
/// NaN unless the view shows the picture that the numbers belong to.
struct ErrorEstimate
{
  double Rmse = std::numeric_limits<double>::quiet_NaN();
  double Linf = std::numeric_limits<double>::quiet_NaN();
  double ReferenceSeconds = std::numeric_limits<double>::quiet_NaN();
  double FrameMs = std::numeric_limits<double>::quiet_NaN();
  std::string Text; // one line that says all of it, or why there is nothing to say
};
}

#endif
