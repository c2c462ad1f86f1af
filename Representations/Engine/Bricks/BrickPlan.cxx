#include "Bricks/BrickPlan.h"

#include "Gpu/VolumeUpload.h"
#include "Scene/CellMap.h"
#include "Scene/Features.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Endless = 1.0e9;   // voxels
constexpr int SmallestEdge = 4;     // voxels of a brick, without those of its neighbours
constexpr double MostBricks = 4096; // each is a pass over the picture
constexpr double BricksAtOnce = 4;  // that a budget has room for, so that most may stay

// By how much samples lie outside the brick whose steps they belong to: a step is drawn with the
// brick that its middle lies in.
double OverhangOf(const Scene& scene)
{
  return 0.5 * KernelStepVoxels(scene);
}

// Texels of the neighbours that samples of a brick read: interpolation and gradients reach two
// further. In powers of two, so that another step seldom means another brick. Steps may be longer
// than the volume.
int MarginOf(const Scene& scene)
{
  const glm::ivec3& texels = scene.Volume.Texels;
  const int longest = std::max({ texels.x, texels.y, texels.z });
  int margin = 4;
  while (margin < longest && margin < std::ceil(OverhangOf(scene)) + 2.0)
  {
    margin *= 2;
  }
  return margin;
}

struct Division
{
  glm::ivec3 Texels{ 0 };
  glm::ivec3 Counts{ 1 };
  int Margin = 0;

  int Border(int axis, int index) const
  {
    return static_cast<int>(
      static_cast<long long>(this->Texels[axis]) * index / this->Counts[axis]);
  }

  TexelBox Held(const glm::ivec3& index) const
  {
    TexelBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int end = this->Border(axis, index[axis] + 1) + this->Margin;
      box.First[axis] = std::max(0, this->Border(axis, index[axis]) - this->Margin);
      box.Size[axis] = std::min(this->Texels[axis], end) - box.First[axis];
    }
    return box;
  }

  glm::ivec3 LargestHeld() const
  {
    glm::ivec3 largest(0);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int index = 0; index < this->Counts[axis]; ++index)
      {
        largest[axis] = std::max(largest[axis], this->Held(glm::ivec3(index)).Size[axis]);
      }
    }
    return largest;
  }

  double Edge(int axis) const
  {
    return static_cast<double>(this->Texels[axis]) / this->Counts[axis];
  }

  // Cuts the longest edge once more; false when all are as short as they may be.
  bool Refine()
  {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      longest = this->Edge(axis) > this->Edge(longest) ? axis : longest;
    }
    ++this->Counts[longest];
    const double bricks = glm::dvec3(this->Counts).x * this->Counts.y * this->Counts.z;
    return this->Edge(longest) >= SmallestEdge && bricks <= MostBricks;
  }
};

// Cuts until the bricks fit; false where they cannot.
bool Fit(Division& division, const Volume& volume, const VolumeRoom& room, double mostBytes)
{
  for (;;)
  {
    const glm::ivec3 texels = division.LargestHeld();
    if (BytesOnDevice(volume, texels) <= mostBytes && (!room.Takes || room.Takes(texels)))
    {
      return true;
    }
    Division finer = division;
    if (!finer.Refine())
    {
      return false;
    }
    division = finer;
  }
}

std::string Bytes(double bytes)
{
  return std::to_string(static_cast<unsigned long long>(bytes)) + " bytes";
}

std::string WhyNoBricks(const Volume& volume, const glm::ivec3& texels, double budget)
{
  const double bytes = BytesOnDevice(volume, texels);
  const std::string needed =
    "the volume needs " + Bytes(BytesOnDevice(volume, volume.Texels)) + " on the device";
  if (bytes > budget)
  {
    return needed + ", in bricks still " + Bytes(bytes) + " at a time; the memory budget is " +
      Bytes(budget);
  }
  return needed + ", which does not take even bricks of " + std::to_string(texels.x) + " x " +
    std::to_string(texels.y) + " x " + std::to_string(texels.z) + " voxels (" + Bytes(bytes) + ")";
}

Division Divide(const Scene& scene, const VolumeRoom& room, double budget)
{
  const Volume& volume = scene.Volume;
  const Division undivided{ volume.Texels, glm::ivec3(1), MarginOf(scene) };
  Division division = undivided;
  const bool fits = BytesOnDevice(volume, volume.Texels) <= budget;
  if (Fit(division, volume, room, fits ? budget : budget / BricksAtOnce))
  {
    return division;
  }
  division = undivided;
  if (Fit(division, volume, room, budget))
  {
    return division;
  }
  throw SceneError(WhyNoBricks(volume, division.LargestHeld(), budget));
}

// The box round all that samples of the brick may see, as far as the macrocells tell; false where
// that is nothing.
bool FindSeen(const Scene& scene, Brick& brick)
{
  const glm::dvec3& half = scene.Volume.BoxHalf;
  const glm::dvec3 overhang(OverhangOf(scene));
  brick.SeenLow = glm::max(brick.Low - overhang, -half);
  brick.SeenHigh = glm::min(brick.High + overhang, half);
  const CellMap* cells = scene.Skipping.Cells.get();
  if (!cells || cells->Codes.empty())
  {
    return true;
  }
  const double edge = cells->EdgeVoxels;
  const glm::ivec3 most = cells->Cells - 1;
  const glm::ivec3 first = glm::min(glm::ivec3(glm::floor((brick.SeenLow + half) / edge)), most);
  const glm::ivec3 last = glm::min(glm::ivec3(glm::floor((brick.SeenHigh + half) / edge)), most);
  glm::ivec3 low = cells->Cells;
  glm::ivec3 high(-1);
  for (int z = first.z; z <= last.z; ++z)
  {
    for (int y = first.y; y <= last.y; ++y)
    {
      for (int x = first.x; x <= last.x; ++x)
      {
        const std::size_t row = y + static_cast<std::size_t>(cells->Cells.y) * z;
        if (cells->Codes[x + cells->Cells.x * row] >= 256) // any kind but Empty
        {
          low = glm::min(low, glm::ivec3(x, y, z));
          high = glm::max(high, glm::ivec3(x, y, z));
        }
      }
    }
  }
  brick.SeenLow = glm::max(brick.SeenLow, edge * glm::dvec3(low) - half);
  brick.SeenHigh = glm::min(brick.SeenHigh, edge * glm::dvec3(high + 1) - half);
  return high.x >= 0;
}

Brick BrickAt(const Scene& scene, const Division& division, const glm::ivec3& index)
{
  Brick brick;
  brick.Texels = division.Held(index);
  brick.Stamp = scene.Volume.TexelStamp;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = 0.5 * division.Texels[axis];
    const bool first = index[axis] == 0;
    const bool last = index[axis] + 1 == division.Counts[axis];
    brick.Low[axis] = first ? -Endless : division.Border(axis, index[axis]) - middle;
    brick.High[axis] = last ? Endless : division.Border(axis, index[axis] + 1) - middle;
    if (scene.Share)
    {
      brick.Low[axis] = std::max(brick.Low[axis], scene.Share->Low[axis]);
      brick.High[axis] = std::min(brick.High[axis], scene.Share->High[axis]);
    }
    ExtendStamp(brick.Stamp, brick.Texels.First[axis]);
    ExtendStamp(brick.Stamp, brick.Texels.Size[axis]);
  }
  return brick;
}

// Index of the brick nearest to the eye.
glm::ivec3 NearestBrick(const Scene& scene, const Division& division)
{
  const glm::dmat4 viewToVoxel = glm::inverse(scene.Camera.WorldToView * scene.Volume.VoxelToWorld);
  const glm::dvec3 eye =
    scene.Camera.Parallel ? Endless * glm::dvec3(viewToVoxel[2]) : glm::dvec3(viewToVoxel[3]);
  glm::ivec3 nearest(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = eye[axis] + 0.5 * division.Texels[axis];
    while (nearest[axis] + 1 < division.Counts[axis] &&
      place >= division.Border(axis, nearest[axis] + 1))
    {
      ++nearest[axis];
    }
  }
  return nearest;
}

// A ray gets no nearer to the eye's brick on any axis, and further on one with each brick that it
// enters.
std::vector<Brick> FrontToBack(const Scene& scene, const Division& division)
{
  const glm::ivec3 nearest = NearestBrick(scene, division);
  std::vector<std::pair<int, Brick>> ranked;
  for (int z = 0; z < division.Counts.z; ++z)
  {
    for (int y = 0; y < division.Counts.y; ++y)
    {
      for (int x = 0; x < division.Counts.x; ++x)
      {
        const glm::ivec3 away = glm::abs(glm::ivec3(x, y, z) - nearest);
        Brick brick = BrickAt(scene, division, { x, y, z });
        const bool empty = glm::any(glm::greaterThanEqual(brick.Low, brick.High));
        if (!empty && FindSeen(scene, brick))
        {
          ranked.emplace_back(away.x + away.y + away.z, brick);
        }
      }
    }
  }
  std::stable_sort(
    ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Brick> bricks;
  for (const auto& [rank, brick] : ranked)
  {
    bricks.push_back(brick);
  }
  return bricks;
}
}

double BytesOnDevice(const Volume& volume, const glm::ivec3& texels)
{
  const glm::dvec3 size(texels);
  const glm::dvec3 blanks = volume.HasBlanks() ? size + 1.0 : glm::dvec3(0.0);
  return size.x * size.y * size.z * static_cast<double>(TexelBytes(volume)) +
    blanks.x * blanks.y * blanks.z;
}

void DivideIntoBricks(Scene& scene, const VolumeRoom& room)
{
  constexpr double Mebibyte = 1024.0 * 1024.0;
  const double own = scene.Sampling.MemoryBudgetMiB;
  const double budget = own > 0.0 ? own * Mebibyte : room.Bytes;
  const Division division = Divide(scene, room, budget);
  scene.Bricks = nullptr;
  scene.BrickBytes = budget;
  if (scene.Share || division.Counts != glm::ivec3(1))
  {
    scene.Bricks = std::make_shared<const std::vector<Brick>>(FrontToBack(scene, division));
  }
}

Scene SceneOfBrick(const Scene& scene, const Brick& brick)
{
  Scene part = scene;
  part.Brick = brick;
  part.Volume.Part = brick.Texels;
  part.Volume.TexelStamp = brick.Stamp;
  return part;
}
}
