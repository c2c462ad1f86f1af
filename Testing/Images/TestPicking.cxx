// Selection passes: what is seen of a volume can be picked, by every technique, and nothing else.
#include "EveryTechnique.h"
#include "StateChecker.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkVolumePicker.h"

#include <array>
#include <cmath>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Tau = 0.3;
constexpr int Side = RenderScene::Size;
constexpr float Visible = 3.0f / 255.0f;

double Zero(double, double, double)
{
  return 0.0;
}

// The prop at every pixel, null where there is none.
std::vector<vtkProp*> PropsAtPixels(vtkRenderer* renderer)
{
  renderer->GetRenderWindow()->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, Side - 1, Side - 1);
  selector->SetActorPassOnly(true);
  selector->CaptureBuffers();
  std::vector<vtkProp*> props;
  for (unsigned int y = 0; y < Side; ++y)
  {
    for (unsigned int x = 0; x < Side; ++x)
    {
      const unsigned int pixel[2] = { x, y };
      props.push_back(selector->GetPixelInformation(pixel).Prop);
    }
  }
  return props;
}

vtkSmartPointer<vtkActor> PlaneAt(double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, z);
  plane->SetPoint1(30.0, -20.0, z);
  plane->SetPoint2(-20.0, 30.0, z);
  plane->SetResolution(8, 8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

std::size_t At(int x, int y)
{
  return static_cast<std::size_t>(y) * Side + x;
}

// Picks the prop exactly where its picture has more than three steps of an 8-bit picture.
void ExpectPickedWhereVisible(RenderScene& scene)
{
  const FloatPicture picture = scene.Picture();
  const std::vector<vtkProp*> props = PropsAtPixels(scene.Renderer);
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  int picked = 0;
  int wrong = 0;
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      const float opacity = PixelAt(picture, x, y).Alpha;
      const bool hit = props[At(x, y)] == scene.Volume.GetPointer();
      picked += hit;
      wrong += std::abs(opacity - Visible) > 1e-4f && hit != (opacity > Visible);
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(picked, 100);
  EXPECT_LT(picked, Side * Side - 100);
  EXPECT_EQ(scene.Picture().Pixels, picture.Pixels) << "picking changes the next picture";
}
}

class Picking : public EveryTechnique
{
};

TEST_P(Picking, PicksWhatIsVisible)
{
  // The lower half of the values is transparent, so part of the box is empty.
  auto property = MakeLinearExtinctionProperty(1.0, 0.0, 4.0);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(2.9, 0.0);
  property->GetScalarOpacity()->AddPoint(3.5, 0.3);
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), property);
  for (const bool parallel : { false, true })
  {
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    scene.LookFrom(1.0, 0.4, 0.5);
    ExpectPickedWhereVisible(scene);
  }
}

TEST_P(Picking, PicksBlocks)
{
  RenderScene scene(GetParam(), MakeImage(5, 5, 5, Zero), MakeConstantProperty(Tau));
  vtkNew<vtkPartitionedDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto block = MakeImage(5, 5, 5, Zero);
    block->SetOrigin(6.0 * i, 0.0, 0.0);
    blocks->SetPartition(i, block);
  }
  scene.Mapper->SetInputDataObject(blocks);
  scene.LookFrom(0.2, 0.3, 1.0);
  ExpectPickedWhereVisible(scene);
}

TEST_P(Picking, NearerGeometryWins)
{
  struct Case
  {
    double Z;
    bool VolumeWins;
  };
  // The box reaches from 0 to 8 and is seen from above; a thousandth of a voxel shows nothing.
  for (const Case& given :
    { Case{ -2.0, true }, Case{ 4.0, true }, Case{ 7.999, false }, Case{ 9.0, false } })
  {
    RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
    scene.LookFrom(0.0, 0.0, 1.0);
    auto plane = PlaneAt(given.Z);
    scene.Renderer->AddActor(plane);
    scene.Renderer->ResetCameraClippingRange();
    const std::vector<vtkProp*> props = PropsAtPixels(scene.Renderer);
    vtkProp* expected =
      given.VolumeWins ? static_cast<vtkProp*>(scene.Volume) : static_cast<vtkProp*>(plane);
    EXPECT_EQ(props[At(32, 32)], expected) << "plane at " << given.Z;
    EXPECT_EQ(props[At(1, 1)], plane) << "plane at " << given.Z;
  }
}

TEST_P(Picking, NearerVolumeWins)
{
  for (const double z : { -12.0, 12.0 })
  {
    RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
    scene.LookFrom(0.0, 0.0, 1.0);
    auto image = MakeImage(9, 9, 9, Zero);
    image->SetOrigin(0.0, 0.0, z);
    vtkNew<vtkVolumeBenchMapper> mapper;
    mapper->SetTechnique(GetParam().c_str());
    mapper->SetInputData(image);
    vtkNew<vtkVolume> other;
    other->SetMapper(mapper);
    other->SetProperty(MakeConstantProperty(Tau));
    scene.Renderer->AddVolume(other);
    scene.Renderer->ResetCamera();
    const std::vector<vtkProp*> props = PropsAtPixels(scene.Renderer);
    vtkVolume* nearer = z > 0.0 ? other.GetPointer() : scene.Volume.GetPointer();
    EXPECT_EQ(props[At(32, 32)], nearer) << "other at " << z;
  }
}

TEST_P(Picking, OnlyItsViewportIsMarked)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
  scene.Renderer->SetViewport(0.5, 0.25, 1.0, 1.0);
  scene.LookFrom(0.0, 0.0, 1.0);
  scene.Window->Render();
  const std::vector<vtkProp*> props = PropsAtPixels(scene.Renderer);
  EXPECT_EQ(props[At(48, 40)], scene.Volume.GetPointer());
  for (const auto& [x, y] : { std::array<int, 2>{ 16, 40 }, { 48, 8 }, { 33, 62 } })
  {
    EXPECT_EQ(props[At(x, y)], nullptr) << x << " " << y;
  }
}

TEST_P(Picking, ProcessIsMarkedAndNothingBehindIsSelected)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
  scene.LookFrom(0.0, 0.0, 1.0);
  scene.Renderer->AddActor(PlaneAt(-3.0));
  scene.Renderer->ResetCameraClippingRange();
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, Side - 1, Side - 1);
  selector->SetProcessID(4);
  selector->CaptureBuffers();
  const unsigned char* process = selector->GetPixelBuffer(vtkHardwareSelector::PROCESS_PASS);
  ASSERT_NE(process, nullptr);
  EXPECT_EQ(process[3 * At(32, 32)], 5); // 0 is nothing
  const unsigned int middle[2] = { 32, 32 };
  const unsigned int edge[2] = { 62, 32 };
  const auto there = selector->GetPixelInformation(middle);
  EXPECT_EQ(there.Prop, scene.Volume.GetPointer());
  // The cell that the ray enters; the plane's in the middle is one of its 64.
  EXPECT_EQ(there.AttributeID, 4 + 8 * (4 + 8 * 7)) << "a cell of the plane behind";
  EXPECT_GT(selector->GetPixelInformation(edge).AttributeID, 0);
}

// The points or cells that are in front of the pixels of the view's middle row.
std::vector<vtkIdType> IdsInFront(RenderScene& scene, int association)
{
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, Side - 1, Side - 1);
  selector->SetFieldAssociation(association);
  selector->CaptureBuffers();
  std::vector<vtkIdType> ids;
  for (unsigned int x = 0; x < Side; ++x)
  {
    const unsigned int pixel[2] = { x, Side / 2 };
    const auto there = selector->GetPixelInformation(pixel);
    ids.push_back(there.Prop ? there.AttributeID : -1);
  }
  return ids;
}

// The place where the ray through a pixel of that row enters the box, in voxels.
std::array<double, 3> EntryAt(RenderScene& scene, int x, double top)
{
  double depth[4];
  scene.Renderer->SetDisplayPoint(x + 0.5, Side / 2 + 0.5, 0.0);
  scene.Renderer->DisplayToWorld();
  scene.Renderer->GetWorldPoint(depth);
  return { depth[0] / depth[3], depth[1] / depth[3], top };
}

TEST_P(Picking, PointsAndCellsAreThoseWhereTheRaysEnter)
{
  constexpr int Dims[3] = { 9, 11, 7 };
  RenderScene scene(
    GetParam(), MakeImage(Dims[0], Dims[1], Dims[2], Zero), MakeConstantProperty(Tau));
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0, 1.0);
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataObject::FIELD_ASSOCIATION_CELLS })
  {
    const bool points = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
    const std::vector<vtkIdType> ids = IdsInFront(scene, association);
    int seen = 0;
    for (int x = 0; x < Side; ++x)
    {
      const std::array<double, 3> entry = EntryAt(scene, x, Dims[2] - 1.0);
      if (ids[x] < 0)
      {
        continue;
      }
      const auto cellX = static_cast<vtkIdType>(std::floor(entry[0] + (points ? 0.5 : 0.0)));
      const auto cellY = static_cast<vtkIdType>(std::floor(entry[1] + (points ? 0.5 : 0.0)));
      const int less = points ? 0 : 1;
      EXPECT_EQ(ids[x],
        cellX + (Dims[0] - less) * (cellY + (Dims[1] - less) * vtkIdType(Dims[2] - 1 - less)))
        << (points ? "point" : "cell") << " at pixel " << x;
      ++seen;
    }
    EXPECT_GT(seen, Side / 4);
  }
}

TEST_P(Picking, GlStateIsLeftAsFound)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  vtkNew<StateChecker> mapper;
  mapper->SetTechnique(GetParam().c_str());
  mapper->SetInputData(MakeImage(12, 10, 8, Bumpy));
  scene.Volume->SetMapper(mapper);
  PropsAtPixels(scene.Renderer);
  ASSERT_FALSE(mapper->Before.empty());
  EXPECT_EQ(mapper->Before, mapper->After);
  EXPECT_EQ(mapper->Error, static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(Picking, VolumePickerMeetsTheVolume)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
  scene.LookFrom(0.0, 0.0, 1.0);
  const FloatPicture before = scene.Picture();
  vtkNew<vtkVolumePicker> picker;
  picker->SetVolumeOpacityIsovalue(0.05);
  ASSERT_TRUE(picker->Pick(32.0, 32.0, 0.0, scene.Renderer));
  EXPECT_EQ(picker->GetVolume(), scene.Volume.GetPointer());
  EXPECT_NEAR(picker->GetPickPosition()[2], 8.0, 0.1);
  EXPECT_FALSE(picker->Pick(1.0, 1.0, 0.0, scene.Renderer));
  EXPECT_EQ(scene.Picture().Pixels, before.Pixels);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Picking);
