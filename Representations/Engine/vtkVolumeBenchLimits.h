/**
 * @class   vtkVolumeBenchLimits
 * @brief   what drawing a volume may take of the machine: memory, and time while the mouse drags
 *
 * The part of vtkVolumeBenchMapper's settings that changes what a picture costs, and still pictures
 * not at all.
 */
#ifndef vtkVolumeBenchLimits_h
#define vtkVolumeBenchLimits_h

#include "VolumeBenchEngineModule.h" // for the export macro
#include "vtkVolumeMapper.h"

class VOLUMEBENCHENGINE_EXPORT vtkVolumeBenchLimits : public vtkVolumeMapper
{
public:
  vtkAbstractTypeMacro(vtkVolumeBenchLimits, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Bytes, in MiB, that the volume's voxels may take on the device; 0 (default): most of its
   * memory. A volume that needs more, or is longer on an axis than the device takes, is drawn in
   * bricks, with the same samples. Technique reference reads the volume where it is.
   */
  vtkSetMacro(MemoryBudgetMiB, double);
  vtkGetMacro(MemoryBudgetMiB, double);
  ///@}

  ///@{
  /**
   * Milliseconds that the volume may take of a frame while the mouse drags (an update rate above
   * 1); 0: such frames are as good as still ones. Default 0. Where it is too short for those, steps
   * get longer, up to 2 voxels and not with PreIntegrated or an ErrorTarget; then the picture has
   * fewer pixels and is enlarged. Technique reference has a coarse picture of its own.
   */
  vtkSetMacro(InteractiveFrameMs, double);
  vtkGetMacro(InteractiveFrameMs, double);
  ///@}

  ///@{
  /**
   * Milliseconds of a still picture beyond which the next different one is preceded by a frame as
   * while the mouse drags, and follows it when nothing else happens; in windows of Qt, as
   * ParaView's is, and with an InteractiveFrameMs. Pictures that are captured or drawn by scripts
   * are complete at once. Default 1000.
   */
  vtkSetMacro(PreviewedStillMs, double);
  vtkGetMacro(PreviewedStillMs, double);
  ///@}

protected:
  vtkVolumeBenchLimits() = default;
  ~vtkVolumeBenchLimits() override = default;

  double MemoryBudgetMiB = 0.0;
  double InteractiveFrameMs = 0.0;
  double PreviewedStillMs = 1000.0;

private:
  vtkVolumeBenchLimits(const vtkVolumeBenchLimits&) = delete;
  void operator=(const vtkVolumeBenchLimits&) = delete;
};

#endif
