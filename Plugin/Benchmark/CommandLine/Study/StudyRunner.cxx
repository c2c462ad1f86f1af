#include "StudyRunner.h"

#include "SceneRun.h"
#include "TechniqueChoice.h"
#include "TextFile.h"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

namespace volumebench
{
namespace
{
namespace fs = std::filesystem;

class Runner
{
public:
  Runner(const Study& study, const StudyPlaces& places, const Json& context,
    const StudyProgress& progress)
    : Asked(study)
    , Places(places)
    , Context(context)
    , Progress(progress)
    , Runs(study.Runs())
    , Rows(this->Runs.size())
  {
    for (const StudyScene& scene : study.Scenes())
    {
      const std::string& name = scene.TransferFunction;
      if (!this->Functions.count(name))
      {
        this->Functions[name] = ReadFunction(name, { study.Folder, places.Data });
      }
    }
    for (const Json& dataset : study.Document["datasets"])
    {
      CheckVolume(dataset, places.Data);
    }
  }

  std::vector<Json> Measure()
  {
    this->MakeFolder();
    WriteTextFile(this->Places.Out / "settings.json", this->Asked.Settings().dump(1) + "\n");
    for (const Json& dataset : this->Asked.Document["datasets"])
    {
      this->MeasureDataset(dataset);
    }
    return this->Finished();
  }

private:
  void MakeFolder() const
  {
    std::error_code fault;
    fs::create_directories(this->Places.Out, fault);
    if (fault)
    {
      throw std::runtime_error(this->Places.Out.string() + ": cannot be made: " + fault.message());
    }
    CheckWritable(this->Places.Out / "results.json");
  }

  void MeasureDataset(const Json& dataset)
  {
    const std::string name = dataset["name"];
    std::unique_ptr<OpenVolume> volume;
    std::string fault;
    try
    {
      this->Progress("reading " + name, this->Finished().size());
      volume = std::make_unique<OpenVolume>(ReadVolume(dataset, this->Places.Data));
    }
    catch (const std::exception& error)
    {
      fault = error.what();
    }
    for (const StudyScene& scene : this->Asked.Scenes())
    {
      if (scene.Dataset == name)
      {
        this->MeasureScene(scene, volume.get(), fault);
        this->Write();
      }
    }
  }

  // Sets the rows of a scene; `fault` is why there is no volume.
  void MeasureScene(const StudyScene& scene, const OpenVolume* volume, const std::string& fault)
  {
    std::vector<std::size_t> places;
    std::vector<StudyRun> runs;
    for (std::size_t i = 0; i < this->Runs.size(); ++i)
    {
      const StudyRun& run = this->Runs[i];
      if (!(run.Scene == scene))
      {
        continue;
      }
      const std::string reason = WhyNotHere(run.Technique, run.Path);
      if (!reason.empty())
      {
        this->Rows[i] = RowWithout(this->Asked, run, volume, "unsupported", reason);
      }
      else if (!volume)
      {
        this->Rows[i] = RowWithout(this->Asked, run, volume, "failed", fault);
      }
      else
      {
        places.push_back(i);
        runs.push_back(run);
      }
    }
    if (!runs.empty())
    {
      this->Progress(scene.Title(), this->Finished().size());
      const std::vector<Json> rows = this->RowsOf(scene, runs, *volume);
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        this->Rows[places[i]] = rows[i];
      }
    }
  }

  std::vector<Json> RowsOf(
    const StudyScene& scene, const std::vector<StudyRun>& runs, const OpenVolume& volume) const
  {
    try
    {
      return volumebench::MeasureScene(
        this->Asked, runs, volume, this->Functions.at(scene.TransferFunction));
    }
    catch (const std::exception& error) // the study goes on with the next scene
    {
      std::vector<Json> rows;
      for (const StudyRun& run : runs)
      {
        rows.push_back(RowWithout(this->Asked, run, &volume, "failed", error.what()));
      }
      return rows;
    }
  }

  std::vector<Json> Finished() const
  {
    std::vector<Json> rows;
    std::copy_if(this->Rows.begin(), this->Rows.end(), std::back_inserter(rows),
      [](const Json& row) { return !row.is_null(); });
    return rows;
  }

  void Write() const
  {
    const Json document = { { "schema", 1 }, { "context", this->Context },
      { "runs", this->Finished() } };
    WriteTextFile(this->Places.Out / "results.json", document.dump(1) + "\n");
  }

  const Study& Asked;
  const StudyPlaces& Places;
  const Json& Context;
  const StudyProgress& Progress;
  std::vector<StudyRun> Runs;
  std::vector<Json> Rows; // null: not measured yet
  std::map<std::string, FunctionFile> Functions;
};
}

std::vector<Json> RunStudy(
  const Study& study, const StudyPlaces& places, const Json& context, const StudyProgress& progress)
{
  return Runner(study, places, context, progress).Measure();
}
}
