// What every technique can do. A technique holds GPU objects but no settings: those are the Scene.
#ifndef volumebench_Technique_h
#define volumebench_Technique_h

#include "Bricks/BrickPlan.h"
#include "Scene/Features.h"
#include "Scene/Scene.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;

namespace volumebench
{
/// What the technique spends before a frame, each as of the last time that it had to be done; NaN
/// where it has no such step.
struct SetUpCosts
{
  double UploadMs = std::numeric_limits<double>::quiet_NaN();
  double TablesMs = std::numeric_limits<double>::quiet_NaN();
  double GridMs = std::numeric_limits<double>::quiet_NaN();
  double CompileMs = std::numeric_limits<double>::quiet_NaN();
  std::size_t BytesOnDevice = 0;
};

/// One stage of a frame, such as a pass or the making of geometry.
struct StageTime
{
  std::string Name;
  double Ms = 0.0;
};

class Technique
{
public:
  virtual ~Technique() = default;

  /// Empty when this machine can run the technique; else the sentence that says why not. The
  /// context is current.
  virtual std::string WhyUnsupported(vtkOpenGLRenderWindow*) const { return this->WhyNoDevice(); }

  /// Empty when there is the device that the technique needs beside OpenGL's, if it needs one; else
  /// the sentence that says why not. Asks no context.
  virtual std::string WhyNoDevice() const { return {}; }

  /// What results say of a device that is not OpenGL's; empty for a technique without one.
  virtual std::string GetDeviceName() const { return {}; }

  /// Whether its steps may have different lengths, as the cells of a graded CellMap say.
  virtual bool StepsMayVary() const { return false; }

  /// Whether its samples count from where rays enter the volume, so that it can draw a share of one.
  virtual bool DrawsShares() const { return false; }

  /// What its device has room for of the scene's volume, which is divided into bricks where that is
  /// less; nothing for a technique that reads the volume where it is. The context is current.
  virtual std::optional<VolumeRoom> RoomFor(const Scene&) const { return {}; }

  /// Uploads and compiles what the scene changed. Throws SceneError or KernelError.
  virtual void Prepare(const Scene& scene, vtkOpenGLRenderWindow* window) = 0;

  /// Blends the premultiplied picture over the bound framebuffer; the GL state is left as found.
  virtual void Render(const Scene& scene, vtkOpenGLRenderWindow* window) = 0;

  virtual SetUpCosts GetSetUpCosts() const = 0;

  /// Stages of the last frame whose scene asked for them; empty for a technique with one stage.
  virtual std::vector<StageTime> GetStages() const { return {}; }

  /// Who is to be told the share in [0, 1] of a frame that takes long.
  void SetProgress(std::function<void(double)> progress) { this->Progress = std::move(progress); }

  /// Features compiled into the kernel that drew last.
  virtual FeatureSet GetFeatures() const = 0;

  /// Deletes all GPU objects; their context is current.
  virtual void Release() = 0;
  /// Drops all GPU objects of a context that no longer exists.
  virtual void Forget() = 0;

protected:
  void ReportProgress(double share) const
  {
    if (this->Progress)
    {
      this->Progress(share);
    }
  }

private:
  std::function<void(double)> Progress;
};
}

#endif
