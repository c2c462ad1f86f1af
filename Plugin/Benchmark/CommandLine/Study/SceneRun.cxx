#include "SceneRun.h"

#include "Names.h"
#include "vtkVolumeBenchmark.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <set>

namespace volumebench
{
namespace
{
// Keeps the first error of a filter, on one line and without VTK's preamble.
class FilterError
{
public:
  explicit FilterError(vtkObject* filter)
  {
    this->Watch->SetClientData(&this->Text);
    this->Watch->SetCallback(
      [](vtkObject*, unsigned long, void* client, void* call)
      {
        auto& text = *static_cast<std::string*>(client);
        if (text.empty() && call)
        {
          text = OneLine(static_cast<const char*>(call));
        }
      });
    filter->AddObserver(vtkCommand::ErrorEvent, this->Watch);
  }

  std::string Text;

private:
  static std::string OneLine(std::string text)
  {
    const std::size_t preamble = text.find("): ");
    text = preamble == std::string::npos ? text : text.substr(preamble + 3);
    std::string line;
    for (const char letter : text)
    {
      const bool space = letter == '\n' || letter == ' ';
      line +=
        space && (line.empty() || line.back() == ' ') ? "" : std::string(1, space ? ' ' : letter);
    }
    return line.substr(0, line.find_last_not_of(' ') + 1);
  }

  vtkNew<vtkCallbackCommand> Watch;
};

void SetFunction(vtkVolumeBenchmark* bench, const OpenVolume& volume, const FunctionFile& function)
{
  for (const std::vector<double>& point : function.Opacity)
  {
    bench->AddOpacityPoint(function.ValueAt(point[0], volume.Range), point[1]);
  }
  for (const std::vector<double>& point : function.Color)
  {
    bench->AddColorPoint(function.ValueAt(point[0], volume.Range), point[1], point[2], point[3]);
  }
  bench->SetScalarOpacityUnitDistance(
    function.UnitDistance * (function.DistanceInEdges ? volume.MeanEdge : volume.MeanSpacing));
}

void SetMethod(vtkVolumeBenchmark* bench, const Json& document)
{
  const Json& camera = document["camera"];
  bench->SetCameraPath(camera["path"].get<std::string>().c_str());
  bench->SetCameraSeed(camera["seed"]);
  bench->SetFrames(camera["frames"]);
  bench->SetElevation(camera["elevation_degrees"]);
  bench->SetZoom(camera["zoom"]);
  const Json& timing = document["timing"];
  bench->SetWarmUpFrames(timing["warm_up_frames"]);
  bench->SetMinimumFrames(timing["minimum_frames"]);
  bench->SetRelativeNoise(timing["relative_noise"]);
  bench->SetTimeLimit(timing["time_limit_s"]);
  bench->SetCoolDown(timing["cool_down_ms"]);
  const Json& error = document["error"];
  bench->SetErrorViews(error["views"]);
  bench->SetReference(error["reference"] == "Fine Steps" ? ReferenceNames().NumberOf("Fine Steps")
                                                         : ReferenceNames().NumberOf("Cell Exact"));
  bench->SetReferenceStepVoxels(error["reference_step_voxels"]);
  if (!error["image_size"].is_null())
  {
    bench->SetErrorImageSize(error["image_size"][0], error["image_size"][1]);
  }
}

void SetScene(vtkVolumeBenchmark* bench, const Json& document, const StudyScene& scene)
{
  bench->SetImageSize(scene.Width, scene.Height);
  bench->SetBlendMode(BlendModeNames().NumberOf(scene.BlendMode));
  bench->SetTerminationThreshold(document["termination_threshold"]);
  bench->SetRaySetUp(RaySetUpNames().NumberOf(document["ray_set_up"]));
  bench->SetShade(scene.Lighting);
  bench->SetLightingDamping(document["lighting_damping"]);
}

// Every run is a variant, so that the filter measures these and no others.
void SetRuns(vtkVolumeBenchmark* bench, const std::vector<StudyRun>& runs)
{
  std::set<std::string> techniques;
  for (const StudyRun& run : runs)
  {
    if (techniques.insert(run.Technique).second)
    {
      bench->AddTechnique(run.Technique.c_str());
    }
    bench->AddVariant(run.VariantText().c_str());
  }
  // A variant names its own; these only have to be there.
  bench->AddIntegrator("Midpoint");
  bench->AddStepVoxels(1.0);
}
}

std::vector<Json> MeasureScene(const Study& study, const std::vector<StudyRun>& runs,
  const OpenVolume& volume, const FunctionFile& function)
{
  vtkNew<vtkVolumeBenchmark> bench;
  bench->SetInputDataObject(volume.Image);
  bench->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, volume.Array.c_str());
  SetScene(bench, study.Document, runs.front().Scene);
  SetFunction(bench, volume, function);
  SetMethod(bench, study.Document);
  SetRuns(bench, runs);
  FilterError error(bench);
  bench->Update();
  auto* table = vtkTable::SafeDownCast(bench->GetOutputDataObject(0));
  return RowsOf(study, runs, volume, table,
    error.Text.empty() ? "the filter returned no row for this run" : error.Text);
}
}
