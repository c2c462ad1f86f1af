// Counts on request the samples that a mapper's picture takes.
#ifndef volumebench_SampleCounter_h
#define volumebench_SampleCounter_h

#include "Questions/PictureQuestion.h"
#include "Questions/SamplesTaken.h"

#include <string>

namespace volumebench
{
class SampleCounter : public PictureQuestion
{
public:
  SampleCounter();

  SamplesTaken Get(vtkVolumeBenchMapper* mapper) const;

private:
  void Answer(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    VolumePainter& painter) override;

  SamplesTaken Result;
};
}

#endif
