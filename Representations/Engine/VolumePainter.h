// Draws all blocks of a mapper's input over each other, each by an instance of the same technique.
#ifndef volumebench_VolumePainter_h
#define volumebench_VolumePainter_h

#include "Gpu/GlTimer.h"
#include "Gpu/OffscreenPicture.h"
#include "Gpu/SelectionMask.h"
#include "Interaction/InteractiveFrames.h"
#include "Scene/Blocks.h"
#include "Scene/FeatureWords.h"
#include "Scene/SceneBuilder.h"
#include "Techniques/Technique.h"

#include "vtkWeakPointer.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeBenchMapper;

namespace volumebench
{
class VolumePainter
{
public:
  /// Blends the picture over the bound framebuffer. Throws SceneError, UnsupportedError or
  /// KernelError.
  void Draw(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

  /// Marks where the picture is visible, at the depth where the rays enter the blocks: for
  /// selection passes. Points and cells have numbers in images that are whole and no blocks.
  void Mark(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const SelectionMark& mark);

  /// Draws the picture with a technique beside the window, hidden by what the window shows as the
  /// picture in it is, and waits until it is done. With CountSamples it is one of counts.
  void DrawOffscreen(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const std::string& technique, const Measurement& measurement = {});

  /// What DrawOffscreen drew.
  FloatPicture ReadOffscreen();

  /// Of all that the picture depends on.
  ChangeStamp StampOf(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

  /// Whether the last picture was a coarse one before a still one, which will be asked for.
  bool IsPreview() const { return this->Frames.IsCoarse(); }

  /// GPU objects go with the context that made them: deleted while it lives, dropped when it is
  /// gone.
  void ReleaseGpu();
  vtkOpenGLRenderWindow* GetWindow() const;

  ///@{
  /// Of the last picture, over all its blocks: features that any used, and sums of what they cost.
  bool HasDrawn() const { return !this->Parts.empty(); }
  FeatureSet GetFeatures() const;
  SetUpCosts GetSetUpCosts() const;
  std::vector<StageTime> GetStages() const;
  /// Features that no block used, and why the first did not.
  std::vector<LeftOutFeature> GetLeftOut() const;
  ///@}

  /// Of the last picture whose steps an error target chose, of the worst of its blocks; NaN of
  /// others.
  double GetExpectedError() const;

  /// Samples that have the last colour in the last picture; NaN unless it shows samples.
  double GetFullScaleSamples() const { return this->FullScaleSamples; }

  /// From the beginning of the last still picture drawn with the mapper's TimeFrames on until the
  /// device was done with it; NaN when there is none. Waits for the device.
  double GetFrameMs();

private:
  struct Part
  {
    SceneBuilder Builder;
    std::unique_ptr<volumebench::Technique> Technique;
    std::string Name;    // of the block, for messages
    FeatureSet Features; // of the last picture in the window
    double ExpectedError = 0.0;
    std::vector<LeftOutFeature> LeftOut;
  };

  struct PartScene
  {
    Part* Drawn;
    volumebench::Scene Scene;
  };

  void UseTechnique(const std::string& id);
  void UseWindow(vtkRenderer* renderer);
  void PrepareAll(const std::vector<PartScene>& scenes);
  void RenderAll(const std::vector<PartScene>& scenes, vtkVolumeBenchMapper* mapper);
  void UseBlocks(const std::vector<Block>& blocks);
  std::vector<PartScene> ScenesBackToFront(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer,
    vtkVolume* volume, const glm::ivec4& viewport, double stepFactor = 1.0);
  std::vector<PartScene> ArrangeFrame(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer,
    vtkVolume* volume, const glm::ivec4& viewport, glm::ivec4& drawn);
  ChangeStamp StampOf(const std::vector<PartScene>& scenes) const;

  std::string TechniqueId;                  // of the technique in use
  std::vector<std::unique_ptr<Part>> Parts; // one for each block
  OffscreenPicture Offscreen;
  SelectionMask Selection;
  GlTimer Timer;
  InteractiveFrames Frames;
  double FullScaleSamples = std::numeric_limits<double>::quiet_NaN();
  OpaqueDepth Depth;                            // that a stamp is of
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose context holds the GPU objects
};
}

#endif
