// Transfer functions from JSON files: opacity per unit distance and colour over scalar values.
#ifndef volumebench_TransferFunctionFile_h
#define volumebench_TransferFunctionFile_h

#include "JsonFile.h"

#include <filesystem>
#include <string>
#include <vector>

namespace volumebench
{
struct FunctionFile
{
  bool Normalized = false;                  // points are over [0, 1] and not over scalar values
  std::vector<std::vector<double>> Opacity; // x, alpha
  std::vector<std::vector<double>> Color;   // x, r, g, b
  double UnitDistance = 1.0;                // over which the opacities hold, in
  bool DistanceInEdges = false;             // edges of the box, or else voxels, of mean length

  /// Where x is in data of this range.
  double ValueAt(double x, const double range[2]) const;
};

/// NAME.json in the first folder that has it, or else the one that the program carries. Throws
/// std::runtime_error that names the file.
FunctionFile ReadFunction(
  const std::string& name, const std::vector<std::filesystem::path>& folders);
}

#endif
