/**
 * @class   vtkVolumeBenchMeasuring
 * @brief   what is recorded of a picture of a volume, or drawn in its place
 *
 * The part of vtkVolumeBenchMapper's settings that is for looking at what a picture costs.
 */
#ifndef vtkVolumeBenchMeasuring_h
#define vtkVolumeBenchMeasuring_h

#include "VolumeBenchEngineModule.h" // for the export macro
#include "vtkVolumeBenchLimits.h"

class VOLUMEBENCHENGINE_EXPORT vtkVolumeBenchMeasuring : public vtkVolumeBenchLimits
{
public:
  vtkAbstractTypeMacro(vtkVolumeBenchMeasuring, vtkVolumeBenchLimits);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * For measuring: instead of the picture, draws samples taken (red), samples skipped (green) and
   * whether the ray was terminated (blue), to be summed over a float target. Default off.
   */
  vtkSetMacro(CountSamples, bool);
  vtkGetMacro(CountSamples, bool);
  vtkBooleanMacro(CountSamples, bool);
  ///@}

  enum Shows
  {
    Picture = 0,
    SamplesPerPixel = 1
  };

  ///@{
  /**
   * What is drawn: Picture (default) or SamplesPerPixel, for looking at what a picture costs: each
   * pixel in a colour from dark blue (none) to yellow (GetFullScaleSamples or more) by the samples
   * that its ray takes, and nothing where it takes none. Technique reference and inputs of several
   * blocks have no such view.
   */
  vtkSetMacro(Show, int);
  vtkGetMacro(Show, int);
  ///@}

  ///@{
  /**
   * For measuring: times each stage of a frame, which makes the frame slower; for showing: keeps
   * the time of the last still picture, for GetFrameMs. A software renderer has to finish what
   * comes before and after the frame. Both off by default.
   */
  vtkSetMacro(TimeStages, bool);
  vtkGetMacro(TimeStages, bool);
  vtkBooleanMacro(TimeStages, bool);
  vtkSetMacro(TimeFrames, bool);
  vtkGetMacro(TimeFrames, bool);
  vtkBooleanMacro(TimeFrames, bool);
  ///@}

protected:
  vtkVolumeBenchMeasuring() = default;
  ~vtkVolumeBenchMeasuring() override = default;

  bool CountSamples = false;
  int Show = Picture;
  bool TimeStages = false;
  bool TimeFrames = false;

private:
  vtkVolumeBenchMeasuring(const vtkVolumeBenchMeasuring&) = delete;
  void operator=(const vtkVolumeBenchMeasuring&) = delete;
};

#endif
