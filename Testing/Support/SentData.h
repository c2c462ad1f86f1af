// Counts what a piece of code sends to devices, and what they hold of it, at the calls of OpenGL
// and OpenCL themselves.
#ifndef volumebench_SentData_h
#define volumebench_SentData_h

#include <cstddef>
#include <functional>
#include <ostream>

namespace volumebench::test
{
/// Calls that carry data, or make programs. Storage without contents does not count.
struct SentData
{
  int Lines = 0;    // one-dimensional textures
  int Pictures = 0; // two-dimensional ones
  int Volumes = 0;  // three-dimensional ones at once
  int Slabs = 0;    // parts of three-dimensional ones
  int Blocks = 0;   // uniform buffers
  int Writes = 0;   // to buffers and images of OpenCL
  int Programs = 0; // linked

  bool operator==(const SentData& other) const
  {
    return this->Lines == other.Lines && this->Pictures == other.Pictures &&
      this->Volumes == other.Volumes && this->Slabs == other.Slabs &&
      this->Blocks == other.Blocks && this->Writes == other.Writes &&
      this->Programs == other.Programs;
  }
};

inline std::ostream& operator<<(std::ostream& os, const SentData& sent)
{
  return os << sent.Lines << " lines, " << sent.Pictures << " pictures, " << sent.Volumes
            << " volumes, " << sent.Slabs << " slabs, " << sent.Blocks << " blocks, " << sent.Writes
            << " writes, " << sent.Programs << " programs";
}

/// What `action` sends. An OpenGL context has been made before, and `action` makes none.
SentData SentBy(const std::function<void()>& action);

/// Buffers and images of OpenCL that have been made and not released since the first call.
int OpenClObjects();
}

#endif
