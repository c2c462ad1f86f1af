// The largest extinction that a kernel can make of any value in a range.
#ifndef volumebench_Majorant_h
#define volumebench_Majorant_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <vector>

namespace volumebench
{
/// Answers for any range of stored values in constant time, from a table of maxima over runs of
/// 1, 2, 4, ... of the transfer function's intervals.
class VOLUMEBENCHENGINE_EXPORT Majorant
{
public:
  explicit Majorant(const Scene& scene);

  /// Per data unit, over the stored values from low to high, low <= high: at least what look-ups of
  /// the table and its integrals give.
  float Of(float low, float high) const;

  /// Equal for functions that have equal majorants.
  static ChangeStamp StampOf(const TransferFunction& function);

private:
  float MaximumOf(int first, int last) const;

  double Low; // stored value of the first entry
  double Span;
  double Steps;        // between the first and the last entry
  double SegmentSteps; // the same of the table of pre-integrated segments; 0: there is none
  std::vector<float> Entries;
  std::vector<std::vector<float>> Levels;
};
}

#endif
