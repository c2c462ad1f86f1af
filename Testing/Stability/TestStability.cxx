// Every technique passes every stability case with the integrators that the case is meant for.
#include "EveryTechnique.h"

#include "Names.h"
#include "Stability/CaseTable.h"
#include "Stability/StabilityRun.h"

#include <algorithm>

using namespace volumebench;
using namespace volumebench::test;

class Stability : public EveryTechnique
{
protected:
  // All of them for one ray caster and one slicer. The others leave out PreIntegrated, whose tables
  // are the same and take longer to make than all else here.
  static std::vector<int> IntegratorsToTry()
  {
    std::vector<int> numbers = IntegratorNames().Numbers();
    if (GetParam() != "single-pass" && GetParam() != "slices")
    {
      numbers.erase(
        std::remove(numbers.begin(), numbers.end(), integrators::PreIntegrated), numbers.end());
    }
    return numbers;
  }

  // Cases first to last, in groups, so that a failure says about where to look.
  void PassCases(int first, int last)
  {
    StabilitySettings settings;
    settings.Techniques = { GetParam() };
    settings.Integrators = IntegratorsToTry();
    settings.MeantOnly = true;
    settings.Quick = true;
    for (const StabilityCase& row : StabilityCases())
    {
      if (row.Number >= first && row.Number <= last)
      {
        settings.Cases.push_back(row.Number);
      }
    }
    const auto results = RunStability(settings, [](double) { return true; });
    ASSERT_FALSE(results.empty());
    for (const StabilityResult& result : results)
    {
      const std::string integrator = result.Who.Integrator == NoIntegrator
        ? std::string()
        : IntegratorNames().NameOf(result.Who.Integrator);
      EXPECT_TRUE(result.Status == "pass" || result.Status == "not-applicable")
        << "case " << result.Case << " (" << FindStabilityCase(result.Case).Title << ") "
        << integrator << ": " << result.Status << ", " << result.Reason;
    }
  }
};

TEST_P(Stability, Cases1To8)
{
  this->PassCases(1, 8);
}

TEST_P(Stability, Cases9To16)
{
  this->PassCases(9, 16);
}

TEST_P(Stability, Cases17To24)
{
  this->PassCases(17, 24);
}

TEST_P(Stability, Cases25To32)
{
  this->PassCases(25, 32);
}

TEST_P(Stability, OwnCases)
{
  this->PassCases(33, 1000);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Stability);
