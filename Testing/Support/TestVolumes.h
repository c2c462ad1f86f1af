// Small volumes whose value, gradient and ray integral are known, by the names that tests use.
#ifndef volumebench_TestVolumes_h
#define volumebench_TestVolumes_h

#include "Stability/Phantoms.h"

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
using volumebench::Bumpy;
using volumebench::BumpyProperty;
using volumebench::Field;
using volumebench::MakeConstantProperty;
using volumebench::MakeImage;
using volumebench::MakeLinearExtinctionProperty;
using volumebench::OpacityOfExtinction;
}

#endif
