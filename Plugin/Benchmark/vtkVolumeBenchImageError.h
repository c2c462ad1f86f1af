/**
 * @class   vtkVolumeBenchImageError
 * @brief   tells how far pictures are from their references
 *
 * Pictures at port 0, as many references at port 1: each vtkImageData with one slice, its point
 * scalars four 32-bit floats, linear premultiplied RGBA, bottom row first. Out comes a table with
 * one row for all of them together, as if they were one picture. Columns are the keys of an error
 * in results.json: error.rmse, error.linf, error.p999, error.psnr, error.mean, error.ssim,
 * error.delta_e_over_1_percent, error.flip_mean and error.flip_p99; NaN stands for what there is
 * not, such as the error of an empty picture. See ImageError.h and PerceivedError.h.
 *
 * Pictures of different sizes or numbers and other data give one error and an empty table.
 */
#ifndef vtkVolumeBenchImageError_h
#define vtkVolumeBenchImageError_h

#include "VolumeBenchBenchmarkModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

class VOLUMEBENCHBENCHMARK_EXPORT vtkVolumeBenchImageError : public vtkTableAlgorithm
{
public:
  static vtkVolumeBenchImageError* New();
  vtkTypeMacro(vtkVolumeBenchImageError, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Removes all inputs of a port. */
  void RemovePictures();
  void RemoveReferences();
  ///@}

protected:
  vtkVolumeBenchImageError();
  ~vtkVolumeBenchImageError() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVolumeBenchImageError(const vtkVolumeBenchImageError&) = delete;
  void operator=(const vtkVolumeBenchImageError&) = delete;
};

#endif
