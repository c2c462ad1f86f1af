#include "Techniques/WorkGroupChoice.h"

#include "Gpu/VolumeUpload.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace volumebench
{
namespace
{
constexpr double Megabyte = 1048576.0;
constexpr double ObliqueCosine = 0.92; // a view further than some 23 degrees from each axis

std::size_t BytesOf(const Volume& volume)
{
  return TexelBytes(volume) * volume.Texels.x * volume.Texels.y * volume.Texels.z;
}

int PowerOfTwo(double value)
{
  return static_cast<int>(std::lround(std::log2(std::max(value, 1.0e-6))));
}

// 'x', 'y' or 'z', or '/' for a view between them.
char ViewAxis(const Scene& scene)
{
  const glm::dmat3 worldToVoxel = glm::inverse(glm::dmat3(scene.Volume.VoxelToWorld));
  const glm::dmat3 viewToWorld = glm::inverse(glm::dmat3(scene.Camera.WorldToView));
  const glm::dvec3 forward =
    glm::normalize(worldToVoxel * (viewToWorld * glm::dvec3(0.0, 0.0, -1.0)));
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(forward[axis]) > ObliqueCosine)
    {
      return "xyz"[axis];
    }
  }
  return '/';
}
}

void RefuseTurns(const Scene& scene, const char* technique)
{
  if (scene.Sampling.Order == VoxelOrder::InPlaceRotation)
  {
    throw SceneError(std::string("technique '") + technique +
      "' does not turn voxels: it has the voxel orders Naive and Block Shape");
  }
}

glm::ivec2 SuggestedWorkGroup(std::size_t volumeBytes)
{
  const double megabytes = static_cast<double>(volumeBytes) / Megabyte;
  if (megabytes <= 16.0)
  {
    return { 16, 8 };
  }
  return megabytes <= 128.0 ? glm::ivec2(8, 4) : glm::ivec2(4, 4);
}

std::vector<glm::ivec2> WorkGroupCandidates(const Scene& scene)
{
  std::vector<glm::ivec2> candidates = { SuggestedWorkGroup(BytesOf(scene.Volume)) };
  for (const glm::ivec2 shape :
    { glm::ivec2(4, 4), glm::ivec2(8, 8), glm::ivec2(16, 8), glm::ivec2(16, 16) })
  {
    if (shape != candidates.front())
    {
      candidates.push_back(shape);
    }
  }
  return candidates;
}

glm::ivec2 FastestWorkGroup(const std::vector<TimedWorkGroup>& measured)
{
  constexpr double Noise = 0.05;
  TimedWorkGroup best = measured.front();
  for (const TimedWorkGroup& one : measured)
  {
    const double share = best.Shape == measured.front().Shape ? 1.0 - Noise : 1.0;
    if (one.Ms < share * best.Ms)
    {
      best = one;
    }
  }
  return best.Shape;
}

std::string SceneClass(const Scene& scene, const glm::ivec4& rectangle)
{
  const double pixels = static_cast<double>(rectangle.z) * rectangle.w;
  return std::to_string(PowerOfTwo(static_cast<double>(BytesOf(scene.Volume)))) + " " +
    std::to_string(PowerOfTwo(pixels)) + " " +
    std::to_string(PowerOfTwo(scene.Sampling.StepVoxels)) + " " + ViewAxis(scene);
}

glm::ivec2& MeasuredWorkGroup(const std::string& sceneClass)
{
  static std::map<std::string, glm::ivec2> shapes; // for the life of the process
  return shapes.try_emplace(sceneClass, 0, 0).first->second;
}

glm::ivec2 FindWorkGroup(const Scene& scene, const PicturePart& part, const std::string& device,
  const std::function<double(glm::ivec2, const PicturePart&)>& measureMs)
{
  constexpr int SmallestSide = 64;
  const glm::ivec2 size = part.End - part.First;
  glm::ivec2& known = MeasuredWorkGroup(device + " " + SceneClass(scene, { part.First, size }));
  if (known.x == 0)
  {
    const glm::ivec2 sides = glm::min(size, glm::max(size / 3, glm::ivec2(SmallestSide)));
    const glm::ivec2 first = part.First + (size - sides) / 2;
    std::vector<TimedWorkGroup> measured;
    for (const glm::ivec2 shape : WorkGroupCandidates(scene))
    {
      measured.push_back({ shape, measureMs(shape, { first, first + sides }) });
    }
    known = FastestWorkGroup(measured);
  }
  return known;
}
}
