// Turns the xz-slices of a volume by 90 degrees about y in place (Misaki, Ino & Hagihara 2017): a block
// turns one orbit of tiles in a stack of slices, with one tile in shared memory and one in registers. The
// volume is written through a surface of the array that the texture object reads.
#define FUNC __device__ inline
#define STRUCT(name) struct name
#include "Shared/VoxelRotation.h"

#ifndef TEXEL
#define TEXEL unsigned short
#define TILE 32
#define LAYERS 8
#endif
#define COLUMN (int(threadIdx.x) % TILE)
#define ROW (int(threadIdx.x) / TILE)

// A thread has one column and row of a tile, in all slices.
FUNC void loadTile(
  TEXEL* held, cudaSurfaceObject_t volume, OrbitTile part, int firstLayer, int layers)
{
  if (isInTile(part, COLUMN, ROW))
  {
    for (int layer = 0; layer < LAYERS; ++layer)
    {
      if (layer < layers)
      {
        surf3Dread(&held[layer], volume, (part.x + COLUMN) * int(sizeof(TEXEL)),
          firstLayer + layer, part.z + ROW);
      }
    }
  }
}

FUNC void placeTile(TEXEL* turned, const TEXEL* held, OrbitTile part)
{
  if (isInTile(part, COLUMN, ROW))
  {
    for (int layer = 0; layer < LAYERS; ++layer)
    {
      turned[placeTurned(part, TILE, COLUMN, ROW, layer)] = held[layer];
    }
  }
}

FUNC void storeTile(
  const TEXEL* turned, cudaSurfaceObject_t volume, OrbitTile part, int firstLayer, int layers)
{
  if (isInTile(part, COLUMN, ROW))
  {
    for (int layer = 0; layer < layers; ++layer)
    {
      surf3Dwrite(turned[placeOf(TILE, COLUMN, ROW, layer)], volume,
        (part.x + COLUMN) * int(sizeof(TEXEL)), firstLayer + layer, part.z + ROW);
    }
  }
}

// Blocks: orbits of a slice across, stacks of LAYERS slices up; TILE * TILE threads.
extern "C" __global__ void __launch_bounds__(TILE * TILE)
  turnVoxels(cudaSurfaceObject_t volume, int side, int height)
{
  __shared__ TEXEL turned[TILE * (TILE + 1) * LAYERS];
  TEXEL held[LAYERS] = {};
  const int firstLayer = blockIdx.y * LAYERS;
  const int layers = min(LAYERS, height - firstLayer);
  OrbitTile from = firstTileOf(side, TILE, blockIdx.x);
  loadTile(held, volume, from, firstLayer, layers);
  for (int leg = 0; leg < 4; ++leg)
  {
    const OrbitTile to = turnedTile(from, side);
    placeTile(turned, held, from);
    if (leg < 3)
    {
      loadTile(held, volume, to, firstLayer, layers);
    }
    __syncthreads(); // all of `to` is read before any of it is written
    storeTile(turned, volume, to, firstLayer, layers);
    __syncthreads(); // and the shared tile before it is filled again
    from = to;
  }
}
