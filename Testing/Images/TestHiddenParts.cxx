// Parts of a volume that are not drawn: hidden cells and points, crop regions, clip planes. In a
// homogeneous medium opacity tells the exact length of what is left of each ray.
#include "EveryTechnique.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkUnsignedCharArray.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Tau = 0.2;

double Zero(double, double, double)
{
  return 0.0;
}

using LengthAt = std::function<double(double x, double y)>;

// Compares all pixels under LookAlongZ with the length of medium that they should show.
void ExpectLengths(RenderScene& scene, const LengthAt& lengthAt)
{
  const FloatPicture picture = scene.Picture();
  ASSERT_EQ(scene.Mapper->GetFailure(), "");
  int wrong = 0;
  double worst = 0.0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const double length = lengthAt(scene.PositionOf(x, 0), scene.PositionOf(y, 1));
      const double difference = std::abs(PixelAt(picture, x, y).Alpha - -std::expm1(-Tau * length));
      wrong += difference > 1e-4;
      worst = std::max(worst, difference);
    }
  }
  EXPECT_EQ(wrong, 0) << "worst difference " << worst;
}

bool Inside(double x, double low, double high)
{
  return x > low && x < high;
}

bool InBox(double x, double y)
{
  return Inside(x, 0.0, 8.0) && Inside(y, 0.0, 8.0);
}

vtkSmartPointer<vtkImageData> CubeWithCells()
{
  auto image = MakeImage(9, 9, 9, Zero);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(0.0);
  image->GetCellData()->SetScalars(cells);
  return image;
}

void UseCells(RenderScene& scene)
{
  scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  scene.Mapper->SelectScalarArray("cells");
}

RenderScene* MakeScene(const std::string& technique, vtkImageData* image)
{
  auto* scene = new RenderScene(technique, image, MakeConstantProperty(Tau));
  scene->LookAlongZ(5.0);
  scene->Mapper->SetStepVoxels(0.25);
  return scene;
}

void AddPlane(RenderScene& scene, const double origin[3], const double normal[3])
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  scene.Mapper->AddClippingPlane(plane);
}
}

class HiddenParts : public EveryTechnique
{
protected:
  std::unique_ptr<RenderScene> Make(vtkImageData* image)
  {
    return std::unique_ptr<RenderScene>(MakeScene(GetParam(), image));
  }
};

TEST_P(HiddenParts, ExactlyTheHiddenCellIsLeftOut)
{
  for (const bool cellData : { false, true })
  {
    for (const int flag : { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL })
    {
      auto image = CubeWithCells();
      image->AllocateCellGhostArray()->SetValue(5 + 8 * (2 + 8 * 3), flag);
      auto scene = this->Make(image);
      if (cellData)
      {
        UseCells(*scene);
      }
      SCOPED_TRACE("cell data " + std::to_string(cellData) + " flag " + std::to_string(flag));
      ExpectLengths(*scene,
        [](double x, double y)
        { return InBox(x, y) ? 8.0 - (Inside(x, 5.0, 6.0) && Inside(y, 2.0, 3.0)) : 0.0; });
    }
  }
}

TEST_P(HiddenParts, CellsAtTheBordersAreLeftOutToo)
{
  for (const bool cellData : { false, true })
  {
    auto image = CubeWithCells();
    image->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
    image->GetCellGhostArray()->SetValue(511, vtkDataSetAttributes::HIDDENCELL);
    auto scene = this->Make(image);
    if (cellData)
    {
      UseCells(*scene);
    }
    SCOPED_TRACE("cell data " + std::to_string(cellData));
    ExpectLengths(*scene,
      [](double x, double y)
      {
        const bool corner = (x < 1.0 && y < 1.0) || (x > 7.0 && y > 7.0);
        return InBox(x, y) ? 8.0 - corner : 0.0;
      });
  }
}

TEST_P(HiddenParts, AHiddenPointHidesTheCellsAroundIt)
{
  auto image = MakeImage(9, 9, 9, Zero);
  image->AllocatePointGhostArray()->SetValue(
    5 + 9 * (2 + 9 * 3), vtkDataSetAttributes::HIDDENPOINT);
  image->GetPointGhostArray()->SetValue(100, vtkDataSetAttributes::DUPLICATEPOINT);
  ExpectLengths(*this->Make(image),
    [](double x, double y)
    { return InBox(x, y) ? 8.0 - 2.0 * (Inside(x, 4.0, 6.0) && Inside(y, 1.0, 3.0)) : 0.0; });
}

TEST_P(HiddenParts, WithoutHiddenOnesGhostsCostNothing)
{
  auto image = MakeImage(9, 9, 9, Zero);
  image->AllocatePointGhostArray()->Fill(vtkDataSetAttributes::DUPLICATEPOINT);
  image->AllocateCellGhostArray();
  auto scene = this->Make(image);
  ExpectLengths(*scene, [](double x, double y) { return InBox(x, y) ? 8.0 : 0.0; });
  EXPECT_NE(scene->Mapper->GetLeftOut().find("blanking"), std::string::npos);
}

TEST_P(HiddenParts, ChangedGhostsAreDrawn)
{
  auto image = MakeImage(9, 9, 9, Zero);
  auto scene = this->Make(image);
  ExpectLengths(*scene, [](double x, double y) { return InBox(x, y) ? 8.0 : 0.0; });
  image->AllocateCellGhostArray()->Fill(vtkDataSetAttributes::HIDDENCELL);
  image->Modified();
  ExpectLengths(*scene, [](double, double) { return 0.0; });
  image->GetCellGhostArray()->Fill(0);
  image->GetCellGhostArray()->Modified();
  ExpectLengths(*scene, [](double x, double y) { return InBox(x, y) ? 8.0 : 0.0; });
}

TEST_P(HiddenParts, CropRegionsKeepExactlyTheirPart)
{
  const double planes[6] = { 2.0, 5.0, 1.5, 6.0, 3.0, 7.0 };
  for (const int flags : { VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE, VTK_CROP_CROSS,
         VTK_CROP_INVERTED_CROSS, 1, 1 << 13, 1 << 14, 1 << 26, 0x5a5a5a5 })
  {
    auto scene = this->Make(MakeImage(9, 9, 9, Zero));
    scene->Mapper->CroppingOn();
    scene->Mapper->SetCroppingRegionPlanes(planes);
    scene->Mapper->SetCroppingRegionFlags(flags);
    scene->Mapper->SetStepVoxels(0.73); // borders within a step are exact, too
    SCOPED_TRACE("flags " + std::to_string(flags));
    ExpectLengths(*scene,
      [&](double x, double y)
      {
        const int column =
          (x > planes[0]) + (x > planes[1]) + 3 * ((y > planes[2]) + (y > planes[3]));
        const double lengths[3] = { 3.0, 4.0, 1.0 };
        double length = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          length += (flags >> (column + 9 * k)) & 1 ? lengths[k] : 0.0;
        }
        return InBox(x, y) ? length : 0.0;
      });
  }
}

TEST_P(HiddenParts, ClipPlanesCutExactly)
{
  auto scene = this->Make(MakeImage(9, 9, 9, Zero));
  const double first[3] = { 0.0, 0.0, 3.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  AddPlane(*scene, first, up);
  ExpectLengths(*scene, [](double x, double y) { return InBox(x, y) ? 5.0 : 0.0; });
  // Oblique: keeps z below 4 + x / 2. The normal's length must not matter.
  const double second[3] = { 0.0, 0.0, 4.0 };
  const double oblique[3] = { 1.0, 0.0, -2.0 };
  AddPlane(*scene, second, oblique);
  ExpectLengths(*scene,
    [](double x, double y) { return InBox(x, y) ? std::min(8.0, 4.0 + 0.5 * x) - 3.0 : 0.0; });
  // Along the rays: all or nothing.
  const double third[3] = { 3.0, 0.0, 0.0 };
  const double sideways[3] = { 1.0, 0.0, 0.0 };
  AddPlane(*scene, third, sideways);
  ExpectLengths(*scene,
    [](double x, double y)
    { return InBox(x, y) && x > 3.0 ? std::min(8.0, 4.0 + 0.5 * x) - 3.0 : 0.0; });
  EXPECT_NE(scene->Mapper->GetFeatures().find("clip-planes"), std::string::npos);
}

TEST_P(HiddenParts, ClipPlanesStandInTheWorld)
{
  // The actor is turned, stretched and moved; the plane is not.
  auto scene = this->Make(MakeImage(9, 9, 9, Zero));
  scene->Volume->SetScale(1.0, 1.0, 2.0);
  scene->Volume->SetPosition(0.0, 0.0, 10.0); // z from 10 to 26
  scene->LookAlongZ(5.0);
  const double origin[3] = { 0.0, 0.0, 16.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  AddPlane(*scene, origin, up);
  ExpectLengths(*scene, [](double x, double y) { return InBox(x, y) ? 5.0 : 0.0; });
}

TEST_P(HiddenParts, TooManyClipPlanesAreRefused)
{
  auto scene = this->Make(MakeImage(9, 9, 9, Zero));
  scene->Mapper->GlobalWarningDisplayOff();
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  for (int i = 0; i < 9; ++i)
  {
    AddPlane(*scene, origin, up);
  }
  scene->Picture();
  scene->Mapper->GlobalWarningDisplayOn();
  EXPECT_NE(scene->Mapper->GetFailure().find("9 clip planes"), std::string::npos);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(HiddenParts);
