// Which integrator a scene needs: Midpoint where the changes of its field and of its functions let
// that suffice, else Segment, which costs more for each sample.
#ifndef volumebench_IntegratorChoice_h
#define volumebench_IntegratorChoice_h

#include "VolumeBenchEngineModule.h"

#include "Scene/MacrocellCache.h"
#include "Scene/Scene.h"

#include <utility>

namespace volumebench
{
/// Root mean square of a picture that Midpoint may be expected to err by: a quarter of a grey level
/// of eight bits.
constexpr double SufficientError = 1.0e-3;

class VOLUMEBENCHENGINE_EXPORT IntegratorChoice
{
public:
  /// Replaces Automatic by Midpoint or Segment, for a scene whose volume, transfer function without
  /// integrals and all else are built. Steps that are all alike have Midpoint where its error is
  /// expected to be at most SufficientError or about that of Segment. With an error target, which
  /// both keep, the cheaper one is taken. Jitter, several components and volumes that ranks share
  /// have Segment without being judged.
  void Choose(MacrocellCache& cells, Scene& scene);

  /// Milliseconds that choosing took since the last call, with macrocells that were new to it.
  double TakeMs() { return std::exchange(this->Ms, 0.0); }

private:
  Integrator Chosen = Integrator::Midpoint; // for the scene with Stamp
  ChangeStamp Stamp = 0;
  MacrocellCache OwnCells; // where the scene's have another size
  double Ms = 0.0;
};
}

#endif
