#include "vtkVolumeBenchViewCapture.h"

#include "FloatPicture.h"

#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkVolumeBenchViewCapture);

vtkVolumeBenchViewCapture::vtkVolumeBenchViewCapture() = default;
vtkVolumeBenchViewCapture::~vtkVolumeBenchViewCapture() = default;

void vtkVolumeBenchViewCapture::SetView(vtkPVView* view)
{
  this->View = vtkPVRenderView::SafeDownCast(view);
}

void vtkVolumeBenchViewCapture::Capture()
{
  try
  {
    if (!this->View)
    {
      throw std::runtime_error("there is no render view to capture");
    }
    volumebench::WriteFloatPicture(
      volumebench::RenderToFloat(this->View->GetRenderer()), this->FileName);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("View not captured: " << error.what());
  }
}

void vtkVolumeBenchViewCapture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
