#include "Scene/ScalarStatistics.h"

#include "AllCores.h"
#include "Scene/FromVtk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace volumebench
{
namespace
{
void Merge(ScalarStatistics& into, const ScalarStatistics& other)
{
  if (other.AnyFinite)
  {
    into.Low = into.AnyFinite ? std::min(into.Low, other.Low) : other.Low;
    into.High = into.AnyFinite ? std::max(into.High, other.High) : other.High;
    into.AnyFinite = true;
  }
  into.AllFinite = into.AllFinite && other.AllFinite;
}

void Include(ScalarStatistics& statistics, double value)
{
  if (!std::isfinite(value))
  {
    statistics.AllFinite = false;
    return;
  }
  Merge(statistics, { value, value, true, true });
}

// Values side by side, so that a compiler can compare many at once.
constexpr int Lanes = 64;

template <typename T>
struct LaneRanges
{
  T Low[Lanes];
  T High[Lanes];

  explicit LaneRanges(const T* values)
  {
    std::copy_n(values, Lanes, this->Low);
    std::copy_n(values, Lanes, this->High);
  }

  // Whether all are finite; the ranges mean nothing once they were not.
  bool Include(const T* values)
  {
    int notFinite = 0;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const T value = values[lane];
      this->Low[lane] = value < this->Low[lane] ? value : this->Low[lane];
      this->High[lane] = value > this->High[lane] ? value : this->High[lane];
      notFinite |= value - value == T(0) ? 0 : 1;
    }
    return notFinite == 0;
  }

  ScalarStatistics Merged() const
  {
    return { static_cast<double>(*std::min_element(this->Low, this->Low + Lanes)),
      static_cast<double>(*std::max_element(this->High, this->High + Lanes)), true, true };
  }
};

// Values that are not finite make no more than a block be looked at one by one.
constexpr vtkIdType BlockValues = 64 * Lanes;

template <typename T>
ScalarStatistics OfBlock(const T* values)
{
  LaneRanges<T> ranges(values);
  bool allFinite = true;
  for (vtkIdType i = 0; i < BlockValues && allFinite; i += Lanes)
  {
    allFinite = ranges.Include(values + i);
  }
  if (allFinite)
  {
    return ranges.Merged();
  }
  ScalarStatistics result;
  for (vtkIdType i = 0; i < BlockValues; ++i)
  {
    Include(result, static_cast<double>(values[i]));
  }
  return result;
}

struct StatisticsWorker
{
  template <typename Array>
  static ScalarStatistics OfPart(Array* array, int component, vtkIdType begin, vtkIdType end)
  {
    ScalarStatistics result;
    if constexpr (IsPlain<Array>)
    {
      if (array->GetNumberOfComponents() == 1 && component == 0)
      {
        const vtkIdType last = begin + (end - begin) / BlockValues * BlockValues;
        for (; begin < last; begin += BlockValues)
        {
          Merge(result, OfBlock(array->GetPointer(begin)));
        }
      }
    }
    for (const auto tuple : vtk::DataArrayTupleRange(array, begin, end))
    {
      Include(result, ValueOf(tuple, component));
    }
    return result;
  }

  template <typename Array>
  void operator()(Array* array, int component, ScalarStatistics& result) const
  {
    std::mutex merging;
    ForOnAllCores(0, array->GetNumberOfTuples(), 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        const ScalarStatistics part = OfPart(array, component, begin, end);
        const std::lock_guard<std::mutex> lock(merging);
        Merge(result, part);
      });
  }
};
}

ScalarStatistics ComputeStatistics(vtkDataArray* scalars, int component)
{
  ScalarStatistics result;
  const StatisticsWorker worker;
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, worker, component, result))
  {
    worker(scalars, component, result);
  }
  return result;
}
}
