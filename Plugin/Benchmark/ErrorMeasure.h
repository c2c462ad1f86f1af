// The error of each run's pictures against the reference, at the error views of the camera path.
#ifndef volumebench_ErrorMeasure_h
#define volumebench_ErrorMeasure_h

#include "Experiment.h"
#include "Error/FloatPicture.h"

#include <functional>
#include <string>
#include <vector>

class vtkVolumeBenchMapper;

namespace volumebench
{
class Stage;
struct Run;

/// Camera frame of an error view: an eighth of a view's share past the axes, where grids and
/// silhouettes look their best.
int ErrorFrame(int view, const ExperimentSettings& settings);

class ErrorMeasure
{
public:
  /// `proceed` is asked before each picture; all must outlive this.
  ErrorMeasure(Stage& stage, const ExperimentSettings& settings, const ContestantInput& input,
    const std::function<bool()>& proceed, const ExperimentListener& listener);

  /// Sets the errors of all runs that are not over and have none from an earlier experiment.
  void Measure(std::vector<Run>& runs);

private:
  void TakePictures(Run& run);
  void CompareWith(vtkVolumeBenchMapper& mapper, std::vector<Run>& runs);
  void Compare(Run& run, const std::vector<FloatPicture>& references, double uncertainty);
  void KeepPictures(const FloatPicture& reference, std::vector<Run>& runs) const;
  double ReferenceUncertainty(vtkVolumeBenchMapper& mapper);
  std::string ReferenceName() const;
  bool HasFineSteps() const;
  bool IsWanted(const Run& run) const;
  int Width() const;
  int Height() const;
  void PlaceFrame(int view);

  Stage& Scene;
  const ExperimentSettings& Settings;
  const ContestantInput& Input;
  const std::function<bool()>& Proceed;
  const ExperimentListener& Tell;
  double Bounds[6] = {};
};
}

#endif
