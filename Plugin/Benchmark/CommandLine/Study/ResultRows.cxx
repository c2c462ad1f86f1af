#include "ResultRows.h"

#include "vtkAbstractArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <sstream>

namespace volumebench
{
namespace
{
// Reads one row of the table; absent, empty and NaN cells are null.
class TableRow
{
public:
  TableRow(vtkTable* table, vtkIdType row)
    : Table(table)
    , Row(row)
  {
  }

  Json Number(const std::string& column) const
  {
    const double value = this->Cell(column).ToDouble();
    return std::isfinite(value) ? Json(value) : Json();
  }

  Json Whole(const std::string& column) const
  {
    const Json value = this->Number(column);
    // A mean over two views may end in a half, which Python rounds to even.
    return value.is_null() ? value : Json(std::llrint(value.get<double>()));
  }

  std::string Text(const std::string& column) const { return this->Cell(column).ToString(); }

  Json TextOrNull(const std::string& column) const
  {
    const std::string text = this->Text(column);
    return text.empty() ? Json() : Json(text);
  }

  Json Words(const std::string& column) const
  {
    std::istringstream stream(this->Text(column));
    Json words = Json::array();
    for (std::string word; stream >> word;)
    {
      words.push_back(word);
    }
    return words;
  }

  Json Object(const std::string& column) const
  {
    const std::string text = this->Text(column);
    return text.empty() ? Json() : Json::parse(text);
  }

  Json Spread(const std::string& name) const
  {
    return this->Numbers(name, { "median", "q1", "q3", "min", "max" });
  }

  Json Numbers(const std::string& name, const std::vector<std::string>& parts) const
  {
    Json group = Json::object();
    for (const std::string& part : parts)
    {
      group[part] = this->Number(name + "." + part);
    }
    return group;
  }

private:
  vtkVariant Cell(const std::string& column) const
  {
    return this->Table->GetValueByName(this->Row, column.c_str());
  }

  vtkTable* Table;
  vtkIdType Row;
};

Json Nulls(const std::vector<std::string>& keys)
{
  Json group = Json::object();
  for (const std::string& key : keys)
  {
    group[key] = nullptr;
  }
  return group;
}

// All that is known of a run before it is measured, and null for all that is measured.
Json Unmeasured(const Study& study, const StudyRun& run, const OpenVolume* volume)
{
  const Json spread = Nulls({ "median", "q1", "q3", "min", "max" });
  return { { "study", study.Name() }, { "dataset", run.Scene.Dataset },
    { "dims", volume ? Json(volume->Dims) : Json() },
    { "scalar_type", volume ? Json(volume->ScalarType) : Json() },
    { "transfer_function", run.Scene.TransferFunction }, { "technique", run.Technique },
    { "integrator", run.Integrator }, { "blend_mode", run.Scene.BlendMode },
    { "step_voxels", run.StepVoxels }, { "image_size", { run.Scene.Width, run.Scene.Height } },
    { "view", study.Document["camera"]["path"] }, { "path", run.Path },
    { "settings", run.SettingsObject() }, { "lighting", run.Scene.Lighting },
    { "stand_in_for", study.Dataset(run.Scene.Dataset).value("stands_for", Json()) },
    { "features", nullptr }, { "left_out", nullptr }, { "status", "failed" }, { "reason", nullptr },
    { "frames", nullptr }, { "frame_ms", spread }, { "gpu_ms", spread }, { "fps", nullptr },
    { "frame_log", nullptr }, { "setup_ms", Nulls({ "upload", "tables", "grid", "compile" }) },
    { "stages_ms", nullptr }, { "samples_taken", nullptr }, { "samples_skipped", nullptr },
    { "rays_terminated", nullptr }, { "bytes_on_device", nullptr },
    { "error",
      Nulls({ "rmse", "linf", "p999", "psnr", "mean", "ssim", "delta_e_over_1_percent", "flip_mean",
        "flip_p99", "reference", "reference_uncertainty", "image_size" }) } };
}

Json ErrorOf(const TableRow& row)
{
  Json error = row.Numbers("error",
    { "rmse", "linf", "p999", "psnr", "mean", "ssim", "delta_e_over_1_percent", "flip_mean",
      "flip_p99" });
  error["reference"] = row.TextOrNull("error.reference");
  error["reference_uncertainty"] = row.Number("error.reference_uncertainty");
  const Json width = row.Whole("error.image_size.w");
  const Json height = row.Whole("error.image_size.h");
  error["image_size"] = width.is_null() ? Json() : Json{ width, height };
  return error;
}

void FillMeasured(const TableRow& row, Json& record)
{
  record["features"] = row.Words("features");
  record["left_out"] = row.Words("left_out");
  record["status"] = row.Text("status");
  record["reason"] = row.TextOrNull("reason");
  record["frame_ms"] = row.Spread("frame_ms");
  record["gpu_ms"] = row.Spread("gpu_ms");
  record["fps"] = row.Number("fps");
  record["setup_ms"] = row.Numbers("setup_ms", { "upload", "tables", "grid", "compile" });
  record["frame_log"] = row.Object("frame_log");
  record["stages_ms"] = row.Object("stages_ms");
  for (const char* key :
    { "frames", "samples_taken", "samples_skipped", "rays_terminated", "bytes_on_device" })
  {
    record[key] = row.Whole(key);
  }
  record["error"] = ErrorOf(row);
}

// Tells whether a row of the table is that run; a peer has no integrator or step of a study's.
bool Answers(const TableRow& row, const StudyRun& run)
{
  const std::string text = row.Text("settings");
  if (row.Text("technique") != run.Technique ||
    Json::parse(text.empty() ? "{}" : text) != run.SettingsObject())
  {
    return false;
  }
  if (IsPeer(run.Technique))
  {
    return true;
  }
  const double step = run.StepVoxels.get<double>();
  const Json measured = row.Number("step_voxels");
  return row.Text("integrator") == run.Integrator && measured.is_number() &&
    std::abs(measured.get<double>() - step) <= 1e-6 * step;
}
}

Json RowWithout(const Study& study, const StudyRun& run, const OpenVolume* volume,
  const std::string& status, const std::string& reason)
{
  Json record = Unmeasured(study, run, volume);
  record["status"] = status;
  record["reason"] = reason;
  return record;
}

std::vector<Json> RowsOf(const Study& study, const std::vector<StudyRun>& runs,
  const OpenVolume& volume, vtkTable* table, const std::string& reason)
{
  std::vector<Json> records;
  for (const StudyRun& run : runs)
  {
    records.push_back(RowWithout(study, run, &volume, "failed", reason));
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
    {
      const TableRow row(table, i);
      if (Answers(row, run))
      {
        FillMeasured(row, records.back());
        break;
      }
    }
  }
  return records;
}
}
