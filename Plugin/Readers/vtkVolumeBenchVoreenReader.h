/**
 * @class   vtkVolumeBenchVoreenReader
 * @brief   reads Voreen's .dat headers with their .raw files
 *
 * See VoreenFile.h for the format.
 */
#ifndef vtkVolumeBenchVoreenReader_h
#define vtkVolumeBenchVoreenReader_h

#include "vtkVolumeBenchVolumeReader.h"

class VOLUMEBENCHREADERS_EXPORT vtkVolumeBenchVoreenReader : public vtkVolumeBenchVolumeReader
{
public:
  static vtkVolumeBenchVoreenReader* New();
  vtkTypeMacro(vtkVolumeBenchVoreenReader, vtkVolumeBenchVolumeReader);

  int CanReadFile(const char* fileName) override;

protected:
  vtkVolumeBenchVoreenReader() = default;
  ~vtkVolumeBenchVoreenReader() override = default;

  volumebench::VolumeLayout Open(const std::string& fileName) override;

private:
  vtkVolumeBenchVoreenReader(const vtkVolumeBenchVoreenReader&) = delete;
  void operator=(const vtkVolumeBenchVoreenReader&) = delete;
};

#endif
