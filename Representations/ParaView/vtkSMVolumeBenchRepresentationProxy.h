/**
 * @class   vtkSMVolumeBenchRepresentationProxy
 * @brief   the client's side of vtkVolumeBenchRepresentation
 *
 * After each still picture of its view it fetches what the representation knows of the picture:
 * ParaView itself reads such properties once, when it makes the panel. What the picture used, left
 * out and took is known where it was drawn, so that is asked of the server when the server drew, and
 * not when the server died meanwhile.
 *
 * It also gives our types in the Representation list what ParaView gives its own "Volume" by name:
 * an array to colour by when none is chosen, and Shade among the rows that are not advanced.
 */
#ifndef vtkSMVolumeBenchRepresentationProxy_h
#define vtkSMVolumeBenchRepresentationProxy_h

#include "VolumeBenchRepresentationsModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h" // for the view and its renderer

class vtkRenderer;

class VOLUMEBENCHREPRESENTATIONS_EXPORT vtkSMVolumeBenchRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMVolumeBenchRepresentationProxy* New();
  vtkTypeMacro(vtkSMVolumeBenchRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMVolumeBenchRepresentationProxy();
  ~vtkSMVolumeBenchRepresentationProxy() override;

  void CreateVTKObjects() override;
  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  vtkSMVolumeBenchRepresentationProxy(const vtkSMVolumeBenchRepresentationProxy&) = delete;
  void operator=(const vtkSMVolumeBenchRepresentationProxy&) = delete;

  void OnTypeChosen();
  void Follow(vtkSMProxy* view);
  bool IsDrawnByServer();
  void OnClientDrew();
  void OnRendered(vtkObject* view, unsigned long event, void* interactive);

  vtkWeakPointer<vtkSMProxy> Followed; // the view that is observed
  unsigned long Observer = 0;
  vtkWeakPointer<vtkRenderer> FollowedRenderer; // the client's own
  unsigned long RendererObserver = 0;
};

#endif
