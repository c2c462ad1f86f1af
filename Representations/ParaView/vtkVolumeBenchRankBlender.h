/**
 * @class   vtkVolumeBenchRankBlender
 * @brief   blends the volumes of all ranks before ParaView blends the ranks' pictures
 *
 * ParaView puts the ranks' pictures together in 8 bits and rounds down each time, so that thin
 * media get darker with every rank behind another, by half a level each. This prop comes after the
 * volumes of a view, which draw into its layer, and lets the ranks exchange their layers in float.
 * Each then draws what leaves ParaView nothing to round.
 *
 * All ranks have to render it, and no rank alone: its bounds are those of all ranks' volumes.
 */
#ifndef vtkVolumeBenchRankBlender_h
#define vtkVolumeBenchRankBlender_h

#include "vtkBoundingBox.h" // for a member
#include "vtkNew.h"         // for a member
#include "vtkProp.h"

#include <memory> // for the layer
#include <vector> // for boxes

namespace volumebench
{
class LayerPicture;
}

class vtkOrderedCompositingHelper;

class vtkVolumeBenchRankBlender : public vtkProp
{
public:
  static vtkVolumeBenchRankBlender* New();
  vtkTypeMacro(vtkVolumeBenchRankBlender, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Empties the layer for a frame in which the ranks draw what is in these boxes, one each, and
   * volumes are in the bounds.
   */
  void Begin(const std::vector<vtkBoundingBox>& ranks, const vtkBoundingBox& bounds);

  const std::shared_ptr<volumebench::LayerPicture>& GetLayer() { return this->Layer; }

  using Superclass::GetBounds;
  double* GetBounds() override { return this->Bounds; }
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasOpaqueGeometry() override { return 0; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkVolumeBenchRankBlender();
  ~vtkVolumeBenchRankBlender() override;

private:
  vtkVolumeBenchRankBlender(const vtkVolumeBenchRankBlender&) = delete;
  void operator=(const vtkVolumeBenchRankBlender&) = delete;

  std::shared_ptr<volumebench::LayerPicture> Layer;
  vtkNew<vtkOrderedCompositingHelper> Order; // as ParaView sorts the ranks
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

#endif
