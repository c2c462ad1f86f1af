#include "vtkVolumeBenchVolumeReader.h"

#include "VolumeLayout.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <stdexcept>

namespace
{
using volumebench::VolumeLayout;

// Copies one slice of an extent; whole rows that follow each other are read at once.
void ReadSlice(const VolumeLayout& layout, const int extent[6], int z, unsigned char* to)
{
  const auto rowVoxels = static_cast<std::uint64_t>(layout.Dims[0]);
  const auto rows = static_cast<std::uint64_t>(layout.Dims[1]);
  const auto place = [&](int y)
  {
    const std::uint64_t row = std::uint64_t(z) * rows + std::uint64_t(y);
    return layout.Offset + (row * rowVoxels + std::uint64_t(extent[0])) * layout.VoxelBytes;
  };
  const std::uint64_t rowBytes = std::uint64_t(extent[1] - extent[0] + 1) * layout.VoxelBytes;
  const int rowCount = extent[3] - extent[2] + 1;
  if (extent[1] - extent[0] + 1 == layout.Dims[0])
  {
    layout.Source->Read(place(extent[2]), rowBytes * std::uint64_t(rowCount), to);
    return;
  }
  for (int row = 0; row < rowCount; ++row)
  {
    layout.Source->Read(place(extent[2] + row), rowBytes, to + rowBytes * std::uint64_t(row));
  }
}

void SwapToHost(const VolumeLayout& layout, unsigned char* values, std::size_t byteCount)
{
  const std::size_t width = layout.VoxelBytes / static_cast<std::uint64_t>(layout.Components);
  const std::size_t count = byteCount / width;
  if (width == 2)
  {
    layout.BigEndian ? vtkByteSwap::Swap2BERange(values, count)
                     : vtkByteSwap::Swap2LERange(values, count);
  }
  else if (width == 4)
  {
    vtkByteSwap::Swap4LERange(values, count);
  }
  else if (width == 8)
  {
    vtkByteSwap::Swap8LERange(values, count);
  }
}

void AddTexts(const VolumeLayout& layout, vtkFieldData* fields)
{
  for (const auto& [name, text] : layout.Texts)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(text);
    fields->AddArray(array);
  }
}
}

vtkVolumeBenchVolumeReader::vtkVolumeBenchVolumeReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkVolumeBenchVolumeReader::~vtkVolumeBenchVolumeReader() = default;

bool vtkVolumeBenchVolumeReader::OpenLayout()
{
  this->Fault.clear();
  try
  {
    if (this->FileName.empty())
    {
      throw std::runtime_error("no file name is given");
    }
    this->Layout = std::make_unique<VolumeLayout>(this->Open(this->FileName));
    if (!this->Layout->Warning.empty())
    {
      vtkWarningMacro(<< this->FileName << ": " << this->Layout->Warning);
    }
  }
  catch (const std::exception& fault)
  {
    this->Layout.reset();
    this->Fault = fault.what();
    vtkErrorMacro(<< this->Fault);
  }
  return this->Layout != nullptr;
}

int vtkVolumeBenchVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = output->GetInformationObject(0);
  // The pipeline goes on with an empty image: a failure would add a second, vaguer error.
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (this->OpenLayout())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis + 1] = this->Layout->Dims[axis] - 1;
    }
    info->Set(vtkDataObject::SPACING(), this->Layout->Spacing.data(), 3);
    info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
    vtkDataObject::SetPointDataActiveScalarInfo(
      info, this->Layout->ScalarType, this->Layout->Components);
  }
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkVolumeBenchVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  auto* image = vtkImageData::GetData(info);
  image->Initialize();
  if (!this->Fault.empty() || (!this->Layout && !this->OpenLayout()))
  {
    return 1;
  }
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  image->SetExtent(extent);
  image->SetSpacing(this->Layout->Spacing.data());
  try
  {
    this->Fill(image);
  }
  catch (const std::exception& fault)
  {
    image->Initialize();
    this->Fault = this->FileName + ": " + fault.what();
    vtkErrorMacro(<< this->Fault);
  }
  this->Layout.reset(); // what was unpacked is needed no more
  return 1;
}

void vtkVolumeBenchVolumeReader::Fill(vtkImageData* image)
{
  const VolumeLayout& layout = *this->Layout;
  const int* extent = image->GetExtent();
  image->AllocateScalars(layout.ScalarType, layout.Components);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("voxels");
  const std::size_t sliceBytes = std::size_t(extent[1] - extent[0] + 1) *
    std::size_t(extent[3] - extent[2] + 1) * layout.VoxelBytes;
  auto* next = static_cast<unsigned char*>(scalars->GetVoidPointer(0));
  const int slices = extent[5] - extent[4] + 1;
  for (int slice = 0; slice < slices && !this->AbortExecute; ++slice)
  {
    ReadSlice(layout, extent, extent[4] + slice, next);
    SwapToHost(layout, next, sliceBytes);
    next += sliceBytes;
    this->UpdateProgress((slice + 1.0) / slices);
  }
  AddTexts(layout, image->GetFieldData());
}

void vtkVolumeBenchVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Fault: " << this->Fault << "\n";
}
