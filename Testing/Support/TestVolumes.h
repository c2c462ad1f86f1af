// Small volumes whose value, gradient and ray integral are known.
#ifndef volumebench_TestVolumes_h
#define volumebench_TestVolumes_h

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <functional>

namespace volumebench::test
{
using Field = std::function<double(double i, double j, double k)>; // by point index

/// Point data "field" of a VTK scalar type.
inline vtkSmartPointer<vtkImageData> MakeImage(
  int nx, int ny, int nz, const Field& field, int scalarType = VTK_FLOAT)
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

/// Opacity per unit distance 1 that has this extinction.
inline double OpacityOfExtinction(double extinction)
{
  return -std::expm1(-extinction);
}

/// White everywhere; the same opacity for every value.
inline vtkSmartPointer<vtkVolumeProperty> MakeConstantProperty(double extinction)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 0.5, 0.25);
  color->AddRGBPoint(1.0, 1.0, 0.5, 0.25);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, OpacityOfExtinction(extinction));
  opacity->AddPoint(1.0, OpacityOfExtinction(extinction));
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();
  return property;
}

/// White; extinction `scale * value` for values in [low, high], through so many knots that the
/// piecewise linear opacity stands for it to a part in 1e7.
inline vtkSmartPointer<vtkVolumeProperty> MakeLinearExtinctionProperty(
  double scale, double low, double high, int knots = 1025)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(low, 1.0, 1.0, 1.0);
  color->AddRGBPoint(high, 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int i = 0; i < knots; ++i)
  {
    const double value = low + (high - low) * i / (knots - 1.0);
    opacity->AddPoint(value, OpacityOfExtinction(scale * value));
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();
  return property;
}

/// A smooth field between 0 and 4, the same along no axis.
inline double Bumpy(double i, double j, double k)
{
  return 2.0 + std::sin(0.9 * i + 0.4 * j) + std::cos(0.7 * k);
}

inline vtkSmartPointer<vtkVolumeProperty> BumpyProperty()
{
  return MakeLinearExtinctionProperty(0.1, 0.0, 4.0);
}
}

#endif
