#include "VolumeFile.h"

#include "Generators.h"
#include "Lists.h"
#include "TextFile.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkLogger.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"
#include "vtkVolumeBenchPvmReader.h"
#include "vtkVolumeBenchVoreenReader.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace volumebench
{
namespace
{
namespace fs = std::filesystem;

// A .raw file may belong to a header, so it comes last.
const char* const Extensions[] = { ".nrrd", ".nhdr", ".mhd", ".mha", ".vti", ".nii", ".nii.gz",
  ".pvm", ".dat", ".raw" };
const char* const MriFile = "/usr/share/mricron/templates/ch2.nii.gz";

struct ScalarKind
{
  int VtkType;
  std::size_t Bytes;
};

const std::map<std::string, ScalarKind>& ScalarKinds()
{
  static const std::map<std::string, ScalarKind> kinds = { { "int8", { VTK_SIGNED_CHAR, 1 } },
    { "uint8", { VTK_UNSIGNED_CHAR, 1 } }, { "int16", { VTK_SHORT, 2 } },
    { "uint16", { VTK_UNSIGNED_SHORT, 2 } }, { "int32", { VTK_INT, 4 } },
    { "uint32", { VTK_UNSIGNED_INT, 4 } }, { "float32", { VTK_FLOAT, 4 } },
    { "float64", { VTK_DOUBLE, 8 } } };
  return kinds;
}

std::string ScalarTypeOf(vtkDataArray* scalars)
{
  const int bits = 8 * scalars->GetDataTypeSize();
  const int type = scalars->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return "float" + std::to_string(bits);
  }
  return (scalars->GetDataTypeMin() < 0.0 ? "int" : "uint") + std::to_string(bits);
}

bool IsGenerated(const std::string& name)
{
  return Holds(GeneratorNames(), name);
}

// Runs a reader with VTK's own messages off; true when it brought an image.
template <typename Reader>
bool Read(Reader* reader, const fs::path& path, vtkImageData* image)
{
  bool failed = false;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&failed);
  watch->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { *static_cast<bool*>(data) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, watch);
  reader->SetFileName(path.c_str());
  const vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  reader->Update();
  vtkLogger::SetStderrVerbosity(verbosity);
  image->ShallowCopy(reader->GetOutput());
  return !failed && image->GetNumberOfPoints() > 0;
}

template <typename Reader>
bool ReadIfPossible(const fs::path& path, vtkImageData* image)
{
  vtkNew<Reader> reader;
  return reader->CanReadFile(path.c_str()) && Read(reader.Get(), path, image);
}

// Reads by a reader of ours, whose faults name the file.
template <typename Reader>
bool ReadByOwn(const fs::path& path, vtkImageData* image)
{
  vtkNew<Reader> reader;
  if (!Read(reader.Get(), path, image))
  {
    throw std::runtime_error(reader->GetFault());
  }
  return true;
}

Json RawLayout(const fs::path& path)
{
  fs::path sidecar = path;
  sidecar.replace_extension(".json");
  if (!fs::is_regular_file(sidecar))
  {
    throw std::runtime_error(path.string() + ": " + sidecar.filename().string() +
      " is missing beside it; it gives dims and scalar_type");
  }
  Json layout = ParseJson(ReadTextFile(sidecar), sidecar.string());
  CheckSchema(layout, "raw_volume_schema.json", sidecar.string());
  std::uintmax_t bytes = ScalarKinds().at(layout["scalar_type"]).Bytes;
  std::string size;
  for (const Json& count : layout["dims"])
  {
    bytes *= count.get<std::uintmax_t>();
    size += (size.empty() ? "" : " x ") + count.dump();
  }
  if (fs::file_size(path) != bytes)
  {
    throw std::runtime_error(path.string() + ": has " + std::to_string(fs::file_size(path)) +
      " bytes, but " + sidecar.filename().string() + " says " + size + " of " +
      layout["scalar_type"].get<std::string>() + ", that is " + std::to_string(bytes) + " bytes");
  }
  return layout;
}

bool ReadRaw(const fs::path& path, vtkImageData* image)
{
  const Json layout = RawLayout(path);
  const auto dims = layout["dims"].get<std::array<int, 3>>();
  const auto spacing = layout.value("spacing", std::array<double, 3>{ 1.0, 1.0, 1.0 });
  vtkNew<vtkImageReader2> reader;
  reader->SetFileDimensionality(3);
  reader->FileLowerLeftOn(); // else VTK turns the rows upside down
  reader->SetDataExtent(0, dims[0] - 1, 0, dims[1] - 1, 0, dims[2] - 1);
  reader->SetDataSpacing(spacing[0], spacing[1], spacing[2]);
  reader->SetDataScalarType(ScalarKinds().at(layout["scalar_type"]).VtkType);
  reader->SetNumberOfScalarComponents(1);
  if (layout.value("byte_order", "little") == "little")
  {
    reader->SetDataByteOrderToLittleEndian();
  }
  else
  {
    reader->SetDataByteOrderToBigEndian();
  }
  return Read(reader.Get(), path, image);
}

bool ReadAny(const fs::path& path, vtkImageData* image)
{
  const std::string extension = path.extension();
  if (extension == ".raw")
  {
    return ReadRaw(path, image);
  }
  if (extension == ".pvm")
  {
    return ReadByOwn<vtkVolumeBenchPvmReader>(path, image);
  }
  if (extension == ".dat")
  {
    return ReadByOwn<vtkVolumeBenchVoreenReader>(path, image);
  }
  if (extension == ".nrrd" || extension == ".nhdr")
  {
    return ReadIfPossible<vtkNrrdReader>(path, image);
  }
  if (extension == ".mhd" || extension == ".mha")
  {
    return ReadIfPossible<vtkMetaImageReader>(path, image);
  }
  if (extension == ".vti")
  {
    return ReadIfPossible<vtkXMLImageDataReader>(path, image);
  }
  return ReadIfPossible<vtkNIFTIImageReader>(path, image);
}

vtkDataArray* ScalarsOf(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return scalars ? scalars : image->GetPointData()->GetArray(0);
}

// The axes (x, y, z) of the built-in head become (-x, z, y): upright, no voxel changes.
vtkSmartPointer<vtkImageData> Upright(vtkImageData* image)
{
  int dims[3];
  image->GetDimensions(dims);
  double spacing[3];
  image->GetSpacing(spacing);
  vtkDataArray* scalars = ScalarsOf(image);
  auto turned = vtkSmartPointer<vtkImageData>::New();
  turned->SetDimensions(dims[0], dims[2], dims[1]);
  turned->SetSpacing(spacing[0], spacing[2], spacing[1]);
  turned->AllocateScalars(scalars->GetDataType(), 1);
  vtkDataArray* target = turned->GetPointData()->GetScalars();
  vtkIdType next = 0;
  for (int z = 0; z < dims[1]; ++z)
  {
    for (int y = 0; y < dims[2]; ++y)
    {
      for (int x = 0; x < dims[0]; ++x)
      {
        const vtkIdType source = dims[0] - 1 - x +
          static_cast<vtkIdType>(dims[0]) * (z + static_cast<vtkIdType>(dims[1]) * y);
        target->SetTuple(next++, source, scalars);
      }
    }
  }
  return turned;
}

OpenVolume Opened(
  const vtkSmartPointer<vtkImageData>& image, const std::string& name, const std::string& file)
{
  vtkDataArray* scalars = ScalarsOf(image);
  if (!scalars)
  {
    throw std::runtime_error(file + ": holds no point data");
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error(file + ": has " + std::to_string(scalars->GetNumberOfComponents()) +
      " components a voxel; one is needed");
  }
  OpenVolume volume;
  image->GetDimensions(volume.Dims.data());
  if (*std::min_element(volume.Dims.begin(), volume.Dims.end()) < 2)
  {
    throw std::runtime_error(file + ": is " + std::to_string(volume.Dims[0]) + " x " +
      std::to_string(volume.Dims[1]) + " x " + std::to_string(volume.Dims[2]) +
      " voxels; each side needs two or more");
  }
  scalars->GetFiniteRange(volume.Range);
  if (volume.Range[0] > volume.Range[1])
  {
    throw std::runtime_error(file + ": holds no finite value");
  }
  if (!scalars->GetName() || !*scalars->GetName())
  {
    scalars->SetName(name.c_str());
  }
  image->GetPointData()->SetActiveScalars(scalars->GetName());
  const double* spacing = image->GetSpacing();
  volume.MeanSpacing = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    volume.MeanEdge += (volume.Dims[axis] - 1) * spacing[axis] / 3.0;
  }
  volume.Image = image;
  volume.Array = scalars->GetName();
  volume.ScalarType = ScalarTypeOf(scalars);
  return volume;
}
}

fs::path FindVolumeFile(const std::string& name, const fs::path& folder)
{
  for (const char* extension : Extensions)
  {
    fs::path path = folder / (name + extension);
    if (!folder.empty() && fs::is_regular_file(path))
    {
      return path;
    }
  }
  return {};
}

void CheckGenerated(const Json& dataset, const std::string& where)
{
  const std::string name = dataset["name"];
  const std::string generated = dataset.value("generator", dataset.value("otherwise", name));
  for (const char* key : { "otherwise", "generator" })
  {
    if (dataset.contains(key) && !IsGenerated(generated))
    {
      throw std::runtime_error(where + ": \"" + key + "\" of dataset \"" + name + "\" is \"" +
        generated + "\"; it must be a generated volume: " + Joined(GeneratorNames()));
    }
  }
  for (const char* key : { "dims", "scalar_type", "extent", "share", "seed", "spacing" })
  {
    if (!dataset.contains(key))
    {
      continue;
    }
    if (!IsGenerated(generated))
    {
      throw std::runtime_error(where + ": \"" + key + "\" of dataset \"" + name +
        "\" applies only to generated volumes: " + Joined(GeneratorNames()));
    }
    if (!Holds(GeneratorKeys(generated), key))
    {
      throw std::runtime_error(where + ": \"" + key + "\" does not apply to \"" + generated + "\"");
    }
  }
}

void CheckVolume(const Json& dataset, const fs::path& folder)
{
  const std::string name = dataset["name"];
  if (!GeneratorOf(dataset).empty())
  {
    return;
  }
  const fs::path file = FindVolumeFile(name, folder);
  if (file.extension() == ".raw")
  {
    RawLayout(file);
  }
  if (!file.empty() || (name == "mri" && fs::is_regular_file(MriFile)))
  {
    return;
  }
  std::string names;
  for (const char* extension : Extensions)
  {
    names += (names.empty() ? "" : ", ") + std::string(extension + 1);
  }
  const std::string looked =
    folder.empty() ? "nowhere: no --data folder is given" : "in " + folder.string();
  throw std::runtime_error("dataset \"" + name + "\": no file of that name (" + names +
    "); looked " + looked +
    (name == "mri" ? std::string("; nor is there ") + MriFile + " of the package mricron-data"
                   : "; generated: " + Joined(GeneratorNames())));
}

OpenVolume ReadVolume(const Json& dataset, const fs::path& folder)
{
  const std::string name = dataset["name"];
  if (!GeneratorOf(dataset).empty())
  {
    return Opened(Generate(dataset), name, name);
  }
  const fs::path found = FindVolumeFile(name, folder);
  const fs::path file = found.empty() ? fs::path(MriFile) : found;
  auto image = vtkSmartPointer<vtkImageData>::New();
  if (!ReadAny(file, image))
  {
    throw std::runtime_error(file.string() + ": cannot be read as " + file.extension().string());
  }
  return Opened(found.empty() ? Upright(image) : image, name, file.string());
}
}
