#include "vtkVolumeBenchMapper.h"

#include "Error/ErrorEstimator.h"
#include "Gpu/LayerPicture.h"
#include "Questions/SampleCounter.h"
#include "VolumePainter.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <new>

vtkStandardNewMacro(vtkVolumeBenchMapper);

struct vtkVolumeBenchMapper::Internals
{
  volumebench::VolumePainter Painter;
  volumebench::ErrorEstimator Estimator;
  std::shared_ptr<volumebench::LayerPicture> Layer;
  volumebench::SampleCounter Counter;
  std::string Failure;
  bool Unsupported = false;

  bool HasPicture() const { return this->Failure.empty() && this->Painter.HasDrawn(); }
  void DrawOrMark(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
};

vtkVolumeBenchMapper::vtkVolumeBenchMapper()
  : Internal(std::make_unique<Internals>())
{
}

vtkVolumeBenchMapper::~vtkVolumeBenchMapper()
{
  this->Internal->Painter.ReleaseGpu();
}

namespace
{
// The second pass of an id is drawn for those alone that have told large ones.
volumebench::SelectionMark MarkFor(vtkHardwareSelector* selector, vtkDataSet* data)
{
  using Content = volumebench::SelectionMark::Content;
  constexpr int BitsOfPass = 24;
  if (data)
  {
    selector->UpdateMaximumPointId(data->GetNumberOfPoints());
    selector->UpdateMaximumCellId(data->GetNumberOfCells());
  }
  volumebench::SelectionMark mark;
  mark.BeginsSelection = selector->GetCurrentPass() == vtkHardwareSelector::ACTOR_PASS;
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::ACTOR_PASS:
    case vtkHardwareSelector::PROCESS_PASS:
      selector->GetPropColorValue(glm::value_ptr(mark.Color));
      break;
    case vtkHardwareSelector::POINT_ID_LOW24:
      mark.Asks = Content::PointId;
      break;
    case vtkHardwareSelector::POINT_ID_HIGH24:
      mark.Asks = Content::PointId;
      mark.FirstBit = BitsOfPass;
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
      mark.Asks = Content::CellId;
      break;
    case vtkHardwareSelector::CELL_ID_HIGH24:
      mark.Asks = Content::CellId;
      mark.FirstBit = BitsOfPass;
      break;
    default:
      break;
  }
  return mark;
}
}

void vtkVolumeBenchMapper::Internals::DrawOrMark(
  vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto draw = [&] { this->Painter.Draw(mapper, renderer, volume); };
  if (!selector)
  {
    this->Layer&& window ? this->Layer->Draw(window, draw) : draw();
    return;
  }
  selector->BeginRenderProp();
  const volumebench::SelectionMark mark = MarkFor(selector, mapper->GetDataSetInput());
  try
  {
    this->Painter.Mark(mapper, renderer, volume, mark);
  }
  catch (...)
  {
    selector->EndRenderProp();
    throw;
  }
  selector->EndRenderProp();
}

void vtkVolumeBenchMapper::SetLayer(const std::shared_ptr<volumebench::LayerPicture>& layer)
{
  this->Internal->Layer = layer;
}

void vtkVolumeBenchMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  std::string failure;
  bool aborted = false;
  this->Internal->Unsupported = false;
  try
  {
    this->Internal->DrawOrMark(this, renderer, volume);
  }
  catch (const volumebench::UnsupportedError& error)
  {
    failure = error.what();
    this->Internal->Unsupported = true;
  }
  catch (const volumebench::AbortedError& error)
  {
    failure = error.what();
    aborted = true;
  }
  catch (const std::bad_alloc&)
  {
    failure = "this machine has not enough memory to draw " +
      std::to_string(this->GetDataObjectInput()->GetNumberOfElements(vtkDataObject::POINT)) +
      " points with technique '" + this->Technique + "'";
  }
  catch (const std::exception& error)
  {
    failure = error.what();
  }
  // Once per cause, not once per frame; an abort is no error.
  if (!aborted && !failure.empty() && failure != this->Internal->Failure)
  {
    vtkErrorMacro("Volume not drawn: " << failure);
  }
  this->Internal->Failure = failure;
  if (!renderer->GetSelector())
  {
    this->Internal->Estimator.FollowFrame(this, renderer, volume, this->Internal->Painter, failure);
    this->Internal->Counter.FollowFrame(this, renderer, volume, this->Internal->Painter, failure);
  }
}

void vtkVolumeBenchMapper::EstimateError()
{
  this->Internal->Estimator.Request();
}

volumebench::ErrorEstimate vtkVolumeBenchMapper::GetErrorEstimate()
{
  return this->Internal->Estimator.Get(this);
}

void vtkVolumeBenchMapper::AskForSamples()
{
  this->Internal->Counter.Request();
}

volumebench::SamplesTaken vtkVolumeBenchMapper::GetSamplesTaken()
{
  return this->Internal->Counter.Get(this);
}

void vtkVolumeBenchMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window == this->Internal->Painter.GetWindow())
  {
    this->Internal->Painter.ReleaseGpu();
  }
}

const std::string& vtkVolumeBenchMapper::GetFailure() const
{
  return this->Internal->Failure;
}

bool vtkVolumeBenchMapper::GetUnsupported() const
{
  return this->Internal->Unsupported;
}

namespace
{
std::string Joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}
}

std::string vtkVolumeBenchMapper::GetFeatures() const
{
  const volumebench::VolumePainter& painter = this->Internal->Painter;
  return painter.HasDrawn() ? Joined(volumebench::FeatureNames(painter.GetFeatures(), true))
                            : std::string();
}

std::string vtkVolumeBenchMapper::GetLeftOut() const
{
  const volumebench::VolumePainter& painter = this->Internal->Painter;
  return painter.HasDrawn() ? Joined(volumebench::FeatureNames(painter.GetFeatures(), false))
                            : std::string();
}

std::string vtkVolumeBenchMapper::GetUsedText() const
{
  const volumebench::VolumePainter& painter = this->Internal->Painter;
  return this->Internal->HasPicture() ? volumebench::LabelsOf(painter.GetFeatures())
                                      : std::string();
}

std::string vtkVolumeBenchMapper::GetLeftOutText() const
{
  const volumebench::VolumePainter& painter = this->Internal->Painter;
  return this->Internal->HasPicture() ? volumebench::LinesOf(painter.GetLeftOut()) : std::string();
}

double vtkVolumeBenchMapper::GetFrameMs() const
{
  return this->Internal->HasPicture() ? this->Internal->Painter.GetFrameMs() : vtkMath::Nan();
}

double vtkVolumeBenchMapper::GetExpectedError() const
{
  return this->Internal->HasPicture() ? this->Internal->Painter.GetExpectedError() : vtkMath::Nan();
}

double vtkVolumeBenchMapper::GetFullScaleSamples() const
{
  return this->Internal->HasPicture() ? this->Internal->Painter.GetFullScaleSamples()
                                      : vtkMath::Nan();
}

volumebench::SetUpCosts vtkVolumeBenchMapper::GetSetUpCosts() const
{
  return this->Internal->Painter.GetSetUpCosts();
}

std::vector<volumebench::StageTime> vtkVolumeBenchMapper::GetStages() const
{
  return this->Internal->Painter.GetStages();
}

vtkDataSet* vtkVolumeBenchMapper::GetInput()
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(this->GetDataObjectInput());
  if (!composite)
  {
    return this->Superclass::GetInput();
  }
  const std::vector<vtkDataSet*> blocks = vtkCompositeDataSet::GetDataSets(composite);
  return blocks.empty() ? nullptr : blocks.front();
}

double* vtkVolumeBenchMapper::GetBounds()
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(this->GetDataObjectInput());
  if (!composite)
  {
    double* bounds = this->Superclass::GetBounds();
    // VTK leaves out what has such bounds, and nobody would say why; nor should cameras follow
    // them.
    if (bounds &&
      !std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); }))
    {
      vtkMath::UninitializeBounds(this->Bounds);
      return this->Bounds;
    }
    return bounds;
  }
  this->Update();
  vtkBoundingBox box;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(composite))
  {
    double bounds[6];
    block->GetBounds(bounds);
    box.AddBounds(bounds);
  }
  vtkMath::UninitializeBounds(this->Bounds);
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
  return this->Bounds;
}

int vtkVolumeBenchMapper::FillInputPortInformation(int port, vtkInformation* information)
{
  if (!this->Superclass::FillInputPortInformation(port, information))
  {
    return 0;
  }
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkVolumeBenchMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Technique << "\n";
  os << indent << "Integrator: " << this->Integrator << "\n";
  os << indent << "StepVoxels: " << this->StepVoxels << "\n";
  os << indent << "ErrorTarget: " << this->ErrorTarget << "\n";
  os << indent << "Jitter: " << this->Jitter << "\n";
  os << indent << "JitterSeed: " << this->JitterSeed << "\n";
  os << indent << "TableSize: " << this->TableSize << "\n";
  os << indent << "Skipping: " << this->Skipping << "\n";
  os << indent << "MacrocellVoxels: " << this->MacrocellVoxels << "\n";
  os << indent << "TerminationThreshold: " << this->TerminationThreshold << "\n";
  os << indent << "RaySetUp: " << this->RaySetUp << "\n";
  os << indent << "WorkGroupShape: " << this->WorkGroupShape << "\n";
  os << indent << "OpenClDevice: " << this->OpenClDevice << "\n";
  os << indent << "OpenClStorage: " << this->OpenClStorage << "\n";
  os << indent << "VoxelOrder: " << this->VoxelOrder << "\n";
  os << indent << "PictureTransfer: " << this->PictureTransfer << "\n";
  os << indent << "SliceExtent: " << this->SliceExtent << "\n";
  os << indent << "SliceThreads: " << this->SliceThreads << "\n";
  os << indent << "SliceTarget: " << this->SliceTarget << "\n";
  os << indent << "SliceOrder: " << this->SliceOrder << "\n";
  os << indent << "ReferenceMethod: " << this->ReferenceMethod << "\n";
  os << indent << "LightingDamping: " << this->LightingDamping << "\n";
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "Failure: " << this->Internal->Failure << "\n";
}
