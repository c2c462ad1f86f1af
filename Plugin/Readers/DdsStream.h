// Unpacks a Differential Data Stream, the compression of PVM volumes (S. Roettger, V^3).
//
// After the eight bytes "DDS v3d\n" or "DDS v3e\n" come bits, the highest of each byte first: two
// for the interleave less one, 16 for the strip less one, then runs. A run is seven bits for its
// length (0: the end, as are bits behind the last byte), three for the width of its values (0, or 2
// to 8 as 1 to 7) and its values, each less half of what its width holds. A value is added to the
// byte before; from the byte strip + 1 on also what changed between the two bytes one strip
// earlier. The bytes came from an interleaved list: all first bytes of its groups, then all second
// ones; in "v3e" so for each 2^24 groups.
#ifndef volumebench_DdsStream_h
#define volumebench_DdsStream_h

#include "ByteSource.h"

#include <functional>

namespace volumebench
{
/// Called with the share that is done, from 0 to 1.
using Progress = std::function<void(double)>;

/// Tells whether a file that begins with these bytes is such a stream.
VOLUMEBENCHREADERS_EXPORT bool IsDds(const Bytes& beginning);

/// `packed` is the whole file; throws std::runtime_error when it ends within a run.
VOLUMEBENCHREADERS_EXPORT Bytes UnpackDds(const Bytes& packed, const Progress& progress);
}

#endif
