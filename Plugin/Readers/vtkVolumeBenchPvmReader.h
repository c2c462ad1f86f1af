/**
 * @class   vtkVolumeBenchPvmReader
 * @brief   reads PVM volumes, plain or packed as a Differential Data Stream
 *
 * See PvmFile.h for the format.
 */
#ifndef vtkVolumeBenchPvmReader_h
#define vtkVolumeBenchPvmReader_h

#include "vtkVolumeBenchVolumeReader.h"

class VOLUMEBENCHREADERS_EXPORT vtkVolumeBenchPvmReader : public vtkVolumeBenchVolumeReader
{
public:
  static vtkVolumeBenchPvmReader* New();
  vtkTypeMacro(vtkVolumeBenchPvmReader, vtkVolumeBenchVolumeReader);

  int CanReadFile(const char* fileName) override;

protected:
  vtkVolumeBenchPvmReader() = default;
  ~vtkVolumeBenchPvmReader() override = default;

  volumebench::VolumeLayout Open(const std::string& fileName) override;

private:
  vtkVolumeBenchPvmReader(const vtkVolumeBenchPvmReader&) = delete;
  void operator=(const vtkVolumeBenchPvmReader&) = delete;
};

#endif
