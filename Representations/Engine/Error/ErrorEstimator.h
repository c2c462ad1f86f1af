// Estimates on request how far the picture of a mapper is from the exact one.
#ifndef volumebench_ErrorEstimator_h
#define volumebench_ErrorEstimator_h

#include "Error/ErrorEstimate.h"
#include "Questions/PictureQuestion.h"

#include <string>

namespace volumebench
{
class ErrorEstimator : public PictureQuestion
{
public:
  ErrorEstimator();

  ErrorEstimate Get(vtkVolumeBenchMapper* mapper) const;

private:
  void Answer(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    VolumePainter& painter) override;

  ErrorEstimate Result;
  std::string Summary; // of the result, without times
};
}

#endif
