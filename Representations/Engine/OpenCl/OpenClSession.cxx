#include "OpenCl/OpenClSession.h"

#include "Gpu/KernelSpecializer.h"

namespace volumebench
{
namespace
{
// Literals without a suffix are floats, as in GLSL.
constexpr const char* BuildOptions = "-cl-std=CL1.2 -cl-single-precision-constant";

std::vector<cl_context_properties> PropertiesOf(
  const OpenClDevice& device, std::vector<cl_context_properties> properties)
{
  properties.insert(properties.end(),
    { CL_CONTEXT_PLATFORM, reinterpret_cast<cl_context_properties>(device.Platform), 0 });
  return properties;
}

std::string BuildLog(cl_program program, cl_device_id device)
{
  const OpenClApi& cl = OpenCl();
  std::size_t size = 0;
  cl.GetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
  std::string log(size, '\0');
  cl.GetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr);
  return log.c_str();
}
}

OpenClSession& OpenClSession::Of(const OpenClDevice& device)
{
  // Never deleted: drivers end before statics of the process do.
  static auto* sessions = new std::map<cl_device_id, std::unique_ptr<OpenClSession>>;
  std::unique_ptr<OpenClSession>& session = (*sessions)[device.Id];
  if (!session)
  {
    session.reset(new OpenClSession(device, {}));
  }
  return *session;
}

std::shared_ptr<OpenClSession> OpenClSession::Sharing(
  const OpenClDevice& device, const GlContext& context)
{
  const std::vector<cl_context_properties> sharing =
    GlSharingProperties(device.Extensions, context);
  if (sharing.empty() || !Draws(device, PropertiesOf(device, sharing)))
  {
    return nullptr;
  }
  return std::shared_ptr<OpenClSession>(new OpenClSession(device, sharing));
}

bool OpenClSession::Draws(
  const OpenClDevice& device, const std::vector<cl_context_properties>& properties)
{
  const auto info = reinterpret_cast<clGetGLContextInfoKHR_fn>(
    OpenCl().GetExtensionFunctionAddressForPlatform(device.Platform, "clGetGLContextInfoKHR"));
  cl_device_id drawing = nullptr;
  return info &&
    info(properties.data(), CL_CURRENT_DEVICE_FOR_GL_CONTEXT_KHR, sizeof(drawing), &drawing,
      nullptr) == CL_SUCCESS &&
    drawing == device.Id;
}

OpenClSession::OpenClSession(
  const OpenClDevice& device, const std::vector<cl_context_properties>& sharing)
  : Device(device)
{
  const OpenClApi& cl = OpenCl();
  const std::vector<cl_context_properties> properties = PropertiesOf(device, sharing);
  cl_int status = CL_SUCCESS;
  this->Context = cl.CreateContext(properties.data(), 1, &device.Id, nullptr, nullptr, &status);
  CheckOpenCl(status, "clCreateContext");
  this->Queue = cl.CreateCommandQueue(this->Context, device.Id, CL_QUEUE_PROFILING_ENABLE, &status);
  CheckOpenCl(status, "clCreateCommandQueue");
}

OpenClSession::~OpenClSession()
{
  const OpenClApi& cl = OpenCl();
  for (const auto& [text, kernel] : this->Kernels)
  {
    cl.ReleaseKernel(kernel);
  }
  cl.ReleaseCommandQueue(this->Queue);
  cl.ReleaseContext(this->Context);
}

bool OpenClSession::HasKernel(const KernelText& text) const
{
  return this->Kernels.count(text.Source) > 0;
}

cl_kernel OpenClSession::KernelOf(const KernelText& text, const char* name)
{
  const auto found = this->Kernels.find(text.Source);
  if (found != this->Kernels.end())
  {
    return found->second;
  }
  const OpenClApi& cl = OpenCl();
  cl_int status = CL_SUCCESS;
  const char* source = text.Source.c_str();
  cl_program program = cl.CreateProgramWithSource(this->Context, 1, &source, nullptr, &status);
  CheckOpenCl(status, "clCreateProgramWithSource");
  status = cl.BuildProgram(program, 1, &this->Device.Id, BuildOptions, nullptr, nullptr);
  if (status != CL_SUCCESS)
  {
    const std::string log = BuildLog(program, this->Device.Id);
    cl.ReleaseProgram(program);
    throw KernelError("OpenCL device '" + this->Device.Name + "' does not compile " +
      text.Files.front() + ": " + OneLine(log));
  }
  cl_kernel kernel = cl.CreateKernel(program, name, &status);
  cl.ReleaseProgram(program); // the kernel keeps it
  CheckOpenCl(status, "clCreateKernel");
  this->Kernels[text.Source] = kernel;
  return kernel;
}

std::size_t OpenClSession::LargestWorkGroup(cl_kernel kernel) const
{
  std::size_t items = 0;
  CheckOpenCl(OpenCl().GetKernelWorkGroupInfo(
                kernel, this->Device.Id, CL_KERNEL_WORK_GROUP_SIZE, sizeof(items), &items, nullptr),
    "clGetKernelWorkGroupInfo");
  return items;
}
}
