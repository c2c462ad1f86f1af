#include "Scene/MacrocellCache.h"

#include "Scene/FieldChanges.h"
#include "Stopwatch.h"

namespace volumebench
{
namespace
{
int EdgeOf(const Scene& scene)
{
  return scene.Sampling.MacrocellVoxels > 0 ? scene.Sampling.MacrocellVoxels
                                            : SuitableMacrocellEdge(scene.Volume.Texels);
}
}

ChangeStamp MacrocellCache::StampOf(const Scene& scene)
{
  ChangeStamp stamp = scene.Volume.TexelStamp;
  ExtendStamp(stamp, EdgeOf(scene));
  return stamp;
}

const MacrocellGrid& MacrocellCache::GridOf(const Scene& scene)
{
  const ChangeStamp stamp = StampOf(scene);
  if (stamp != this->GridStamp)
  {
    const Stopwatch watch;
    this->Grid = BuildMacrocellGrid(scene.Volume, EdgeOf(scene));
    this->GridStamp = stamp;
    this->Ms += watch.ElapsedMs();
  }
  return this->Grid;
}

const std::vector<glm::vec2>& MacrocellCache::ChangesOf(const Scene& scene)
{
  const MacrocellGrid& grid = this->GridOf(scene);
  if (this->GridStamp != this->ChangesStamp)
  {
    const Stopwatch watch;
    this->Changes = MeasureFieldChanges(scene.Volume, grid);
    this->ChangesStamp = this->GridStamp;
    this->Ms += watch.ElapsedMs();
  }
  return this->Changes;
}
}
