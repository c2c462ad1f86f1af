#include "Stability/Trial.h"

#include "TechniqueSettings.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderer.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
ContestantInput InputOf(const Shot& shot)
{
  ContestantInput input;
  input.Image = shot.Image;
  input.ArrayName = "field";
  input.CellArray = shot.OnCells;
  input.Property = shot.Property;
  return input;
}

void KeepError(vtkObject*, unsigned long, void* errors, void* message)
{
  auto& text = *static_cast<std::string*>(errors);
  text = text.empty() && message ? static_cast<const char*>(message) : text;
}

// No warnings while a peer draws: VTK's mappers warn of what a case does to them on purpose.
class QuietPeer
{
public:
  explicit QuietPeer(bool peer)
    : Before(vtkObject::GetGlobalWarningDisplay())
  {
    vtkObject::SetGlobalWarningDisplay(peer ? 0 : this->Before);
  }
  ~QuietPeer() { vtkObject::SetGlobalWarningDisplay(this->Before); }

private:
  int Before;
};

// VTK's messages on one line without the file, line and object they begin with.
std::string OneLine(std::string message)
{
  const std::size_t begin = message.find("): ");
  message.erase(0, begin == std::string::npos ? 0 : begin + 3);
  std::replace(message.begin(), message.end(), '\n', ' ');
  message.erase(message.find_last_not_of(' ') + 1);
  return message;
}
}

Trial::Trial(Stage& stage, const Subject& subject, bool quick)
  : Scene(stage)
  , Tried(subject)
  , Quick(quick)
{
}

Trial::~Trial()
{
  if (this->Drawn)
  {
    this->Scene.Remove(*this->Drawn);
  }
}

vtkVolumeBenchMapper* Trial::GetMapper()
{
  return this->Drawn ? this->Drawn->GetMapper() : nullptr;
}

FloatPicture Trial::Draw(const Shot& shot)
{
  this->Arrange(shot);
  this->Errors.clear();
  const QuietPeer quiet(this->Tried.Peer);
  FloatPicture picture = this->Scene.Picture();
  vtkRenderer* renderer = this->Scene.GetRenderer();
  if (shot.Opaque)
  {
    renderer->RemoveViewProp(shot.Opaque);
  }
  vtkVolumeBenchMapper* mapper = this->GetMapper();
  if (mapper && !mapper->GetFailure().empty())
  {
    throw Refusal(mapper->GetFailure(), mapper->GetUnsupported());
  }
  if (!this->Errors.empty())
  {
    throw Refusal(OneLine(this->Errors), false);
  }
  return picture;
}

void Trial::Arrange(const Shot& shot)
{
  if (!this->Drawn)
  {
    this->Drawn = std::make_unique<Contestant>(this->Tried.Technique, InputOf(shot));
    if (!this->Drawn->GetUnsupported().empty())
    {
      throw Refusal(this->Drawn->GetUnsupported(), true);
    }
    this->Scene.Add(*this->Drawn);
    this->Scene.Show(*this->Drawn);
    // Errors that somebody observes are not printed: they belong into the result.
    vtkNew<vtkCallbackCommand> keep;
    keep->SetCallback(KeepError);
    keep->SetClientData(&this->Errors);
    this->Drawn->GetVolume()->GetMapper()->AddObserver(vtkCommand::ErrorEvent, keep);
  }
  this->ArrangeMapper(shot);
  this->ArrangeView(shot);
}

void Trial::ArrangeMapper(const Shot& shot)
{
  // A property counts as changed when it is set again, and then its tables are made anew.
  if (shot.Image != this->Image || shot.Property != this->Property || shot.Blocks)
  {
    this->Drawn->SetInput(shot.Image, shot.Property);
    this->Image = shot.Blocks ? nullptr : shot.Image;
    this->Property = shot.Property;
  }
  this->Drawn->SetStepVoxels(shot.StepVoxels);
  vtkVolume* volume = this->Drawn->GetVolume();
  volume->SetUserMatrix(shot.ActorMatrix);
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  mapper->SetScalarMode(
    shot.OnCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  const std::array<double, 6>& crop = shot.CropBox;
  mapper->SetCropping(crop[1] > crop[0]);
  mapper->SetCroppingRegionFlagsToSubVolume();
  mapper->SetCroppingRegionPlanes(crop[0], crop[1], crop[2], crop[3], crop[4], crop[5]);
  vtkVolumeBenchMapper* ours = this->GetMapper();
  if (!ours)
  {
    if (shot.AdjustPeer)
    {
      shot.AdjustPeer(*mapper);
    }
    return;
  }
  ours->SetIntegrator(std::max(this->Tried.Integrator, 0));
  ApplySettings(TechniqueSettings{}, *ours);
  ours->SetTerminationThreshold(0.0);
  ours->SetRaySetUp(1);
  if (shot.Blocks)
  {
    ours->SetInputDataObject(shot.Blocks);
  }
  if (shot.Adjust)
  {
    shot.Adjust(*ours);
  }
}

void Trial::ArrangeView(const Shot& shot)
{
  const std::array<double, 2>& corner = shot.ViewportCorner;
  this->Scene.Resize(static_cast<int>(std::lround(shot.Width / (1.0 - corner[0]))),
    static_cast<int>(std::lround(shot.Height / (1.0 - corner[1]))));
  vtkRenderer* renderer = this->Scene.GetRenderer();
  renderer->SetViewport(corner[0], corner[1], 1.0, 1.0);
  renderer->SetActiveCamera(shot.Camera);
  renderer->RemoveAllLights();
  renderer->SetAutomaticLightCreation(!shot.Light);
  if (shot.Light)
  {
    renderer->AddLight(shot.Light);
  }
  if (shot.Opaque)
  {
    renderer->AddViewProp(shot.Opaque);
  }
}

double WorstDifference(const FloatPicture& picture, const ExpectedPixel& expected)
{
  double worst = 0.0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const Pixel pixel = PixelAt(picture, x, y);
      const glm::dvec4 difference =
        glm::dvec4(pixel.Red, pixel.Green, pixel.Blue, pixel.Alpha) - expected(x + 0.5, y + 0.5);
      for (int channel = 0; channel < 4; ++channel)
      {
        if (std::isnan(difference[channel]))
        {
          return std::numeric_limits<double>::quiet_NaN();
        }
        worst = std::max(worst, std::abs(difference[channel]));
      }
    }
  }
  return worst;
}

double WorstDifference(const FloatPicture& a, const FloatPicture& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    throw std::invalid_argument("pictures of different sizes cannot be compared");
  }
  return WorstDifference(a,
    [&b](double x, double y)
    {
      const Pixel pixel = PixelAt(b, static_cast<int>(x), static_cast<int>(y));
      return glm::dvec4(pixel.Red, pixel.Green, pixel.Blue, pixel.Alpha);
    });
}
}
