// Compiles an entry kernel for a set of features with the compiler of its language, which its
// extension tells: .vert, .frag, .comp GLSL; .cl OpenCL C 1.2; .cu CUDA; .cxx C++17.
#ifndef volumebench_KernelCompilers_h
#define volumebench_KernelCompilers_h

#include "Scene/Features.h"

#include <string>
#include <vector>

struct KernelVerdict
{
  bool Accepted;
  std::string Log; // GLSL: with the file numbers of #line replaced by our file names
};

/// Entry kernels below Shaders/, then the probes of the dialects beside this file.
std::vector<std::string> KernelEntries();

/// Empty when the compiler of the entry's language is there; else the sentence that says it is not.
std::string WhyNotCompiled(const std::string& entry);

/// Whether any feature is named in the text of an entry.
bool HasFeatures(const std::string& entry);

KernelVerdict CompileKernel(const std::string& entry, const volumebench::FeatureSet& features);

/// What the compiler sees of a GLSL entry: no comments, nothing that a feature leaves out. Throws
/// std::runtime_error with the compiler's log.
std::string PreprocessGlsl(const std::string& entry, const volumebench::FeatureSet& features);

#endif
