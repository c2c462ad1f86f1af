// A volume property with an opacity and a colour function at hand, both without points.
#ifndef volumebench_PropertyWithFunctions_h
#define volumebench_PropertyWithFunctions_h

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

namespace volumebench::test
{
struct PropertyWithFunctions
{
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;

  PropertyWithFunctions()
  {
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Color);
  }
};
}

#endif
