/**
 * @class   vtkVolumeBenchViewCapture
 * @brief   writes what a ParaView render view shows as a float picture
 *
 * The picture is linear premultiplied RGBA, 32-bit float, little-endian, width * height * 4 values,
 * bottom row first, over a transparent background: the view's props, camera and mapper settings as
 * they are, without the view's image-space effects (FXAA, SSAO). The file appears whole or not at
 * all.
 */
#ifndef vtkVolumeBenchViewCapture_h
#define vtkVolumeBenchViewCapture_h

#include "VolumeBenchViewCaptureModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkWeakPointer.h" // for the view

#include <string> // for names and texts

class vtkPVRenderView;
class vtkPVView;

class VOLUMEBENCHVIEWCAPTURE_EXPORT vtkVolumeBenchViewCapture : public vtkObject
{
public:
  static vtkVolumeBenchViewCapture* New();
  vtkTypeMacro(vtkVolumeBenchViewCapture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetView(vtkPVView* view);

  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);

  ///@{
  /**
   * Instead of what volumes look like, write in red how many samples VTK's GPU mapper or ours takes
   * for each pixel, and of ours in green and blue what it skips and whether it stops; default off.
   * Volumes with another mapper are left as they are.
   */
  vtkSetMacro(CountSamples, bool);
  vtkGetMacro(CountSamples, bool);
  ///@}

  /**
   * Renders and writes. What goes wrong is reported as one error that names the file or the cause.
   */
  void Capture();

  /**
   * What our mapper tells of its last frame in the view, as one JSON object whose members are
   * named as the columns of the benchmark filter: features, left_out, setup_ms.*, bytes_on_device.
   * An empty object unless exactly one volume of ours is visible.
   */
  const char* GetDescription();

protected:
  vtkVolumeBenchViewCapture();
  ~vtkVolumeBenchViewCapture() override;

private:
  vtkVolumeBenchViewCapture(const vtkVolumeBenchViewCapture&) = delete;
  void operator=(const vtkVolumeBenchViewCapture&) = delete;

  vtkWeakPointer<vtkPVRenderView> View;
  std::string FileName;
  std::string Description;
  bool CountSamples = false;
};

#endif
