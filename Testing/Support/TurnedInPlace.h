// Turns the voxels of an array as the blocks of Shaders/RotateVoxels.cu do, one after the other:
// each with one tile in shared memory and one in registers, and nothing else.
#ifndef volumebench_TurnedInPlace_h
#define volumebench_TurnedInPlace_h

#include "VoxelOrder/VoxelRotation.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

namespace volumebench::test
{
template <typename T>
class InPlaceTurner
{
public:
  /// `texels`: x and z must be the same.
  InPlaceTurner(std::vector<T>& voxels, const glm::ivec3& texels, int tile, int layers)
    : Voxels(voxels)
    , Texels(texels)
    , Tile(tile)
    , Shared(placesOfTile(tile, layers))
    , Registers(static_cast<std::size_t>(tile) * tile * layers)
  {
    for (int layer = 0; layer < texels.y; layer += layers)
    {
      for (int orbit = 0; orbit < orbitCount(texels.x, tile); ++orbit)
      {
        this->TurnOrbit(orbit, layer, std::min(layers, texels.y - layer));
      }
    }
  }

private:
  /// Calls `action` with column, row and layer of a stack of tiles and the voxel that is there.
  template <typename Action>
  void ForEach(const OrbitTile& part, int firstLayer, int layers, const Action& action)
  {
    for (int layer = 0; layer < layers; ++layer)
    {
      for (int i = 0; i < this->Tile * this->Tile; ++i)
      {
        const int column = i % this->Tile;
        const int row = i / this->Tile;
        if (isInTile(part, column, row))
        {
          const std::size_t y = firstLayer + layer;
          const std::size_t z = part.z + row;
          action(column, row, layer,
            this->Voxels.at(part.x + column + this->Texels.x * (y + this->Texels.y * z)));
        }
      }
    }
  }

  T& Held(int column, int row, int layer)
  {
    return this->Registers.at((layer * this->Tile + row) * this->Tile + column);
  }

  void Load(const OrbitTile& part, int firstLayer, int layers)
  {
    this->ForEach(part, firstLayer, layers,
      [this](int column, int row, int layer, const T& voxel)
      { this->Held(column, row, layer) = voxel; });
  }

  void TurnOrbit(int orbit, int firstLayer, int layers)
  {
    OrbitTile from = firstTileOf(this->Texels.x, this->Tile, orbit);
    this->Load(from, firstLayer, layers);
    for (int leg = 0; leg < 4; ++leg)
    {
      const OrbitTile to = turnedTile(from, this->Texels.x);
      this->ForEach(from, firstLayer, layers,
        [&](int column, int row, int layer, const T&)
        {
          this->Shared.at(placeTurned(from, this->Tile, column, row, layer)) =
            this->Held(column, row, layer);
        });
      this->Load(to, firstLayer, layers);
      this->ForEach(to, firstLayer, layers,
        [&](int column, int row, int layer, T& voxel)
        { voxel = this->Shared.at(placeOf(this->Tile, column, row, layer)); });
      from = to;
    }
  }

  std::vector<T>& Voxels;
  glm::ivec3 Texels;
  int Tile;
  std::vector<T> Shared;
  std::vector<T> Registers;
};

/// Voxels that are all different, x first, then y, then z.
inline std::vector<int> NumberedVoxels(const glm::ivec3& texels)
{
  std::vector<int> voxels(static_cast<std::size_t>(texels.x) * texels.y * texels.z);
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    voxels[i] = static_cast<int>(i);
  }
  return voxels;
}
}

#endif
