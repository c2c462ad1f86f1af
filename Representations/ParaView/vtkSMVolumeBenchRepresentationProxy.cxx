#include "vtkSMVolumeBenchRepresentationProxy.h"

#include "ServerConnection.h"
#include "Techniques/TechniqueTable.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkRenderer.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
// Known only to a process that has drawn the picture.
constexpr const char* PictureRows[] = { "UsedText", "LeftOutText", "LastFrameMs", "ExpectedError",
  "FullScaleSamples", "SamplesText", "SamplesTaken", "SamplesPerRay", "OpenclDevices" };

constexpr const char* ErrorRows[] = { "ErrorText", "ErrorRmse", "LargestError", "ReferenceSeconds",
  "FrameMs" };

constexpr float BeforeParaView = 1.0f; // ParaView's observers have priority 0

bool IsOurs(const std::string& type)
{
  const std::vector<volumebench::TechniqueRow>& rows = volumebench::TechniqueTable();
  return std::any_of(rows.begin(), rows.end(),
    [&type](const volumebench::TechniqueRow& row) { return type == row.Label; });
}

// The number of the first array of the points, as of any array if there is none of the points.
unsigned int FirstOf(vtkSMArrayListDomain* arrays)
{
  for (unsigned int index = 0; index < arrays->GetNumberOfStrings(); ++index)
  {
    if (arrays->GetFieldAssociation(index) == vtkDataObject::POINT)
    {
      return index;
    }
  }
  return 0;
}
}

vtkStandardNewMacro(vtkSMVolumeBenchRepresentationProxy);

vtkSMVolumeBenchRepresentationProxy::vtkSMVolumeBenchRepresentationProxy() = default;

vtkSMVolumeBenchRepresentationProxy::~vtkSMVolumeBenchRepresentationProxy()
{
  this->Follow(nullptr);
}

void vtkSMVolumeBenchRepresentationProxy::CreateVTKObjects()
{
  const bool created = this->ObjectsCreated != 0;
  this->Superclass::CreateVTKObjects();
  vtkSMProxy* parent = this->GetParentProxy();
  if (created || !parent)
  {
    return;
  }
  if (vtkSMProperty* type = parent->GetProperty("Representation"))
  {
    type->AddObserver(
      vtkCommand::ModifiedEvent, this, &vtkSMVolumeBenchRepresentationProxy::OnTypeChosen);
  }
  if (vtkSMProperty* shade = parent->GetProperty("Shade"))
  {
    shade->SetPanelVisibility("default"); // its group shows it for volumes alone
  }
}

// At once and not with the next picture, so that the GUI undoes both together. What a state file
// brings, an array or none on purpose, is set before there are objects, and stays.
void vtkSMVolumeBenchRepresentationProxy::OnTypeChosen()
{
  vtkSMProxy* parent = this->GetParentProxy();
  if (!parent || !IsOurs(vtkSMPropertyHelper(parent, "Representation").GetAsString()) ||
    vtkSMPVRepresentationProxy::GetUsingScalarColoring(parent))
  {
    return;
  }
  vtkSMProperty* chosen = parent->GetProperty("ColorArrayName");
  auto* arrays = chosen ? chosen->FindDomain<vtkSMArrayListDomain>() : nullptr;
  if (arrays && arrays->GetNumberOfStrings() > 0)
  {
    const unsigned int first = FirstOf(arrays);
    vtkSMPVRepresentationProxy::SetScalarColoring(
      parent, arrays->GetString(first), arrays->GetFieldAssociation(first));
    vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange(parent, true);
  }
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
  if (this->FollowedRenderer)
  {
    this->FollowedRenderer->RemoveObserver(this->RendererObserver);
  }
  this->Followed = view;
  auto* drawn = view ? vtkPVRenderView::SafeDownCast(view->GetClientSideObject()) : nullptr;
  this->FollowedRenderer = drawn ? drawn->GetRenderer() : nullptr;
  if (view)
  {
    this->Observer = view->AddObserver(
      vtkCommand::EndEvent, this, &vtkSMVolumeBenchRepresentationProxy::OnRendered);
  }
  if (this->FollowedRenderer)
  {
    this->RendererObserver = this->FollowedRenderer->AddObserver(vtkCommand::EndEvent, this,
      &vtkSMVolumeBenchRepresentationProxy::OnClientDrew, BeforeParaView);
  }
}

void vtkSMVolumeBenchRepresentationProxy::OnClientDrew()
{
  auto* view =
    this->Followed ? vtkPVRenderView::SafeDownCast(this->Followed->GetClientSideObject()) : nullptr;
  if (view)
  {
    volumebench::ExpectPicture(this->GetSession(), view);
  }
}

void vtkSMVolumeBenchRepresentationProxy::OnRendered(vtkObject*, unsigned long, void* interactive)
{
  if (!interactive || *static_cast<int*>(interactive))
  {
    return;
  }
  if (!volumebench::IsConnected(this->GetSession()))
  {
    vtkErrorMacro(
      "The server ended, or the connection to it was lost, before its picture was here. "
      "Nothing of this session can be drawn again. Disconnect (File > Disconnect, in "
      "Python Disconnect()), and connect to a new server.");
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
