// One way of drawing the volume in an experiment: a technique of ours or a peer of VTK's, with the
// mapper and the volume that are shown while it is measured.
#ifndef volumebench_Contestant_h
#define volumebench_Contestant_h

#include "vtkVolumeBenchMapper.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkVolumeProperty;

namespace volumebench
{
struct ContestantInput
{
  vtkImageData* Image = nullptr;
  std::string ArrayName;
  bool CellArray = false;
  int Components = 1;
  int VectorMode = 1; // vtkVolumeBenchMapper::VectorModes
  int VectorComponent = 0;
  int BlendMode = 0; // vtkVolumeBenchMapper's numbers
  double LightingDamping = 0.0;
  vtkVolumeProperty* Property = nullptr;
};

class Contestant
{
public:
  /// Throws std::runtime_error when `id` is neither a technique nor a peer.
  Contestant(const std::string& id, const ContestantInput& input);

  const std::string& GetId() const { return this->Id; }
  vtkVolume* GetVolume() { return this->Volume; }

  /// Our mapper, null for a peer.
  vtkVolumeBenchMapper* GetMapper() { return this->Mapper; }

  /// Why a peer cannot draw this input, or a technique has no device here; empty when it can.
  const std::string& GetUnsupported() const { return this->Unsupported; }

  /// Whether it is VTK's GPU mapper, whose samples can be counted.
  bool IsGpuPeer() const;

  /// Shows another image and function in the same mapper; the array's name and centring, the step
  /// and all other settings stay.
  void SetInput(vtkImageData* image, vtkVolumeProperty* property);

  /// A peer counts voxels of the mean edge length of the present image.
  void SetStepVoxels(double step);

  /// Whether a technique takes steps, and so has an integrator: all but the exact reference do.
  static bool TakesSteps(const std::string& id) { return id != "reference"; }

  /// Ids of the peers.
  static const std::vector<std::string>& Peers();

private:
  vtkSmartPointer<vtkVolumeMapper> MakePeer(const ContestantInput& input);
  std::string WhyUnsupported(const ContestantInput& input) const;

  std::string Id;
  vtkNew<vtkVolume> Volume;
  vtkSmartPointer<vtkVolumeBenchMapper> Mapper;
  std::string Unsupported;
};
}

#endif
