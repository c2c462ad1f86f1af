// Rays through a volume whose voxels have been turned in place, by 0 to 3 quarters, against the
// same rays through the volume in the order of its grid: shaded, so that samples beyond the border
// matter.
#include "EngineScene.h"
#include "KernelInstances.h"
#include "Scene/PackScene.h"
#include "TurnedInPlace.h"
#include "VoxelOrder/VoxelOrder.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Pixels = 12;
constexpr int Tile = 4;

double Slopes(double i, double j, double k)
{
  return 0.5 + 0.2 * std::sin(0.7 * i + 0.3 * j) + 0.2 * std::cos(0.9 * k - 0.2 * i * j);
}

// The weights of the eight texels round a place, and what they make of an array.
template <typename TexelAt>
double Filtered(const glm::dvec3& position, const glm::ivec3& texels, const TexelAt& texelAt)
{
  const glm::dvec3 last = texels - 1;
  const glm::dvec3 place = glm::clamp(position * glm::dvec3(texels) - 0.5, glm::dvec3(0.0), last);
  const glm::ivec3 low = glm::min(glm::ivec3(place), glm::max(texels - 2, 0));
  const glm::dvec3 share = place - glm::dvec3(low);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= side[axis] == 1 ? share[axis] : 1.0 - share[axis];
    }
    sum += weight == 0.0 ? 0.0 : weight * texelAt(low + side);
  }
  return sum;
}

class OrderedVolume
{
public:
  explicit OrderedVolume(const glm::ivec3& texels)
    : Texels(texels)
    , Padded(PaddedTexels(texels))
    , Image(MakeImage(texels.x, texels.y, texels.z, Slopes, VTK_FLOAT))
    , Function(MakeLinearExtinctionProperty(0.2, 0.0, 1.0, 65))
    , Engine(MakeEngineScene(this->Image, this->Function))
  {
    this->Engine.Sampling.StepVoxels = 0.37;
    this->Engine.Lighting.Enabled = true;
    this->Engine.Lighting.Lights = { { { 0.3, 0.9, 0.5, 0.0 }, { 1.0, 1.0, 1.0 } } };
    for (int z = 0; z < this->Padded.z; ++z)
    {
      for (int y = 0; y < this->Padded.y; ++y)
      {
        for (int x = 0; x < this->Padded.x; ++x)
        {
          const glm::ivec3 inside = glm::min(glm::ivec3(x, y, z), texels - 1);
          this->Array.push_back(Slopes(inside.x, inside.y, inside.z));
        }
      }
    }
  }

  void Turn() { InPlaceTurner<double>(this->Array, this->Padded, Tile, 2); }

  void LookFrom(const glm::dvec3& direction, bool parallel)
  {
    const glm::dvec3 middle = 0.5 * glm::dvec3(this->Texels - 1);
    const double size = glm::length(middle);
    LookFromTo(this->Engine, middle + 3.2 * size * glm::normalize(direction), middle, 1.05 * size,
      Pixels, parallel);
  }

  template <typename BackendScene>
  BackendScene Kernel() const
  {
    BackendScene kernel = {};
    const SceneBlock64 block = PackScene(this->Engine);
    static_assert(sizeof(block) == sizeof(typename BackendScene::SceneBlock), "another layout");
    std::memcpy(static_cast<void*>(static_cast<typename BackendScene::SceneBlock*>(&kernel)),
      &block, sizeof(block));
    kernel.table = [](double value)
    { return glm::dvec4(value, 0.5, 1.0 - value, 0.3 * value * value); };
    return kernel;
  }

  double TexelAt(const glm::ivec3& at) const { return this->Array.at(this->IndexOf(at)); }
  const glm::ivec3& GetTexels() const { return this->Texels; }
  const glm::ivec3& GetPadded() const { return this->Padded; }

private:
  std::size_t IndexOf(const glm::ivec3& at) const
  {
    return at.x + this->Padded.x * (at.y + static_cast<std::size_t>(this->Padded.y) * at.z);
  }

  glm::ivec3 Texels;
  glm::ivec3 Padded;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkVolumeProperty> Function;
  Scene Engine;
  std::vector<double> Array;
};

// Calls the test for volumes wider, deeper and as wide as deep, turned 0 to 3 times, from all
// sides.
template <typename Test>
void ForEveryOrderAndView(const Test& test)
{
  for (const glm::ivec3& texels : { glm::ivec3(13, 6, 9), glm::ivec3(7, 6, 12), glm::ivec3(8) })
  {
    OrderedVolume volume(texels);
    for (int turns = 0; turns < 4; ++turns)
    {
      for (int i = 0; i < 27; ++i)
      {
        if (i != 13)
        {
          volume.LookFrom({ i % 3 - 1 + 0.1, (i / 3) % 3 - 1 - 0.07, i / 9 - 1 }, i % 2 == 0);
          test(volume, turns);
        }
      }
      volume.Turn();
    }
  }
}

glm::dvec2 PixelAt(int index)
{
  return { index % Pixels + 0.5, index / Pixels + 0.5 };
}
}

// Texels read where the order has put them are those of the grid, so nothing differs.
TEST(VoxelOrderText, TexelsOfTurnedVoxelsGiveThePictureToTheLastBit)
{
  ForEveryOrderAndView(
    [](const OrderedVolume& volume, int turns)
    {
      const glm::ivec3& texels = volume.GetTexels();
      auto plain = volume.Kernel<lit64::BackendScene>();
      plain.field = [&](const glm::dvec3& position)
      {
        return Filtered(
          position, texels, [](const glm::ivec3& at) { return Slopes(at.x, at.y, at.z); });
      };
      auto ordered = volume.Kernel<lit64::BackendScene>();
      ordered.field = [&](const glm::dvec3& position)
      {
        return Filtered(position, texels,
          [&](const glm::ivec3& at) { return volume.TexelAt(OrderedVoxel(at, texels, turns)); });
      };
      for (int pixel = 0; pixel < Pixels * Pixels; ++pixel)
      {
        ASSERT_EQ(glm::dvec4(lit64::castRay(ordered, PixelAt(pixel), 1.0)),
          glm::dvec4(lit64::castRay(plain, PixelAt(pixel), 1.0)))
          << turns << " turns, pixel " << pixel;
      }
    });
}

// The same through coordinates, as a texture unit is given them: equal up to their rounding.
TEST(VoxelOrderText, CoordinatesInTurnedVoxelsGiveThePicture)
{
  ForEveryOrderAndView(
    [](const OrderedVolume& volume, int turns)
    {
      auto plain = volume.Kernel<lit64::BackendScene>();
      plain.field = [&](const glm::dvec3& position)
      {
        return Filtered(position, volume.GetTexels(),
          [](const glm::ivec3& at) { return Slopes(at.x, at.y, at.z); });
      };
      auto ordered = volume.Kernel<orderedLit64::BackendScene>();
      ordered.field = [&](const glm::dvec3& position)
      {
        return Filtered(
          position, volume.GetPadded(), [&](const glm::ivec3& at) { return volume.TexelAt(at); });
      };
      const VoxelOrderRows rows = OrderRows(volume.GetTexels(), turns);
      ordered.orderX = rows.X;
      ordered.orderZ = rows.Z;
      for (int pixel = 0; pixel < Pixels * Pixels; ++pixel)
      {
        const glm::dvec4 expected = lit64::castRay(plain, PixelAt(pixel), 1.0);
        const glm::dvec4 drawn = orderedLit64::castRay(ordered, PixelAt(pixel), 1.0);
        ASSERT_LE(glm::length(drawn - expected), 1e-12) << turns << " turns, pixel " << pixel;
      }
    });
}
