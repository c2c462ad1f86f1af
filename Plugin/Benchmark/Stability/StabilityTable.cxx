#include "Stability/StabilityTable.h"

#include "Names.h"
#include "Stability/CaseTable.h"
#include "TableColumns.h"

namespace volumebench
{
void FillStabilityTable(const std::vector<StabilityResult>& results, vtkTable* table)
{
  using Result = StabilityResult;
  TableColumns<Result> columns(results, table);
  columns.Number("case", [](const Result& r) { return r.Case; });
  columns.Text("title", [](const Result& r) { return FindStabilityCase(r.Case).Title; });
  columns.Text(
    "expectation", [](const Result& r) { return FindStabilityCase(r.Case).Expectation; });
  columns.Number("case_limit", [](const Result& r) { return FindStabilityCase(r.Case).Limit; });
  columns.Text("technique", [](const Result& r) { return r.Who.Technique; });
  columns.Text("integrator",
    [](const Result& r)
    {
      const int integrator = r.Who.Integrator;
      return integrator == NoIntegrator ? std::string() : IntegratorNames().NameOf(integrator);
    });
  columns.Number("meant", [](const Result& r) { return r.Meant ? 1.0 : 0.0; });
  columns.Text("status", [](const Result& r) { return r.Status; });
  columns.Number("error", [](const Result& r) { return r.Error; });
  columns.Number("limit", [](const Result& r) { return r.Limit; });
  columns.Text("reason", [](const Result& r) { return r.Reason; });
}
}
