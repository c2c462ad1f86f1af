// volumebench-run: see Options.cxx for what it does.
#include "Calibration/Calibration.h"
#include "Calibration/CalibrationReport.h"
#include "EglContext.h"
#include "MachineContext.h"
#include "OpenGlWindow.h"
#include "Options.h"
#include "TextFile.h"
#include "vtkVolumeBenchEglWindow.h"

#include <exception>
#include <iostream>

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
  const auto document = CalibrationDocument(calibration, MachineContext(names));
  WriteTextFile(path, document.dump(1) + "\n");
  std::cout << CalibrationTable(calibration) << "Written to " << path << std::endl;
  return 0;
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
  ChooseEglDevice(options.Device);
  vtkVolumeBenchEglWindow::UseForAllWindows();
  return RunCalibration(options);
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
