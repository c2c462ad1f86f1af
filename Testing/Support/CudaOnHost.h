// As much of CUDA as the kernels use, for a C++ compiler: vector types, texture and surface objects
// on arrays in memory, and launches whose threads run one after the other or, where they wait for
// each other, on threads of the host. So CUDA's text is run where there is no device.
#ifndef volumebench_CudaOnHost_h
#define volumebench_CudaOnHost_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

// Words of the language that mean nothing on the host.
#define __device__
#define __global__
#define __constant__
#define __shared__ static
#define __launch_bounds__(threads)
#define __syncthreads() cudaOnHost::waitForAll()

namespace cudaOnHost
{
struct float2
{
  float x, y;
};
struct float3
{
  float x, y, z;
};
struct alignas(16) float4
{
  float x, y, z, w;
};
struct int2
{
  int x, y;
};
struct alignas(16) int4
{
  int x, y, z, w;
};
struct dim3
{
  int x = 1, y = 1, z = 1;
};

inline float2 make_float2(float x, float y)
{
  return { x, y };
}
inline float3 make_float3(float x, float y, float z)
{
  return { x, y, z };
}
inline float4 make_float4(float x, float y, float z, float w)
{
  return { x, y, z, w };
}

inline float min(float a, float b)
{
  return b < a ? b : a;
}
inline float max(float a, float b)
{
  return a < b ? b : a;
}
inline int min(int a, int b)
{
  return b < a ? b : a;
}

using cudaTextureObject_t = unsigned long long; // 1 more than the index of the array; 0 is none
using cudaSurfaceObject_t = unsigned long long;

/// An array with its texture: values as kernels get them, channels of a texel together.
struct Array
{
  glm::ivec3 Size{ 1 };
  int Channels = 1;
  bool Filtered = true; // by normalized coordinates; else the texel of a coordinate in texels
  std::vector<double> Values;
};

inline std::vector<Array>& arrays()
{
  static std::vector<Array> all;
  return all;
}

inline cudaTextureObject_t addArray(Array array)
{
  arrays().push_back(std::move(array));
  return arrays().size();
}

inline Array& arrayOf(unsigned long long object)
{
  if (object == 0 || object > arrays().size())
  {
    throw std::logic_error("a kernel reads a texture that there is not");
  }
  return arrays()[object - 1];
}

struct Texel
{
  double Channels[4] = {};
};

inline Texel texelAt(const Array& array, glm::ivec3 at)
{
  at = glm::clamp(at, glm::ivec3(0), array.Size - 1);
  const std::size_t row = at.y + static_cast<std::size_t>(array.Size.y) * at.z;
  const double* values = &array.Values.at((row * array.Size.x + at.x) * array.Channels);
  Texel texel;
  std::copy_n(values, array.Channels, texel.Channels);
  return texel;
}

inline Texel sampled(unsigned long long object, const glm::dvec3& position)
{
  const Array& array = arrayOf(object);
  if (!array.Filtered)
  {
    return texelAt(array, glm::ivec3(glm::floor(position)));
  }
  const glm::dvec3 place = position * glm::dvec3(array.Size) - 0.5;
  const glm::ivec3 low(glm::floor(place));
  const glm::dvec3 share = place - glm::dvec3(low);
  Texel sum;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 weights = glm::mix(1.0 - share, share, glm::dvec3(side));
    const Texel texel = texelAt(array, low + side);
    for (int channel = 0; channel < array.Channels; ++channel)
    {
      sum.Channels[channel] += weights.x * weights.y * weights.z * texel.Channels[channel];
    }
  }
  return sum;
}

template <typename T>
T typed(const Texel& texel)
{
  const double* v = texel.Channels;
  if constexpr (std::is_same_v<T, float2>)
  {
    return { static_cast<float>(v[0]), static_cast<float>(v[1]) };
  }
  else if constexpr (std::is_same_v<T, float4>)
  {
    return { static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]),
      static_cast<float>(v[3]) };
  }
  else if constexpr (std::is_same_v<T, int4>)
  {
    return { static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2]),
      static_cast<int>(v[3]) };
  }
  else
  {
    return static_cast<T>(v[0]);
  }
}

template <typename T>
T tex1D(cudaTextureObject_t texture, float x)
{
  return typed<T>(sampled(texture, { x, 0.5, 0.5 }));
}
template <typename T>
T tex2D(cudaTextureObject_t texture, float x, float y)
{
  return typed<T>(sampled(texture, { x, y, 0.5 }));
}
template <typename T>
T tex3D(cudaTextureObject_t texture, float x, float y, float z)
{
  return typed<T>(sampled(texture, { x, y, z }));
}

inline double& surfaceTexel(cudaSurfaceObject_t surface, int byteX, int y, int z, int bytes)
{
  Array& array = arrayOf(surface);
  const glm::ivec3 at(byteX / bytes, y, z);
  if (byteX % bytes != 0 || glm::clamp(at, glm::ivec3(0), array.Size - 1) != at)
  {
    throw std::out_of_range("a kernel misses a texel of a surface");
  }
  const std::size_t row = at.y + static_cast<std::size_t>(array.Size.y) * at.z;
  return array.Values.at(row * array.Size.x + at.x);
}

template <typename T>
void surf3Dread(T* texel, cudaSurfaceObject_t surface, int byteX, int y, int z)
{
  *texel = static_cast<T>(surfaceTexel(surface, byteX, y, z, sizeof(T)));
}
template <typename T>
void surf3Dwrite(T texel, cudaSurfaceObject_t surface, int byteX, int y, int z)
{
  surfaceTexel(surface, byteX, y, z, sizeof(T)) = texel;
}

inline thread_local dim3 threadIdx{ 0, 0, 0 };
inline thread_local dim3 blockIdx{ 0, 0, 0 };
inline dim3 blockDim;
inline pthread_barrier_t barrier;

inline void waitForAll()
{
  pthread_barrier_wait(&barrier);
}

/// Runs a kernel whose threads do not wait for each other.
template <typename Kernel>
void launch(const dim3& blocks, const dim3& threads, const Kernel& kernel)
{
  blockDim = threads;
  for (blockIdx.y = 0; blockIdx.y < blocks.y; ++blockIdx.y)
  {
    for (blockIdx.x = 0; blockIdx.x < blocks.x; ++blockIdx.x)
    {
      for (threadIdx.y = 0; threadIdx.y < threads.y; ++threadIdx.y)
      {
        for (threadIdx.x = 0; threadIdx.x < threads.x; ++threadIdx.x)
        {
          kernel();
        }
      }
    }
  }
}

/// Runs one whose threads do, block by block, each thread on one of the host's.
template <typename Kernel>
void launchTogether(const dim3& blocks, int threads, const Kernel& kernel)
{
  pthread_barrier_init(&barrier, nullptr, threads);
  std::vector<std::thread> hosts;
  for (int thread = 0; thread < threads; ++thread)
  {
    hosts.emplace_back(
      [&, thread]
      {
        threadIdx = { thread, 0, 0 };
        for (blockIdx.y = 0; blockIdx.y < blocks.y; ++blockIdx.y)
        {
          for (blockIdx.x = 0; blockIdx.x < blocks.x; ++blockIdx.x)
          {
            kernel();
            waitForAll();
          }
        }
      });
  }
  for (std::thread& host : hosts)
  {
    host.join();
  }
  pthread_barrier_destroy(&barrier);
}
}

#endif
