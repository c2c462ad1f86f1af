#include "vtkVolumeBenchmark.h"

#include "Contestant.h"
#include "Experiment.h"
#include "Names.h"
#include "ResultTable.h"
#include "Scene/DefaultTransferFunction.h"
#include "Scene/VolumeBuilder.h"
#include "Techniques/TechniqueTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTable.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkVolumeBenchmark);

namespace
{
constexpr int OpacityStride = 2;
constexpr int ColorStride = 4;

volumebench::CameraPath CameraPathOf(const std::string& name)
{
  return static_cast<volumebench::CameraPath>(volumebench::CameraPathNames().NumberOf(name));
}

void CheckAscending(const std::vector<double>& points, int stride, const char* what)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!std::isfinite(points[i]))
    {
      throw std::runtime_error(std::string(what) + " holds a value that is not finite");
    }
    if (i % stride == 0 && i > 0 && !(points[i] > points[i - stride]))
    {
      throw std::runtime_error(std::string(what) + " is not ascending: " +
        std::to_string(points[i]) + " follows " + std::to_string(points[i - stride]));
    }
  }
}
}

vtkVolumeBenchmark::vtkVolumeBenchmark()
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

vtkVolumeBenchmark::~vtkVolumeBenchmark() = default;

int vtkVolumeBenchmark::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

const char* vtkVolumeBenchmark::GetCudaDevice()
{
  this->CudaDevice = volumebench::DeviceOfTechnique("cuda");
  return this->CudaDevice.c_str();
}

void vtkVolumeBenchmark::AddTechnique(const char* id)
{
  this->Techniques.emplace_back(id ? id : "");
  this->Modified();
}

void vtkVolumeBenchmark::ClearTechniques()
{
  this->Techniques.clear();
  this->Modified();
}

void vtkVolumeBenchmark::AddIntegrator(const char* name)
{
  this->Integrators.emplace_back(name ? name : "");
  this->Modified();
}

void vtkVolumeBenchmark::ClearIntegrators()
{
  this->Integrators.clear();
  this->Modified();
}

void vtkVolumeBenchmark::AddVariant(const char* text)
{
  this->Variants.emplace_back(text ? text : "");
  this->Modified();
}

void vtkVolumeBenchmark::ClearVariants()
{
  this->Variants.clear();
  this->Modified();
}

void vtkVolumeBenchmark::AddStepVoxels(double step)
{
  this->Append(this->Steps, { step });
}

void vtkVolumeBenchmark::ClearStepVoxels()
{
  this->Steps.clear();
  this->Modified();
}

void vtkVolumeBenchmark::AddOpacityPoint(double x, double alpha)
{
  this->Append(this->OpacityPoints, { x, alpha });
}

void vtkVolumeBenchmark::ClearOpacityPoints()
{
  this->OpacityPoints.clear();
  this->Modified();
}

void vtkVolumeBenchmark::AddColorPoint(double x, double r, double g, double b)
{
  this->Append(this->ColorPoints, { x, r, g, b });
}

void vtkVolumeBenchmark::ClearColorPoints()
{
  this->ColorPoints.clear();
  this->Modified();
}

void vtkVolumeBenchmark::Append(std::vector<double>& points, std::initializer_list<double> values)
{
  points.insert(points.end(), values);
  this->Modified();
}

int vtkVolumeBenchmark::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[0], 0);
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  vtkTable* curves = vtkTable::GetData(outputVector, 1);
  try
  {
    this->Measure(image, table, curves);
  }
  catch (const std::exception& error)
  {
    // The pipeline goes on with an empty table: a failure would add a second, vaguer error.
    vtkErrorMacro("Nothing measured: " << error.what());
    table->Initialize();
    curves->Initialize();
  }
  return 1;
}

volumebench::ExperimentSettings vtkVolumeBenchmark::MakeSettings() const
{
  volumebench::ExperimentSettings settings;
  settings.Techniques = this->Techniques;
  for (const std::string& name : this->Integrators)
  {
    settings.Integrators.push_back(volumebench::IntegratorNames().NumberOf(name));
  }
  settings.StepsVoxels = this->Steps;
  settings.RaySetUp = this->RaySetUp;
  settings.Own.TerminationThreshold = this->TerminationThreshold;
  settings.Own.Jitter = this->Jitter;
  settings.Own.JitterSeed = this->JitterSeed;
  settings.Own.WorkGroupShape = this->WorkGroupShape;
  settings.Own.OpenClDevice = this->OpenClDevice;
  settings.Own.OpenClStorage = this->OpenClStorage;
  settings.Own.VoxelOrder = this->VoxelOrder;
  settings.Own.PictureTransfer = this->PictureTransfer;
  settings.Own.SliceExtent = this->SliceExtent;
  settings.Own.SliceThreads = this->SliceThreads;
  settings.Own.SliceTarget = this->SliceTarget;
  settings.Own.SliceOrder = this->SliceOrder;
  for (const std::string& text : this->Variants)
  {
    settings.Variants.push_back(volumebench::ParseVariant(text));
    settings.Variants.back().Number = static_cast<int>(settings.Variants.size()) - 1;
  }
  settings.Width = this->ImageSize[0];
  settings.Height = this->ImageSize[1];
  settings.Orbit = { this->Frames, this->Elevation, this->Zoom, CameraPathOf(this->CameraPath),
    this->CameraSeed };
  settings.Stop.MinimumFrames = this->MinimumFrames;
  settings.Stop.RelativeNoise = this->RelativeNoise;
  settings.Stop.TimeLimitS = this->TimeLimit;
  settings.Stop.DurationS = this->Seconds;
  settings.CoolDownMs = this->CoolDown;
  settings.WarmUpFrames = this->WarmUpFrames;
  settings.ErrorViews = this->ErrorViews;
  settings.ErrorWidth = this->ErrorImageSize[0];
  settings.ErrorHeight = this->ErrorImageSize[1];
  settings.Reference = this->Reference;
  settings.ReferenceStepVoxels = this->ReferenceStepVoxels;
  settings.PictureFolder = this->PictureFolder;
  volumebench::CheckSettings(settings);
  volumebench::BlendModeNames().NameOf(this->BlendMode);
  return settings;
}

void vtkVolumeBenchmark::Measure(vtkImageData* image, vtkTable* table, vtkTable* curves)
{
  const volumebench::ExperimentSettings settings = this->MakeSettings();
  bool onCells = false;
  vtkDataArray* scalars = this->ChooseArray(image, onCells);
  volumebench::ContestantInput input;
  input.Image = image;
  input.ArrayName = scalars->GetName() ? scalars->GetName() : "";
  input.CellArray = onCells;
  input.Components = scalars->GetNumberOfComponents();
  input.VectorMode = this->VectorMode;
  input.VectorComponent = this->VectorComponent;
  input.BlendMode = this->BlendMode;
  input.LightingDamping = this->LightingDamping;
  // Input that no technique can draw is refused here, before any window opens.
  const volumebench::Volume volume = volumebench::VolumeBuilder().Build(image,
    { input.CellArray ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA,
      VTK_GET_ARRAY_BY_NAME, -1, input.ArrayName.c_str() },
    { this->VectorMode == 0 ? -1 : this->VectorComponent }, false, nullptr);
  vtkNew<vtkVolumeProperty> property;
  this->FillProperty(image, volume.FiniteRange, property);
  input.Property = property;

  const auto results = volumebench::RunExperiment(
    settings, input,
    [this](double share)
    {
      this->UpdateProgress(share);
      return this->GetAbortExecute() == 0;
    },
    [this](std::string note) { this->InvokeEvent(vtkCommand::UserEvent, note.data()); });
  volumebench::FillResultTable(results, settings, this->CameraPath, table);
  volumebench::FillErrorCurves(results, curves);
}

vtkDataArray* vtkVolumeBenchmark::ChooseArray(vtkImageData* image, bool& onCells)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, image, association);
  onCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  if (!scalars && name && *name)
  {
    throw std::runtime_error("the input has no numeric array '" + std::string(name) + "'");
  }
  if (!scalars)
  {
    volumebench::Centering center = volumebench::Centering::Point;
    scalars = volumebench::FirstArray(image, center);
    onCells = center == volumebench::Centering::Cell;
  }
  if (!scalars)
  {
    throw std::runtime_error("the input has no numeric array to draw");
  }
  return scalars;
}

void vtkVolumeBenchmark::FillProperty(
  vtkImageData* image, const double range[2], vtkVolumeProperty* property)
{
  CheckAscending(this->OpacityPoints, OpacityStride, "the opacity function");
  CheckAscending(this->ColorPoints, ColorStride, "the colour function");
  volumebench::FillDefaultTransferFunction(property, range);
  if (!this->OpacityPoints.empty())
  {
    vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
    opacity->RemoveAllPoints();
    for (std::size_t i = 0; i < this->OpacityPoints.size(); i += OpacityStride)
    {
      opacity->AddPoint(this->OpacityPoints[i], this->OpacityPoints[i + 1]);
    }
  }
  if (!this->ColorPoints.empty())
  {
    vtkColorTransferFunction* color = property->GetRGBTransferFunction();
    color->RemoveAllPoints();
    color->SetColorSpaceToRGB();
    for (std::size_t i = 0; i < this->ColorPoints.size(); i += ColorStride)
    {
      const double* point = this->ColorPoints.data() + i;
      color->AddRGBPoint(point[0], point[1], point[2], point[3]);
    }
  }
  const double* spacing = image->GetSpacing();
  const double meanSpacing = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  property->SetScalarOpacityUnitDistance(
    this->ScalarOpacityUnitDistance > 0.0 ? this->ScalarOpacityUnitDistance : meanSpacing);
  property->SetShade(this->Shade);
  property->SetInterpolationTypeToLinear();
}

void vtkVolumeBenchmark::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Techniques:";
  for (const std::string& id : this->Techniques)
  {
    os << " " << id;
  }
  os << "\n";
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "LightingDamping: " << this->LightingDamping << "\n";
  os << indent << "Frames: " << this->Frames << "\n";
  os << indent << "ErrorViews: " << this->ErrorViews << "\n";
}
