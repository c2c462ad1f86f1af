#include "OpenClFetch.h"

#include "Gpu/KernelSpecializer.h"
#include "OpenCl/OpenClScene.h"
#include "Scene/KernelScene.h"
#include "Stopwatch.h"

#include <type_traits>

namespace volumebench
{
namespace
{
constexpr std::size_t GroupSide = 8; // work items
constexpr int LaneColumns = 4;       // of the tile of a work item

cl_float4 FourOf(const glm::dvec3& v)
{
  const glm::vec3 single(v);
  return { { single.x, single.y, single.z, 0.0F } };
}
}

OpenClFetch::OpenClFetch(OpenClSession& session, OpenClLookUp lookUp)
  : Session(session)
  , LookUp(lookUp)
{
}

void OpenClFetch::Compile(bool small)
{
  const int lanes = this->LookUp == OpenClLookUp::Lanes ? this->Session.GetDevice().Lanes() : 1;
  const std::string head = FeatureDefines({}) + "#define WITH_BUFFERS " +
    (this->LookUp == OpenClLookUp::Images ? "0" : "1") + "\n#define WITH_UNSIGNED16 " +
    (small ? "1" : "0") + "\n#define WITH_NEAREST 0\n#define LANES " + std::to_string(lanes) +
    "\n#define LANE_COLUMNS " + std::to_string(LaneColumns) + "\n";
  const KernelText text =
    SpecializeKernel("Calibration/FetchRate.cl", head, EmbeddedKernel, LineStyle::Names);
  this->Kernel = this->Session.KernelOf(text, "sumFetches");
}

template <typename Texel>
void OpenClFetch::SendVolume(int entries, const std::vector<Texel>& texels)
{
  constexpr bool small = std::is_same_v<Texel, std::uint16_t>;
  this->Compile(small);
  SceneBlock numbers = {};
  numbers.textureSize = glm::vec4(glm::vec3(static_cast<float>(entries)), 0.0F);
  this->Numbers.ResizeBuffer(this->Session, sizeof(numbers), CL_MEM_READ_ONLY);
  this->Numbers.Write(&numbers, sizeof(numbers));
  if (this->LookUp == OpenClLookUp::Images)
  {
    const cl_image_format format = { CL_R,
      static_cast<cl_channel_type>(small ? CL_UNORM_INT16 : CL_FLOAT) };
    this->Volume.CreateImage(this->Session, format, glm::ivec3(entries));
    this->Volume.WriteImage(texels.data(), 0, entries);
    this->Table.CreateImage(this->Session, { CL_RGBA, CL_FLOAT }, { 1, 1, 0 });
    return;
  }
  // No point of a pattern is on the last texel of an axis, so that nothing further is read.
  const std::size_t bytes = sizeof(Texel) * texels.size();
  this->Volume.ResizeBuffer(this->Session, bytes, CL_MEM_READ_ONLY);
  this->Volume.Write(texels.data(), bytes);
  this->Table.ResizeBuffer(this->Session, sizeof(cl_float4), CL_MEM_READ_ONLY);
}

template void OpenClFetch::SendVolume(int, const std::vector<std::uint16_t>&);
template void OpenClFetch::SendVolume(int, const std::vector<float>&);

void OpenClFetch::Prepare(const FetchPattern& pattern, int side)
{
  this->Side = side;
  this->Sums.ResizeBuffer(
    this->Session, sizeof(float) * static_cast<std::size_t>(side) * side, CL_MEM_WRITE_ONLY);
  KernelArguments arguments(this->Kernel);
  arguments.Add(this->Numbers);
  arguments.Add(this->Volume);
  arguments.Add(this->Table);
  if (this->LookUp != OpenClLookUp::Images)
  {
    arguments.Add(cl_int(1)); // entries of the table
  }
  arguments.Add(cl_int4{ { pattern.Side, pattern.Length, pattern.Passes, 0 } });
  for (const glm::dvec3& v : { pattern.Origin, pattern.PassShift, pattern.Direction,
         pattern.DirectionX, pattern.DirectionY })
  {
    arguments.Add(FourOf(v));
  }
  arguments.Add(this->Sums);
}

double OpenClFetch::TimeMs(int times)
{
  const OpenClApi& cl = OpenCl();
  const OpenClDevice& device = this->Session.GetDevice();
  const bool inLanes = this->LookUp == OpenClLookUp::Lanes;
  const std::size_t group[2] = { GroupSide, GroupSide };
  const std::size_t items[2] = { static_cast<std::size_t>(
                                   inLanes ? this->Side / LaneColumns : this->Side),
    static_cast<std::size_t>(inLanes ? this->Side * LaneColumns / device.Lanes() : this->Side) };
  const Stopwatch watch;
  for (int i = 0; i < times; ++i)
  {
    CheckOpenCl(cl.EnqueueNDRangeKernel(this->Session.GetQueue(), this->Kernel, 2, nullptr, items,
                  group, 0, nullptr, nullptr),
      "clEnqueueNDRangeKernel");
  }
  CheckOpenCl(cl.Finish(this->Session.GetQueue()), "clFinish");
  return watch.ElapsedMs();
}

std::vector<float> OpenClFetch::ReadSums()
{
  std::vector<float> sums(static_cast<std::size_t>(this->Side) * this->Side);
  this->Sums.Read(sums.size() * sizeof(float),
    [&sums](const void* data)
    { std::copy_n(static_cast<const float*>(data), sums.size(), sums.data()); });
  return sums;
}
}
