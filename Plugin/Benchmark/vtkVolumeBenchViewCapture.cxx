#include "vtkVolumeBenchViewCapture.h"

#include "FloatPicture.h"

#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

#include <cstdio>
#include <fstream>

vtkStandardNewMacro(vtkVolumeBenchViewCapture);

namespace
{
void WriteWhole(const std::string& path, const std::vector<float>& pixels)
{
  const std::string partial = path + ".part";
  std::ofstream file(partial, std::ios::binary);
  file.write(
    reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size() * 4));
  file.close();
  if (!file || std::rename(partial.c_str(), path.c_str()) != 0)
  {
    std::remove(partial.c_str());
    throw std::runtime_error("cannot write the file '" + path + "'");
  }
}
}

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
    WriteWhole(this->FileName, volumebench::RenderToFloat(this->View->GetRenderer()).Pixels);
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
