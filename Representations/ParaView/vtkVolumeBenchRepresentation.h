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
 */
#ifndef vtkVolumeBenchRepresentation_h
#define vtkVolumeBenchRepresentation_h

#include "VolumeBenchRepresentationsModule.h" // for the export macro
#include "vtkImageVolumeRepresentation.h"

class vtkDataArray;
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

protected:
  vtkVolumeBenchRepresentation();
  ~vtkVolumeBenchRepresentation() override;

  void UpdateMapperParameters() override;

private:
  vtkVolumeBenchRepresentation(const vtkVolumeBenchRepresentation&) = delete;
  void operator=(const vtkVolumeBenchRepresentation&) = delete;

  void DrawDefaultArray();
  void ForwardVectorMode();
  vtkVolumeBenchMapper* GetMapper();

  vtkNew<vtkVolumeProperty> DefaultProperty; // used while no array is chosen
  vtkDataArray* RampedArray = nullptr;       // whose range the default ramp spans; never read
  vtkMTimeType RampTime = 0;
};

#endif
