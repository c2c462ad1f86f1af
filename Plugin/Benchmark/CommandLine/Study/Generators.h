// The volumes that studies can generate, as Python/volumebench/generators.py writes them.
#ifndef volumebench_Generators_h
#define volumebench_Generators_h

#include "JsonFile.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;

namespace volumebench
{
/// "lemniscate", "ball", ...
const std::vector<std::string>& GeneratorNames();

/// The keys of a dataset that a generator heeds, such as dims.
std::vector<std::string> GeneratorKeys(const std::string& generator);

/// The generator of a dataset, or nothing: that which it names, or the one of its own name.
std::string GeneratorOf(const Json& dataset);

/// `dataset` is that of a study and has a generator; what it leaves out is the generator's own.
vtkSmartPointer<vtkImageData> Generate(const Json& dataset);
}

#endif
