#include "vtkVolumeBenchImageError.h"

#include "Experiment.h"
#include "Error/FloatPicture.h"
#include "ResultTable.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkVolumeBenchImageError);

namespace
{
volumebench::FloatPicture PictureOf(vtkImageData* image)
{
  int dims[3] = {};
  image->GetDimensions(dims);
  auto* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (dims[2] != 1 || !scalars || scalars->GetNumberOfComponents() != 4)
  {
    throw std::invalid_argument("a picture must be one slice of points with four 32-bit floats");
  }
  const float* values = scalars->GetPointer(0);
  return { dims[0], dims[1], { values, values + scalars->GetNumberOfValues() } };
}

std::vector<volumebench::FloatPicture> PicturesOf(vtkInformationVector* inputs)
{
  std::vector<volumebench::FloatPicture> pictures;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    pictures.push_back(PictureOf(vtkImageData::GetData(inputs, i)));
  }
  return pictures;
}
}

vtkVolumeBenchImageError::vtkVolumeBenchImageError()
{
  this->SetNumberOfInputPorts(2);
}

vtkVolumeBenchImageError::~vtkVolumeBenchImageError() = default;

void vtkVolumeBenchImageError::RemovePictures()
{
  this->RemoveAllInputConnections(0);
}

void vtkVolumeBenchImageError::RemoveReferences()
{
  this->RemoveAllInputConnections(1);
}

int vtkVolumeBenchImageError::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkVolumeBenchImageError::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Left to the pipeline, all inputs would be asked for the extent of the first.
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      using Pipeline = vtkStreamingDemandDrivenPipeline;
      vtkInformation* input = inputVector[port]->GetInformationObject(i);
      input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
  return 1;
}

int vtkVolumeBenchImageError::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  try
  {
    const auto pictures = PicturesOf(inputVector[0]);
    const auto references = PicturesOf(inputVector[1]);
    volumebench::RunResult result;
    result.Error = volumebench::CompareImages(pictures, references);
    result.Perceived = volumebench::ComparePerceived(pictures, references);
    volumebench::FillErrorTable({ result }, table);
  }
  catch (const std::exception& error)
  {
    // The pipeline goes on with an empty table: a failure would add a second, vaguer error.
    vtkErrorMacro("Nothing compared: " << error.what());
    table->Initialize();
  }
  return 1;
}

void vtkVolumeBenchImageError::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
