#include "CUDA/CudaCheck.h"

#include "CUDA/CudaRays.h"
#include "CUDA/VoxelTurner.h"
#include "Error/ImageError.h"
#include "Reference/ReferenceRenderer.h"
#include "Scene/TransferFunctionTable.h"
#include "Scene/VolumeBuilder.h"
#include "VoxelOrder/VoxelOrder.h"

#include "vtkAbstractMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace volumebench
{
namespace
{
constexpr int Pixels = 128;
constexpr double MostRmse = 2e-3;
constexpr double StepVoxels = 0.25;
constexpr int Repeats = 21;

vtkSmartPointer<vtkImageData> Waves()
{
  const int size[3] = { 48, 37, 29 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size);
  vtkNew<vtkFloatArray> values;
  values->SetName("waves");
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        values->InsertNextValue(static_cast<float>(
          0.5 + 0.25 * std::sin(0.3 * i + 0.2 * j) + 0.25 * std::cos(0.25 * k - 0.1 * i)));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkVolumeProperty> Haze()
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.3, 0.0);
  opacity->AddPoint(1.0, 0.3);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  color->AddRGBPoint(1.0, 0.9, 0.4, 0.1);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  return property;
}

void Look(Scene& scene, double degrees)
{
  const glm::dvec3 middle = 0.5 * glm::dvec3(scene.Volume.Texels - 1);
  const double distance = 3.0 * glm::length(middle);
  const double angle = glm::radians(degrees);
  const glm::dvec3 eye = middle + distance * glm::dvec3(std::sin(angle), 0.2, std::cos(angle));
  Camera& camera = scene.Camera;
  camera.WorldToView = glm::lookAt(eye, middle, glm::dvec3(0.0, 1.0, 0.0));
  camera.NearDepth = 0.1 * distance;
  camera.FarDepth = 3.0 * distance;
  camera.ViewToClip = glm::perspective(glm::radians(45.0), 1.0, camera.NearDepth, camera.FarDepth);
  camera.Viewport = { 0, 0, Pixels, Pixels };
}

FloatPicture ReferenceOf(const Scene& scene)
{
  Scene plain = scene;
  plain.Sampling = {};
  plain.Sampling.SetUp = RaySetUp::Box;
  const ReferencePicture exact = ReferenceRenderer().Render(plain);
  FloatPicture picture{ Pixels, Pixels, std::vector<float>(4 * Pixels * Pixels, 0.0f) };
  for (std::size_t i = 0; i < exact.Pixels.size(); ++i)
  {
    const int x = exact.Rectangle.x + static_cast<int>(i) % exact.Width;
    const int y = exact.Rectangle.y + static_cast<int>(i) / exact.Width;
    for (int channel = 0; channel < 4; ++channel)
    {
      picture.Pixels[4 * (y * Pixels + x) + channel] = static_cast<float>(exact.Pixels[i][channel]);
    }
  }
  return picture;
}

// Views round the volume by one caster each, so that In-Place Rotation turns the voxels on the way.
void CheckPictures(CudaCheck& check)
{
  const std::pair<VoxelOrder, const char*> orders[] = { { VoxelOrder::Naive, "Naive" },
    { VoxelOrder::BlockShape, "Block Shape" },
    { VoxelOrder::InPlaceRotation, "In-Place Rotation" } };
  for (const auto& [order, name] : orders)
  {
    for (const bool lit : { false, true })
    {
      CudaRays rays;
      Scene scene = MakeCheckScene(lit, 0.0);
      scene.Sampling.Order = order;
      for (const int degrees : { 0, 88, 91, 94, 180, 182, 184, 271, 273, 275, 360 })
      {
        Look(scene, degrees);
        const FloatPicture picture = rays.Render(scene);
        check.Pictures.push_back(
          CheckPicture(std::string(name) + (lit ? ", shaded, " : ", ") + std::to_string(degrees) +
              " degrees, " + std::to_string(rays.GetQuarterTurns()) + " quarter turns",
            scene, picture));
      }
    }
  }
}

double MedianMs(const std::function<void()>& work)
{
  CudaTimer timer;
  std::vector<double> ms;
  work();
  for (int i = 0; i < Repeats; ++i)
  {
    timer.Start();
    work();
    timer.Stop();
    ms.push_back(timer.ElapsedMs());
  }
  std::nth_element(ms.begin(), ms.begin() + Repeats / 2, ms.end());
  return ms[Repeats / 2];
}

void CopyArray(const CudaTexture& from, const CudaTexture& to)
{
  CUDA_MEMCPY3D copy = {};
  copy.srcMemoryType = CU_MEMORYTYPE_ARRAY;
  copy.srcArray = from.GetArray();
  copy.dstMemoryType = CU_MEMORYTYPE_ARRAY;
  copy.dstArray = to.GetArray();
  copy.WidthInBytes = from.GetSize().x * sizeof(std::uint16_t);
  copy.Height = from.GetSize().y;
  copy.Depth = from.GetSize().z;
  CheckCuda(Cuda().cuMemcpy3D(&copy), "cuMemcpy3D");
}

class TurnedCube
{
public:
  explicit TurnedCube(int side)
    : Texels(side)
    , Voxels(static_cast<std::size_t>(side) * side * side)
  {
    for (std::size_t i = 0; i < this->Voxels.size(); ++i)
    {
      this->Voxels[i] = static_cast<std::uint16_t>(i * 2654435761u >> 7); // alike by chance only
    }
    CudaTexels texels;
    texels.Format = CU_AD_FORMAT_UNSIGNED_INT16;
    texels.Written = true;
    this->Array.Create(texels, this->Texels);
    this->Copy.Create(texels, this->Texels);
  }

  double CopyMs()
  {
    return MedianMs([this] { CopyArray(this->Array, this->Copy); });
  }

  bool IsRight(int layers)
  {
    this->Array.Send(this->Voxels.data(), 0, this->Texels.z);
    TurnVoxels(CudaDevice::Get(), this->Array, layers);
    std::vector<std::uint16_t> turned(this->Voxels.size());
    this->Array.Read(turned.data());
    for (std::size_t i = 0; i < this->Voxels.size(); ++i)
    {
      const std::size_t row = i / this->Texels.x;
      const glm::ivec3 at(i % this->Texels.x, row % this->Texels.y, row / this->Texels.y);
      const glm::ivec3 to = OrderedVoxel(at, this->Texels, 1);
      const std::size_t place =
        to.x + this->Texels.x * (to.y + static_cast<std::size_t>(this->Texels.y) * to.z);
      if (turned[place] != this->Voxels[i])
      {
        return false;
      }
    }
    return true;
  }

  double TurnMs(int layers)
  {
    return MedianMs([&] { TurnVoxels(CudaDevice::Get(), this->Array, layers); });
  }

  std::size_t GetBytes() const { return this->Voxels.size() * sizeof(std::uint16_t); }

private:
  glm::ivec3 Texels;
  std::vector<std::uint16_t> Voxels;
  CudaTexture Array;
  CudaTexture Copy;
};

// Rates count each byte that is read and each that is written.
void CheckTurns(CudaCheck& check)
{
  TurnedCube cube(check.TurnedSide);
  const double copyMs = cube.CopyMs();
  check.CopyBytesPerSecond = 2000.0 * static_cast<double>(cube.GetBytes()) / copyMs;
  for (const int layers : { 1, 2, 4, 8, 16 })
  {
    const bool right = cube.IsRight(layers);
    const double ms = cube.TurnMs(layers);
    check.Turns.push_back({ layers, right, ms, copyMs / ms });
  }
}

void CheckKernels(CudaCheck& check)
{
  const std::pair<const char*, std::vector<Feature>> variants[] = { { "Midpoint",
                                                                      { Feature::Midpoint } },
    { "Midpoint, shaded", { Feature::Midpoint, Feature::Lighting } },
    { "Midpoint, skipping", { Feature::Midpoint, Feature::Skipping, Feature::TightBox } },
    { "Midpoint, shaded, skipping, ending early",
      { Feature::Midpoint, Feature::Lighting, Feature::Skipping, Feature::TightBox,
        Feature::Termination } },
    { "Segment", { Feature::Midpoint, Feature::Segment, Feature::StiffSteps } },
    { "PreIntegrated", { Feature::Midpoint, Feature::PreIntegrated } },
    { "Maximum", { Feature::Midpoint, Feature::MaximumBlend, Feature::Skipping } } };
  for (const auto& [name, parts] : variants)
  {
    FeatureSet features;
    for (const Feature part : parts)
    {
      features.set(static_cast<std::size_t>(part));
    }
    for (const bool turned : { false, true })
    {
      const CudaKernel& kernel = CudaDevice::Get().KernelOf("RayCast.cu", "castRays",
        "sceneOfFrame", FeatureDefines(features) + (turned ? "#define VOLUME_IN_ORDER 1\n" : ""));
      check.Kernels.push_back({ name + std::string(turned ? ", In-Place Rotation" : ""),
        kernel.GetRegisters(), kernel.GetMostThreads() });
    }
  }
}
}

Scene MakeCheckScene(bool lit, double degrees)
{
  const auto image = Waves();
  const auto property = Haze();
  Scene scene;
  scene.Volume = VolumeBuilder().Build(image,
    { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "waves" }, {}, false,
    nullptr);
  scene.TransferFunction = BuildTransferFunction(property, scene.Volume.FiniteRange, {});
  scene.Sampling.StepVoxels = StepVoxels;
  scene.Sampling.SetUp = RaySetUp::Box;
  scene.Lighting.Enabled = lit;
  scene.Lighting.Lights = { { { 0.4, 0.8, 0.6, 0.0 }, { 1.0, 1.0, 1.0 } } };
  Look(scene, degrees);
  return scene;
}

CheckedPicture CheckPicture(
  const std::string& name, const Scene& scene, const FloatPicture& picture)
{
  const double rmse = CompareImages(picture, ReferenceOf(scene)).Rmse;
  return { name, rmse, rmse <= MostRmse };
}

CudaCheck CheckCudaDevice(int side, const std::function<void(const std::string&)>& report)
{
  CudaDevice::Get();
  const CudaScope scope;
  CudaCheck check;
  check.Device = CudaDevice::Description();
  check.TurnedSide = side;
  report("pictures against the exact reference");
  CheckPictures(check);
  report("turns of a volume of " + std::to_string(side) + " voxels a side");
  CheckTurns(check);
  report("kernels");
  CheckKernels(check);
  return check;
}
}
