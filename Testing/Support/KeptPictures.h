// Keeps a picture, its reference and their difference as PNG files, for whoever looks into a
// failure.
#ifndef volumebench_KeptPictures_h
#define volumebench_KeptPictures_h

#include "Error/FloatPicture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

namespace volumebench::test
{
/// Writes one RGBA file whose values are `valueOf(index)` of 0 to 1.
inline void WritePicture(const std::filesystem::path& file, int width, int height,
  const std::function<double(std::size_t)>& valueOf)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(width) * height; ++pixel)
  {
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      const double value = valueOf(4 * pixel + channel);
      bytes[3 * pixel + channel] = static_cast<unsigned char>(
        std::isfinite(value) ? 255.0 * std::clamp(value, 0.0, 1.0) : 255.0);
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  writer->Write();
}

/// Writes NAME-picture.png, NAME-reference.png and NAME-difference.png (fifty times as bright)
/// into PICTURE_FOLDER; returns where they begin.
inline std::string KeepPictures(
  const std::string& name, const FloatPicture& picture, const FloatPicture& reference)
{
  const std::filesystem::path folder(PICTURE_FOLDER);
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& kind, const std::function<double(std::size_t)>& value)
  { WritePicture(folder / (name + kind), picture.Width, picture.Height, value); };
  write("-picture.png", [&](std::size_t i) { return picture.Pixels[i]; });
  write("-reference.png", [&](std::size_t i) { return reference.Pixels[i]; });
  write("-difference.png",
    [&](std::size_t i) { return 50.0 * std::abs(picture.Pixels[i] - reference.Pixels[i]); });
  return (folder / name).string() + "-*.png";
}
}

#endif
