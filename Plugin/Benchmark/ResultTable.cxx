#include "ResultTable.h"

#include "StageMedians.h"
#include "TableColumns.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <string>

namespace volumebench
{
namespace
{
class Columns : public TableColumns<RunResult>
{
public:
  using TableColumns::TableColumns;

  void Spread(const std::string& name, const Summary RunResult::*member)
  {
    this->Number(name + ".median", [=](const RunResult& r) { return (r.*member).Median; });
    this->Number(name + ".q1", [=](const RunResult& r) { return (r.*member).Q1; });
    this->Number(name + ".q3", [=](const RunResult& r) { return (r.*member).Q3; });
    this->Number(name + ".min", [=](const RunResult& r) { return (r.*member).Min; });
    this->Number(name + ".max", [=](const RunResult& r) { return (r.*member).Max; });
  }
};

void FillCosts(Columns& columns)
{
  columns.Number("frames", [](const RunResult& r) { return r.Frames; });
  columns.Spread("frame_ms", &RunResult::FrameMs);
  columns.Spread("gpu_ms", &RunResult::GpuMs);
  columns.Number("fps", [](const RunResult& r) { return 1000.0 / r.FrameMs.Median; });
  columns.Number("setup_ms.upload", [](const RunResult& r) { return r.UploadMs; });
  columns.Number("setup_ms.tables", [](const RunResult& r) { return r.TablesMs; });
  columns.Number("setup_ms.grid", [](const RunResult& r) { return r.GridMs; });
  columns.Number("setup_ms.compile", [](const RunResult& r) { return r.CompileMs; });
  columns.Text("frame_log", [](const RunResult& r) { return r.FrameLog; });
  columns.Text("stages_ms", [](const RunResult& r) { return StagesJson(r.Stages); });
  columns.Number("samples_taken", [](const RunResult& r) { return r.Samples.Taken; });
  columns.Number("samples_skipped", [](const RunResult& r) { return r.Samples.Skipped; });
  columns.Number("rays_terminated", [](const RunResult& r) { return r.Samples.RaysTerminated; });
  columns.Number("bytes_on_device", [](const RunResult& r) { return r.BytesOnDevice; });
}

double PixelsOrNan(int pixels)
{
  return pixels > 0 ? pixels : std::numeric_limits<double>::quiet_NaN();
}

void FillMeasures(Columns& columns)
{
  columns.Number("error.rmse", [](const RunResult& r) { return r.Error.Rmse; });
  columns.Number("error.linf", [](const RunResult& r) { return r.Error.Linf; });
  columns.Number("error.p999", [](const RunResult& r) { return r.Error.P999; });
  columns.Number("error.psnr", [](const RunResult& r) { return r.Error.Psnr; });
  columns.Number("error.mean", [](const RunResult& r) { return r.Error.Mean; });
  columns.Number("error.ssim", [](const RunResult& r) { return r.Perceived.Ssim; });
  columns.Number("error.delta_e_over_1_percent",
    [](const RunResult& r) { return r.Perceived.DeltaEOver1Percent; });
  columns.Number("error.flip_mean", [](const RunResult& r) { return r.Perceived.FlipMean; });
  columns.Number("error.flip_p99", [](const RunResult& r) { return r.Perceived.FlipP99; });
}

void FillErrors(Columns& columns)
{
  FillMeasures(columns);
  columns.Text("error.reference", [](const RunResult& r) { return r.Reference; });
  columns.Number(
    "error.reference_uncertainty", [](const RunResult& r) { return r.ReferenceUncertainty; });
  columns.Number(
    "error.image_size.w", [](const RunResult& r) { return PixelsOrNan(r.ErrorWidth); });
  columns.Number(
    "error.image_size.h", [](const RunResult& r) { return PixelsOrNan(r.ErrorHeight); });
}
}

namespace
{
bool HasPlace(const RunResult& run)
{
  return run.Status == "ok" && run.Error.Rmse > 0.0 && run.FrameMs.Median > 0.0;
}

std::string CurveOf(const RunResult& run)
{
  const std::string settings = run.Settings.empty() ? "" : " " + SettingsJson(run.Settings);
  return run.Technique + (run.Integrator.empty() ? "" : " " + run.Integrator) + settings;
}
}

void FillErrorCurves(const std::vector<RunResult>& results, vtkTable* table)
{
  std::vector<RunResult> placed;
  std::copy_if(results.begin(), results.end(), std::back_inserter(placed), HasPlace);
  Columns columns(placed, table);
  columns.Number(ErrorCurvesX, [](const RunResult& r) { return r.FrameMs.Median; });
  std::set<std::string> known;
  for (const RunResult& run : placed)
  {
    const std::string curve = CurveOf(run);
    if (known.insert(curve).second)
    {
      columns.Number(curve,
        [&curve](const RunResult& r)
        { return CurveOf(r) == curve ? r.Error.Rmse : std::numeric_limits<double>::quiet_NaN(); });
    }
  }
}

void FillErrorTable(const std::vector<RunResult>& results, vtkTable* table)
{
  Columns columns(results, table);
  FillMeasures(columns);
}

void FillResultTable(const std::vector<RunResult>& results, const ExperimentSettings& settings,
  const std::string& view, vtkTable* table)
{
  Columns columns(results, table);
  columns.Text("technique", [](const RunResult& r) { return r.Technique; });
  columns.Text("integrator", [](const RunResult& r) { return r.Integrator; });
  columns.Text("blend_mode", [](const RunResult& r) { return r.BlendMode; });
  columns.Text("settings", [](const RunResult& r) { return SettingsJson(r.Settings); });
  columns.Number("step_voxels", [](const RunResult& r) { return r.StepVoxels; });
  columns.Number("image_size.w", [&](const RunResult&) { return settings.Width; });
  columns.Number("image_size.h", [&](const RunResult&) { return settings.Height; });
  columns.Text("view", [&](const RunResult&) { return view; });
  columns.Text("path", [](const RunResult&) { return std::string("engine"); });
  columns.Text("features", [](const RunResult& r) { return r.Features; });
  columns.Text("left_out", [](const RunResult& r) { return r.LeftOut; });
  columns.Text("status", [](const RunResult& r) { return r.Status; });
  columns.Text("reason", [](const RunResult& r) { return r.Reason; });
  FillCosts(columns);
  FillErrors(columns);
  columns.Text("picture", [](const RunResult& r) { return r.Picture; });
}
}
