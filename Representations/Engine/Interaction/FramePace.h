// How coarse pictures are while the mouse drags, so that each takes no longer than is asked for:
// first by longer steps, then by fewer pixels, in few levels that are kept where they are good
// enough, since a picture that changes its coarseness from frame to frame seems to tremble.
#ifndef volumebench_FramePace_h
#define volumebench_FramePace_h

#include "VolumeBenchEngineModule.h"

#include <vector>

namespace volumebench
{
struct Coarseness
{
  double StepFactor = 1.0; // of the still picture's steps
  int Reduction = 1;       // pixels of the window on an axis to one that is drawn
};

class VOLUMEBENCHENGINE_EXPORT FramePace
{
public:
  /// What the next frame is to be that shall take `targetMs`, when the last took `lastMs` (NaN when
  /// nobody knows); steps may be up to `mostStepFactor` times as long.
  Coarseness Next(double targetMs, double lastMs, double mostStepFactor);

  /// A still picture was drawn, which is not coarse.
  void NoteStill() { this->Drawn = 0; }

private:
  void Learn(double lastMs, int stepLevels);
  double ExpectedMs(int level, double lastMs, int stepLevels) const;
  int Coarser(int level, double targetMs, double lastMs, int stepLevels) const;

  int Level = 0;      // of the last coarse frame; 0 is as good as a still one
  int Drawn = 0;      // of the last frame
  int Calm = 0;       // frames in a row after which a finer one would have been in time
  bool Late = false;  // the frame before was, a little
  int StepLevels = 0; // that KnownMs is for
  std::vector<double>
    KnownMs; // of frames of each level, in the view of the last; NaN: nobody knows
  std::vector<double> Changes; // of each of these since it was measured, as a factor
};
}

#endif
