#include "vtkVolumeBenchRankBlender.h"

#include "Gpu/LayerPicture.h"
#include "RankPictures.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkVolumeBenchRankBlender);

vtkVolumeBenchRankBlender::vtkVolumeBenchRankBlender()
  : Layer(std::make_shared<volumebench::LayerPicture>())
{
  this->PickableOff();
  this->DragableOff();
}

vtkVolumeBenchRankBlender::~vtkVolumeBenchRankBlender() = default;

void vtkVolumeBenchRankBlender::Begin(
  const std::vector<vtkBoundingBox>& ranks, const vtkBoundingBox& bounds)
{
  this->Order->SetBoundingBoxes(ranks);
  bounds.GetBounds(this->Bounds);
  this->Layer->Begin();
}

int vtkVolumeBenchRankBlender::RenderVolumetricGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || renderer->GetSelector())
  {
    return 0;
  }
  const volumebench::RankPicture own{ this->Layer->Read(window),
    volumebench::LayerPicture::ReadOpacity(window) };
  const volumebench::PlacedPicture shown =
    volumebench::BlendAcrossRanks(own, this->Order->ComputeSortOrder(renderer->GetActiveCamera()));
  if (!shown.Picture.Pixels.empty())
  {
    this->Layer->Show(window, shown.Picture, shown.Left, shown.Bottom);
  }
  this->Layer->Begin(); // for the other eye
  return 1;
}

void vtkVolumeBenchRankBlender::ReleaseGraphicsResources(vtkWindow* window)
{
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (glWindow)
  {
    glWindow->MakeCurrent();
  }
  glWindow ? this->Layer->Release() : this->Layer->Forget();
}

void vtkVolumeBenchRankBlender::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bounds: " << this->Bounds[0] << " to " << this->Bounds[1] << ", "
     << this->Bounds[2] << " to " << this->Bounds[3] << ", " << this->Bounds[4] << " to "
     << this->Bounds[5] << "\n";
}
