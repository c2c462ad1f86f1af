// Says at the client what to do when only one of client and server has the plugin loaded.
//
// ParaView lists such a plugin in its dialog and says nothing in scripts: when the server lacks it,
// our representations are simply not in the list; when the client lacks it, no image data can be
// shown at all, for reasons that do not name the plugin.
#ifndef volumebench_OtherSide_h
#define volumebench_OtherSide_h

#include "VolumeBenchRepresentationsModule.h" // for the export macro

namespace volumebench
{
/// Called by ParaView in each process that loads the plugin, when it does.
VOLUMEBENCHREPRESENTATIONS_EXPORT void WatchOtherSide();
}

#endif
