// The names that studies, tables and results use for the mapper's numbers.
#ifndef volumebench_Names_h
#define volumebench_Names_h

#include "VolumeBenchBenchmarkModule.h"

#include <string>
#include <vector>

namespace volumebench
{
/// Names with their numbers, in the order in which they are offered.
class VOLUMEBENCHBENCHMARK_EXPORT NameTable
{
public:
  struct Row
  {
    std::string Name;
    int Number;
  };

  /// `what` names the kind in errors, such as "integrator".
  NameTable(std::string what, std::vector<Row> rows)
    : What(std::move(what))
    , Rows(std::move(rows))
  {
  }

  /// Throws std::runtime_error with the known names.
  int NumberOf(const std::string& name) const;
  /// Throws std::runtime_error with the known numbers.
  const std::string& NameOf(int number) const;
  std::vector<int> Numbers() const;

private:
  std::string What;
  std::vector<Row> Rows;
};

VOLUMEBENCHBENCHMARK_EXPORT const NameTable& IntegratorNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& BlendModeNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& CameraPathNames(); // numbers of CameraPath
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& ReferenceNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& OpenClStorageNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& RaySetUpNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& VoxelOrderNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& PictureTransferNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& SliceExtentNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& SliceTargetNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& SliceOrderNames();
VOLUMEBENCHBENCHMARK_EXPORT const NameTable& SliceThreadsNames();
}

#endif
