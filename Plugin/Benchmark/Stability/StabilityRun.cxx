#include "Stability/StabilityRun.h"

#include "Names.h"
#include "Stability/CaseTable.h"
#include "Techniques/TechniqueTable.h"

#include <algorithm>
#include <limits>

namespace volumebench
{
namespace
{
constexpr int WindowSize = 16; // pixels, until a case asks for its own

std::vector<std::string> TechniquesOf(const StabilitySettings& settings)
{
  std::vector<std::string> ids = settings.Techniques;
  if (ids.empty())
  {
    for (const TechniqueRow& row : TechniqueTable())
    {
      ids.emplace_back(row.Id);
    }
    ids.insert(ids.end(), Contestant::Peers().begin(), Contestant::Peers().end());
  }
  return ids;
}

std::vector<int> IntegratorsOf(const StabilitySettings& settings)
{
  return settings.Integrators.empty() ? IntegratorNames().Numbers() : settings.Integrators;
}

std::vector<const StabilityCase*> CasesOf(const StabilitySettings& settings)
{
  std::vector<const StabilityCase*> cases;
  for (const int number : settings.Cases)
  {
    cases.push_back(&FindStabilityCase(number));
  }
  if (cases.empty())
  {
    for (const StabilityCase& row : StabilityCases())
    {
      cases.push_back(&row);
    }
  }
  return cases;
}

void Judge(const Trial& trial, StabilityResult& result)
{
  const Tally& tally = trial.Tally;
  result.Error = tally.GetError();
  result.Limit = tally.GetLimit();
  result.Status = tally.IsPassed() ? "pass" : "fail";
  result.Reason = tally.IsEmpty() ? "The case measured nothing. " + tally.Text() : tally.Text();
}
}

std::vector<Subject> SubjectsOf(const StabilitySettings& settings)
{
  std::vector<Subject> subjects;
  for (const std::string& id : TechniquesOf(settings))
  {
    const auto& peers = Contestant::Peers();
    if (std::count(peers.begin(), peers.end(), id))
    {
      subjects.push_back({ id, NoIntegrator, true });
      continue;
    }
    if (!FindTechnique(id))
    {
      throw std::runtime_error(WhyNoTechnique(id));
    }
    if (!Contestant::TakesSteps(id))
    {
      subjects.push_back({ id, NoIntegrator, false });
      continue;
    }
    for (const int integrator : IntegratorsOf(settings))
    {
      IntegratorNames().NameOf(integrator);
      subjects.push_back({ id, integrator, false });
    }
  }
  return subjects;
}

StabilityResult TryCase(
  const StabilityCase& tried, const Subject& subject, Stage& stage, bool quick)
{
  constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();
  StabilityResult result{ tried.Number, subject, tried.IsMeantFor(subject), "", NotMeasured,
    NotMeasured, "" };
  Trial trial(stage, subject, quick);
  try
  {
    tried.Measure(trial);
    Judge(trial, result);
  }
  catch (const NotApplicable& reason)
  {
    result.Status = "not-applicable";
    result.Reason = reason.what();
  }
  catch (const Refusal& refusal)
  {
    result.Status = refusal.Unsupported ? "unsupported" : "fail";
    result.Reason = std::string("Drew nothing: ") + refusal.what() + ".";
  }
  return result;
}

std::vector<StabilityResult> RunStability(
  const StabilitySettings& settings, const std::function<bool(double share)>& progress)
{
  const std::vector<Subject> subjects = SubjectsOf(settings);
  const std::vector<const StabilityCase*> cases = CasesOf(settings);
  const auto total = static_cast<double>(subjects.size() * cases.size());
  Stage stage(WindowSize, WindowSize);
  std::vector<StabilityResult> results;
  double done = 0.0;
  for (const StabilityCase* tried : cases)
  {
    for (const Subject& subject : subjects)
    {
      if (!settings.MeantOnly || tried->IsMeantFor(subject))
      {
        results.push_back(TryCase(*tried, subject, stage, settings.Quick));
      }
      done += 1.0;
      if (!progress(done / total))
      {
        return results;
      }
    }
  }
  return results;
}
}
