#include "Scene/DefaultTransferFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

namespace volumebench
{
void FillDefaultTransferFunction(vtkVolumeProperty* property, const double range[2])
{
  const double low = range[0];
  const double high = range[1] > range[0] ? range[1] : range[0] + 1.0;
  vtkNew<vtkColorTransferFunction> color;
  color->SetColorSpaceToDiverging();
  color->AddRGBPoint(low, 0.231373, 0.298039, 0.752941);
  color->AddRGBPoint(0.5 * low + 0.5 * high, 0.865003, 0.865003, 0.865003);
  color->AddRGBPoint(high, 0.705882, 0.0156863, 0.14902);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(low, 0.0);
  opacity->AddPoint(high, 1.0);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
}
}
