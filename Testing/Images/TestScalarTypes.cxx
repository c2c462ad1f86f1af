// Every VTK scalar type, point and cell arrays, components and values that are not finite.
#include "EveryTechnique.h"

#include "Error/ImageError.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"

#include <set>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// 0..40 in whole numbers, so that every type holds it exactly.
double Whole(double i, double j, double k)
{
  return std::floor(20.0 + 10.0 * std::sin(0.9 * i + 0.4 * j) + 9.0 * std::cos(0.7 * k));
}

double WorstDifference(const FloatPicture& a, const FloatPicture& b)
{
  return CompareImages(a, b).Linf;
}

vtkSmartPointer<vtkVolumeProperty> WholeProperty()
{
  return MakeLinearExtinctionProperty(0.01, 0.0, 40.0);
}
}

class ScalarTypes : public EveryTechnique
{
};

TEST_P(ScalarTypes, AllTypesGiveTheSamePicture)
{
  RenderScene reference(GetParam(), MakeImage(12, 10, 8, Whole, VTK_FLOAT), WholeProperty());
  const FloatPicture expected = reference.Picture();
  ASSERT_GT(PixelAt(expected, 32, 32).Alpha, 0.1);
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_DOUBLE })
  {
    RenderScene scene(GetParam(), MakeImage(12, 10, 8, Whole, type), WholeProperty());
    // A 16-bit texture over the whole 16-bit range leaves a quantum of 1.5e-5 of that range
    // between two texels; the optical depth of a step of it is far below 1e-4.
    EXPECT_LE(WorstDifference(scene.Picture(), expected), 1e-4)
      << vtkImageScalarTypeNameMacro(type);
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
  }
}

TEST_P(ScalarTypes, EightBitDataAreFilteredFinely)
{
  // Two voxels, 0 and 1 of 255: 8-bit filter weights would give two levels over 64 pixels.
  auto image = MakeImage(
    2, 2, 2, [](double i, double, double) { return i; }, VTK_UNSIGNED_CHAR);
  RenderScene scene(GetParam(), image, MakeLinearExtinctionProperty(1.0, 0.0, 1.0));
  scene.Window->SetSize(512, 64);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0, 1.0);
  camera->SetParallelScale(0.0624);
  const FloatPicture picture = scene.Picture();
  std::set<float> levels;
  for (int x = 0; x < 512; ++x)
  {
    levels.insert(PixelAt(picture, x, 32).Alpha);
  }
  EXPECT_GE(levels.size(), 200u);
}

TEST_P(ScalarTypes, LargeOffsetsAndRangesInDouble)
{
  RenderScene reference(GetParam(), MakeImage(12, 10, 8, Whole), WholeProperty());
  const FloatPicture expected = reference.Picture();
  for (const auto& [scale, offset] :
    { std::pair{ 1.0, 1.0e9 }, { 1.0e300, 0.0 }, { 1.0e-300, 0.0 } })
  {
    const auto field = [scale = scale, offset = offset](double i, double j, double k)
    { return offset + scale * Whole(i, j, k); };
    auto property = vtkSmartPointer<vtkVolumeProperty>::New();
    property->DeepCopy(WholeProperty());
    vtkNew<vtkPiecewiseFunction> opacity;
    vtkNew<vtkColorTransferFunction> color;
    for (int value = 0; value <= 400; ++value)
    {
      const double x = offset + scale * 0.1 * value;
      opacity->AddPoint(x, OpacityOfExtinction(0.001 * value));
    }
    color->AddRGBPoint(offset, 1.0, 1.0, 1.0);
    color->AddRGBPoint(offset + 40.0 * scale, 1.0, 1.0, 1.0);
    property->SetScalarOpacity(opacity);
    property->SetColor(color);
    RenderScene scene(GetParam(), MakeImage(12, 10, 8, field, VTK_DOUBLE), property);
    EXPECT_LE(WorstDifference(scene.Picture(), expected), 1e-4)
      << "scale " << scale << " offset " << offset;
  }
}

TEST_P(ScalarTypes, CellDataAreConstantHalfACellFromTheBorder)
{
  // One cell thick along y and z: along x the value is that of the cell centres, clamped.
  auto image = MakeImage(3, 2, 2, [](double, double, double) { return 0.0; });
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  cells->InsertNextValue(1.0);
  cells->InsertNextValue(3.0);
  image->GetCellData()->AddArray(cells);
  RenderScene scene(GetParam(), image, MakeLinearExtinctionProperty(0.2, 0.0, 4.0));
  scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  scene.Mapper->SelectScalarArray("cells");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0, 1.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
  const FloatPicture picture = scene.Picture();
  for (int x = 0; x < 64; ++x)
  {
    const double position = (x + 0.5) / 32.0;
    const double value = std::min(3.0, std::max(1.0, 1.0 + 2.0 * (position - 0.5)));
    EXPECT_NEAR(PixelAt(picture, x, 32).Alpha, -std::expm1(-0.2 * value), 1e-5) << position;
  }
}

TEST_P(ScalarTypes, ComponentAndMagnitude)
{
  auto image = MakeImage(4, 4, 4, [](double, double, double) { return 0.0; });
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < 64; ++i)
  {
    vectors->InsertNextTuple3(2.0, 3.0, 6.0);
  }
  image->GetPointData()->AddArray(vectors);
  RenderScene scene(GetParam(), image, MakeLinearExtinctionProperty(0.1, 0.0, 8.0));
  scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  scene.Mapper->SelectScalarArray("vectors");
  const double box[6] = { 0, 3, 0, 3, 0, 3 };
  const double length = RayOfPixel(scene.Renderer, box, 32, 32, RenderScene::Size).Length();
  const auto alpha = [&] { return PixelAt(scene.Picture(), 32, 32).Alpha; };
  scene.Mapper->SetVectorComponent(1);
  EXPECT_NEAR(alpha(), -std::expm1(-0.3 * length), 1e-5);
  scene.Mapper->SetVectorMode(vtkVolumeBenchMapper::Magnitude);
  EXPECT_NEAR(alpha(), -std::expm1(-0.7 * length), 1e-5);
}

TEST_P(ScalarTypes, NonFiniteVoxelsAreBlankAndLeaveTheRestAlone)
{
  const auto clean = [](double i, double j, double k) { return Whole(i, j, k); };
  const auto dirty = [](double i, double j, double k)
  {
    const bool corner = i == 0 && j == 0 && k == 0;
    return corner ? std::nan("") : (i == 1 && j == 0 && k == 0 ? INFINITY : Whole(i, j, k));
  };
  RenderScene good(GetParam(), MakeImage(12, 10, 8, clean), WholeProperty());
  RenderScene bad(GetParam(), MakeImage(12, 10, 8, dirty), WholeProperty());
  good.LookFrom(0.0, 0.0, 1.0);
  bad.LookFrom(0.0, 0.0, 1.0);
  const FloatPicture expected = good.Picture();
  const FloatPicture picture = bad.Picture();
  int changed = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const Pixel a = PixelAt(picture, x, y);
      const Pixel b = PixelAt(expected, x, y);
      ASSERT_TRUE(std::isfinite(a.Red) && std::isfinite(a.Alpha));
      // Looking along z, the blank cells project into the lower left.
      const bool mayChange = x < 28 && y < 28;
      changed += a.Alpha != b.Alpha;
      EXPECT_TRUE(mayChange || a.Alpha == b.Alpha) << x << ", " << y;
    }
  }
  EXPECT_GT(changed, 0);
}

TEST_P(ScalarTypes, ConstantScalars)
{
  auto image = MakeImage(
    4, 4, 4, [](double, double, double) { return 5.0; }, VTK_SHORT);
  RenderScene scene(GetParam(), image, MakeLinearExtinctionProperty(0.1, 0.0, 8.0));
  const double box[6] = { 0, 3, 0, 3, 0, 3 };
  const double length = RayOfPixel(scene.Renderer, box, 32, 32, RenderScene::Size).Length();
  EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-0.5 * length), 2e-5);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(ScalarTypes);
