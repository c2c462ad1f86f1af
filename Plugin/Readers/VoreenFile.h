// Reads the .dat header of a Voreen volume, and old .dat files that hold the voxels themselves.
//
// A header has a line "Key: value" for each of ObjectFileName (the .raw file, beside the header or
// with its path), Resolution, Format (UCHAR, USHORT, USHORT_12, FLOAT, ...), and maybe
// SliceThickness (the spacing) and ObjectModel (I, LUMINANCE_ALPHA, RGB, RGBA); the voxels are
// little-endian. Other keys are passed over. The old files are three 16-bit counts and as many
// 16-bit values.
#ifndef volumebench_VoreenFile_h
#define volumebench_VoreenFile_h

#include "VolumeLayout.h"

namespace volumebench
{
/// Tells by its beginning and size whether a file may be such a volume.
VOLUMEBENCHREADERS_EXPORT bool IsVoreen(const std::string& path);

/// Throws std::runtime_error that names the file and its fault.
VOLUMEBENCHREADERS_EXPORT VolumeLayout OpenVoreen(const std::string& path);
}

#endif
