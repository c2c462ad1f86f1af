/**
 * @class   vtkVolumeBenchMapper
 * @brief   a volume mapper that draws with one of VolumeBench's techniques
 *
 * Takes vtkImageData (and vtkUniformGrid) with point or cell scalars of any numeric type. At each
 * render it builds the Scene, lets the chosen technique prepare what changed and draw, and blends
 * premultiplied colour over the bound framebuffer. What cannot be drawn honestly is not drawn: the
 * mapper says why in one vtkErrorMacro line, once per cause, and in GetFailure().
 *
 * The physics (emission and absorption, opacity per unit distance turned into extinction) is
 * described in Shaders/Shared/Integrate.h.
 */
#ifndef vtkVolumeBenchMapper_h
#define vtkVolumeBenchMapper_h

#include "VolumeBenchEngineModule.h" // for the export macro
#include "vtkVolumeMapper.h"

#include <memory> // for Internals
#include <string> // for messages

namespace volumebench
{
struct SetUpCosts;
}

class VOLUMEBENCHENGINE_EXPORT vtkVolumeBenchMapper : public vtkVolumeMapper
{
public:
  static vtkVolumeBenchMapper* New();
  vtkTypeMacro(vtkVolumeBenchMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum VectorModes
  {
    Magnitude = 0,
    Component = 1
  };

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
   * 0: Left, sampled where a step begins (first order); 1: Midpoint (second order, default).
   */
  vtkSetClampMacro(Integrator, int, 0, 1);
  vtkGetMacro(Integrator, int);
  ///@}

  ///@{
  /**
   * Length of a step in voxel edges, measured in the grid's index space, so that every ray samples
   * the grid equally densely however stretched its spacing is. Must be at least 1/1024; default
   * 0.5.
   */
  vtkSetMacro(StepVoxels, double);
  vtkGetMacro(StepVoxels, double);
  ///@}

  ///@{
  /**
   * A ray stops when less than this share of light would still get through; 0 switches early
   * termination off. In [0, 1); default 0.001, a quarter of a step of an 8-bit
   * picture.
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

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Why the last render drew nothing; empty when it drew.
   */
  const std::string& GetFailure() const;

  /**
   * Whether the last failure was the machine's (no such API, too old a context) and not the
   * scene's.
   */
  bool GetUnsupported() const;

  /**
   * Names of the features compiled into the last kernel, and of those left out, space-separated.
   */
  std::string GetFeatures() const;
  std::string GetLeftOut() const;

  /**
   * What the technique spent on uploads and compilation, and its bytes on the device.
   */
  volumebench::SetUpCosts GetSetUpCosts() const;

protected:
  vtkVolumeBenchMapper();
  ~vtkVolumeBenchMapper() override;

  std::string Technique = "single-pass";
  int Integrator = 1;
  double StepVoxels = 0.5;
  double TerminationThreshold = 0.001;
  int RaySetUp = 1;
  int VectorMode = Component;
  int VectorComponent = 0;

private:
  vtkVolumeBenchMapper(const vtkVolumeBenchMapper&) = delete;
  void operator=(const vtkVolumeBenchMapper&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
