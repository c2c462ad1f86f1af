// Runs the fetches of a pattern in a kernel of OpenCL, by one of the look-ups that the ray casters
// have, and brings their sums back.
#ifndef volumebench_OpenClFetch_h
#define volumebench_OpenClFetch_h

#include "FetchPattern.h"

#include "OpenCl/OpenClMemory.h"

#include <functional>

namespace volumebench
{
enum class OpenClLookUp
{
  Lanes,   // of Shaders/Lanes, from a buffer
  Buffers, // one after the other, from a buffer
  Images
};

class OpenClFetch
{
public:
  OpenClFetch(OpenClSession& session, OpenClLookUp lookUp);

  /// Sends a cube of so many voxels on each axis to the device.
  template <typename Texel>
  void SendVolume(int entries, const std::vector<Texel>& texels);

  /// Takes over what to fetch from it, in a picture of this many pixels on each axis, a multiple
  /// of 64.
  void Prepare(const FetchPattern& pattern, int side);

  /// Runs the kernel so often; returns milliseconds.
  double TimeMs(int times);

  std::vector<float> ReadSums();

private:
  void Compile(bool small);

  OpenClSession& Session;
  OpenClLookUp LookUp;
  cl_kernel Kernel = nullptr; // the session's
  int Side = 0;
  OpenClMemory Numbers;
  OpenClMemory Volume;
  OpenClMemory Table; // an argument that the kernel does not read
  OpenClMemory Sums;
};
}

#endif
