#include "CpuCalibration.h"

#include "AllCores.h"
#include "CpuFetch.h"
#include "CpuPairs.h"
#include "Repeats.h"

#include <chrono>
#include <cstring>

namespace volumebench
{
namespace
{
constexpr glm::ivec2 PictureSize{ 256, 256 };
constexpr int RowsPerTask = 4;
constexpr std::size_t CopyPiece = std::size_t(4) << 20;

template <typename Work>
double WallMs(int times, const Work& work)
{
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < times; ++i)
  {
    work();
  }
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

// `sumRow(pattern, texels, row, sums)` sums the fetches of a row of the picture.
template <typename Texel, typename SumRow>
FetchRate MeasureFetches(const CalibrationSettings& settings, FetchOrder order,
  const std::vector<Texel>& texels, int side, const SumRow& sumRow)
{
  const FetchPattern pattern = MakeFetchPattern(FetchKind::Trilinear, order, side);
  std::vector<float> sums(static_cast<std::size_t>(PictureSize.x) * PictureSize.y);
  const auto rows = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType row = begin; row < end; ++row)
    {
      sumRow(pattern, texels.data(), static_cast<int>(row), sums.data() + row * PictureSize.x);
    }
  };
  const auto picture = [&] { ForOnAllCores(0, PictureSize.y, RowsPerTask, rows); };
  const RepeatedWork work =
    MeasureRepeats(settings, [&](int times) { return WallMs(times, picture); });
  CheckSums(pattern, PictureSize, sums, 1, TexelScale<Texel>::Scale, "the processor");
  FetchRate rate;
  rate.Kind = "trilinear";
  rate.Order = FetchOrderName(order);
  rate.Entries = side;
  const auto amount =
    static_cast<double>(pattern.FetchesPerPixel() * PictureSize.x * PictureSize.y);
  rate.FetchCount = amount * work.Times;
  rate.PerSecond = RatePerSecond(work, amount);
  return rate;
}

template <typename Texel>
void MeasureFormat(const CalibrationSettings& settings, const char* format,
  const CalibrationProgress& progress, Calibration& result)
{
  const auto byGathers = [](const FetchPattern& pattern, const Texel* texels, int row, float* sums)
  { SumRow(BestCpuKernel(), pattern, texels, row, PictureSize.x, sums); };
  const auto byPairs = [](const FetchPattern& pattern, const Texel* texels, int row, float* sums)
  { SumRowByPairs(BestPairKernel(), pattern, texels, row, PictureSize.x, sums); };
  const auto keep = [&](const char* path, FetchRate rate)
  {
    rate.Path = path;
    rate.Format = format;
    result.Fetches.push_back(rate);
  };
  for (const int side : settings.Sides)
  {
    progress("cpu " + std::string(format) + " " + std::to_string(side));
    const std::vector<Texel> texels = CalibrationVolume<Texel>(side);
    for (const FetchOrder order : { FetchOrder::Axis, FetchOrder::Oblique, FetchOrder::Rays })
    {
      keep("cpu", MeasureFetches(settings, order, texels, side, byGathers));
      keep("cpu-pairs", MeasureFetches(settings, order, texels, side, byPairs));
    }
  }
}

CopyRate MeasureCopy(const CalibrationSettings& settings)
{
  const auto bytes = static_cast<std::size_t>(settings.CopyBytes);
  const std::vector<char> source(bytes, 1);
  std::vector<char> target(bytes);
  const auto pieces = [&](vtkIdType begin, vtkIdType end)
  {
    const std::size_t first = static_cast<std::size_t>(begin) * CopyPiece;
    const std::size_t last = std::min(bytes, static_cast<std::size_t>(end) * CopyPiece);
    std::memcpy(target.data() + first, source.data() + first, last - first);
  };
  const auto count = static_cast<vtkIdType>((bytes + CopyPiece - 1) / CopyPiece);
  const auto copy = [&] { ForOnAllCores(0, count, 1, pieces); };
  const RepeatedWork work =
    MeasureRepeats(settings, [&](int times) { return WallMs(times, copy); });
  if (target != source)
  {
    throw std::runtime_error("the processor's copy is not what was copied");
  }
  return { "cpu", static_cast<double>(bytes), RatePerSecond(work, static_cast<double>(bytes)) };
}
}

void CalibrateCpu(
  const CalibrationSettings& settings, const CalibrationProgress& progress, Calibration& result)
{
  result.CpuKernel = CpuKernelName(BestCpuKernel());
  result.CpuPairKernel = PairKernelName(BestPairKernel());
  MeasureFormat<std::uint16_t>(settings, "R16", progress, result);
  MeasureFormat<float>(settings, "R32F", progress, result);
  progress("cpu copy");
  result.Copies.push_back(MeasureCopy(settings));
}
}
