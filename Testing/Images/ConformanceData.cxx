// Scenes of scanned and simulated volumes, skipped where the files are missing, and of generated
// ones that stand in for each kind everywhere.
#include "ConformanceScene.h"

#include "vtkImageReader2.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNrrdReader.h"

#include <cstdlib>
#include <filesystem>

namespace volumebench::test
{
namespace
{
std::filesystem::path DataFolder()
{
  const char* folder = std::getenv("VOLUMEBENCH_DATA");
  return folder ? folder : DATA_FOLDER;
}

template <typename Reader>
vtkSmartPointer<vtkImageData> Read(const std::filesystem::path& file)
{
  if (!std::filesystem::exists(file))
  {
    return nullptr;
  }
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

// From transparent to bone: the transfer function of a scan whose values go up to `high`.
vtkSmartPointer<vtkVolumeProperty> ScanProperty(
  double low, double high, double peak, double unitDistance)
{
  const auto at = [=](double share) { return low + share * (high - low); };
  auto property = HillsProperty(1.0, low, high);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(at(0.0), 0.0);
  opacity->AddPoint(at(0.1), 0.0);
  opacity->AddPoint(at(0.4), 0.4 * peak);
  opacity->AddPoint(at(1.0), peak);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unitDistance);
  return property;
}

ConformanceScene ScanScene(const std::string& name, double step,
  std::function<vtkSmartPointer<vtkImageData>()> image,
  std::function<vtkSmartPointer<vtkVolumeProperty>()> property)
{
  ConformanceScene scene;
  scene.Name = name;
  scene.StepVoxels = step;
  scene.Image = std::move(image);
  scene.Property = std::move(property);
  return scene;
}

void AddFiles(ConformanceScenes& scenes)
{
  scenes.push_back(ScanScene(
    "bucky_uint8", 0.5, [] { return Read<vtkMetaImageReader>(DataFolder() / "bucky.mhd"); },
    [] { return ScanProperty(0.0, 255.0, 0.2, 1.0); }));
  scenes.push_back(ScanScene(
    "walnut_uint16", 1.0, [] { return Read<vtkNrrdReader>(DataFolder() / "walnut.nrrd"); },
    [] { return ScanProperty(1000.0, 15000.0, 0.1, 0.015625); }));
  scenes.push_back(ScanScene(
    "feet_int16", 1.0, [] { return Read<vtkNrrdReader>(DataFolder() / "vhf_feet_ct.nrrd"); },
    [] { return ScanProperty(-300.0, 1200.0, 0.05, 1.0); }));
  scenes.push_back(ScanScene(
    "isabel_float", 1.0, [] { return Read<vtkNrrdReader>(DataFolder() / "isabel_wind.nrrd"); },
    [] { return ScanProperty(0.0, 78.0, 0.3, 4.0); }));
  scenes.push_back(ScanScene(
    "brain_uint8", 1.0,
    [] { return Read<vtkNIFTIImageReader>("/usr/share/mricron/templates/ch2.nii.gz"); },
    [] { return ScanProperty(20.0, 255.0, 0.05, 1.0); }));
}

// A ball of shells: sharp borders as in a scan, a little softened as scanners do.
double Shells(double i, double j, double k)
{
  const double r = std::sqrt((i - 20) * (i - 20) + (j - 17) * (j - 17) + (k - 15) * (k - 15));
  const auto edge = [r](double radius) { return 0.5 * (1.0 + std::tanh(0.8 * (radius - r))); };
  return 0.5 * edge(13.0) - 0.3 * edge(10.0) + 0.8 * edge(5.0);
}

// A swirl with a calm eye, as a storm.
double Storm(double i, double j, double k)
{
  const double r = std::hypot(i - 20.0, j - 17.0) / 10.0;
  return 70.0 * r * std::exp(1.0 - r) *
    (0.7 + 0.3 * std::sin(0.2 * k + std::atan2(j - 17, i - 20)));
}

void AddStandIns(ConformanceScenes& scenes)
{
  struct Row
  {
    const char* Name;
    int Type;
    double Scale;
    double Offset;
  };
  for (const Row& row : { Row{ "shells_uint8", VTK_UNSIGNED_CHAR, 250.0, 0.0 },
         { "shells_uint16", VTK_UNSIGNED_SHORT, 20000.0, 0.0 },
         { "shells_int16", VTK_SHORT, 2200.0, -1000.0 } })
  {
    scenes.push_back(ScanScene(
      row.Name, 1.0,
      [=]
      {
        return MakeImage(
          40, 36, 32,
          [=](double i, double j, double k) { return row.Offset + row.Scale * Shells(i, j, k); },
          row.Type);
      },
      [=] { return ScanProperty(row.Offset, row.Offset + row.Scale, 0.15, 1.0); }));
  }
  scenes.push_back(ScanScene(
    "storm_float", 1.0, [] { return MakeImage(40, 36, 12, Storm); },
    [] { return ScanProperty(0.0, 78.0, 0.3, 1.0); }));
}
}

ConformanceScenes ScenesOfData()
{
  ConformanceScenes scenes;
  AddFiles(scenes);
  AddStandIns(scenes);
  return scenes;
}
}
