/**
 * @class   vtkVolumeBenchMapper
 * @brief   a volume mapper that draws with one of VolumeBench's techniques
 *
 * Takes vtkImageData (and vtkUniformGrid) with point or cell scalars of any numeric type, or a
 * composite data set of such blocks, which must not overlap: blocks are drawn back to front, share
 * one range of values and are blended. At each render it builds the Scene, lets the chosen
 * technique prepare what changed and draw, and blends premultiplied colour over the bound
 * framebuffer. What cannot be drawn honestly is not drawn: the mapper says why in one vtkErrorMacro
 * line, once per cause, and in GetFailure().
 *
 * The physics (emission and absorption, opacity per unit distance turned into extinction) is
 * described in Shaders/Shared/Integrate.h.
 */
#ifndef vtkVolumeBenchMapper_h
#define vtkVolumeBenchMapper_h

#include "VolumeBenchEngineModule.h" // for the export macro
#include "vtkVolumeBenchMeasuring.h"

#include <memory> // for Internals
#include <string> // for messages
#include <vector> // for stage times

namespace volumebench
{
class LayerPicture;
struct ErrorEstimate;
struct SamplesTaken;
struct SetUpCosts;
struct StageTime;
}

class VOLUMEBENCHENGINE_EXPORT vtkVolumeBenchMapper : public vtkVolumeBenchMeasuring
{
public:
  static vtkVolumeBenchMapper* New();
  vtkTypeMacro(vtkVolumeBenchMapper, vtkVolumeBenchMeasuring);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum VectorModes
  {
    Magnitude = 0,
    Component = 1
  };

  /**
   * A blend mode beyond vtkVolumeMapper's own, for SetBlendMode: Composite with every extinction
   * weighted by the difference of the ray's two neighbours, one voxel before and after the sample,
   * as a share of the data's range (Maas & Overhoff 2015). Of VTK's modes Composite, Maximum,
   * Minimum and Average are drawn.
   */
  static constexpr int GRADIENT_BLEND = 16;

  ///@{
  /**
   * Id of the technique, as listed in Plugin/Techniques.cmake. An unknown id draws nothing and
   * reports the known ones. Default "single-pass".
   */
  vtkSetStdStringFromCharMacro(Technique);
  vtkGetCharFromStdStringMacro(Technique);
  ///@}

  ///@{
  /**
   * 0: Left, sampled where a step begins (first order); 1: Midpoint (second order, default); 2:
   * Segment, each step taken from prefix integrals of the transfer function between the values at
   * its two ends: exact for narrow peaks and opaque steps; 3: PreIntegrated, the same from a table
   * over both values (Engel et al. 2001); 4: Automatic, Midpoint where the picture is expected to
   * err by no more than 1e-3 with it, else Segment. Matters for the blend modes Composite and
   * Gradient.
   */
  vtkSetMacro(Integrator, int);
  vtkGetMacro(Integrator, int);
  ///@}

  ///@{
  /**
   * Length of a step in voxel edges, measured in the grid's index space, so that every ray samples
   * the grid equally densely however stretched its spacing is; at least 1/1024, default 0.5. With
   * an ErrorTarget, a root mean square (0: none), cells have 1/32 to 8 times it, as that allows.
   */
  vtkSetMacro(StepVoxels, double);
  vtkGetMacro(StepVoxels, double);
  vtkSetMacro(ErrorTarget, double);
  vtkGetMacro(ErrorTarget, double);
  ///@}

  ///@{
  /**
   * Moves the steps of each pixel's ray by a random share of one: rings of equal sampling become
   * noise, and errors as large as those of Left. Pictures of the same seed, 0 (default) to
   * 16777215, are the same. Left and Midpoint then sample at the same places; Segment,
   * PreIntegrated, Maximum and Minimum move the borders between steps. Technique reference has no
   * steps and ignores it. Default off.
   */
  vtkSetMacro(Jitter, bool);
  vtkGetMacro(Jitter, bool);
  vtkBooleanMacro(Jitter, bool);
  vtkSetMacro(JitterSeed, int);
  vtkGetMacro(JitterSeed, int);
  ///@}

  ///@{
  /**
   * Entries of the table of the transfer functions; 0 (default): as many as its closest two points
   * ask for, between 4096 and what the device takes.
   */
  vtkSetMacro(TableSize, int);
  vtkGetMacro(TableSize, int);
  ///@}

  ///@{
  /**
   * Leaves out what cannot be seen: rays jump over cells in which no value has any opacity, or for
   * Maximum and Minimum none that would change the pixel. The picture is the same. Default on.
   * The cells have MacrocellVoxels voxels along an edge, at least 2; 0 (default): 4, or 8 above 256
   * voxels on the longest axis, or 16 above 512.
   */
  vtkSetMacro(Skipping, bool);
  vtkGetMacro(Skipping, bool);
  vtkBooleanMacro(Skipping, bool);
  vtkSetMacro(MacrocellVoxels, int);
  vtkGetMacro(MacrocellVoxels, int);
  ///@}

  ///@{
  /**
   * A ray stops when less than this share of light would still get through; 0 switches early
   * termination off. In [0, 1); default 0.001, a quarter of a step of an 8-bit picture.
   */
  vtkSetMacro(TerminationThreshold, double);
  vtkGetMacro(TerminationThreshold, double);
  ///@}

  ///@{
  /**
   * 0: Box, every pixel of the box's screen rectangle tests its ray; 1: Rasterised (default), only
   * pixels that the box's back faces cover cast one. The picture is the same.
   */
  vtkSetClampMacro(RaySetUp, int, 0, 1);
  vtkGetMacro(RaySetUp, int);
  ///@}

  ///@{
  /**
   * What to draw of arrays with several components: their magnitude or the component
   * VectorComponent. Arrays with one component ignore both. Default: component 0.
   */
  vtkSetClampMacro(VectorMode, int, Magnitude, Component);
  vtkGetMacro(VectorMode, int);
  vtkSetClampMacro(VectorComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(VectorComponent, int);
  ///@}

  ///@{
  /**
   * Techniques compute, opencl and cuda: pixels of a work group as "WIDTHxHEIGHT": one of the 18
   * shapes from 4x1 to 16x8 of Sans & Carmona 2016, or 16x16 or 32x16, which they tried as well; or
   * "Auto" (default), which measures a few of them once per class of scene, or for OpenCL on a CPU
   * takes 16x8.
   */
  vtkSetStdStringFromCharMacro(WorkGroupShape);
  vtkGetCharFromStdStringMacro(WorkGroupShape);
  ///@}

  ///@{
  /**
   * Technique opencl: the device that draws, as "PLATFORM: DEVICE", or "Auto" (default) for a
   * graphics card or else a CPU; and where its kernels find volume and tables. 0: in what suits the
   * device (default); 1: in images, which it filters; 2: in buffers, which they filter.
   */
  vtkSetStdStringFromCharMacro(OpenClDevice);
  vtkGetCharFromStdStringMacro(OpenClDevice);
  vtkSetMacro(OpenClStorage, int);
  vtkGetMacro(OpenClStorage, int);
  ///@}

  ///@{
  /**
   * Techniques compute and cuda: how a view's path through memory is shortened (Misaki, Ino &
   * Hagihara 2017). 0: Naive (default); 1: BlockShape, work groups shaped by the view in place of
   * WorkGroupShape; 2: InPlaceRotation, voxels also turned on the device (cuda).
   */
  vtkSetMacro(VoxelOrder, int);
  vtkGetMacro(VoxelOrder, int);
  ///@}

  ///@{
  /**
   * Technique cuda: how its picture gets to OpenGL. 0: RegisterOnce (default), in a buffer of both;
   * 1: RegisterEachFrame, as Nikolov 2015 did, for comparison; 2: ThroughHost, for other devices.
   */
  vtkSetMacro(PictureTransfer, int);
  vtkGetMacro(PictureTransfer, int);
  ///@}

  ///@{
  /**
   * Techniques slices and slices-threaded: the depths between which the slice distance divides
   * evenly (Nikolov 2015). 0: depths of the box's nearest and farthest vertex (default); 1: their
   * distances from the eye; 2: entry and exit of the central ray. Slices go on to the ends of the
   * box in any case, so nothing is cut off.
   */
  vtkSetMacro(SliceExtent, int);
  vtkGetMacro(SliceExtent, int);
  ///@}

  ///@{
  /**
   * Technique slices-threaded: threads that make the slices, 1, 2, 4, 8 or 16; 0 (default): as many
   * as pay on this machine.
   */
  vtkSetMacro(SliceThreads, int);
  vtkGetMacro(SliceThreads, int);
  ///@}

  ///@{
  /**
   * Techniques slices and slices-threaded: the texture that slices are blended in. 0: RGBA32F
   * (default), 1: RGBA16F, 2: RGBA8 (loses thin media; for comparison). Blend modes other than
   * Composite and Gradient always take RGBA32F. SliceOrder is 0: front to back (default), or 1:
   * back to front.
   */
  vtkSetMacro(SliceTarget, int);
  vtkGetMacro(SliceTarget, int);
  vtkSetMacro(SliceOrder, int);
  vtkGetMacro(SliceOrder, int);
  ///@}

  ///@{
  /**
   * Technique reference: 0: CellExact (default), exact up to rounding; 1: Midpoint, an independent
   * renderer to check it with, which extrapolates from StepVoxels, its half and its quarter.
   */
  vtkSetMacro(ReferenceMethod, int);
  vtkGetMacro(ReferenceMethod, int);
  ///@}

  ///@{
  /**
   * Fades lighting where the field is nearly constant and its gradient is mostly noise: below this
   * gradient, as a share of the data's range per voxel, diffuse and specular light weigh in
   * proportion to it. 0 (default) switches damping off.
   */
  vtkSetMacro(LightingDamping, double);
  vtkGetMacro(LightingDamping, double);
  ///@}

  /** Where pictures go, except selections: the bound framebuffer (none, default), or a layer. */
  void SetLayer(const std::shared_ptr<volumebench::LayerPicture>& layer);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * The image, or the first block of a composite input: who asks for it, as ParaView's volume prop
   * does, wants to know whether there is something to draw.
   */
  using Superclass::GetInput;
  vtkDataSet* GetInput() override;

  using Superclass::GetBounds;
  double* GetBounds() override;

  /** Why the last render drew nothing; empty when it drew. */
  const std::string& GetFailure() const;

  /** Whether the last failure was the machine's (no API, too old a context), not the scene's. */
  bool GetUnsupported() const;

  /** Names of the features compiled into the last kernel, and of those left out, with spaces. */
  std::string GetFeatures() const;
  std::string GetLeftOut() const;

  /**
   * The same two in plain words: what was used separated by commas, what was left out on a line
   * each with the reason. Empty when the last render drew nothing.
   */
  std::string GetUsedText() const;
  std::string GetLeftOutText() const;

  /**
   * From the beginning of the last still picture that was drawn with TimeFrames on until the device
   * was done with it, in milliseconds, uploads and compilation included; NaN when there is none or
   * the last render drew nothing.
   */
  double GetFrameMs() const;

  /**
   * Root mean square error that the steps by the ErrorTarget let expect of the last frame: more
   * than the target where the shortest steps are too long for it; NaN when its steps were chosen by
   * none.
   */
  double GetExpectedError() const;

  /** Samples that are yellow in the last frame: of the longest ray, skipping none; else NaN. */
  double GetFullScaleSamples() const;

  /** What the technique spent on uploads and compilation, and its bytes on the device. */
  volumebench::SetUpCosts GetSetUpCosts() const;

  /**
   * The stages of the last frame that was drawn with TimeStages on, in order; empty when the
   * technique has only one.
   */
  std::vector<volumebench::StageTime> GetStages() const;

  /**
   * Asks for the error of the next still picture against the technique reference, drawn with it:
   * off-screen, at the size of the view, hidden by the same opaque geometry. The mapper tells its
   * progress, and the window's abort check ends it. Interactive frames (an update rate above 1) do
   * not count as still.
   */
  void EstimateError();

  /**
   * What came of it. The numbers are NaN, and the text says why, unless the last frame was the
   * picture that they belong to and no data, setting, function or camera has changed since.
   */
  volumebench::ErrorEstimate GetErrorEstimate();

  /**
   * The same for the samples that the next still picture takes: it is drawn once more, off-screen,
   * by kernels that count. Until then nothing is counted, and no picture costs more.
   */
  void AskForSamples();
  volumebench::SamplesTaken GetSamplesTaken();

protected:
  vtkVolumeBenchMapper();
  ~vtkVolumeBenchMapper() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;

  std::string Technique = "single-pass";
  int Integrator = 1;
  double StepVoxels = 0.5;
  double ErrorTarget = 0.0;
  bool Jitter = false;
  int JitterSeed = 0;
  int TableSize = 0;
  bool Skipping = true;
  int MacrocellVoxels = 0;
  double TerminationThreshold = 0.001;
  int RaySetUp = 1;
  std::string WorkGroupShape = "Auto";
  std::string OpenClDevice = "Auto";
  int OpenClStorage = 0;
  int VoxelOrder = 0;
  int PictureTransfer = 0;
  int SliceExtent = 0;
  int SliceThreads = 0;
  int SliceTarget = 0;
  int SliceOrder = 0;
  int ReferenceMethod = 0;
  double LightingDamping = 0.0;
  int VectorMode = Component;
  int VectorComponent = 0;

private:
  vtkVolumeBenchMapper(const vtkVolumeBenchMapper&) = delete;
  void operator=(const vtkVolumeBenchMapper&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
