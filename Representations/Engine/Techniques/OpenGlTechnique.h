// What all techniques on OpenGL share: the scene's textures and numbers on the device, programs
// compiled once for each set of features, and drawing over the window with its state left as found.
// A technique adds its kernels and the order in which it draws them.
#ifndef volumebench_OpenGlTechnique_h
#define volumebench_OpenGlTechnique_h

#include "Bricks/BrickPicture.h"
#include "Gpu/FrameStages.h"
#include "Gpu/GlTexture.h"
#include "Gpu/KernelPrograms.h"
#include "Gpu/OpaqueDepth.h"
#include "Gpu/SceneBuffer.h"
#include "Gpu/SceneTextures.h"
#include "Techniques/BoxFaces.h"
#include "Techniques/Technique.h"

#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace volumebench
{
class OpenGlTechnique : public Technique
{
public:
  std::optional<VolumeRoom> RoomFor(const Scene& scene) const override;
  void Prepare(const Scene& scene, vtkOpenGLRenderWindow* window) final;
  void Render(const Scene& scene, vtkOpenGLRenderWindow* window) final;
  SetUpCosts GetSetUpCosts() const override;
  std::vector<StageTime> GetStages() const final { return this->LastStages; }
  FeatureSet GetFeatures() const final { return this->Features | this->HostFeatures; }
  void Release() final;
  void Forget() final;

protected:
  /// What the kernels of this technique take of the scene's features; all unless overridden.
  virtual FeatureSet FeaturesFor(const Scene& scene) const { return FeaturesNeededBy(scene); }

  /// Features of the scene that this technique serves on the host, with no kernel of theirs.
  virtual FeatureSet HostFeaturesFor(const Scene&) const { return {}; }

  /// Whether the kernels read the volume and its functions from textures; without, none are made.
  virtual bool ReadsTextures() const { return true; }

  /// Whether they read texels at all, which hold 16 or 32 bits of a value.
  virtual bool ReadsTexels() const { return true; }

  /// Whether what the tables show as empty may be left out; not where no table is looked up.
  virtual bool LeavesSpaceOut() const { return true; }

  /// Asks for the programs of the frame by ProgramOf, so that drawing compiles nothing.
  virtual void Compile(const Scene& scene) = 0;

  /// Draws. `rectangle` (x, y, width, height in window pixels) holds all that can be seen of the
  /// volume and is not empty; the scene's block is bound. Textures of the technique's own, one
  /// texel to a pixel, hold what BoxRectangle gives, so that rounding does not depend on what is
  /// seen.
  virtual void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) = 0;

  ///@{
  /// GPU objects that the technique has beside those of this class.
  virtual void ReleaseOwn() {}
  virtual void ForgetOwn() {}
  virtual std::size_t GetOwnBytes() const { return 0; }
  ///@}

  /// The program of these entry files (.vert, .frag, .comp) with the features in use; `defines` is
  /// put in front of each. Compiled when it is asked for the first time.
  const GlProgram& ProgramOf(
    const std::vector<const char*>& entries, const std::string& defines = {});

  /// Binds the program and the textures that its features read.
  void BindWithScene(const GlProgram& program, vtkOpenGLRenderWindow* window, TextureUnits& units);

  /// Draws one triangle over the viewport; scissored to `rectangle` unless that is null.
  void DrawTriangle(vtkOpenGLRenderWindow* window, const glm::ivec4* rectangle);

  /// Draws the faces of the volume's box that look away from the camera (`back`) or towards it.
  void DrawBoxFaces(const Scene& scene, vtkOpenGLRenderWindow* window, bool back);

  /// Fills the pixels of `rectangle` in `faces`, as a stage of the frame.
  void FillBoxFaces(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle,
    BoxFaces& faces);
  BoxFaces::Programs BoxFacePrograms();

  /// Blends premultiplied colour over what is there, or what a brick shows with what those before
  /// it do; depth is not tested.
  void BlendPicture(vtkOpenGLRenderWindow* window);
  static void BlendOff(vtkOpenGLRenderWindow* window);

  /// Turns what rays have gathered into their colour, and blends that over the pixels of
  /// `rectangle`. The texture begins at the pixel `first`.
  void Finish(vtkOpenGLRenderWindow* window, GlTexture& gathered, glm::ivec2 first,
    const glm::ivec4& rectangle);

  /// Blends a picture of all that the box covers over the pixels of `rectangle`, as stage
  /// "display".
  void DisplayPicture(
    vtkOpenGLRenderWindow* window, GlTexture& picture, const glm::ivec4& rectangle);

  /// The scene's numbers while it is drawn, as PackScene gives them.
  const SceneBlock64& GetNumbers() const { return this->Numbers.GetNumbers(); }

  FrameStages& GetFrameStages() { return this->Stages; }

  /// The depth of opaque geometry, of this frame if the features ask for it.
  OpaqueDepth& GetDepth() { return this->Depth; }

private:
  void Load(const Scene& scene);
  void LoadBricks(const Scene& scene);
  void DrawPart(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle);
  void DrawBricks(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle);

  SceneTextures Textures;
  BrickPicture Gathered;
  SceneBuffer Numbers;
  OpaqueDepth Depth;
  FrameStages Stages;
  std::vector<StageTime> LastStages;
  KernelPrograms Programs;
  FeatureSet Features;     // compiled into the kernels
  FeatureSet HostFeatures; // served without
  double HostGridMs = std::numeric_limits<double>::quiet_NaN();
};
}

#endif
