// The volumes that a device holds: one, or as many of the bricks of one as a budget has room for.
#ifndef volumebench_VolumeStore_h
#define volumebench_VolumeStore_h

#include "Bricks/BrickPlan.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace volumebench
{
/// `Content` is what the device holds of a volume or brick; its Release frees it, its Forget drops
/// what went with a context.
template <typename Content>
class VolumeStore
{
public:
  /// What is held of the volume or brick that the scene draws; null when it is not. Drops what
  /// belongs to no brick of the scene.
  Content* Find(const Scene& scene)
  {
    this->DropForeign(scene);
    const auto held = this->At(scene.Volume.TexelStamp);
    if (held == this->Volumes.end())
    {
      return nullptr;
    }
    std::rotate(held, held + 1, this->Volumes.end());
    return this->Volumes.back().Held.get();
  }

  /// Makes room within the scene's budget and adds an empty content. Bricks are asked for in much
  /// the same order in every frame, so those asked for last are needed last: they make room.
  Content& Add(const Scene& scene)
  {
    const double bytes = BytesOnDevice(scene.Volume, scene.Volume.Held().Size);
    while (!this->Volumes.empty() && !(this->GetBytes() + bytes <= scene.BrickBytes))
    {
      this->DropLast();
    }
    this->Volumes.push_back({ scene.Volume.TexelStamp, bytes, std::make_unique<Content>() });
    return *this->Volumes.back().Held;
  }

  /// Whether Add would drop nothing.
  bool HasRoomFor(const Scene& scene) const
  {
    return this->GetBytes() + BytesOnDevice(scene.Volume, scene.Volume.Held().Size) <=
      scene.BrickBytes;
  }

  void DropLast()
  {
    this->Volumes.back().Held->Release();
    this->Volumes.pop_back();
  }

  double GetBytes() const
  {
    double bytes = 0.0;
    for (const Entry& entry : this->Volumes)
    {
      bytes += entry.Bytes;
    }
    return bytes;
  }

  void Release()
  {
    while (!this->Volumes.empty())
    {
      this->DropLast();
    }
  }

  void Forget()
  {
    for (Entry& entry : this->Volumes)
    {
      entry.Held->Forget();
    }
    this->Volumes.clear();
  }

private:
  struct Entry
  {
    ChangeStamp Stamp = 0;
    double Bytes = 0.0;
    std::unique_ptr<Content> Held;
  };

  auto At(ChangeStamp stamp)
  {
    return std::find_if(this->Volumes.begin(), this->Volumes.end(),
      [stamp](const Entry& entry) { return entry.Stamp == stamp; });
  }

  // Once in a frame, as its first brick or whole volume is asked for.
  void DropForeign(const Scene& scene)
  {
    const ChangeStamp asked = scene.Volume.TexelStamp;
    if (scene.Bricks && asked != scene.Bricks->front().Stamp)
    {
      return;
    }
    const auto foreign = std::stable_partition(this->Volumes.begin(), this->Volumes.end(),
      [&](const Entry& entry)
      {
        return scene.Bricks ? std::any_of(scene.Bricks->begin(), scene.Bricks->end(),
                                [&](const Brick& brick) { return brick.Stamp == entry.Stamp; })
                            : entry.Stamp == asked;
      });
    for (auto entry = foreign; entry != this->Volumes.end(); ++entry)
    {
      entry->Held->Release();
    }
    this->Volumes.erase(foreign, this->Volumes.end());
  }

  std::vector<Entry> Volumes; // in the order of their last use
};
}

#endif
