#include "Techniques/OpenClRayCast.h"

#include "Gpu/GlRoom.h"
#include "Scene/PackScene.h"
#include "Scene/WorkGroup.h"
#include "Stopwatch.h"
#include "VoxelOrder/ViewClass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

#include <glm/common.hpp>

namespace volumebench
{
namespace
{
constexpr const char* Entry = "RayCast.cl";
constexpr const char* LanesEntry = "RayCastLanes.cl";

// Drivers for CPUs compile a kernel anew for each shape, and lose next to nothing with this one.
constexpr glm::ivec2 CpuWorkGroup(16, 8);

// Of what a processor casts at a time, at most.
constexpr std::size_t BandBytes = std::size_t(1) << 20;

bool UsesBuffers(const Scene& scene, const OpenClDevice& device)
{
  const OpenClStorage storage = scene.Sampling.OpenCl.Storage;
  if (storage == OpenClStorage::Images && !device.HasImages)
  {
    throw SceneError("the OpenCL device '" + device.Name + "' has no images; choose Buffers");
  }
  const bool suits = device.IsCpu() || !device.HasImages;
  return storage == OpenClStorage::Auto ? suits : storage == OpenClStorage::Buffers;
}

// Rays that a work item casts side by side. Voxels are counted by whole numbers of the
// lanes, which have 32 bits.
int LanesFor(const Scene& scene, const OpenClDevice& device)
{
  const glm::dvec3 texels(scene.Volume.Texels);
  const double most = static_cast<double>(std::numeric_limits<cl_int>::max());
  if (!device.IsCpu() || !UsesBuffers(scene, device) || WhyNoSimdRays(scene) ||
    (texels.x + 1.0) * (texels.y + 1.0) * (texels.z + 1.0) > most)
  {
    return 1;
  }
  const int chosen = scene.Sampling.OpenCl.Lanes;
  return chosen > 0 ? chosen : device.Lanes();
}

// Pixels of a work item: nearly square, or along the smaller stride of the voxels.
glm::ivec2 TileOf(int lanes, bool shaped, bool across)
{
  if (lanes == 1)
  {
    return { 1, 1 };
  }
  const int columns = shaped ? (across ? lanes / 2 : 2) : 4;
  return { columns, lanes / columns };
}

double MillisecondsOf(cl_event event)
{
  const OpenClApi& cl = OpenCl();
  CheckOpenCl(cl.WaitForEvents(1, &event), "the kernel");
  cl_ulong begin = 0;
  cl_ulong end = 0;
  cl.GetEventProfilingInfo(event, CL_PROFILING_COMMAND_START, sizeof(begin), &begin, nullptr);
  cl.GetEventProfilingInfo(event, CL_PROFILING_COMMAND_END, sizeof(end), &end, nullptr);
  cl.ReleaseEvent(event);
  return static_cast<double>(end - begin) * 1.0e-6;
}

void CheckWorkGroup(const OpenClSession& session, cl_kernel kernel, glm::ivec2 shape)
{
  const std::size_t most = session.LargestWorkGroup(kernel);
  if (static_cast<std::size_t>(shape.x) * shape.y > most)
  {
    throw SceneError("the work group " + WorkGroupName(shape) +
      " is too large: the OpenCL device '" + session.GetDevice().Name + "' takes at most " +
      std::to_string(most) + " work items of this kernel in a group");
  }
}
}

std::string OpenClRayCast::GetDeviceName() const
{
  return OpenClDevices().empty() ? std::string() : OpenClDevices().front().Name;
}

FeatureSet OpenClRayCast::FeaturesFor(const Scene& scene) const
{
  FeatureSet features = FeaturesNeededBy(scene);
  features.reset(static_cast<std::size_t>(Feature::RasterisedSetUp));
  const OpenClDevice& device = ChooseOpenClDevice(OpenClDevices(), scene.Sampling.OpenCl.Device);
  const bool lanes = LanesFor(scene, device) > 1;
  features.set(static_cast<std::size_t>(Feature::SimdRays), lanes);
  if (lanes) // whose text looks values up itself
  {
    features.reset(static_cast<std::size_t>(Feature::Ramps));
    features.reset(static_cast<std::size_t>(Feature::MoreRamps));
  }
  return features;
}

std::optional<VolumeRoom> OpenClRayCast::RoomFor(const Scene& scene) const
{
  const OpenClDevice& device = ChooseOpenClDevice(OpenClDevices(), scene.Sampling.OpenCl.Device);
  return OpenClScene::RoomFor(scene.Volume, OpenClSession::Of(device), UsesBuffers(scene, device));
}

void OpenClRayCast::Compile(const Scene& scene)
{
  this->ProgramOf({ "Viewport.vert", "Picture.frag" });
  const OpenClDevice& device = ChooseOpenClDevice(OpenClDevices(), scene.Sampling.OpenCl.Device);
  OpenClSession& session = this->SessionFor(device);
  const FeatureSet features = this->GetFeatures();
  this->Data.Update(scene, features, session, UsesBuffers(scene, device));
  if (!Has(features, Feature::OpaqueDepth))
  {
    this->Depth.Release();
  }
  RefuseTurns(scene, "opencl");
  const Stopwatch watch;
  const ViewClass view = ViewClassOf(ScreenAxesOf(scene));
  if (!this->CompileFor(scene, view))
  {
    return;
  }
  if (scene.Sampling.Order == VoxelOrder::BlockShape)
  {
    this->CompileFor(scene, { view.FacingAxis, !view.Across }); // so that no frame of a turn has to
    this->CompileFor(scene, view);
  }
  this->CompileMs = watch.ElapsedMs();
}

OpenClSession& OpenClRayCast::SessionFor(const OpenClDevice& device)
{
  const GlContext context = device.IsCpu() ? GlContext() : CurrentGlContext();
  const bool same =
    this->Session && this->Session->GetDevice().Id == device.Id && this->SharedContext == context;
  if (!same)
  {
    this->ReleaseOpenCl();
    this->Shared = OpenClSession::Sharing(device, context);
    this->SharedContext = context;
    this->Session = this->Shared ? this->Shared.get() : &OpenClSession::Of(device);
  }
  return *this->Session;
}

bool OpenClRayCast::CompileFor(const Scene& scene, const ViewClass& view)
{
  OpenClSession& session = *this->Session;
  const OpenClDevice& device = session.GetDevice();
  const int lanes = LanesFor(scene, device);
  const bool shaped = scene.Sampling.Order == VoxelOrder::BlockShape;
  this->Tile = TileOf(lanes, shaped, view.Across);
  this->WorkGroup =
    shaped ? glm::max(BlockShapeOf(view) / this->Tile, 1) : scene.Sampling.WorkGroup;
  std::string defines = FeatureDefines(this->GetFeatures()) + this->Data.GetDefines() +
    "#define LANES " + std::to_string(lanes) + "\n#define LANE_COLUMNS " +
    std::to_string(this->Tile.x) + "\n#define WITH_GL_PICTURE " + (this->Shared ? "1" : "0") + "\n";
  if (shaped)
  {
    // A text of its own for each shape of groups, as drivers for CPUs have a program.
    defines += std::string("#define ACROSS ") + (view.Across ? "1" : "0") + "\n";
  }
  if (this->Kernel && defines == this->KernelDefines)
  {
    return false; // as in most frames
  }
  const KernelText text =
    SpecializeKernel(lanes > 1 ? LanesEntry : Entry, defines, EmbeddedKernel, LineStyle::Names);
  const bool known = this->Kernel && session.HasKernel(text);
  this->Kernel = nullptr;
  this->KernelDefines = defines;
  this->Kernel = session.KernelOf(text, "castRays");
  if (!known && device.IsCpu())
  {
    // Compiles the rest: a launch without a ray.
    this->Cast({}, this->ChooseWorkGroup(scene, {}));
  }
  return !known;
}

double OpenClRayCast::Cast(const PicturePart& part, glm::ivec2 workGroup)
{
  CheckWorkGroup(*this->Session, this->Kernel, workGroup);
  const glm::ivec2 size = part.End - part.First;
  const std::size_t bytes =
    sizeof(glm::vec4) * static_cast<std::size_t>(std::max(size.x * size.y, 1));
  if (!this->Shared && this->Result.GetBytes() < bytes)
  {
    this->Result.ResizeBuffer(*this->Session, bytes, CL_MEM_WRITE_ONLY);
  }
  KernelArguments arguments(this->Kernel);
  this->Data.AddTo(arguments);
  if (Has(this->GetFeatures(), Feature::OpaqueDepth))
  {
    if (!this->Depth.IsCreated())
    {
      this->Depth.ResizeBuffer(*this->Session, sizeof(float), CL_MEM_READ_ONLY);
    }
    arguments.Add(this->Depth);
    arguments.Add(this->DepthWidth);
  }
  arguments.Add(this->Shared ? this->Target : this->Result);
  arguments.Add(cl_int4{ { part.First.x, part.First.y, part.End.x, part.End.y } });
  const glm::ivec2 pixels = workGroup * this->Tile;
  const glm::ivec2 groups = glm::max((size + pixels - 1) / pixels, glm::ivec2(1));
  const std::size_t group[2] = { static_cast<std::size_t>(workGroup.x),
    static_cast<std::size_t>(workGroup.y) };
  const std::size_t items[2] = { groups.x * group[0], groups.y * group[1] };
  cl_event done = nullptr;
  CheckOpenCl(OpenCl().EnqueueNDRangeKernel(this->Session->GetQueue(), this->Kernel, 2, nullptr,
                items, group, 0, nullptr, &done),
    "clEnqueueNDRangeKernel");
  return MillisecondsOf(done);
}

void OpenClRayCast::SendDepth(const glm::ivec4& viewport)
{
  const Stopwatch watch;
  const std::vector<float> depth = this->GetDepth().Read(viewport);
  this->Depth.ResizeBuffer(*this->Session, depth.size() * sizeof(float), CL_MEM_READ_ONLY);
  this->Depth.Write(depth.data(), depth.size() * sizeof(float));
  this->DepthWidth = viewport.z;
  this->GetFrameStages().Add("opaque depth", watch.ElapsedMs());
}

void OpenClRayCast::Draw(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  glFlush(); // what is timed by OpenGL begins before the kernel does
  if (Has(this->GetFeatures(), Feature::OpaqueDepth))
  {
    this->SendDepth(scene.Camera.Viewport);
  }
  this->Data.SetNumbers(RoundToFloat(this->GetNumbers()));
  const glm::ivec4 box = BoxRectangle(scene);
  const PicturePart part = PartOf(box, rectangle);
  this->Picture.Bind(GL_TEXTURE_2D);
  if (this->PictureSize != glm::ivec2(box.z, box.w))
  {
    this->Picture.SetSampling(false);
    this->PictureSize = glm::ivec2(0);
    ForgetGlErrors();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, box.z, box.w, 0, GL_RGBA, GL_FLOAT, nullptr);
    CheckGlRoom(
      "a picture of " + std::to_string(box.z) + " x " + std::to_string(box.w) + " pixels");
    this->PictureSize = { box.z, box.w };
    this->Target.Release();
  }
  if (this->Shared)
  {
    this->Picture.Unbind();
    this->CastShared(scene, part);
    this->DisplayPicture(window, this->Picture, rectangle);
    return;
  }
  const glm::ivec2 workGroup = this->ChooseWorkGroup(scene, part);
  for (const PicturePart& band : this->BandsOf(part, workGroup.y))
  {
    this->GetFrameStages().Add("dispatch", this->Cast(band, workGroup));
    this->Transfer(band);
  }
  this->Picture.Unbind();
  this->DisplayPicture(window, this->Picture, rectangle);
}

void OpenClRayCast::CastShared(const Scene& scene, const PicturePart& part)
{
  if (!this->Target.IsCreated())
  {
    this->Target.ShareTexture(*this->Session, this->Picture.GetHandle());
  }
  glFinish(); // OpenGL must be done with the texture
  this->Target.WhileAcquired(
    [&]
    {
      const glm::ivec2 workGroup = this->ChooseWorkGroup(scene, part);
      this->GetFrameStages().Add("dispatch", this->Cast(part, workGroup));
    });
}

std::vector<PicturePart> OpenClRayCast::BandsOf(const PicturePart& part, int groupRows) const
{
  const glm::ivec2 size = part.End - part.First;
  const int unit = groupRows * this->Tile.y;
  const std::size_t bytes = sizeof(glm::vec4) * static_cast<std::size_t>(size.x) * size.y;
  const int count =
    this->Session->GetDevice().IsCpu() ? static_cast<int>(bytes / BandBytes) + 1 : 1;
  const int units = (size.y + unit - 1) / unit;
  const int rows = unit * std::max((units + count - 1) / count, 1);
  std::vector<PicturePart> bands;
  for (int first = part.First.y; first < part.End.y; first += rows)
  {
    bands.push_back(
      { { part.First.x, first }, { part.End.x, std::min(first + rows, part.End.y) } });
  }
  return bands;
}

void OpenClRayCast::Transfer(const PicturePart& part)
{
  const Stopwatch watch;
  const glm::ivec2 size = part.End - part.First;
  const std::size_t bytes = sizeof(glm::vec4) * static_cast<std::size_t>(size.x) * size.y;
  this->Result.Read(bytes,
    [&](const void* texels)
    {
      glTexSubImage2D(
        GL_TEXTURE_2D, 0, part.First.x, part.First.y, size.x, size.y, GL_RGBA, GL_FLOAT, texels);
    });
  this->GetFrameStages().Add("transfer", watch.ElapsedMs());
}

glm::ivec2 OpenClRayCast::ChooseWorkGroup(const Scene& scene, const PicturePart& part)
{
  if (this->WorkGroup.x > 0)
  {
    return this->WorkGroup;
  }
  if (this->Session->GetDevice().IsCpu())
  {
    return CpuWorkGroup;
  }
  const std::string device = this->Session->GetDevice().Name + " " +
    this->GetFeatures().to_string() + " " + this->Data.GetDefines();
  return FindWorkGroup(scene, part, device,
    [&](glm::ivec2 shape, const PicturePart& middle)
    {
      this->Cast({ middle.First, middle.First + 1 }, shape); // warms up
      return this->Cast(middle, shape);
    });
}

SetUpCosts OpenClRayCast::GetSetUpCosts() const
{
  SetUpCosts costs = this->OpenGlTechnique::GetSetUpCosts();
  costs.UploadMs = this->Data.GetUploadMs();
  costs.TablesMs = this->Data.GetTablesMs();
  costs.GridMs =
    Has(this->GetFeatures(), Feature::Skipping) ? this->Data.GetGridMs() : costs.GridMs;
  costs.CompileMs = this->CompileMs;
  return costs;
}

void OpenClRayCast::ReleaseOpenCl()
{
  this->Data.Release();
  this->Depth.Release();
  this->Target.Release();
  this->Result.Release();
  this->Kernel = nullptr;
  this->KernelDefines.clear();
  this->Session = nullptr;
  this->Shared.reset(); // after all that it made
  this->SharedContext = {};
}

void OpenClRayCast::ReleaseOwn()
{
  this->ReleaseOpenCl(); // a texture that is shared goes after its image
  this->Picture.Release();
}

void OpenClRayCast::ForgetOwn()
{
  this->Picture.Forget();
  this->PictureSize = glm::ivec2(0);
  this->ReleaseOpenCl();
}

std::size_t OpenClRayCast::GetOwnBytes() const
{
  const std::size_t picture = sizeof(glm::vec4) * this->PictureSize.x * this->PictureSize.y;
  return this->Data.GetBytesOnDevice() + this->Depth.GetBytes() + this->Result.GetBytes() + picture;
}
}
