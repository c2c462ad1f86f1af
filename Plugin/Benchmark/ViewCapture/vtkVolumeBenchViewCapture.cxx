#include "vtkVolumeBenchViewCapture.h"

#include "FloatRendering.h"
#include "JsonText.h"
#include "Techniques/Technique.h"
#include "VtkSampleCounter.h"

#include "vtkMultiBlockVolumeMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeBenchMapper.h"
#include "vtkVolumeCollection.h"

#include <memory>
#include <vector>

vtkStandardNewMacro(vtkVolumeBenchViewCapture);

namespace
{
// Returns our mappers among those of the visible volumes.
std::vector<vtkVolumeBenchMapper*> OurMappers(vtkRenderer* renderer)
{
  std::vector<vtkVolumeBenchMapper*> mappers;
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
    auto* mapper = volume && volume->GetVisibility()
      ? vtkVolumeBenchMapper::SafeDownCast(volume->GetMapper())
      : nullptr;
    if (mapper)
    {
      mappers.push_back(mapper);
    }
  }
  return mappers;
}

std::string DescriptionOf(const vtkVolumeBenchMapper& mapper)
{
  using namespace volumebench;
  const SetUpCosts costs = mapper.GetSetUpCosts();
  return JsonObject({ { "features", JsonString(mapper.GetFeatures()) },
    { "left_out", JsonString(mapper.GetLeftOut()) },
    { "setup_ms.upload", JsonNumber(costs.UploadMs) },
    { "setup_ms.tables", JsonNumber(costs.TablesMs) },
    { "setup_ms.grid", JsonNumber(costs.GridMs) },
    { "setup_ms.compile", JsonNumber(costs.CompileMs) },
    { "bytes_on_device", JsonNumber(static_cast<double>(costs.BytesOnDevice)) } });
}

// Lets our visible volumes draw their counts while in scope.
class CountingMappers
{
public:
  explicit CountingMappers(vtkRenderer* renderer)
    : Mappers(OurMappers(renderer))
  {
    this->Set(true);
  }
  ~CountingMappers() { this->Set(false); }
  CountingMappers(const CountingMappers&) = delete;
  CountingMappers& operator=(const CountingMappers&) = delete;

private:
  void Set(bool count)
  {
    for (vtkVolumeBenchMapper* mapper : this->Mappers)
    {
      mapper->SetCountSamples(count);
    }
  }

  std::vector<vtkVolumeBenchMapper*> Mappers;
};

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
    std::unique_ptr<CountingMappers> counting;
    if (this->CountSamples)
    {
      counting = std::make_unique<CountingMappers>(renderer);
      counted = std::make_unique<CountedVolumes>(renderer);
    }
    volumebench::WriteFloatPicture(volumebench::RenderToFloat(renderer), this->FileName);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("View not captured: " << error.what());
  }
}

const char* vtkVolumeBenchViewCapture::GetDescription()
{
  const auto mappers =
    this->View ? OurMappers(this->View->GetRenderer()) : std::vector<vtkVolumeBenchMapper*>();
  this->Description = mappers.size() == 1 ? DescriptionOf(*mappers.front()) : "{}";
  return this->Description.c_str();
}

void vtkVolumeBenchViewCapture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
