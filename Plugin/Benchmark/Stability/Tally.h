// What the measurements of one stability case add up to: the one that comes closest to its limit,
// or goes furthest beyond it, and sentences about it.
#ifndef volumebench_Tally_h
#define volumebench_Tally_h

#include "VolumeBenchBenchmarkModule.h"

#include <string>
#include <vector>

namespace volumebench
{
class VOLUMEBENCHBENCHMARK_EXPORT Tally
{
public:
  Tally();

  /// One measurement: an error >= 0 in the unit of its limit, and what it is of, such as "alpha at
  /// step 2.7". An error that is not a number is worse than any other.
  void Note(double error, double limit, const std::string& what);

  /// A further sentence.
  void Remark(const std::string& sentence);

  bool IsEmpty() const { return this->Count == 0; }
  /// Whether there was a measurement and none went beyond its limit.
  bool IsPassed() const;

  /// Error and limit of the worst measurement; NaN when there was none.
  double GetError() const { return this->Error; }
  double GetLimit() const { return this->Limit; }

  std::string Text() const;

private:
  int Count = 0;
  double Error;
  double Limit;
  double Ratio = -1.0;
  std::string What;
  std::string Remarks;
};

/// Observed order of convergence from errors at steps that halve from one to the next: the mean
/// slope in log2. NaN unless there are at least two errors and all are positive.
VOLUMEBENCHBENCHMARK_EXPORT double ObservedOrder(const std::vector<double>& errors);

/// "3.2e-05", the way all sentences and pages show an error.
VOLUMEBENCHBENCHMARK_EXPORT std::string ErrorText(double error);

/// A number as one would write it: "0.37", "4096", "1e+06".
VOLUMEBENCHBENCHMARK_EXPORT std::string PlainText(double number);
}

#endif
