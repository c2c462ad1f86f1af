#include "Scene/SceneBuilder.h"

#include "Bricks/VolumeShare.h"

#include "Scene/CameraBuilder.h"
#include "Scene/CellMap.h"
#include "Scene/CheckScene.h"
#include "Scene/FromVtk.h"
#include "Scene/KernelScene.h"
#include "Scene/Features.h"
#include "Scene/Majorant.h"
#include "Scene/HomogeneousCells.h"
#include "Scene/NumberText.h"
#include "Scene/PrefixTable.h"
#include "Scene/StepLengths.h"
#include "Scene/WorkGroup.h"
#include "Scene/TransferFunctionTable.h"
#include "Stopwatch.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
ChannelRequest ChannelsOf(vtkVolumeBenchMapper* mapper, vtkVolumeProperty* property)
{
  const bool magnitude = mapper->GetVectorMode() == vtkVolumeBenchMapper::Magnitude;
  return { magnitude ? -1 : mapper->GetVectorComponent(), !property->GetIndependentComponents() };
}

// Refuses a number that is none of an enumeration's.
int Checked(int value, int last, const char* what)
{
  if (value < 0 || value > last)
  {
    throw SceneError("there is no " + std::string(what) + " " + std::to_string(value));
  }
  return value;
}

glm::ivec2 WorkGroupOf(const std::string& text)
{
  const glm::ivec2 shape = ParseWorkGroup(text);
  if (shape.x < 0)
  {
    throw SceneError(
      "there is no work-group shape '" + text + "'; known are Auto, " + WorkGroupNames());
  }
  return shape;
}

Slicing BuildSlicing(vtkVolumeBenchMapper* mapper)
{
  Slicing slicing;
  slicing.Extent = static_cast<SliceExtent>(Checked(mapper->GetSliceExtent(), 2, "slice extent"));
  slicing.Target = static_cast<SliceTarget>(Checked(mapper->GetSliceTarget(), 2, "slice target"));
  slicing.BackToFront = Checked(mapper->GetSliceOrder(), 1, "slice order") == 1;
  slicing.Threads = mapper->GetSliceThreads();
  if (slicing.Threads < 0 || slicing.Threads > MostSliceThreads)
  {
    throw SceneError("slices cannot be made by " + std::to_string(slicing.Threads) +
      " threads; there may be 1 to " + std::to_string(MostSliceThreads) + ", or 0 for Auto");
  }
  return slicing;
}

Sampling BuildSampling(vtkVolumeBenchMapper* mapper)
{
  Sampling sampling;
  sampling.Integration = static_cast<Integrator>(Checked(mapper->GetIntegrator(), 4, "integrator"));
  sampling.SetUp = static_cast<RaySetUp>(mapper->GetRaySetUp());
  sampling.StepVoxels = mapper->GetStepVoxels();
  sampling.TerminationThreshold = mapper->GetTerminationThreshold();
  sampling.Jitter = mapper->GetJitter();
  sampling.JitterSeed = mapper->GetJitterSeed();
  sampling.TableSize = mapper->GetTableSize();
  sampling.SkipsEmptySpace = mapper->GetSkipping();
  sampling.MacrocellVoxels = mapper->GetMacrocellVoxels();
  sampling.WorkGroup = WorkGroupOf(mapper->GetWorkGroupShape());
  sampling.Order = static_cast<VoxelOrder>(Checked(mapper->GetVoxelOrder(), 2, "voxel order"));
  sampling.Transfer =
    static_cast<PictureTransfer>(Checked(mapper->GetPictureTransfer(), 2, "picture transfer"));
  sampling.Slices = BuildSlicing(mapper);
  sampling.OpenCl = { mapper->GetOpenClDevice(),
    static_cast<OpenClStorage>(Checked(mapper->GetOpenClStorage(), 2, "OpenCL storage")) };
  sampling.Method =
    static_cast<ReferenceMethod>(Checked(mapper->GetReferenceMethod(), 1, "reference method"));
  if (sampling.MacrocellVoxels != 0 && sampling.MacrocellVoxels < 2)
  {
    throw SceneError("the macrocells have an edge of " + std::to_string(sampling.MacrocellVoxels) +
      " voxels; it must be at least 2, or 0 for one that suits the volume");
  }
  if (!(sampling.StepVoxels >= SmallestStepVoxels) || !std::isfinite(sampling.StepVoxels))
  {
    throw SceneError("the step is " + NumberText(sampling.StepVoxels) +
      " voxels; it must be at least " + NumberText(SmallestStepVoxels));
  }
  if (!(sampling.TerminationThreshold >= 0.0 && sampling.TerminationThreshold < 1.0))
  {
    throw SceneError("the termination threshold is " + NumberText(sampling.TerminationThreshold) +
      "; it must be in [0, 1)");
  }
  sampling.ErrorTarget = mapper->GetErrorTarget();
  if (!(sampling.ErrorTarget >= 0.0 && sampling.ErrorTarget <= 1.0))
  {
    throw SceneError("the error target is " + NumberText(sampling.ErrorTarget) +
      "; it must be in [0, 1], where 0 takes all steps alike");
  }
  sampling.MemoryBudgetMiB = mapper->GetMemoryBudgetMiB();
  if (!(sampling.MemoryBudgetMiB >= 0.0) || !std::isfinite(sampling.MemoryBudgetMiB))
  {
    throw SceneError("the memory budget is " + std::to_string(sampling.MemoryBudgetMiB) +
      " MiB; it must be positive, or 0 for what the device has");
  }
  if (sampling.JitterSeed < 0 || sampling.JitterSeed > MostJitterSeed)
  {
    throw SceneError("the jitter seed is " + std::to_string(sampling.JitterSeed) +
      "; it must be from 0 to " + std::to_string(MostJitterSeed));
  }
  return sampling;
}

BlendMode BlendModeOf(vtkVolumeBenchMapper* mapper)
{
  switch (mapper->GetBlendMode())
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
      return BlendMode::Composite;
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return BlendMode::Maximum;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return BlendMode::Minimum;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return BlendMode::Average;
    case vtkVolumeBenchMapper::GRADIENT_BLEND:
      return BlendMode::Gradient;
    default:
      throw SceneError("the blend mode " + std::to_string(mapper->GetBlendMode()) +
        " cannot be drawn: only Composite, Maximum, Minimum, Average and Gradient can");
  }
}

void AddPlanes(vtkVolumeBenchMapper* mapper, Clip& clip)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const int count = planes ? planes->GetNumberOfItems() : 0;
  if (count > ClipPlaneLimit)
  {
    throw SceneError("there are " + std::to_string(count) + " clip planes; at most " +
      std::to_string(ClipPlaneLimit) + " can be drawn");
  }
  for (int i = 0; i < count; ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const glm::dvec3 normal = FromVtk(plane->GetNormal());
    clip.Planes.emplace_back(normal, -glm::dot(normal, FromVtk(plane->GetOrigin())));
  }
}

Clip BuildClip(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer)
{
  Clip clip;
  clip.OpaqueGeometry = HasOpaqueGeometry(renderer);
  const bool cropping = mapper->GetCropping() != 0;
  const bool box = mapper->GetCroppingRegionFlags() == VTK_CROP_SUBVOLUME;
  constexpr unsigned int AllRegions = (1u << 27) - 1u;
  const unsigned int flags = mapper->GetCroppingRegionFlags() & static_cast<int>(AllRegions);
  clip.Crop = cropping && box;
  if (cropping && !box)
  {
    clip.CropRegionFlags = flags;
    clip.Empty = flags == 0;
  }
  const double* planes = mapper->GetCroppingRegionPlanes();
  clip.CropLow = { planes[0], planes[2], planes[4] };
  clip.CropHigh = { planes[1], planes[3], planes[5] };
  AddPlanes(mapper, clip);
  return clip;
}

void RefuseUnsupported(
  const Scene& scene, vtkVolumeBenchMapper* mapper, vtkVolumeProperty* property)
{
  const bool dependent = scene.Volume.Channels > 1;
  const bool projects = scene.Compositing.Mode == BlendMode::Maximum ||
    scene.Compositing.Mode == BlendMode::Minimum || scene.Compositing.Mode == BlendMode::Average;
  if (dependent && projects)
  {
    throw SceneError("the blend modes Maximum, Minimum and Average project one value; dependent "
                     "components have several: choose a component or the magnitude");
  }
  if (dependent && scene.Sampling.Integration == Integrator::PreIntegrated)
  {
    throw SceneError("the integrator PreIntegrated needs one value per sample; dependent "
                     "components have several: choose Midpoint");
  }
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    throw SceneError("2D transfer functions cannot be drawn");
  }
  // The mapper's own default stands for no limit; doubles reach beyond it.
  const double* range = mapper->GetAverageIPScalarRange();
  const bool limited = (range[0] > VTK_FLOAT_MIN && range[0] > scene.Volume.FiniteRange[0]) ||
    (range[1] < VTK_FLOAT_MAX && range[1] < scene.Volume.FiniteRange[1]);
  if (scene.Compositing.Mode == BlendMode::Average && limited)
  {
    throw SceneError("the blend mode Average cannot be limited to a part of the scalar range");
  }
}

// Between two entries of the table of the function there may be another colour.
void KeepColorOfSegments(TransferFunction& function)
{
  const SharedTable<glm::vec4>& entries = function.Segments;
  const bool same = function.Color &&
    std::all_of(entries.begin(), entries.end(),
      [&function](const glm::vec4& entry)
      { return entry.w <= 0.0f || IsColor(glm::vec3(entry), *function.Color); });
  if (!same)
  {
    function.Color.reset();
  }
}

// Of what the lengths of steps depend on beside the grid.
ChangeStamp StepLengthsStampOf(const Scene& scene)
{
  ChangeStamp stamp = scene.TransferFunction.Stamp;
  ExtendStamp(stamp, scene.Sampling.ErrorTarget);
  ExtendStamp(stamp, scene.Sampling.StepVoxels);
  ExtendStamp(stamp, scene.Sampling.Integration);
  for (int axis = 0; axis < 3; ++axis)
  {
    ExtendStamp(stamp, glm::length(glm::dvec3(scene.Volume.VoxelToData[axis])));
  }
  return stamp;
}

double MeanEdge(const Volume& volume)
{
  const glm::dmat3 edges(volume.VoxelToData);
  return (glm::length(edges[0]) + glm::length(edges[1]) + glm::length(edges[2])) / 3.0;
}
}

// `largestTable` holds for the prefix integrals too, which have two entries more.
void SceneBuilder::BuildTable(vtkVolumeProperty* property, Scene& scene, int largestTable)
{
  const Volume& volume = scene.Volume;
  ChangeStamp stamp = property->GetMTime();
  ExtendStamp(stamp, volume.Stamp);
  ExtendStamp(stamp, volume.FiniteRange[0]);
  ExtendStamp(stamp, volume.FiniteRange[1]);
  ExtendStamp(stamp, largestTable);
  ExtendStamp(stamp, scene.Sampling.TableSize);
  if (stamp != this->TableStamp)
  {
    this->TableStamp = 0;
    this->Table = BuildTransferFunction(property, volume.FiniteRange,
      { largestTable - 2, scene.Sampling.TableSize },
      volume.Channels == 2 ? volume.ColorRange : nullptr);
    this->TableStamp = stamp;
  }
  scene.TransferFunction = this->Table;
}

// Adds to the table what the scene's integrator has beside it.
void SceneBuilder::AddIntegrals(Scene& scene)
{
  const bool prefix = Has(FeaturesNeededBy(scene), Feature::Segment);
  const bool segments = Has(FeaturesNeededBy(scene), Feature::PreIntegrated);
  const double length = scene.Sampling.StepVoxels * MeanEdge(scene.Volume);
  ChangeStamp stamp = this->TableStamp;
  ExtendStamp(stamp, prefix);
  ExtendStamp(stamp, segments ? length : 0.0);
  if (stamp != this->FunctionStamp)
  {
    this->FunctionStamp = 0;
    this->Function = this->Table;
    if (prefix)
    {
      BuildPrefixTable(this->Function);
      ExtendStamp(this->Function.Stamp, prefix);
    }
    if (segments)
    {
      const double perVoxel = std::max(1.0, 1.0 / scene.Sampling.StepVoxels);
      this->Segments.Build(this->Function, { length, perVoxel });
      this->Function.SegmentSize = this->Segments.GetSize();
      this->Function.Segments = this->Segments.GetEntries();
      KeepColorOfSegments(this->Function);
      ExtendStamp(this->Function.Stamp, length);
      ExtendStamp(this->Function.Stamp, perVoxel);
    }
    this->Function.ExtinctionStamp = Majorant::StampOf(this->Function);
    this->FunctionStamp = stamp;
  }
  scene.TransferFunction = this->Function;
}

void SceneBuilder::BuildSkipping(Scene& scene)
{
  const BlendMode mode = scene.Compositing.Mode;
  if (!scene.Sampling.SkipsEmptySpace || mode == BlendMode::Average)
  {
    return;
  }
  const bool extreme = mode == BlendMode::Maximum || mode == BlendMode::Minimum;
  const bool graded = CanGradeSteps(scene);
  ChangeStamp stamp = MacrocellCache::StampOf(scene);
  if (graded || !WhyNoHomogeneousCells(scene))
  {
    ExtendStamp(stamp, StepLengthsStampOf(scene));
  }
  ExtendStamp(stamp, extreme ? 0 : scene.TransferFunction.ExtinctionStamp);
  ExtendStamp(stamp, mode);
  if (stamp != this->SkipsStamp)
  {
    const MacrocellGrid& grid = this->Cells.GridOf(scene);
    const double choosingMs = this->Choice.TakeMs();
    const Stopwatch watch;
    CellMap cells = extreme ? MapExtremes(grid, scene)
      : graded              ? MapGradedCells(grid, this->Cells.ChangesOf(scene), scene)
                            : MapOccupiedCells(grid, scene);
    cells.Stamp = stamp;
    this->Skips.Cells = std::make_shared<CellMap>(std::move(cells));
    this->SkipsStamp = stamp;
    this->Skips.GridMs = watch.ElapsedMs() + this->Cells.TakeMs() + choosingMs;
  }
  scene.Skipping = this->Skips;
  if (graded)
  {
    // Light that a ray stops short of is an error as well; a quarter of the target is left to it.
    scene.Sampling.TerminationThreshold =
      std::min(scene.Sampling.TerminationThreshold, 0.25 * scene.Sampling.ErrorTarget);
  }
}

Volume SceneBuilder::BuildVolume(
  vtkVolumeBenchMapper* mapper, vtkVolume* volume, vtkImageData* image)
{
  const ArrayRequest request{ mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
    mapper->GetArrayId(), mapper->GetArrayName() };
  vtkVolumeProperty* property = volume->GetProperty();
  const bool nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  return this->Volumes.Build(
    image, request, ChannelsOf(mapper, property), nearest, volume->GetMatrix());
}

ScalarRange SceneBuilder::RangeOf(
  vtkVolumeBenchMapper* mapper, vtkVolume* volume, vtkImageData* image)
{
  const Volume built = this->BuildVolume(mapper, volume, image);
  return { built.FiniteRange[0], built.FiniteRange[1] };
}

Scene SceneBuilder::Build(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
  vtkImageData* image, const ScalarRange& range, const RenderTarget& target)
{
  Scene scene;
  vtkVolumeProperty* property = volume->GetProperty();
  scene.Sampling = BuildSampling(mapper);
  scene.Compositing.Mode = BlendModeOf(mapper);
  scene.Measurement = { mapper->GetCountSamples(),
    Checked(mapper->GetShow(), vtkVolumeBenchMapper::SamplesPerPixel, "view") ==
      vtkVolumeBenchMapper::SamplesPerPixel,
    mapper->GetTimeStages() };
  scene.Volume = this->BuildVolume(mapper, volume, image);
  scene.Volume.FiniteRange[0] = range.Low;
  scene.Volume.FiniteRange[1] = range.High;
  RefuseUnsupported(scene, mapper, property);
  scene.Camera = BuildCamera(renderer, target.Viewport);
  scene.Lighting = BuildLighting(renderer, property);
  scene.Lighting.Damping = mapper->GetLightingDamping();
  scene.Clip = BuildClip(mapper, renderer);
  scene.Share = ShareOf(image, scene.Volume);
  scene.Sampling.StepsMayVary = target.StepsMayVary;
  this->BuildTable(property, scene, target.LargestTable);
  this->Choice.Choose(this->Cells, scene);
  scene.Sampling.StepVoxels *= target.StepFactor; // with the still picture's integrator
  this->AddIntegrals(scene);
  CheckScene(scene);
  this->BuildSkipping(scene);
  return scene;
}
}
