// Runs a reader on a file and keeps what it reports.
#ifndef volumebench_VolumeReading_h
#define volumebench_VolumeReading_h

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace volumebench
{
template <typename Reader>
struct VolumeReading
{
  /// Reads all, or the part of an extent.
  explicit VolumeReading(const std::string& path, const int* extent = nullptr)
  {
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(this);
    watch->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* data)
      {
        auto* reading = static_cast<VolumeReading*>(self);
        if (event == vtkCommand::ProgressEvent)
        {
          reading->Shares.push_back(*static_cast<double*>(data));
          return;
        }
        reading->Errors.emplace_back(static_cast<const char*>(data));
      });
    this->File->AddObserver(vtkCommand::ErrorEvent, watch);
    this->File->AddObserver(vtkCommand::ProgressEvent, watch);
    this->File->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, watch);
    this->File->SetFileName(path.c_str());
    if (extent)
    {
      this->File->UpdateExtent(extent);
    }
    else
    {
      this->File->Update();
    }
    this->Image = this->File->GetOutput();
  }

  double At(int x, int y, int z, int component = 0) const
  {
    return this->Image->GetScalarComponentAsDouble(x, y, z, component);
  }

  vtkNew<Reader> File;
  vtkImageData* Image = nullptr;
  std::vector<std::string> Errors;
  std::vector<double> Shares; // of the progress
};

/// One error in one line that begins with the path and tells the cause, and an empty image.
template <typename Reader>
void ExpectRefused(const std::string& path, const std::string& cause)
{
  const VolumeReading<Reader> reading(path);
  ASSERT_EQ(reading.Errors.size(), 1u) << cause;
  const std::string fault = reading.File->GetFault();
  EXPECT_NE(reading.Errors[0].find(fault), std::string::npos);
  EXPECT_EQ(fault.find(path + ": "), 0u) << fault;
  EXPECT_NE(fault.find(cause), std::string::npos) << "'" << fault << "' lacks '" << cause << "'";
  EXPECT_EQ(reading.Image->GetNumberOfPoints(), 0);
}
}

#endif
