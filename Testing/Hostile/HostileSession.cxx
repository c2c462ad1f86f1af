#include "HostileSession.h"

#include "vtkLightCollection.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOutputWindow.h"
#include "vtkPlaneCollection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace volumebench::test
{
namespace
{
// Keeps our own messages and drops VTK's, which hostile input makes many of.
class MessageKeeper : public vtkOutputWindow
{
public:
  static MessageKeeper* New();
  std::vector<std::string> Messages;

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    static const std::string ours = "Volume not drawn: ";
    std::string message = text;
    const std::size_t begin = message.find(ours);
    if (begin != std::string::npos)
    {
      message = message.substr(begin + ours.size());
      message.erase(message.find_last_not_of('\n') + 1);
      this->Messages.push_back(message);
    }
  }
};
vtkStandardNewMacro(MessageKeeper);

MessageKeeper* Keeper()
{
  static const vtkSmartPointer<MessageKeeper> keeper = []
  {
    auto made = vtkSmartPointer<MessageKeeper>::New();
    vtkOutputWindow::SetInstance(made);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    return made;
  }();
  return keeper;
}

vtkSmartPointer<vtkVolumeProperty> GoodProperty()
{
  return MakeProperty({ { 0.0, 0.0 }, { 1.0, 0.02 }, { 3.0, 0.2 }, { 4.0, 0.4 } },
    { { 0.0, { 0.1, 0.2, 0.9 } }, { 2.0, { 0.9, 0.8, 0.1 } }, { 4.0, { 0.8, 0.1, 0.2 } } });
}

float LargestAlpha(const FloatPicture& picture)
{
  float largest = 0.0f;
  for (std::size_t i = 3; i < picture.Pixels.size(); i += 4)
  {
    largest = std::max(largest, picture.Pixels[i]);
  }
  return largest;
}

void ExpectColors(const FloatPicture& picture)
{
  const auto wrong = std::find_if(picture.Pixels.begin(), picture.Pixels.end(),
    [](float value) { return !(value >= 0.0f && value <= 1.0f + 1e-6f); });
  EXPECT_TRUE(wrong == picture.Pixels.end()) << *wrong << " is no colour";
}
}

vtkStandardNewMacro(HostileMapper);

void HostileMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Fault)
  {
    this->Fault->Begin(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  }
  this->StateChecker::Render(renderer, volume);
  if (this->Fault)
  {
    this->Fault->End();
  }
}

HostileSession::HostileSession(const std::string& technique)
  : Technique(technique)
  , Image(MakeImage(12, 10, 8, Bumpy))
  , Property(GoodProperty())
{
  this->Window->SetShowWindow(false);
  this->Window->SetUseOffScreenBuffers(true);
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AddVolume(this->Volume);
  this->ArrangeGood();
  this->Good = this->Draw();
  EXPECT_TRUE(this->Messages.empty());
  EXPECT_GT(LargestAlpha(this->Good), 0.5f);
}

HostileSession& HostileSession::Of(const std::string& technique)
{
  // Never deleted: drivers end before statics of the process do.
  static auto* sessions = new std::map<std::string, std::unique_ptr<HostileSession>>;
  std::unique_ptr<HostileSession>& session = (*sessions)[technique];
  if (!session)
  {
    session = std::make_unique<HostileSession>(technique);
  }
  return *session;
}

void HostileSession::ArrangeMapper()
{
  vtkVolumeBenchMapper* mapper = this->Mapper;
  const auto fresh = vtkSmartPointer<vtkVolumeBenchMapper>::New();
  mapper->SetTechnique(this->Technique.c_str());
  mapper->SetIntegrator(fresh->GetIntegrator());
  mapper->SetStepVoxels(fresh->GetStepVoxels());
  mapper->SetErrorTarget(fresh->GetErrorTarget());
  mapper->SetJitter(fresh->GetJitter());
  mapper->SetJitterSeed(fresh->GetJitterSeed());
  mapper->SetTableSize(fresh->GetTableSize());
  mapper->SetSkipping(fresh->GetSkipping());
  mapper->SetMacrocellVoxels(fresh->GetMacrocellVoxels());
  mapper->SetTerminationThreshold(fresh->GetTerminationThreshold());
  mapper->SetRaySetUp(fresh->GetRaySetUp());
  mapper->SetVectorMode(fresh->GetVectorMode());
  mapper->SetVectorComponent(fresh->GetVectorComponent());
  mapper->SetWorkGroupShape(fresh->GetWorkGroupShape());
  mapper->SetOpenClDevice(fresh->GetOpenClDevice());
  mapper->SetOpenClStorage(fresh->GetOpenClStorage());
  mapper->SetVoxelOrder(fresh->GetVoxelOrder());
  mapper->SetPictureTransfer(fresh->GetPictureTransfer());
  mapper->SetSliceExtent(fresh->GetSliceExtent());
  mapper->SetSliceThreads(fresh->GetSliceThreads());
  mapper->SetSliceTarget(fresh->GetSliceTarget());
  mapper->SetSliceOrder(fresh->GetSliceOrder());
  mapper->SetReferenceMethod(fresh->GetReferenceMethod());
  mapper->SetLightingDamping(fresh->GetLightingDamping());
  mapper->SetCountSamples(fresh->GetCountSamples());
  mapper->SetMemoryBudgetMiB(fresh->GetMemoryBudgetMiB());
  mapper->SetInteractiveFrameMs(fresh->GetInteractiveFrameMs());
  mapper->SetShow(fresh->GetShow());
  mapper->SetBlendMode(fresh->GetBlendMode());
  mapper->SetScalarMode(fresh->GetScalarMode());
  mapper->SetArrayAccessMode(fresh->GetArrayAccessMode());
  mapper->SetAverageIPScalarRange(fresh->GetAverageIPScalarRange());
  mapper->SetCropping(fresh->GetCropping());
  mapper->SetCroppingRegionFlags(fresh->GetCroppingRegionFlags());
  mapper->SetCroppingRegionPlanes(fresh->GetCroppingRegionPlanes());
  mapper->RemoveAllClippingPlanes();
}

void HostileSession::Show(vtkDataObject* data)
{
  this->Mapper->SetInputDataObject(data);
}

void HostileSession::Show(vtkVolumeProperty* property)
{
  this->Volume->SetProperty(property);
}

void HostileSession::ArrangeGood()
{
  this->Mapper->Fault.reset();
  this->ArrangeMapper();
  this->Show(this->Image);
  this->Show(this->Property);
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetUserMatrix(nullptr);
  this->Volume->SetScale(1.0);
  this->Volume->SetPosition(0.0, 0.0, 0.0);
  this->Window->SetSize(RenderScene::Size, RenderScene::Size);
  this->Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  this->Renderer->RemoveAllLights();
  this->Renderer->PreserveDepthBufferOff();
  this->Renderer->SetActiveCamera(vtkNew<vtkCamera>());
  this->Renderer->GetActiveCamera()->SetFocalPoint(5.5, 4.5, 3.5);
  this->Renderer->GetActiveCamera()->SetPosition(6.5, 5.2, 5.1);
  this->Renderer->ResetCamera();
}

FloatPicture HostileSession::Draw()
{
  Keeper()->Messages.clear();
  FloatPicture picture;
  for (int frame = 0; frame < 2; ++frame)
  {
    picture = RenderToFloat(this->Renderer);
    EXPECT_EQ(this->Mapper->Before, this->Mapper->After) << "the state of OpenGL is another one";
    EXPECT_EQ(this->Mapper->Error, static_cast<GLenum>(GL_NO_ERROR));
  }
  this->Messages = Keeper()->Messages;
  return picture;
}

void HostileSession::ExpectRefusal(const FloatPicture& picture, const std::string& words)
{
  EXPECT_EQ(LargestAlpha(picture), 0.0f) << "something is drawn";
  ASSERT_EQ(this->Messages.size(), 1u) << ::testing::PrintToString(this->Messages);
  const std::string& message = this->Messages.front();
  EXPECT_EQ(message, this->Mapper->GetFailure());
  EXPECT_NE(message.find(words), std::string::npos) << "'" << words << "' is not in: " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
  EXPECT_LT(message.size(), 400u) << message;
}

void HostileSession::Expect(const Outcome& outcome)
{
  const FloatPicture picture = this->Draw();
  ExpectColors(picture);
  if (outcome.Kind == Outcome::Refused)
  {
    this->ExpectRefusal(picture, outcome.Words);
    return;
  }
  EXPECT_TRUE(this->Messages.empty()) << ::testing::PrintToString(this->Messages);
  if (outcome.Kind == Outcome::Same)
  {
    EXPECT_EQ(picture.Pixels, this->Good.Pixels);
  }
  else
  {
    EXPECT_EQ(LargestAlpha(picture) > 1e-3f, outcome.Kind == Outcome::Drawn)
      << "largest alpha " << LargestAlpha(picture);
  }
}

void HostileSession::ExpectGood()
{
  this->ArrangeGood();
  const FloatPicture picture = this->Draw();
  EXPECT_TRUE(this->Messages.empty()) << ::testing::PrintToString(this->Messages);
  ASSERT_EQ(picture.Pixels.size(), this->Good.Pixels.size());
  int differing = 0;
  for (std::size_t i = 0; i < picture.Pixels.size(); ++i)
  {
    differing += picture.Pixels[i] != this->Good.Pixels[i];
  }
  EXPECT_EQ(differing, 0) << "values of the good scene afterwards are others";
}
}
