/**
 * @class   vtkVolumeBenchRepresentation
 * @brief   ParaView's shell round vtkVolumeBenchMapper
 *
 * One class serves every technique: ParaView calls SetRepresentation with the technique's id when
 * the user picks its label. Data delivery, ordered compositing, cropping and lighting settings are
 * the superclass's; this class puts our mapper in its place and forwards our own settings.
 *
 * When no array is chosen to colour by, the first point array (else cell array) is drawn with a
 * ramp over its range, since ParaView picks one by itself only for its own "Volume".
 *
 * While it is shown, its view does not peel volumes together with translucent geometry: that pass
 * of VTK's draws each volume once per layer and works with VTK's own mapper only.
 */
#ifndef vtkVolumeBenchRepresentation_h
#define vtkVolumeBenchRepresentation_h

#include "VolumeBenchRepresentationsModule.h" // for the export macro
#include "vtkImageVolumeRepresentation.h"
#include "vtkWeakPointer.h" // for the renderer

#include <string> // for the failure

class vtkDataArray;
class vtkRenderer;
class vtkVolumeBenchMapper;

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
  void SetTerminationThreshold(double threshold);
  void SetRaySetUp(int setUp);
  ///@}

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkVolumeBenchRepresentation();
  ~vtkVolumeBenchRepresentation() override;

  void UpdateMapperParameters() override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkVolumeBenchRepresentation(const vtkVolumeBenchRepresentation&) = delete;
  void operator=(const vtkVolumeBenchRepresentation&) = delete;

  void DrawDefaultArray();
  void SwitchVolumePeelingOff(vtkRenderer* renderer);
  void RestoreVolumePeeling();
  std::string WhyNotDrawn();
  void ForwardVectorMode();
  vtkVolumeBenchMapper* GetMapper();

  vtkNew<vtkVolumeProperty> DefaultProperty; // used while no array is chosen
  vtkDataArray* RampedArray = nullptr;       // whose range the default ramp spans; never read
  vtkMTimeType RampTime = 0;
  std::string Failure;                  // said once, not at every render
  vtkWeakPointer<vtkRenderer> Unpeeled; // whose volume peeling was on and is off for us
};

#endif
