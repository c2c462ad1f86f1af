#include "vtkVolumeBenchVoreenReader.h"

#include "VoreenFile.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeBenchVoreenReader);

int vtkVolumeBenchVoreenReader::CanReadFile(const char* fileName)
{
  return fileName && volumebench::IsVoreen(fileName);
}

volumebench::VolumeLayout vtkVolumeBenchVoreenReader::Open(const std::string& fileName)
{
  return volumebench::OpenVoreen(fileName);
}
