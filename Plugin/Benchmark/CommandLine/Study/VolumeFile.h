// Finds and reads the volumes of a study: generated, built in, or files in the data folder.
#ifndef volumebench_VolumeFile_h
#define volumebench_VolumeFile_h

#include "JsonFile.h"

#include "vtkSmartPointer.h"

#include <array>
#include <filesystem>
#include <string>

class vtkImageData;

namespace volumebench
{
/// Image data in memory with what a study needs to know of it.
struct OpenVolume
{
  vtkSmartPointer<vtkImageData> Image;
  std::string Array; // the active point scalars
  std::array<int, 3> Dims{};
  std::string ScalarType; // as numpy calls it: uint8, float32, ...
  double Range[2] = { 0.0, 0.0 };
  double MeanSpacing = 1.0;
  double MeanEdge = 0.0; // of the box
};

/// The file NAME.nrrd, .nhdr, .mhd, .mha, .vti, .nii, .nii.gz, .pvm, .dat or .raw in a folder, the
/// first of them; empty when there is none.
std::filesystem::path FindVolumeFile(const std::string& name, const std::filesystem::path& folder);

/// Throws std::runtime_error, `where` in front, when a dataset has keys that only a generated
/// volume heeds and is none, or a stand-in that is none.
void CheckGenerated(const Json& dataset, const std::string& where);

/// Throws std::runtime_error that says what is missing when a dataset has no file and is not
/// generated; nothing is read.
void CheckVolume(const Json& dataset, const std::filesystem::path& folder);

/// Reads or generates it; anything that is no 3-D scalar image is an error that names the file.
OpenVolume ReadVolume(const Json& dataset, const std::filesystem::path& folder);
}

#endif
