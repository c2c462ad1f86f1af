// The generated volumes that depend on a seed; the Python modules of their names tell what they
// show.
#ifndef volumebench_SeededGenerators_h
#define volumebench_SeededGenerators_h

#include "GeneratedSlices.h"

namespace volumebench
{
/// A body with a spine and a tree of filled vessels, as an angiography by CT shows them.
SlicePainter Vessels(const Dims& dims, std::uint64_t seed);

/// Ultrasound: fully developed speckle with dark vessels.
SlicePainter Speckle(const Dims& dims, std::uint64_t seed);

/// Thin curved petals in a mostly empty box.
SlicePainter Flower(const Dims& dims, std::uint64_t seed);
}

#endif
