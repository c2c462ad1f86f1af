/**
 * @class   vtkVolumeBenchmark
 * @brief   measures speed and error of volume-rendering techniques on the input
 *
 * Image data in, a table out with one row per run: every chosen technique with every chosen
 * integrator, step and variant, and the peers vtk-gpu and vtk-fixed-point once each with ParaView's
 * step. The picture is drawn in an off-screen window of the filter's own while the camera goes
 * round the y axis. Column names are the keys of results.json, nested ones joined by dots;
 * stages_ms and settings hold JSON objects. NaN and empty strings stand for what was not measured.
 * Times are milliseconds, errors are on linear premultiplied float RGBA in [0, 1] over the union
 * footprint. The second port has the same errors as curves over the frame time, for a chart.
 *
 * While it measures, it invokes vtkCommand::UserEvent with the text of each note
 * (ExperimentNotes.h).
 *
 * Bad settings and input that cannot be drawn give one error and an empty table.
 */
#ifndef vtkVolumeBenchmark_h
#define vtkVolumeBenchmark_h

#include "VolumeBenchBenchmarkModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#include <string> // for technique ids
#include <vector> // for lists

class vtkDataArray;
class vtkImageData;
class vtkVolumeProperty;

namespace volumebench
{
struct ExperimentSettings;
}

class VOLUMEBENCHBENCHMARK_EXPORT vtkVolumeBenchmark : public vtkTableAlgorithm
{
public:
  static vtkVolumeBenchmark* New();
  vtkTypeMacro(vtkVolumeBenchmark, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Ids of techniques and peers to measure. */
  void AddTechnique(const char* id);
  void ClearTechniques();
  ///@}

  ///@{
  /** Integrators by name, "Left", "Midpoint", "Segment", "PreIntegrated" or "Automatic". */
  void AddIntegrator(const char* name);
  void ClearIntegrators();
  ///@}

  ///@{
  /** Steps in voxel edges. */
  void AddStepVoxels(double step);
  void ClearStepVoxels();
  ///@}

  ///@{
  /** Size of the picture in pixels. */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /** Opacity points x, alpha, x, alpha, ... in scalar values, ascending; none: a ramp. */
  void AddOpacityPoint(double x, double alpha);
  void ClearOpacityPoints();
  ///@}

  ///@{
  /** Colour points x, r, g, b, ... in scalar values, ascending; none: cool to warm. */
  void AddColorPoint(double x, double r, double g, double b);
  void ClearColorPoints();
  ///@}

  ///@{
  /** Length in the data's units over which the opacities hold; 0: the mean spacing. */
  vtkSetMacro(ScalarOpacityUnitDistance, double);
  vtkGetMacro(ScalarOpacityUnitDistance, double);
  ///@}

  ///@{
  /** As in vtkVolumeBenchMapper. */
  vtkSetMacro(TerminationThreshold, double);
  vtkGetMacro(TerminationThreshold, double);
  vtkSetMacro(RaySetUp, int);
  vtkGetMacro(RaySetUp, int);
  vtkSetMacro(Jitter, bool);
  vtkGetMacro(Jitter, bool);
  vtkSetMacro(JitterSeed, int);
  vtkGetMacro(JitterSeed, int);
  vtkSetMacro(VectorMode, int);
  vtkGetMacro(VectorMode, int);
  vtkSetMacro(VectorComponent, int);
  vtkGetMacro(VectorComponent, int);
  ///@}

  ///@{
  /** As in vtkVolumeBenchMapper; the peers get the blend mode too. */
  vtkSetMacro(BlendMode, int);
  vtkGetMacro(BlendMode, int);
  vtkSetMacro(LightingDamping, double);
  vtkGetMacro(LightingDamping, double);
  ///@}

  /** The device of technique cuda, for results; empty where there is none. */
  const char* GetCudaDevice();

  ///@{
  /** Settings that only some techniques have, as in vtkVolumeBenchMapper. */
  vtkSetStdStringFromCharMacro(WorkGroupShape);
  vtkGetCharFromStdStringMacro(WorkGroupShape);
  vtkSetStdStringFromCharMacro(OpenClDevice);
  vtkGetCharFromStdStringMacro(OpenClDevice);
  vtkSetMacro(OpenClStorage, int);
  vtkGetMacro(OpenClStorage, int);
  vtkSetMacro(VoxelOrder, int);
  vtkGetMacro(VoxelOrder, int);
  vtkSetMacro(PictureTransfer, int);
  vtkGetMacro(PictureTransfer, int);
  vtkSetMacro(SliceExtent, int);
  vtkGetMacro(SliceExtent, int);
  vtkSetMacro(SliceThreads, int);
  vtkGetMacro(SliceThreads, int);
  vtkSetMacro(SliceTarget, int);
  vtkGetMacro(SliceTarget, int);
  vtkSetMacro(SliceOrder, int);
  vtkGetMacro(SliceOrder, int);
  ///@}

  ///@{
  /**
   * Variants of a technique, "ID; name=value; name=value", with the names of the settings above in
   * lower case: work_group_shape, slice_threads, ... Such a technique is measured once for each of
   * its variants; what a variant does not name is as set above.
   */
  void AddVariant(const char* text);
  void ClearVariants();
  ///@}

  ///@{
  /** Gradient shading with a headlight. */
  vtkSetMacro(Shade, bool);
  vtkGetMacro(Shade, bool);
  ///@}

  ///@{
  /** Camera path by name, such as "orbit-y", and the seed of path "random"; see Orbit.h. */
  vtkSetStdStringFromCharMacro(CameraPath);
  vtkGetCharFromStdStringMacro(CameraPath);
  vtkSetMacro(CameraSeed, int);
  vtkGetMacro(CameraSeed, int);
  ///@}

  ///@{
  /** Frames of one turn, elevation above the equator in degrees, divisor of the distance. */
  vtkSetMacro(Frames, int);
  vtkGetMacro(Frames, int);
  vtkSetMacro(Elevation, double);
  vtkGetMacro(Elevation, double);
  vtkSetMacro(Zoom, double);
  vtkGetMacro(Zoom, double);
  ///@}

  ///@{
  /** When a run is long enough: see StopRule.h. Seconds above 0 rotates for that long instead. */
  vtkSetMacro(WarmUpFrames, int);
  vtkGetMacro(WarmUpFrames, int);
  vtkSetMacro(MinimumFrames, int);
  vtkGetMacro(MinimumFrames, int);
  vtkSetMacro(RelativeNoise, double);
  vtkGetMacro(RelativeNoise, double);
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  vtkSetMacro(Seconds, double);
  vtkGetMacro(Seconds, double);
  /** Milliseconds of rest before each block of frames. */
  vtkSetMacro(CoolDown, double);
  vtkGetMacro(CoolDown, double);
  ///@}

  ///@{
  /**
   * Views of the turn at which the error is measured (0: none). What it is measured against: 0: the
   * cell-exact picture of technique reference (default), 1: single-pass with ReferenceStepVoxels.
   */
  vtkSetMacro(ErrorViews, int);
  vtkGetMacro(ErrorViews, int);
  vtkSetMacro(Reference, int);
  vtkGetMacro(Reference, int);
  vtkSetMacro(ReferenceStepVoxels, double);
  vtkGetMacro(ReferenceStepVoxels, double);
  ///@}

  ///@{
  /** Size of the pictures that the error is measured on; 0 0: the size that is timed. */
  vtkSetVector2Macro(ErrorImageSize, int);
  vtkGetVector2Macro(ErrorImageSize, int);
  ///@}

  ///@{
  /**
   * Folder for what each run drew at the first error view, named in column picture, and for
   * reference.rgba32f; format as in vtkVolumeBenchViewCapture. Empty: no pictures.
   */
  vtkSetStdStringFromCharMacro(PictureFolder);
  vtkGetCharFromStdStringMacro(PictureFolder);
  ///@}

protected:
  vtkVolumeBenchmark();
  ~vtkVolumeBenchmark() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int ImageSize[2] = { 500, 500 };
  double ScalarOpacityUnitDistance = 0.0;
  double TerminationThreshold = 0.001;
  bool Jitter = false;
  int JitterSeed = 0;
  int RaySetUp = 1;
  int VectorMode = 0;
  int VectorComponent = 0;
  bool Shade = false;
  int BlendMode = 0;
  double LightingDamping = 0.0;
  std::string WorkGroupShape = "Auto";
  std::string OpenClDevice = "Auto";
  int OpenClStorage = 0;
  std::string CudaDevice;
  int VoxelOrder = 0;
  int PictureTransfer = 0;
  int SliceExtent = 0;
  int SliceThreads = 0;
  int SliceTarget = 0;
  int SliceOrder = 0;
  std::string CameraPath = "orbit-y";
  int CameraSeed = 0;
  int Frames = 36;
  double Elevation = 20.0;
  double Zoom = 1.0;
  int WarmUpFrames = 2;
  int MinimumFrames = 12;
  double RelativeNoise = 0.01;
  double TimeLimit = 10.0;
  double Seconds = 0.0;
  double CoolDown = 0.0;
  int ErrorViews = 1;
  int Reference = 0;
  double ReferenceStepVoxels = 1.0 / 32.0;
  int ErrorImageSize[2] = { 0, 0 };
  std::string PictureFolder;

private:
  vtkVolumeBenchmark(const vtkVolumeBenchmark&) = delete;
  void operator=(const vtkVolumeBenchmark&) = delete;

  volumebench::ExperimentSettings MakeSettings() const;
  void Measure(vtkImageData* image, vtkTable* table, vtkTable* curves);
  vtkDataArray* ChooseArray(vtkImageData* image, bool& onCells);
  void FillProperty(vtkImageData* image, const double range[2], vtkVolumeProperty* property);
  void Append(std::vector<double>& points, std::initializer_list<double> values);

  std::vector<std::string> Techniques;
  std::vector<std::string> Integrators;
  std::vector<std::string> Variants;
  std::vector<double> Steps;
  std::vector<double> OpacityPoints; // x, alpha
  std::vector<double> ColorPoints;   // x, r, g, b
};

#endif
