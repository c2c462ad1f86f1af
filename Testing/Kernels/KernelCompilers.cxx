#include "KernelCompilers.h"

#include "Command.h"
#include "Gpu/KernelSpecializer.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

using namespace volumebench;

namespace
{
const std::string ShaderFolder = SOURCE_FOLDER "/Shaders";
const std::string ProbeFolder = SOURCE_FOLDER "/Testing/Kernels";
const std::string EngineFolder = SOURCE_FOLDER "/Representations/Engine";

std::string ExtensionOf(const std::string& entry)
{
  return std::filesystem::path(entry).extension();
}

// An embedded kernel, or a file of this test or of the engine.
const char* FindText(const std::string& path)
{
  static std::map<std::string, std::string> probes; // the pointers must outlive the call
  if (const char* embedded = EmbeddedKernel(path))
  {
    return embedded;
  }
  std::ifstream file(ProbeFolder + "/" + path);
  if (!file)
  {
    file.open(EngineFolder + "/" + path);
  }
  if (!file)
  {
    return nullptr;
  }
  std::string& text = probes[path];
  text.assign(std::istreambuf_iterator<char>(file), {});
  return text.c_str();
}

std::string FindFile(const std::string& entry)
{
  return (EmbeddedKernel(entry) ? ShaderFolder : ProbeFolder) + "/" + entry;
}

// The name that a text for the compiler gets, which no test that runs beside this one writes.
std::string TextFile(const std::string& entry, const FeatureSet& features)
{
  const std::filesystem::path path(entry);
  return TEXT_FOLDER "/" + path.stem().string() + "-" + features.to_string() +
    path.extension().string();
}

// Runs the compiler on a specialised text, with an option unless that is empty.
KernelVerdict RunGlslang(
  const std::string& entry, const FeatureSet& features, const std::string& option)
{
  const std::string head = GlslHead(ExtensionOf(entry) == ".comp", features);
  const KernelText text = SpecializeKernel(entry, head, FindText);
  const std::string file = TextFile(entry, features);
  std::ofstream(file) << text.Source;
  std::vector<std::string> words = { GLSLANG_COMPILER };
  if (!option.empty())
  {
    words.push_back(option);
  }
  words.push_back(file);
  const CommandResult result = RunCommand(words);
  return { result.ExitCode == 0, NameFilesInLog(result.Output, text.Files) };
}

// OpenCL C, CUDA and C++ have an #include of their own.
KernelVerdict CompileWith(
  std::vector<std::string> words, const std::string& entry, const FeatureSet& features)
{
  for (const FeatureRow& row : FeatureTable())
  {
    words.push_back(std::string("-D") + row.Define + (Has(features, row.Bit) ? "=1" : "=0"));
  }
  for (const std::string& folder : { ShaderFolder, ProbeFolder, EngineFolder })
  {
    words.insert(words.end(), { "-I", folder });
  }
  words.push_back(FindFile(entry));
  const CommandResult result = RunCommand(words);
  return { result.ExitCode == 0, result.Output };
}

std::vector<std::string> CompilerWords(const std::string& extension)
{
  if (extension == ".cl")
  {
    return { OPENCL_COMPILER, "-x", "cl", "-cl-std=CL1.2", "-cl-single-precision-constant",
      "-Xclang", "-finclude-default-header", "--target=spir64", "-emit-llvm", "-Wall", "-Wextra",
      "-Wno-unused-parameter", "-Werror", "-c", "-o", "/dev/null" };
  }
  if (extension == ".cu")
  {
    return { CUDA_COMPILER, "-std=c++17", "-arch=sm_90", "-allow-unsupported-compiler", "-Werror",
      "all-warnings", "-ptx", "-o", "/dev/null" };
  }
  if (extension == ".cxx")
  {
    return { CPP_COMPILER, "-std=c++17", "-Wall", "-Wextra", "-Wno-unused-parameter", "-Wundef",
      "-Werror", "-idirafter", GLM_FOLDER, "-fsyntax-only" };
  }
  throw std::invalid_argument("no compiler is known for " + extension);
}
}

std::vector<std::string> KernelEntries()
{
  std::vector<std::string> entries;
  for (const std::string& path : EmbeddedKernelPaths())
  {
    const bool needsBuffers = path == "RayCastLanes.cl"; // which ProbeLanes.cl and its like give it
    if (ExtensionOf(path) != ".h" && !needsBuffers)
    {
      entries.push_back(path);
    }
  }
  entries.insert(entries.end(),
    { "ProbeBuffers.cl", "ProbeNearest.cl", "ProbeLanes.cl", "ProbeEightLanes.cl", "ProbeFloat.cxx",
      "ProbeDouble.cxx" });
  return entries;
}

std::string WhyNotCompiled(const std::string& entry)
{
  const bool missing = ExtensionOf(entry) == ".cu" && std::string(CUDA_COMPILER).empty();
  return missing ? "not run: no nvcc" : "";
}

bool HasFeatures(const std::string& entry)
{
  return SpecializeKernel(entry, "", FindText).Source.find("WITH_") != std::string::npos;
}

KernelVerdict CompileKernel(const std::string& entry, const FeatureSet& features)
{
  const std::string extension = ExtensionOf(entry);
  const bool glsl = extension == ".vert" || extension == ".frag" || extension == ".comp";
  return glsl ? RunGlslang(entry, features, {})
              : CompileWith(CompilerWords(extension), entry, features);
}

std::string PreprocessGlsl(const std::string& entry, const FeatureSet& features)
{
  const KernelVerdict verdict = RunGlslang(entry, features, "-E");
  if (!verdict.Accepted)
  {
    throw std::runtime_error(verdict.Log);
  }
  return verdict.Log;
}
