// How the xz-slices of a volume are turned by 90 degrees about y in place (Misaki, Ino & Hagihara
// 2017). One turn takes the voxel (x, z) of a square slice to (side - 1 - z, x). A tile and its three
// images make an orbit, which one block of threads turns through the memory of one tile. The first
// tiles of all orbits fill the quarter [0, (side + 1) / 2) x [0, side / 2) and are cut off at its ends,
// so that the images of that quarter cover a slice of any side exactly once, without padding to whole
// tiles; the middle voxel of an odd side stays where it is.

// Part of a slice, in voxels.
STRUCT(OrbitTile)
{
  int x; // lowest voxel
  int z;
  int width; // along x
  int depth; // along z
};

FUNC int wholeTiles(int voxels, int tile)
{
  return (voxels + tile - 1) / tile;
}

// Orbits of a slice; none where there is nothing to turn.
FUNC int orbitCount(int side, int tile)
{
  return wholeTiles((side + 1) / 2, tile) * wholeTiles(side / 2, tile);
}

FUNC OrbitTile firstTileOf(int side, int tile, int orbit)
{
  int columns = wholeTiles((side + 1) / 2, tile);
  OrbitTile first;
  first.x = orbit % columns * tile;
  first.z = orbit / columns * tile;
  int width = (side + 1) / 2 - first.x;
  int depth = side / 2 - first.z;
  first.width = width < tile ? width : tile;
  first.depth = depth < tile ? depth : tile;
  return first;
}

// Where one turn takes a tile.
FUNC OrbitTile turnedTile(OrbitTile from, int side)
{
  OrbitTile to;
  to.x = side - from.z - from.depth;
  to.z = from.x;
  to.width = from.depth;
  to.depth = from.width;
  return to;
}

// Whether a place of a whole tile belongs to one that may be cut off.
FUNC bool isInTile(OrbitTile part, int column, int row)
{
  return column < part.width && row < part.depth;
}

// Where the memory of a stack of tiles holds a voxel. A row is one place longer than a tile, so that
// threads that write a column use different banks.
FUNC int placeOf(int tile, int column, int row, int layer)
{
  return (layer * tile + row) * (tile + 1) + column;
}

FUNC int placesOfTile(int tile, int layers)
{
  return tile * (tile + 1) * layers;
}

// Where it holds one of this part after a turn.
FUNC int placeTurned(OrbitTile part, int tile, int column, int row, int layer)
{
  return placeOf(tile, part.depth - 1 - row, column, layer);
}
