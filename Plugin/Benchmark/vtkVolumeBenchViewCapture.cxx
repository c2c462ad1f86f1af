#include "vtkVolumeBenchViewCapture.h"

#include "FloatRendering.h"
#include "VtkSampleCounter.h"

#include "vtkMultiBlockVolumeMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <memory>
#include <vector>

vtkStandardNewMacro(vtkVolumeBenchViewCapture);

namespace
{
// Draws the visible volumes of VTK's GPU mapper through volumes of its own while in scope:
// ParaView's prop keeps the one that it renders with, and its shader, to itself.
class CountedVolumes
{
public:
  explicit CountedVolumes(vtkRenderer* renderer)
    : Renderer(renderer)
  {
    vtkVolumeCollection* volumes = renderer->GetVolumes();
    for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
    {
      auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
      if (volume && volume->GetVisibility() &&
        vtkMultiBlockVolumeMapper::SafeDownCast(volume->GetMapper()))
      {
        this->Hidden.emplace_back(volume);
      }
    }
    for (vtkVolume* volume : this->Hidden)
    {
      this->Replace(volume);
    }
  }
  ~CountedVolumes()
  {
    for (std::size_t i = 0; i < this->Shown.size(); ++i)
    {
      this->Renderer->RemoveVolume(this->Shown[i]);
      this->Hidden[i]->SetVisibility(true);
    }
  }
  CountedVolumes(const CountedVolumes&) = delete;
  CountedVolumes& operator=(const CountedVolumes&) = delete;

private:
  void Replace(vtkVolume* volume)
  {
    auto copy = vtkSmartPointer<vtkVolume>::New();
    copy->SetMapper(volume->GetMapper());
    copy->SetProperty(volume->GetProperty());
    copy->SetUserMatrix(volume->GetMatrix());
    volume->SetVisibility(false);
    this->Renderer->AddVolume(copy);
    this->Shown.push_back(copy);
    this->Counters.push_back(std::make_unique<volumebench::VtkSampleCounter>(copy));
  }

  vtkRenderer* Renderer;
  std::vector<vtkSmartPointer<vtkVolume>> Hidden;
  std::vector<vtkSmartPointer<vtkVolume>> Shown;
  std::vector<std::unique_ptr<volumebench::VtkSampleCounter>> Counters;
};
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
    vtkRenderer* renderer = this->View->GetRenderer();
    std::unique_ptr<CountedVolumes> counted;
    if (this->CountSamples)
    {
      counted = std::make_unique<CountedVolumes>(renderer);
    }
    volumebench::WriteFloatPicture(volumebench::RenderToFloat(renderer), this->FileName);
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
