#include "CpuCalibration.h"

#include "AllCores.h"
#include "CpuFetch.h"
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

template <typename Texel>
FetchRate MeasureFetches(const CalibrationSettings& settings, CpuKernel kernel, FetchOrder order,
  const std::vector<Texel>& texels, int side)
{
  const FetchPattern pattern = MakeFetchPattern(FetchKind::Trilinear, order, side);
  std::vector<float> sums(static_cast<std::size_t>(PictureSize.x) * PictureSize.y);
  const auto rows = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType row = begin; row < end; ++row)
    {
      SumRow(kernel, pattern, texels.data(), static_cast<int>(row), PictureSize.x,
        sums.data() + row * PictureSize.x);
    }
  };
  const auto picture = [&] { ForOnAllCores(0, PictureSize.y, RowsPerTask, rows); };
  const RepeatedWork work =
    MeasureRepeats(settings, [&](int times) { return WallMs(times, picture); });
  CheckSums(pattern, PictureSize, sums, 1, TexelScale<Texel>::Scale, "the processor");
  FetchRate rate;
  rate.Path = "cpu";
  rate.Kind = "trilinear";
  rate.Order = order == FetchOrder::Axis ? "axis" : "oblique";
  rate.Entries = side;
  const auto amount =
    static_cast<double>(pattern.FetchesPerPixel() * PictureSize.x * PictureSize.y);
  rate.FetchCount = amount * work.Times;
  rate.PerSecond = RatePerSecond(work, amount);
  return rate;
}

template <typename Texel>
void MeasureFormat(const CalibrationSettings& settings, CpuKernel kernel, const char* format,
  const CalibrationProgress& progress, Calibration& result)
{
  for (const int side : settings.Sides)
  {
    progress("cpu " + std::string(format) + " " + std::to_string(side));
    const std::vector<Texel> texels = CalibrationVolume<Texel>(side);
    for (const FetchOrder order : { FetchOrder::Axis, FetchOrder::Oblique })
    {
      result.Fetches.push_back(MeasureFetches(settings, kernel, order, texels, side));
      result.Fetches.back().Format = format;
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
  const CpuKernel kernel = BestCpuKernel();
  result.CpuKernel = kernel == CpuKernel::Avx2 ? "AVX2" : "scalar";
  MeasureFormat<std::uint16_t>(settings, kernel, "R16", progress, result);
  MeasureFormat<float>(settings, kernel, "R32F", progress, result);
  progress("cpu copy");
  result.Copies.push_back(MeasureCopy(settings));
}
}
