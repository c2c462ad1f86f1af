/**
 * @class   vtkVolumeBenchVolumeReader
 * @brief   base of readers whose files hold one volume of one array
 *
 * Gives image data with the point scalars "voxels", what the file tells of itself as field data,
 * and only the part of the volume that the pipeline asks for. A file that cannot be read is one
 * error that names it and its fault, and an empty image.
 */
#ifndef vtkVolumeBenchVolumeReader_h
#define vtkVolumeBenchVolumeReader_h

#include "VolumeBenchReadersModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the layout
#include <string> // for names

namespace volumebench
{
struct VolumeLayout;
}

class VOLUMEBENCHREADERS_EXPORT vtkVolumeBenchVolumeReader : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkVolumeBenchVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);

  /**
   * Tells from its beginning whether the file may be of this format; nothing is reported.
   */
  virtual int CanReadFile(const char* fileName) = 0;

  /**
   * Why the last update gave nothing, or an empty text.
   */
  vtkGetCharFromStdStringMacro(Fault);

protected:
  vtkVolumeBenchVolumeReader();
  ~vtkVolumeBenchVolumeReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * Reads what comes before the voxels; throws std::runtime_error that names the file.
   */
  virtual volumebench::VolumeLayout Open(const std::string& fileName) = 0;

private:
  vtkVolumeBenchVolumeReader(const vtkVolumeBenchVolumeReader&) = delete;
  void operator=(const vtkVolumeBenchVolumeReader&) = delete;

  bool OpenLayout();
  void Fill(vtkImageData* image);

  std::string FileName;
  std::string Fault;
  std::unique_ptr<volumebench::VolumeLayout> Layout; // from the information to the data
};

#endif
