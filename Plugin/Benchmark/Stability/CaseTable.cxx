#include "Stability/CaseTable.h"

#include <algorithm>
#include <stdexcept>

namespace volumebench
{
bool StabilityCase::IsMeantFor(const Subject& subject) const
{
  const auto isMeantFor = [this](int integrator)
  { return std::count(this->MeantFor.begin(), this->MeantFor.end(), integrator) > 0; };
  // A technique without integrators has to be right everywhere.
  return !subject.Peer &&
    (subject.Integrator == NoIntegrator || isMeantFor(subject.Integrator) ||
      (subject.Integrator == integrators::Automatic && isMeantFor(integrators::Segment)));
}

const std::vector<StabilityCase>& StabilityCases()
{
  static const std::vector<StabilityCase> cases = []
  {
    std::vector<StabilityCase> all;
    for (const auto& group : { SlabCases(), ConvergenceCases(), FunctionCases(), StiffCases(),
           RayCases(), PlacementCases(), DataCases(), ShortcutCases() })
    {
      all.insert(all.end(), group.begin(), group.end());
    }
    std::sort(all.begin(), all.end(),
      [](const StabilityCase& a, const StabilityCase& b) { return a.Number < b.Number; });
    return all;
  }();
  return cases;
}

const StabilityCase& FindStabilityCase(int number)
{
  for (const StabilityCase& row : StabilityCases())
  {
    if (row.Number == number)
    {
      return row;
    }
  }
  throw std::runtime_error("there is no stability case " + std::to_string(number) +
    "; known are 1 to " + std::to_string(StabilityCases().back().Number));
}
}
