#include "RandomScene.h"

#include "Scene/Scene.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <sstream>

namespace volumebench::test
{
RandomScene::RandomScene(unsigned seed, const std::string& technique)
  : Random(seed)
{
  const auto image = this->DrawImage();
  const auto property = this->DrawProperty(image);
  this->Scene = std::make_unique<RenderScene>(technique, image, property);
  this->Scene->Window->SetSize(Size, Size);
  this->Scene->Mapper->SetScalarMode(
    this->OnCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
  this->DrawSampling(technique);
  this->DrawSurroundings();
  this->DrawCamera();
  if (this->Chance(0.3))
  {
    const int seed = this->Whole(0, MostJitterSeed);
    this->Scene->Mapper->JitterOn();
    this->Scene->Mapper->SetJitterSeed(seed);
    this->Text += ", jitter " + std::to_string(seed);
  }
}

double RandomScene::Uniform(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(this->Random);
}

double RandomScene::PowerOfTen(double low, double high)
{
  return std::pow(10.0, this->Uniform(low, high));
}

int RandomScene::Whole(int low, int high)
{
  return std::uniform_int_distribution<int>(low, high)(this->Random);
}

vtkSmartPointer<vtkImageData> RandomScene::DrawImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  this->OnCells = this->Chance(0.3);
  const int least = this->OnCells ? 1 : 2;
  int cells[3];
  for (int& count : cells)
  {
    count = this->Chance(0.2) ? 1 : this->Whole(least - 1 + (least == 1), 39);
  }
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  const double scale = this->PowerOfTen(-6.0, 6.0);
  double spacing[3];
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = scale * (this->Chance(0.3) ? this->PowerOfTen(-3.0, 3.0) : 1.0);
    squares += std::pow(cells[axis] * spacing[axis], 2.0);
  }
  this->Diagonal = std::sqrt(squares);
  image->SetSpacing(spacing);
  const double farOff = this->Chance(0.5) ? 0.0 : this->PowerOfTen(0.0, 8.0);
  image->SetOrigin(farOff, -0.3 * farOff, 0.1 * farOff);
  this->DrawValues(image);
  std::ostringstream text;
  text << cells[0] << "x" << cells[1] << "x" << cells[2] << " cells, spacing " << spacing[0] << " "
       << spacing[1] << " " << spacing[2] << ", origin " << farOff << ", "
       << image->GetScalarTypeAsString();
  this->Text = text.str();
  return image;
}

void RandomScene::DrawValues(vtkImageData* image)
{
  static constexpr int Types[] = { VTK_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_FLOAT, VTK_DOUBLE };
  const int type = Types[this->Whole(0, 8)];
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("field");
  array->SetNumberOfTuples(this->OnCells ? image->GetNumberOfCells() : image->GetNumberOfPoints());
  const double base = real && this->Chance(0.3) ? this->PowerOfTen(0.0, 9.0) : 0.0;
  const double span =
    real ? this->PowerOfTen(-6.0, type == VTK_DOUBLE ? 300.0 : 30.0) : this->Whole(1, 127);
  const bool constant = this->Chance(0.1);
  this->Holes = real && this->Chance(0.3);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double value = base + (constant ? 0.5 : this->Uniform(0.0, 1.0)) * span;
    value = this->Holes && this->Chance(0.02) ? std::nan("") : value;
    array->SetTuple1(i, this->Holes && this->Chance(0.01) ? -HUGE_VAL : value);
  }
  if (this->Holes)
  {
    array->SetTuple1(0, base); // at least one value is finite
  }
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (this->OnCells)
  {
    attributes = image->GetCellData();
  }
  attributes->SetScalars(array);
}

vtkSmartPointer<vtkVolumeProperty> RandomScene::DrawProperty(vtkImageData* image)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkDataArray* array =
    this->OnCells ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars();
  double range[2];
  array->GetFiniteRange(range);
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  const auto anywhere = [&] { return range[0] + this->Uniform(-0.2, 1.2) * width; };
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  const int knots = this->Whole(1, 12);
  for (int i = 0; i < knots; ++i)
  {
    const double value = anywhere();
    const double height = this->Chance(0.2) ? 0.0 : (this->Chance(0.1) ? 1.0 : this->Uniform(0, 1));
    opacity->AddPoint(value, height, 0.5, this->Chance(0.1) ? 1.0 : 0.0);
    opacity->AddPoint(value + this->PowerOfTen(-7.0, -1.0) * width, 0.0);
    color->AddRGBPoint(
      anywhere(), this->Uniform(0.0, 1.0), this->Uniform(0.0, 1.0), this->Uniform(0.0, 1.0));
  }
  opacity->SetClamping(this->Chance(0.8));
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  property->SetScalarOpacityUnitDistance(this->Diagonal * this->PowerOfTen(-8.0, 8.0));
  property->SetInterpolationType(
    this->Chance(0.1) ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  this->Lit = this->Chance(0.25);
  property->SetShade(this->Lit);
  return property;
}

void RandomScene::DrawSampling(const std::string& technique)
{
  static constexpr int Modes[] = { vtkVolumeMapper::COMPOSITE_BLEND,
    vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
    vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeBenchMapper::GRADIENT_BLEND };
  const int mode = this->Chance(0.6) ? 0 : this->Whole(1, 4);
  this->Composite = mode == 0;
  vtkVolumeBenchMapper* mapper = this->Scene->Mapper;
  const int integrator = this->Whole(0, 3);
  const double step = this->PowerOfTen(-1.3, 1.7);
  mapper->SetBlendMode(Modes[mode]);
  mapper->SetIntegrator(integrator);
  mapper->SetStepVoxels(step);
  mapper->SetTerminationThreshold(this->Chance(0.5) ? 0.0 : 0.001);
  mapper->SetRaySetUp(this->Whole(0, 1));
  mapper->SetSliceOrder(this->Whole(0, 1));
  mapper->SetSliceExtent(this->Whole(0, 2));
  mapper->SetWorkGroupShape("8x8");
  this->Text += ", " + technique + ", integrator " + std::to_string(integrator) + ", mode " +
    std::to_string(mode) + ", step " + std::to_string(step);
}

void RandomScene::DrawSurroundings()
{
  if (this->Chance(0.3))
  {
    vtkNew<vtkTransform> transform;
    transform->RotateWXYZ(this->Uniform(0.0, 360.0), this->Uniform(-1.0, 1.0), 0.3, 0.8);
    transform->Scale(this->Chance(0.3) ? -1.0 : 1.0, this->PowerOfTen(-1.0, 1.0), 1.0);
    this->Scene->Volume->SetUserMatrix(transform->GetMatrix());
  }
  if (this->Chance(0.3))
  {
    double box[6];
    std::copy_n(this->Scene->Mapper->GetBounds(), 6, box);
    vtkVolumeBenchMapper* mapper = this->Scene->Mapper;
    mapper->SetCropping(true);
    mapper->SetCroppingRegionFlags(
      this->Chance(0.5) ? VTK_CROP_SUBVOLUME : this->Whole(1, (1 << 27) - 1));
    mapper->SetCroppingRegionPlanes(box[0] + 0.2 * (box[1] - box[0]), box[1], box[2],
      box[3] - 0.3 * (box[3] - box[2]), box[4] + 0.1 * (box[5] - box[4]), box[5]);
  }
}

void RandomScene::DrawCamera()
{
  RenderScene& scene = *this->Scene;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelProjection(this->Chance(0.3));
  scene.LookFrom(this->Uniform(-1.0, 1.0), this->Uniform(-1.0, 1.0), this->Uniform(0.1, 1.0));
  if (this->Chance(0.3))
  {
    camera->SetViewAngle(this->PowerOfTen(0.0, 2.1));
  }
  // Up to ten times nearer or a thousand times farther: the eye may stand in the volume.
  camera->Dolly(this->Chance(0.5) ? 1.0 : this->PowerOfTen(-1.0, 1.0));
  if (this->Chance(0.2))
  {
    camera->Dolly(this->PowerOfTen(0.0, 3.0));
  }
  scene.Renderer->ResetCameraClippingRange();
}

void RandomScene::UseOneColor(const glm::dvec3& rgb)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, rgb.x, rgb.y, rgb.z);
  this->Scene->Volume->GetProperty()->SetColor(color);
}

void RandomScene::UseOneMedium(const glm::dvec3& rgb, double extinction)
{
  this->UseOneColor(rgb);
  vtkNew<vtkPiecewiseFunction> opacity;
  const double unit = 0.1 / extinction;
  opacity->AddPoint(0.0, OpacityOfExtinction(0.1));
  this->Scene->Volume->GetProperty()->SetScalarOpacity(opacity);
  this->Scene->Volume->GetProperty()->SetScalarOpacityUnitDistance(unit);
}
}
