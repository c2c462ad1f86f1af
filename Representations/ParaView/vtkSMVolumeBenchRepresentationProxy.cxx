#include "vtkSMVolumeBenchRepresentationProxy.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"

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
  for (const char* name :
    { "ErrorText", "ErrorRmse", "LargestError", "ReferenceSeconds", "FrameMs" })
  {
    this->UpdatePropertyInformation(this->GetProperty(name));
  }
}

void vtkSMVolumeBenchRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
