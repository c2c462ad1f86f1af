#include "TechniqueSettings.h"

#include "JsonText.h"
#include "Names.h"
#include "Scene/Scene.h"
#include "vtkVolumeBenchMapper.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace volumebench
{
namespace
{
std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::vector<std::string> Parts(const std::string& text)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(';', begin);
    parts.push_back(Trimmed(text.substr(begin, end - begin)));
  }
  return parts;
}

using Setter = void (*)(TechniqueSettings&, const std::string&);

double NumberOf(const std::string& name, const std::string& text)
{
  std::size_t used = 0;
  double number = 0.0;
  try
  {
    number = std::stod(text, &used);
  }
  catch (const std::logic_error&)
  {
    used = 0;
  }
  if (used == 0 || used != text.size() || !std::isfinite(number))
  {
    throw std::runtime_error("the setting " + name + " is '" + text + "', which is no number");
  }
  return number;
}

int CountOf(const std::string& name, const std::string& text)
{
  const double number = NumberOf(name, text);
  if (number != std::floor(number) || std::abs(number) > 1e9)
  {
    throw std::runtime_error("the setting " + name + " is '" + text + "', which is no count");
  }
  return static_cast<int>(number);
}

bool SwitchOf(const std::string& name, const std::string& text)
{
  const bool on = text == "true" || text == "1";
  if (!on && text != "false" && text != "0")
  {
    throw std::runtime_error(
      "the setting " + name + " is '" + text + "'; it must be true or false");
  }
  return on;
}

// Numbers with spaces between; "nan" is one that is not known.
std::vector<double> NumbersOf(const std::string& name, const std::string& text)
{
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string word; stream >> word;)
  {
    numbers.push_back(
      word == "nan" ? std::numeric_limits<double>::quiet_NaN() : NumberOf(name, word));
  }
  return numbers;
}

// Tells whether the value belongs to an earlier measurement, which it then is part of.
bool TakeEarlier(const SettingValue& value, EarlierMeasurement& earlier)
{
  if (value.Name == "frames_ms")
  {
    earlier.FramesMs = NumbersOf(value.Name, value.Text);
  }
  else if (value.Name == "frames_gpu_ms")
  {
    earlier.GpuMs = NumbersOf(value.Name, value.Text);
  }
  else if (value.Name == "error_known")
  {
    earlier.HasError = SwitchOf(value.Name, value.Text);
  }
  else
  {
    return false;
  }
  return true;
}

struct SettingRow
{
  const char* Name;
  bool IsNumber; // or true or false, in JSON
  Setter Set;
};

const SettingRow Rows[] = {
  { "termination_threshold", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.TerminationThreshold = NumberOf("termination_threshold", text); } },
  { "error_target", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.ErrorTarget = NumberOf("error_target", text); } },
  { "interactive_frame_ms", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.InteractiveFrameMs = NumberOf("interactive_frame_ms", text); } },
  { "memory_budget_mib", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.MemoryBudgetMiB = NumberOf("memory_budget_mib", text); } },
  { "jitter", true,
    [](TechniqueSettings& s, const std::string& text) { s.Jitter = SwitchOf("jitter", text); } },
  { "jitter_seed", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.JitterSeed = CountOf("jitter_seed", text); } },
  { "table_size", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.TableSize = CountOf("table_size", text); } },
  { "skipping", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.Skipping = SwitchOf("skipping", text); } },
  { "macrocell_voxels", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.MacrocellVoxels = CountOf("macrocell_voxels", text); } },
  { "ray_set_up", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.RaySetUp = RaySetUpNames().NumberOf(text); } },
  { "work_group_shape", false,
    [](TechniqueSettings& s, const std::string& text) { s.WorkGroupShape = text; } },
  { "opencl_device", false,
    [](TechniqueSettings& s, const std::string& text) { s.OpenClDevice = text; } },
  { "opencl_storage", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.OpenClStorage = OpenClStorageNames().NumberOf(text); } },
  { "voxel_order", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.VoxelOrder = VoxelOrderNames().NumberOf(text); } },
  { "picture_transfer", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.PictureTransfer = PictureTransferNames().NumberOf(text); } },
  { "slice_extent", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.SliceExtent = SliceExtentNames().NumberOf(text); } },
  { "slice_threads", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.SliceThreads = SliceThreadsNames().NumberOf(text); } },
  { "slice_target", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.SliceTarget = SliceTargetNames().NumberOf(text); } },
  { "slice_order", false,
    [](TechniqueSettings& s, const std::string& text)
    { s.SliceOrder = SliceOrderNames().NumberOf(text); } },
  { "sample_distance_voxels", true,
    [](TechniqueSettings& s, const std::string& text)
    { s.SampleDistanceVoxels = NumberOf("sample_distance_voxels", text); } },
};

const SettingRow& RowOf(const std::string& name)
{
  std::string known;
  for (const SettingRow& row : Rows)
  {
    if (name == row.Name)
    {
      return row;
    }
    known += (known.empty() ? "" : ", ") + std::string(row.Name);
  }
  throw std::runtime_error("there is no technique setting '" + name + "'; known are " + known);
}
}

Variant ParseVariant(const std::string& text)
{
  const std::vector<std::string> parts = Parts(text);
  Variant variant;
  variant.Technique = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const std::size_t equals = parts[i].find('=');
    if (equals == std::string::npos)
    {
      throw std::runtime_error("the variant '" + text + "' holds '" + parts[i] +
        "'; each part after the technique must be NAME=VALUE");
    }
    const SettingValue value = { Trimmed(parts[i].substr(0, equals)),
      Trimmed(parts[i].substr(equals + 1)) };
    if (value.Name == "integrator")
    {
      variant.Integrator = IntegratorNames().NumberOf(value.Text);
    }
    else if (value.Name == "step_voxels")
    {
      variant.StepVoxels = NumberOf(value.Name, value.Text);
    }
    else if (!TakeEarlier(value, variant.Earlier))
    {
      variant.Values.push_back(value);
    }
  }
  if (variant.Earlier.FramesMs.size() != variant.Earlier.GpuMs.size())
  {
    throw std::runtime_error(
      "the variant '" + variant.Technique + "' has not as many frames_gpu_ms as frames_ms");
  }
  CheckTechniqueSettings(WithValues({}, variant.Values));
  return variant;
}

TechniqueSettings WithValues(
  const TechniqueSettings& settings, const std::vector<SettingValue>& values)
{
  TechniqueSettings changed = settings;
  for (const SettingValue& value : values)
  {
    RowOf(value.Name).Set(changed, value.Text);
  }
  return changed;
}

std::string SettingsJson(const std::vector<SettingValue>& values)
{
  std::vector<JsonMember> members;
  for (const SettingValue& value : values)
  {
    const bool number = RowOf(value.Name).IsNumber;
    members.push_back({ value.Name, number ? value.Text : JsonString(value.Text) });
  }
  return JsonObject(members);
}

void CheckTechniqueSettings(const TechniqueSettings& settings)
{
  // What our mapper can tell by itself, it does; VTK's mappers would draw nothing or never end.
  if (!(settings.SampleDistanceVoxels >= SmallestStepVoxels))
  {
    throw std::runtime_error("the sample distance is " + JsonNumber(settings.SampleDistanceVoxels) +
      " voxels; it must be at least " + JsonNumber(SmallestStepVoxels));
  }
  OpenClStorageNames().NameOf(settings.OpenClStorage);
  VoxelOrderNames().NameOf(settings.VoxelOrder);
  PictureTransferNames().NameOf(settings.PictureTransfer);
  SliceExtentNames().NameOf(settings.SliceExtent);
  SliceThreadsNames().NameOf(settings.SliceThreads);
  SliceTargetNames().NameOf(settings.SliceTarget);
  SliceOrderNames().NameOf(settings.SliceOrder);
}

void ApplySettings(const TechniqueSettings& settings, vtkVolumeBenchMapper& mapper)
{
  mapper.SetTerminationThreshold(settings.TerminationThreshold);
  mapper.SetErrorTarget(settings.ErrorTarget);
  mapper.SetMemoryBudgetMiB(settings.MemoryBudgetMiB);
  mapper.SetInteractiveFrameMs(settings.InteractiveFrameMs);
  mapper.SetJitter(settings.Jitter);
  mapper.SetJitterSeed(settings.JitterSeed);
  mapper.SetTableSize(settings.TableSize);
  mapper.SetSkipping(settings.Skipping);
  mapper.SetMacrocellVoxels(settings.MacrocellVoxels);
  if (settings.RaySetUp >= 0)
  {
    mapper.SetRaySetUp(settings.RaySetUp);
  }
  mapper.SetWorkGroupShape(settings.WorkGroupShape.c_str());
  mapper.SetOpenClDevice(settings.OpenClDevice.c_str());
  mapper.SetOpenClStorage(settings.OpenClStorage);
  mapper.SetVoxelOrder(settings.VoxelOrder);
  mapper.SetPictureTransfer(settings.PictureTransfer);
  mapper.SetSliceExtent(settings.SliceExtent);
  mapper.SetSliceThreads(settings.SliceThreads);
  mapper.SetSliceTarget(settings.SliceTarget);
  mapper.SetSliceOrder(settings.SliceOrder);
}
}
