// Reads the header of a PVM volume (S. Roettger, V^3), plain or packed as a Differential Data
// Stream.
//
// "PVM\n", width, height, depth, components, then the voxels; "PVM2\n" has three voxel lengths
// between depth and components, "PVM3\n" also four texts behind the voxels, each with a zero at its
// end: description, courtesy, parameters, comment. One component is an 8-bit value, two are one of
// 16 bits, the higher byte first; three and four are colours of 8 bits.
#ifndef volumebench_PvmFile_h
#define volumebench_PvmFile_h

#include "DdsStream.h"
#include "VolumeLayout.h"

namespace volumebench
{
/// Tells by its first bytes whether a file may be a PVM volume.
VOLUMEBENCHREADERS_EXPORT bool IsPvm(const std::string& path);

/// Throws std::runtime_error that names the file and its fault. Packed files are unpacked whole.
VOLUMEBENCHREADERS_EXPORT VolumeLayout OpenPvm(const std::string& path, const Progress& progress);
}

#endif
