// Estimates on request how far the picture of a mapper is from the exact one, and knows for how
// long the numbers hold: until the picture, or a setting that it depends on, is another.
#ifndef volumebench_ErrorEstimator_h
#define volumebench_ErrorEstimator_h

#include "Error/ErrorEstimate.h"
#include "VolumePainter.h"

#include "vtkRenderer.h"
#include "vtkType.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkVolumeBenchMapper;

namespace volumebench
{
class ErrorEstimator
{
public:
  /// The next still picture is to be judged.
  void Request();

  /// To be called after each frame; `failure` says why it was not drawn. Draws the picture and its
  /// reference off-screen when that is asked for and the frame is no interactive one.
  void FollowFrame(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    VolumePainter& painter, const std::string& failure);

  ErrorEstimate Get(vtkVolumeBenchMapper* mapper) const;

private:
  enum class State
  {
    Idle,    // nothing was asked for
    Waiting, // for a still picture
    Known,
    Failed
  };

  void Estimate(vtkVolumeBenchMapper* mapper, VolumePainter& painter);
  void Fail(const std::string& reason);
  bool IsCurrent(vtkVolumeBenchMapper* mapper) const;
  vtkMTimeType SettingsTime(vtkVolumeBenchMapper* mapper) const;

  State Progress = State::Idle;
  ErrorEstimate Result;
  std::string Summary;                  // of the result, without times
  ChangeStamp Stamp = 0;                // of the picture that was judged
  bool Shown = false;                   // the last frame was that picture
  vtkMTimeType FollowedAt = 0;          // of the newest setting in the last frame
  vtkWeakPointer<vtkRenderer> Renderer; // of the last frame
  vtkWeakPointer<vtkVolume> Volume;
};
}

#endif
