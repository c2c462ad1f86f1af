// A stability case: a scene that is hard on a renderer, what its picture must be, and for whom.
//
// Expected values are worked out in each case in double precision, from a formula or an integral
// that shares nothing with the renderers. Errors are of linear premultiplied RGBA unless the case
// says otherwise.
#ifndef volumebench_Case_h
#define volumebench_Case_h

#include "Stability/Trial.h"

#include <functional>
#include <string>
#include <vector>

namespace volumebench
{
struct StabilityCase
{
  int Number = 0; // 1 to 32 are the list that the project set out with; 33 and on are its own
  std::string Title;
  std::string Expectation;   // what is expected and how close, for readers
  double Limit = 0.0;        // of the error in its main measurement
  std::vector<int> MeantFor; // integrators of vtkVolumeBenchMapper that must pass
  std::function<void(Trial&)> Measure;

  /// Whether a failure of this subject is a defect, and not what a control is there to show.
  bool IsMeantFor(const Subject& subject) const;
};

/// Integrators that a case can be meant for.
namespace integrators
{
constexpr int Left = 0;
constexpr int Midpoint = 1;
constexpr int Segment = 2;
constexpr int PreIntegrated = 3;
constexpr int Automatic = 4; // has to pass what Segment has to

/// Where the sampling does not matter at all, or all that matters is where the ray runs.
inline std::vector<int> All()
{
  return { Left, Midpoint, Segment, PreIntegrated };
}
/// Where second order, or a field that is linear along the ray, is enough.
inline std::vector<int> SecondOrder()
{
  return { Midpoint, Segment, PreIntegrated };
}
}

std::vector<StabilityCase> SlabCases();
std::vector<StabilityCase> ConvergenceCases();
std::vector<StabilityCase> FunctionCases();
std::vector<StabilityCase> StiffCases();
std::vector<StabilityCase> RayCases();
std::vector<StabilityCase> PlacementCases();
std::vector<StabilityCase> DataCases();
std::vector<StabilityCase> ShortcutCases();
}

#endif
