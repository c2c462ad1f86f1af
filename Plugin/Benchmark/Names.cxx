#include "Names.h"

#include "Orbit.h"
#include "vtkVolumeBenchMapper.h"

#include <stdexcept>

namespace volumebench
{
int NameTable::NumberOf(const std::string& name) const
{
  std::string known;
  for (const Row& row : this->Rows)
  {
    if (row.Name == name)
    {
      return row.Number;
    }
    known += (known.empty() ? "" : ", ") + row.Name;
  }
  throw std::runtime_error("there is no " + this->What + " '" + name + "'; known are " + known);
}

const std::string& NameTable::NameOf(int number) const
{
  std::string known;
  for (const Row& row : this->Rows)
  {
    if (row.Number == number)
    {
      return row.Name;
    }
    const std::string text = std::to_string(row.Number);
    known += (known.empty() ? "" : ", ") + text + (row.Name == text ? "" : " (" + row.Name + ")");
  }
  throw std::runtime_error(
    "there is no " + this->What + " " + std::to_string(number) + "; known are " + known);
}

std::vector<int> NameTable::Numbers() const
{
  std::vector<int> numbers;
  for (const Row& row : this->Rows)
  {
    numbers.push_back(row.Number);
  }
  return numbers;
}

const NameTable& IntegratorNames()
{
  static const NameTable names("integrator",
    { { "Left", 0 }, { "Midpoint", 1 }, { "Segment", 2 }, { "PreIntegrated", 3 },
      { "Automatic", 4 } });
  return names;
}

const NameTable& BlendModeNames()
{
  static const NameTable names("blend mode",
    { { "Composite", vtkVolumeMapper::COMPOSITE_BLEND },
      { "Maximum", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND },
      { "Minimum", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND },
      { "Average", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND },
      { "Gradient", vtkVolumeBenchMapper::GRADIENT_BLEND } });
  return names;
}

const NameTable& ReferenceNames()
{
  static const NameTable names("reference", { { "Cell Exact", 0 }, { "Fine Steps", 1 } });
  return names;
}

const NameTable& CameraPathNames()
{
  static const NameTable names("camera path",
    { { "orbit-y", static_cast<int>(CameraPath::OrbitY) },
      { "three-views", static_cast<int>(CameraPath::ThreeViews) },
      { "orbit-x", static_cast<int>(CameraPath::OrbitX) },
      { "orbit-diagonal", static_cast<int>(CameraPath::OrbitDiagonal) },
      { "in-and-out", static_cast<int>(CameraPath::InAndOut) },
      { "random", static_cast<int>(CameraPath::Random) } });
  return names;
}

const NameTable& OpenClStorageNames()
{
  static const NameTable names(
    "OpenCL storage", { { "Auto", 0 }, { "Images", 1 }, { "Buffers", 2 } });
  return names;
}

const NameTable& RaySetUpNames()
{
  static const NameTable names("ray set-up", { { "Box", 0 }, { "Rasterised", 1 } });
  return names;
}

const NameTable& VoxelOrderNames()
{
  static const NameTable names(
    "voxel order", { { "Naive", 0 }, { "Block Shape", 1 }, { "In-Place Rotation", 2 } });
  return names;
}

const NameTable& PictureTransferNames()
{
  static const NameTable names("picture transfer",
    { { "Register Once", 0 }, { "Register Each Frame", 1 }, { "Through Host", 2 } });
  return names;
}

const NameTable& SliceExtentNames()
{
  static const NameTable names(
    "slice extent", { { "Vertex Depth", 0 }, { "Vertex Distance", 1 }, { "Central Ray", 2 } });
  return names;
}

const NameTable& SliceTargetNames()
{
  static const NameTable names(
    "slice target", { { "RGBA32F", 0 }, { "RGBA16F", 1 }, { "RGBA8", 2 } });
  return names;
}

const NameTable& SliceOrderNames()
{
  static const NameTable names("slice order", { { "Front to Back", 0 }, { "Back to Front", 1 } });
  return names;
}

const NameTable& SliceThreadsNames()
{
  static const NameTable names("number of slice threads",
    { { "0", 0 }, { "1", 1 }, { "2", 2 }, { "4", 4 }, { "8", 8 }, { "16", 16 } });
  return names;
}
}
