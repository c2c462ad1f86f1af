#include "Stability/Phantoms.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <cmath>

namespace volumebench
{
vtkSmartPointer<vtkImageData> MakeImage(int nx, int ny, int nz, const Field& field, int scalarType)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(nx, ny, nz);
  vtkSmartPointer<vtkDataArray> scalars;
  scalars.TakeReference(vtkDataArray::CreateDataArray(scalarType));
  scalars->SetName("field");
  scalars->SetNumberOfTuples(image->GetNumberOfPoints());
  vtkIdType tuple = 0;
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        scalars->SetTuple1(tuple++, field(i, j, k));
      }
    }
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

double Bumpy(double i, double j, double k)
{
  return 2.0 + std::sin(0.9 * i + 0.4 * j) + std::cos(0.7 * k);
}

double OpacityOfExtinction(double extinction)
{
  return -std::expm1(-extinction);
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty(
  const std::vector<OpacityKnot>& opacity, const std::vector<ColorKnot>& color, double unitDistance)
{
  vtkNew<vtkColorTransferFunction> colorFunction;
  for (const ColorKnot& knot : color)
  {
    colorFunction->AddRGBPoint(knot.Value, knot.Color.x, knot.Color.y, knot.Color.z);
  }
  vtkNew<vtkPiecewiseFunction> opacityFunction;
  std::vector<double> pairs; // added at once: VTK sorts a function anew for each point
  for (const OpacityKnot& knot : opacity)
  {
    pairs.push_back(knot.Value);
    pairs.push_back(knot.Opacity);
  }
  opacityFunction->FillFromDataPointer(static_cast<int>(opacity.size()), pairs.data());
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colorFunction);
  property->SetScalarOpacity(opacityFunction);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  return property;
}

glm::dvec3 ConstantColor()
{
  return { 1.0, 0.5, 0.25 };
}

vtkSmartPointer<vtkVolumeProperty> MakeConstantProperty(double extinction)
{
  const double opacity = OpacityOfExtinction(extinction);
  return MakeProperty(
    { { 0.0, opacity }, { 1.0, opacity } }, { { 0.0, ConstantColor() }, { 1.0, ConstantColor() } });
}

vtkSmartPointer<vtkVolumeProperty> MakeLinearExtinctionProperty(
  double scale, double low, double high, int knots)
{
  std::vector<OpacityKnot> opacity;
  for (int i = 0; i < knots; ++i)
  {
    const double value = low + (high - low) * i / (knots - 1.0);
    opacity.push_back({ value, OpacityOfExtinction(scale * value) });
  }
  const glm::dvec3 white(1.0);
  return MakeProperty(opacity, { { low, white }, { high, white } });
}

vtkSmartPointer<vtkVolumeProperty> BumpyProperty()
{
  return MakeLinearExtinctionProperty(0.1, 0.0, 4.0);
}
}
