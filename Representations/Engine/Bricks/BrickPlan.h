// Divides a volume that a device does not take at once into bricks, each with as much of its
// neighbours as its samples reach, so that the picture is that of the whole.
#ifndef volumebench_BrickPlan_h
#define volumebench_BrickPlan_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <cstddef>
#include <functional>
#include <limits>

namespace volumebench
{
/// What a device has room for.
struct VolumeRoom
{
  double Bytes = std::numeric_limits<double>::infinity(); // for voxels and what hides them
  /// Whether one volume may have this many texels on each axis; null: any number.
  std::function<bool(const glm::ivec3&)> Takes;
};

/// Bytes that this many texels of the volume take on a device, with those of its blanking grid.
VOLUMEBENCHENGINE_EXPORT double BytesOnDevice(const Volume& volume, const glm::ivec3& texels);

/// Sets the scene's bricks, front to back, and the bytes that they may take together; none where
/// the device takes the whole volume. The scene's own memory budget comes before that of the
/// device. Throws SceneError, with the bytes, when the smallest bricks are too large.
VOLUMEBENCHENGINE_EXPORT void DivideIntoBricks(Scene& scene, const VolumeRoom& room);

/// The scene with one of its bricks to be drawn.
VOLUMEBENCHENGINE_EXPORT Scene SceneOfBrick(const Scene& scene, const Brick& brick);
}

#endif
