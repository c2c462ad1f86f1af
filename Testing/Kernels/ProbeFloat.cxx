// The least function that casts a ray in C++, in float.
#define KERNEL_NAMESPACE probe
#define KERNEL_REAL float
#include "Scene/KernelInstance.h"

probe::vec4 Probe(const probe::BackendScene& scene, probe::vec2 pixel)
{
  return probe::castRay(scene, pixel, 1);
}
