// volumebench-run: see Options.cxx for what it does.
#include "Calibration/Calibration.h"
#include "Calibration/CalibrationReport.h"
#ifdef VOLUMEBENCH_HAS_CUDA
#include "Cuda/CudaReport.h"
#endif
#include "EglContext.h"
#include "MachineContext.h"
#include "OpenGlWindow.h"
#include "Options.h"
#include "Study/Lists.h"
#include "Study/StudyFile.h"
#include "Study/StudyRunner.h"
#include "TextFile.h"
#include "vtkVolumeBenchEglWindow.h"

#include <exception>
#include <iostream>
#include <map>

namespace
{
using namespace volumebench;

OpenGlNames NamesOfDevice()
{
  const auto window = MakeOpenGlWindow();
  return ReadOpenGlNames();
}

int RunCalibration(const Options& options)
{
  const std::string path = options.Out.empty() ? "calibration.json" : options.Out;
  CheckWritable(path); // told before minutes are spent
  const OpenGlNames names = NamesOfDevice();
  std::cout << names.Renderer << ", OpenGL " << names.Version << std::endl;
  const Calibration calibration = Calibrate(MakeCalibrationSettings(options.Quick),
    [](const std::string& what) { std::cerr << "measuring " << what << std::endl; });
  const auto document = CalibrationDocument(calibration, MachineContext(names, true));
  WriteTextFile(path, document.dump(1) + "\n");
  std::cout << CalibrationTable(calibration) << "Written to " << path << std::endl;
  return 0;
}

#ifdef VOLUMEBENCH_HAS_CUDA
int RunCudaCheck(const Options& options)
{
  constexpr int side = 512;
  constexpr int quickSide = 128;
  const std::string path = options.Out.empty() ? "cuda-check.json" : options.Out;
  CheckWritable(path);
  const CudaCheck check = CheckCudaDevice(options.Quick ? quickSide : side,
    [](const std::string& what) { std::cerr << "checking " << what << std::endl; });
  WriteTextFile(path, CudaDocument(check, MachineContext({}, false)).dump(1) + "\n");
  std::cout << CudaTable(check) << "Written to " << path << std::endl;
  return IsRight(check) ? 0 : 1;
}
#else
int RunCudaCheck(const Options&)
{
  throw std::runtime_error("this build has no technique cuda: CUDA's toolkit was not found");
}
#endif

void PrintRun(const StudyRun& run)
{
  const StudyScene& scene = run.Scene;
  std::cout << Json{
    { "dataset", scene.Dataset }, { "transfer_function", scene.TransferFunction },
    { "image_size", { scene.Width, scene.Height } }, { "blend_mode", scene.BlendMode },
    { "path", run.Path }, { "technique", run.Technique }, { "integrator", run.Integrator },
    { "step_voxels", run.StepVoxels }, { "settings", run.SettingsObject() }
  }.dump() << "\n";
}

void PrintRow(const Json& row)
{
  const auto text = [&](const char* key)
  { return row[key].is_string() ? row[key].get<std::string>() : row[key].dump(); };
  std::cout << "  " << text("dataset") << ", " << text("transfer_function") << ", "
            << text("technique") << ", " << text("integrator") << ", step " << text("step_voxels")
            << (row["settings"].empty() ? "" : ", " + row["settings"].dump()) << ": ";
  if (row["status"] == "ok")
  {
    std::cout << row["frame_ms"]["median"] << " ms, RMSE " << row["error"]["rmse"] << "\n";
  }
  else
  {
    std::cout << text("status") << ": " << text("reason") << "\n";
  }
}

// What was measured or failed, a line each, and why the rest was not tried.
bool PrintRows(const std::vector<Json>& rows)
{
  bool allFailed = true;
  std::map<std::string, int> unsupported;
  for (const Json& row : rows)
  {
    allFailed = allFailed && row["status"] == "failed";
    if (row["status"] == "unsupported")
    {
      ++unsupported[row["reason"].get<std::string>()];
    }
    else
    {
      PrintRow(row);
    }
  }
  for (const auto& [reason, count] : unsupported)
  {
    std::cout << "  " << count << " rows unsupported: " << reason << "\n";
  }
  return !allFailed;
}

int MeasureStudy(const Options& options)
{
  Study study = LoadStudy(options.Study, options.Quick, options.Techniques, options.Data);
  if (options.List)
  {
    for (const StudyRun& run : study.Runs())
    {
      PrintRun(run);
    }
    return 0;
  }
  for (const std::string& name : study.FitMemory(FreeMemoryGb()))
  {
    std::cerr << "note: " << name << " is left out: it takes more memory than is free" << std::endl;
  }
  if (study.Runs().empty())
  {
    throw std::runtime_error(options.Study + ": no volume fits the memory of this machine");
  }
  if (study.Document.contains("start"))
  {
    std::cerr << "note: first pictures are those of ParaView's views; not measured here"
              << std::endl;
  }
  const OpenGlNames names = NamesOfDevice();
  std::cout << names.Renderer << ", OpenGL " << names.Version << std::endl;
  const std::size_t count = study.Runs().size();
  const bool openCl = Holds(study.Techniques, "opencl");
  const std::vector<Json> rows =
    RunStudy(study, { options.Out, options.Data }, MachineContext(names, openCl),
      [&](const std::string& what, std::size_t done)
      { std::cerr << "[" << done << " of " << count << " rows] " << what << std::endl; });
  const bool anyMeasured = PrintRows(rows);
  std::cout << rows.size() << " rows in " << options.Out << "/results.json\n";
  return anyMeasured ? 0 : 1;
}

int Main(const std::vector<std::string>& arguments)
{
  const Options options = ParseOptions(arguments);
  if (options.Help)
  {
    std::cout << Usage();
    return 0;
  }
  if (options.Version)
  {
    std::cout << "volumebench-run " VOLUMEBENCH_VERSION "\n";
    return 0;
  }
  if (options.CheckCuda)
  {
    return RunCudaCheck(options);
  }
  ChooseEglDevice(options.Device);
  vtkVolumeBenchEglWindow::UseForAllWindows();
  return options.Calibrate ? RunCalibration(options) : MeasureStudy(options);
}
}

int main(int argc, char** argv)
{
  try
  {
    return Main({ argv + 1, argv + argc });
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << error.what() << "\n";
    return 2;
  }
}
