#include "Gpu/KernelPrograms.h"

#include <chrono>

namespace volumebench
{
namespace
{
GlStage StageOf(const std::string& entry)
{
  const std::string extension = entry.substr(entry.rfind('.'));
  if (extension == ".comp")
  {
    return GlStage::Compute;
  }
  return extension == ".vert" ? GlStage::Vertex : GlStage::Fragment;
}

GlStageText StageText(const char* entry, const FeatureSet& features, const std::string& defines)
{
  const GlStage stage = StageOf(entry);
  const std::string head = GlslHead(stage == GlStage::Compute, features);
  return { stage, SpecializeKernel(entry, head + defines, EmbeddedKernel) };
}
}

const GlProgram& KernelPrograms::Get(
  const std::vector<const char*>& entries, const FeatureSet& features, const std::string& defines)
{
  std::string key = features.to_string() + defines;
  for (const char* entry : entries)
  {
    key += std::string(" ") + entry;
  }
  const auto found = this->Programs.find(key);
  if (found != this->Programs.end())
  {
    return *found->second;
  }
  const auto begin = std::chrono::steady_clock::now();
  std::vector<GlStageText> stages;
  stages.reserve(entries.size());
  for (const char* entry : entries)
  {
    stages.push_back(StageText(entry, features, defines));
  }
  auto built = std::make_unique<GlProgram>();
  built->Build(stages);
  built->ConnectBlock("SceneBlock", SceneBinding);
  this->CompileMs =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return *(this->Programs[key] = std::move(built));
}

void KernelPrograms::Release()
{
  for (auto& [key, program] : this->Programs)
  {
    program->Release();
  }
  this->Forget();
}
}
