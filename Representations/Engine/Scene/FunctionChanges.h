// How much a transfer function changes over the values of a cell: means over any range of values of
// its first and second differences, in constant time.
#ifndef volumebench_FunctionChanges_h
#define volumebench_FunctionChanges_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <vector>

namespace volumebench
{
/// Of colour times extinction and extinction, as the root mean square of the four numbers of a
/// pixel, per data unit; of colour alone, as that of three.
class VOLUMEBENCHENGINE_EXPORT FunctionChanges
{
public:
  explicit FunctionChanges(const Scene& scene);

  /// What the values of a cell may be, in entries of the table; from the smaller to the larger.
  struct Range
  {
    int First;
    int Last;
  };

  Range RangeOf(float low, float high) const;

  /// Entries of the table per stored value.
  double PerValue() const { return this->EntriesPerValue; }

  /// Means over a range of what lies `entries` apart, as the table is: its difference, its second
  /// difference (over half of that on either side), the difference of the colours.
  double First(const Range& range, double entries) const;
  double Second(const Range& range, double entries) const;
  double Color(const Range& range, double entries) const;

  /// Of the squares of what First is the mean of.
  double FirstSquare(const Range& range, double entries) const;

  double MeanExtinction(const Range& range) const;
  double LeastExtinction(const Range& range) const;

private:
  // Prefix sums over the entries, one row for each power of two of entries that are compared.
  using Rows = std::vector<std::vector<double>>;

  double MeanOf(const std::vector<double>& sums, const Range& range) const;
  double MeanOf(const Rows& rows, const Range& range, double entries, double power) const;
  void AddRow(const SharedTable<glm::vec4>& table, int apart);

  double Low = 0.0; // stored value of the first entry
  double EntriesPerValue = 0.0;
  int LastEntry = 0;
  Rows FirstSums;
  Rows FirstSquareSums;
  Rows SecondSums;
  Rows ColorSums;
  std::vector<double> ExtinctionSums;
  std::vector<std::vector<float>> Least; // over runs of 1, 2, 4, ... entries
};
}

#endif
