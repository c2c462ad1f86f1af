// Texture slicing whose polygons are made by several threads (Nikolov 2015).
#ifndef volumebench_SlicesThreaded_h
#define volumebench_SlicesThreaded_h

#include "Techniques/Slices.h"

namespace volumebench
{
class SlicesThreaded : public Slices
{
protected:
  int ThreadsFor(const Scene& scene, int slabs) const override;
};
}

#endif
