#include "vtkVolumeBenchPvmReader.h"

#include "PvmFile.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeBenchPvmReader);

int vtkVolumeBenchPvmReader::CanReadFile(const char* fileName)
{
  return fileName && volumebench::IsPvm(fileName);
}

volumebench::VolumeLayout vtkVolumeBenchPvmReader::Open(const std::string& fileName)
{
  return volumebench::OpenPvm(fileName, [this](double share) { this->UpdateProgress(share); });
}
