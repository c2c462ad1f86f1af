// Instantiates Shaders/RayCast.cu as C++ in a namespace of its own, for the features that are
// defined as WITH_NAME. It has no include guard, and leaves the features for
// Scene/KernelInstance.h, which gives the same in the C++ dialect and undefines them.
//
//   #define CUDA_NAMESPACE cudaMidpoint
//   #define WITH_MIDPOINT 1
//   #include "CudaInstance.h"
//
// gives cudaMidpoint::castRays, sceneOfFrame and the rest.
#include "CudaOnHost.h"

#ifndef CUDA_NAMESPACE
#error "CudaInstance.h needs CUDA_NAMESPACE"
#endif

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"

// The entry is extern "C": namespaces do not tell its instances apart, names must.
#define CUDA_ENTRY_OF(space) castRays_##space
#define CUDA_ENTRY(space) CUDA_ENTRY_OF(space)
#define castRays CUDA_ENTRY(CUDA_NAMESPACE)

namespace CUDA_NAMESPACE
{
using namespace cudaOnHost;
using cudaOnHost::max;
using cudaOnHost::min;
using std::ceil;
using std::exp;
using std::fabs;
using std::floor;
using std::fmaxf;
using std::fminf;
using std::pow;

#include "RayCast.cu"

constexpr auto Entry = &castRays;
}

#pragma GCC diagnostic pop

#undef castRays
#undef CUDA_ENTRY_OF
#undef CUDA_ENTRY
#undef CUDA_NAMESPACE
#undef VECTOR_FUNC
#include "Scene/ForgetKernelMacros.h"
