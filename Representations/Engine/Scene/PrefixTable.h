// Prefix integrals of a transfer function, for the integrator Segment: their difference over two
// values is what the function holds between them, to the last digit of a narrow peak.
#ifndef volumebench_PrefixTable_h
#define volumebench_PrefixTable_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

namespace volumebench
{
/// Fills Prefix and its units from Exact: one integral up to each entry of Table, and one more
/// entry on either side, in which the function goes on as at its end. Integrals are whole numbers
/// of 2^-31 of all, so that their differences are exact; an entry has no extinction only if the
/// function has none there.
VOLUMEBENCHENGINE_EXPORT void BuildPrefixTable(TransferFunction& function);
}

#endif
