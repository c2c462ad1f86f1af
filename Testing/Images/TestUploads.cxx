// What is sent to the device between two pictures: only what has changed.
#include "EveryTechnique.h"
#include "SentData.h"
#include "Techniques/Technique.h"

#include <memory>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// Half of the volume is empty, so that macrocells are sent; its values run from 0 to 1.
double Half(double i, double, double)
{
  return std::max(0.0, i / 20.0 - 1.0);
}

vtkSmartPointer<vtkVolumeProperty> PropertyUpTo(double opacity)
{
  auto property = MakeConstantProperty(0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(
    1.0, 0.2, 0.4, 1.0); // one colour has a kernel of its own
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, opacity);
  property->SetScalarOpacity(function);
  property->ShadeOn();
  return property;
}
}

class Uploads : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "draws on the processor";
    }
    if (HasDeviceOfItsOwn(GetParam()))
    {
      GTEST_SKIP() << "what goes to OpenGL is counted";
    }
    this->Scene = std::make_unique<RenderScene>(GetParam(), this->Image, this->Property);
    // Which shape is best may depend on the view, and would be found by trying.
    this->Scene->Mapper->SetWorkGroupShape("8x8");
    this->Scene->Window->Render();
    ASSERT_EQ(this->Scene->Mapper->GetFailure(), "");
  }

  // What the next picture sends after a change.
  SentData After(const std::function<void()>& change)
  {
    change();
    return SentBy([this] { this->Scene->Window->Render(); });
  }

  // With the numbers of the scene, which every picture sends.
  static SentData WithBlock(int lines = 0, int volumes = 0, int slabs = 0)
  {
    SentData sent;
    sent.Lines = lines;
    sent.Volumes = volumes;
    sent.Slabs = slabs;
    sent.Blocks = 1;
    if (GetParam() == "opencl")
    {
      // All that the kernel reads goes by writes, and the picture that it makes to OpenGL.
      sent = {};
      sent.Writes = 1 + lines + volumes + slabs;
      sent.Pictures = 1;
      sent.Blocks = 1;
    }
    return sent;
  }

  // Slices leave tiles out on the processor.
  static int CellMaps() { return IsSliced(GetParam()) ? 0 : 1; }

  vtkSmartPointer<vtkImageData> Image = MakeImage(41, 33, 25, Half, VTK_FLOAT);
  vtkSmartPointer<vtkVolumeProperty> Property = PropertyUpTo(0.5);
  std::unique_ptr<RenderScene> Scene;
};

TEST_P(Uploads, TurningSendsNumbersOnly)
{
  for (int move = 0; move < 20; ++move)
  {
    const auto turn = [this]
    {
      this->Scene->Renderer->GetActiveCamera()->Azimuth(5.0);
      this->Scene->Renderer->GetActiveCamera()->Elevation(2.0);
      this->Scene->Renderer->ResetCameraClippingRange();
    };
    ASSERT_EQ(this->After(turn), WithBlock()) << "move " << move;
  }
}

TEST_P(Uploads, SettingsOfThePictureSendNumbersOnly)
{
  EXPECT_EQ(this->After([] {}), WithBlock());
  EXPECT_EQ(this->After([this] { this->Scene->Mapper->SetStepVoxels(0.45); }), WithBlock());
  EXPECT_EQ(this->After([this] { this->Property->SetAmbient(0.35); }), WithBlock());
  EXPECT_EQ(this->After([this] { this->Scene->Volume->SetPosition(3.0, 0.0, 1.0); }), WithBlock());
  EXPECT_EQ(this->After([this] { this->Scene->Window->SetSize(80, 50); }), WithBlock());
  EXPECT_EQ(this->After([this] { this->Image->SetSpacing(1.0, 1.0, 2.0); }), WithBlock());
}

TEST_P(Uploads, NearestNeighboursNeedNoOtherTexels)
{
  const FloatPicture linear = this->Scene->Picture();
  EXPECT_EQ(this->After([this] { this->Property->SetInterpolationTypeToNearest(); }), WithBlock());
  const FloatPicture nearest = this->Scene->Picture();
  EXPECT_NE(nearest.Pixels, linear.Pixels);
  RenderScene fresh(GetParam(), this->Image, this->Property);
  EXPECT_EQ(fresh.Picture().Pixels, nearest.Pixels);
}

TEST_P(Uploads, OpacitiesSendTheirTableAndTheMacrocells)
{
  const auto edit = [this]
  {
    this->Property->GetScalarOpacity()->AddPoint(0.4, 0.0);
    this->Property->GetScalarOpacity()->AddPoint(0.7, 0.3);
  };
  EXPECT_EQ(this->After(edit), WithBlock(1, CellMaps()));
}

TEST_P(Uploads, ColoursSendTheirTableOnly)
{
  const auto edit = [this] { this->Property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1, 0, 0); };
  EXPECT_EQ(this->After(edit), WithBlock(1));
}

TEST_P(Uploads, DataSendTheVolumeAndTheMacrocells)
{
  const auto edit = [this]
  {
    this->Image->GetPointData()->GetScalars()->SetComponent(40, 0, 0.5);
    this->Image->GetPointData()->GetScalars()->Modified();
  };
  EXPECT_EQ(this->After(edit), WithBlock(0, CellMaps(), 1));
}

TEST_P(Uploads, TheDeviceHoldsLittleMoreThanTheVolume)
{
  // 16 bits to a voxel for types of 8 and 16 bits, 32 for the others.
  for (const auto& [type, bytes] :
    { std::pair{ VTK_UNSIGNED_CHAR, 2 }, { VTK_SHORT, 2 }, { VTK_FLOAT, 4 } })
  {
    constexpr int Edge = 128;
    RenderScene scene(GetParam(), MakeImage(Edge, Edge, Edge, Half, type), this->Property);
    scene.Window->Render();
    const auto onDevice = static_cast<double>(scene.Mapper->GetSetUpCosts().BytesOnDevice);
    const double volume = static_cast<double>(bytes) * Edge * Edge * Edge;
    const double pictures = 4.0 * 16.0 * RenderScene::Size * RenderScene::Size;
    EXPECT_GE(onDevice, volume);
    EXPECT_LE(onDevice, 1.15 * volume + (GetParam() == "single-pass" ? 0.0 : pictures));
  }
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Uploads);
