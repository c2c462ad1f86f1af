/**
 * @class   vtkVolumeBenchRepresentation
 * @brief   ParaView's shell round vtkVolumeBenchMapper
 *
 * One class serves every technique: ParaView calls SetRepresentation with the technique's id when
 * the user picks its label. Data delivery, ordered compositing, cropping and lighting settings are
 * the superclass's; this class puts our mapper in its place and forwards our own settings.
 *
 * A composite input is kept as a list of image blocks, which the mapper draws in order. Ranks are
 * put together by ParaView in the order of the boxes round their data, so those must not overlap.
 *
 * When no array is chosen to colour by, the first point array (else cell array) is drawn with a
 * ramp over its range, since ParaView picks one by itself only for its own "Volume".
 *
 * While it is shown, its view does not peel volumes together with translucent geometry: that pass
 * of VTK's draws each volume once per layer and works with VTK's own mapper only.
 */
#ifndef vtkVolumeBenchRepresentation_h
#define vtkVolumeBenchRepresentation_h

#include "ImagePieces.h"                      // for a member
#include "RankLayout.h"                       // for a member
#include "VolumeBenchRepresentationsModule.h" // for the export macro
#include "vtkImageVolumeRepresentation.h"
#include "vtkStringArray.h" // for a member
#include "vtkWeakPointer.h" // for the renderer

#include <string> // for messages

namespace volumebench
{
struct Block;
struct ErrorEstimate;
struct SamplesTaken;
}

class vtkCompositeDataSet;
class vtkPiecewiseFunction;
class vtkPVRenderView;
class vtkRenderer;
class vtkVolumeBenchMapper;
class vtkVolumeBenchRankBlender;

class VOLUMEBENCHREPRESENTATIONS_EXPORT vtkVolumeBenchRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkVolumeBenchRepresentation* New();
  vtkTypeMacro(vtkVolumeBenchRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Called by ParaView with the id of the chosen technique, such as "single-pass".
   */
  void SetRepresentation(const char* technique);

  ///@{
  /**
   * Forwarded to vtkVolumeBenchMapper.
   */
  void SetIntegrator(int integrator);
  void SetStepVoxels(double step);
  void SetMemoryBudget(double mebibytes);
  void SetInteractiveFrameTime(double milliseconds);
  void SetTerminationThreshold(double threshold);
  void SetSkipping(bool skipping);
  void SetMacrocellVoxels(int edge);
  void SetRaySetUp(int setUp);
  void SetJitter(bool jitter);
  void SetJitterSeed(int seed);
  void SetWorkGroupShape(const char* shape);
  void SetOpenClDevice(const char* device);
  void SetOpenClStorage(int storage);
  void SetVoxelOrder(int number);
  void SetPictureTransfer(int number);
  void SetSliceExtent(int extent);
  void SetSliceOrder(int order);
  void SetSliceTarget(int target);
  void SetSliceThreads(int threads);
  void SetLightingDamping(double gradient);
  void SetReferenceMethod(int method);
  void SetShow(int show);
  ///@}

  /**
   * The mapper's error target, of the picture of all ranks together: of each it is the less the
   * more of them can lie behind each other.
   */
  void SetErrorTarget(double target);

  /**
   * The mapper's blend mode. ParaView's own property goes to SetBlendMode and knows but three
   * modes, two of which are for its own mapper; this one wins.
   */
  vtkSetMacro(TechniqueBlendMode, int);

  ///@{
  /**
   * Whether opacity is multiplied by a factor that rises from 0 to 1 over a range of gradient
   * magnitudes (data values per unit of length). A range of 0 and 0 stands for 0 to a tenth of the
   * opacity function's range per voxel: that range is the same on every rank, the data's is not.
   */
  vtkSetMacro(GradientOpacity, bool);
  vtkSetVector2Macro(GradientOpacityRange, double);
  ///@}

  ///@{
  /**
   * vtkVolumeBenchMapper::EstimateError, in a session without servers and other ranks, and what it
   * finds of the next still picture. Numbers that belong to no picture on the screen are NaN; the
   * text says why.
   */
  void EstimateError();
  double GetErrorRmse();
  double GetLargestError();
  double GetReferenceSeconds();
  double GetFrameMs();
  const char* GetErrorText();
  ///@}

  ///@{
  /**
   * What the last still picture used and left out, and its time: vtkVolumeBenchMapper's, of this
   * process. Empty and NaN unless it drew the volume.
   */
  const char* GetUsedText();
  const char* GetLeftOutText();
  double GetLastFrameMs();
  double GetExpectedError();
  double GetFullScaleSamples();
  ///@}

  ///@{
  /**
   * vtkVolumeBenchMapper::AskForSamples, on one rank, and what it finds of the next still picture
   * of this process.
   */
  void CountSamples();
  double GetSamplesTaken();
  double GetSamplesPerRay();
  const char* GetSamplesText();
  ///@}

  ///@{
  /**
   * Asks all ranks of pvbatch what the last still picture took of them: time, voxels with those of
   * neighbours, and the memory of the process. To be called on all of them.
   */
  void AskRanks();
  const char* GetRanksText();
  ///@}

  /**
   * "Auto" and, once technique opencl is in use, the OpenCL devices of this process's machine:
   * asking for them loads their drivers.
   */
  vtkStringArray* GetOpenClDevices();

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkVolumeBenchRepresentation();
  ~vtkVolumeBenchRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void UpdateMapperParameters() override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkVolumeBenchRepresentation(const vtkVolumeBenchRepresentation&) = delete;
  void operator=(const vtkVolumeBenchRepresentation&) = delete;

  void KeepImages(vtkDataObject* input);
  bool NeedsOneRank();
  void PlaceInWorld(vtkInformation* request, vtkInformation* reply);
  void UseRanks(vtkInformation* request, vtkInformation* reply);
  void Spread(
    const volumebench::RankLayout& layout, vtkInformation* request, vtkInformation* reply);
  vtkSmartPointer<vtkDataObject> ExchangedData(const volumebench::RankLayout& layout);
  void FindDefaultRange();
  void LookAtOrder(vtkPVRenderView* view);
  void SortVolumes(vtkPVRenderView* view);
  bool RanksBlend(vtkPVRenderView* view, bool low);
  void UseLayer(vtkPVRenderView* view, bool low);
  void Redeliver(vtkInformation* request, vtkInformation* reply);
  void ForwardErrorTarget();
  int GetLayers();
  void DrawDefaultArray();
  void SwitchVolumePeelingOff(vtkRenderer* renderer);
  void RestoreVolumePeeling();
  std::string WhyNotDrawn();
  void CheckArray(const volumebench::Block& block);
  std::string WhyRanksDoNotBlend();
  void ForwardCropping();
  void ForwardVectorMode();
  void ForwardGradientOpacity(vtkVolumeProperty* property);
  vtkVolumeBenchMapper* GetMapper();
  volumebench::ErrorEstimate GetErrorEstimate();
  volumebench::SamplesTaken GetSamples();
  bool IsDrawn();

  int TechniqueBlendMode = 0;
  double ErrorTarget = 0.0;
  bool GradientOpacity = false;
  double GradientOpacityRange[2] = { 0.0, 0.0 };
  vtkNew<vtkPiecewiseFunction> GradientFunction;
  vtkNew<vtkStringArray> OpenClDevices;

  vtkNew<vtkVolumeProperty> DefaultProperty; // used while no array is chosen
  double RampRange[2] = { 1.0, 0.0 };        // that its ramp spans

  volumebench::Images OwnImages; // of this process's input, without ghost cells
  bool OnlyImages = true;        // there is nothing else in it
  vtkSmartPointer<vtkDataObject> OwnData;
  vtkTimeStamp OwnTime;
  double WholeBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; // of all ranks' data
  volumebench::RankLayout Ranks;
  double SpreadMatrix[16] = {}; // what they are laid out for
  int SpreadLayers = 0;
  bool Redelivers = false;
  vtkNew<vtkVolumeBenchRankBlender> Blender; // in use by the last of a view's volumes
  bool RanksInterleave = false;              // with all that the view shows
  std::string RanksRefusal;                  // why they cannot be laid out
  std::string RanksText;
  double OwnRange[2] = { 1.0, 0.0 };     // of the values of the default array
  double DefaultRange[2] = { 1.0, 0.0 }; // of the values of the default array on all ranks
  vtkTimeStamp SpreadTime;
  std::string Failure;        // said once, not at every render
  std::string ErrorRefusal;   // why no error can be estimated
  std::string SamplesRefusal; // why no samples can be counted
  std::string SamplesText;
  std::string ErrorText; // these live as long as who asked for them needs
  std::string UsedText;
  std::string LeftOutText;
  vtkWeakPointer<vtkRenderer> Unpeeled; // whose volume peeling was on and is off for us
};

#endif
