#include "TechniqueSettings.h"

#include "JsonText.h"
#include "Names.h"
#include "vtkVolumeBenchMapper.h"

#include <stdexcept>

namespace volumebench
{
namespace
{
constexpr const char* ThreadsName = "slice_threads";

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

void SetValue(TechniqueSettings& settings, const SettingValue& value)
{
  if (value.Name == "work_group_shape")
  {
    settings.WorkGroupShape = value.Text;
  }
  else if (value.Name == "slice_extent")
  {
    settings.SliceExtent = SliceExtentNames().NumberOf(value.Text);
  }
  else if (value.Name == ThreadsName)
  {
    settings.SliceThreads = SliceThreadsNames().NumberOf(value.Text);
  }
  else if (value.Name == "slice_target")
  {
    settings.SliceTarget = SliceTargetNames().NumberOf(value.Text);
  }
  else if (value.Name == "slice_order")
  {
    settings.SliceOrder = SliceOrderNames().NumberOf(value.Text);
  }
  else
  {
    throw std::runtime_error("there is no technique setting '" + value.Name +
      "'; known are work_group_shape, slice_extent, slice_threads, slice_target, slice_order");
  }
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
    variant.Values.push_back(
      { Trimmed(parts[i].substr(0, equals)), Trimmed(parts[i].substr(equals + 1)) });
  }
  WithValues({}, variant.Values);
  return variant;
}

TechniqueSettings WithValues(
  const TechniqueSettings& settings, const std::vector<SettingValue>& values)
{
  TechniqueSettings changed = settings;
  for (const SettingValue& value : values)
  {
    SetValue(changed, value);
  }
  return changed;
}

std::string SettingsJson(const std::vector<SettingValue>& values)
{
  std::vector<JsonMember> members;
  for (const SettingValue& value : values)
  {
    const bool number = value.Name == ThreadsName;
    members.push_back({ value.Name, number ? value.Text : JsonString(value.Text) });
  }
  return JsonObject(members);
}

void CheckTechniqueSettings(const TechniqueSettings& settings)
{
  SliceExtentNames().NameOf(settings.SliceExtent);
  SliceThreadsNames().NameOf(settings.SliceThreads);
  SliceTargetNames().NameOf(settings.SliceTarget);
  SliceOrderNames().NameOf(settings.SliceOrder);
}

void ApplySettings(const TechniqueSettings& settings, vtkVolumeBenchMapper& mapper)
{
  mapper.SetWorkGroupShape(settings.WorkGroupShape.c_str());
  mapper.SetSliceExtent(settings.SliceExtent);
  mapper.SetSliceThreads(settings.SliceThreads);
  mapper.SetSliceTarget(settings.SliceTarget);
  mapper.SetSliceOrder(settings.SliceOrder);
}
}
