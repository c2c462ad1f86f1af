#include "vtkSMVolumeBenchRepresentationProxy.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkSMProperty.h"

namespace
{
// Known only to a process that has drawn the picture.
constexpr const char* PictureRows[] = { "UsedText", "LeftOutText", "LastFrameMs",
  "FullScaleSamples", "OpenclDevices" };

constexpr const char* ErrorRows[] = { "ErrorText", "ErrorRmse", "LargestError", "ReferenceSeconds",
  "FrameMs" };
}

vtkStandardNewMacro(vtkSMVolumeBenchRepresentationProxy);

vtkSMVolumeBenchRepresentationProxy::vtkSMVolumeBenchRepresentationProxy() = default;

vtkSMVolumeBenchRepresentationProxy::~vtkSMVolumeBenchRepresentationProxy()
{
  this->Follow(nullptr);
}

void vtkSMVolumeBenchRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  this->Follow(view);
}

void vtkSMVolumeBenchRepresentationProxy::Follow(vtkSMProxy* view)
{
  if (view == this->Followed)
  {
    return;
  }
  if (this->Followed)
  {
    this->Followed->RemoveObserver(this->Observer);
  }
  this->Followed = view;
  if (view)
  {
    this->Observer = view->AddObserver(
      vtkCommand::EndEvent, this, &vtkSMVolumeBenchRepresentationProxy::OnRendered);
  }
}

void vtkSMVolumeBenchRepresentationProxy::OnRendered(vtkObject*, unsigned long, void* interactive)
{
  if (!interactive || *static_cast<int*>(interactive))
  {
    return;
  }
  for (const char* name : ErrorRows)
  {
    this->UpdatePropertyInformation(this->GetProperty(name));
  }
  for (const char* name : PictureRows)
  {
    this->UpdatePropertyInformation(this->GetProperty(name));
  }
}

bool vtkSMVolumeBenchRepresentationProxy::IsDrawnByServer()
{
  auto* view =
    this->Followed ? vtkPVRenderView::SafeDownCast(this->Followed->GetClientSideObject()) : nullptr;
  return view && view->GetUseDistributedRenderingForRender();
}

// A property is fetched from one of the processes that the proxy's location names, the client
// first.
void vtkSMVolumeBenchRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  this->Superclass::UpdatePropertyInformationInternal(property);
  if (!this->IsDrawnByServer())
  {
    return;
  }
  const vtkTypeUInt32 everywhere = this->Location;
  this->Location = vtkPVSession::RENDER_SERVER_ROOT;
  for (const char* name : PictureRows)
  {
    vtkSMProperty* row = this->GetProperty(name);
    if (!property || property == row)
    {
      this->Superclass::UpdatePropertyInformationInternal(row);
    }
  }
  this->Location = everywhere;
}

void vtkSMVolumeBenchRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
