// Faults of drivers, devices and memory.
#include "HostileSession.h"

#include "OpenCl/OpenClApi.h"

namespace volumebench::test
{
namespace
{
// Those that read the scene from textures, and those that draw into one.
const std::vector<std::string> WithTextures = { "single-pass", "multi-pass", "compute", "slices",
  "slices-threaded" };
const std::vector<std::string> WithPictures = { "multi-pass", "compute", "slices",
  "slices-threaded" };

using Do = std::function<void(HostileSession&)>;

// A fault while another volume is sent.
Do Sending(const DeviceFaultPointer& fault)
{
  return [fault](HostileSession& session)
  {
    session.Show(MakeImage(40, 40, 40, Bumpy));
    session.Mapper->Fault = fault;
  };
}

// A fault while another function is sent, with what its empty cells are skipped by.
Do Editing(const DeviceFaultPointer& fault, int integrator = 1)
{
  return [=](HostileSession& session)
  {
    session.Show(MakeProperty({ { 0.0, 0.0 }, { 2.5, 0.0 }, { 4.0, 0.7 } },
      { { 0.0, { 0.5, 0.2, 0.3 } }, { 4.0, { 0.1, 0.2, 0.3 } } }));
    session.Mapper->SetIntegrator(integrator);
    session.Mapper->SetMacrocellVoxels(2);
    session.Mapper->Fault = fault;
  };
}

// A fault while all is made anew.
Do FromTheBeginning(const DeviceFaultPointer& fault)
{
  return [fault](HostileSession& session)
  {
    session.Mapper->ReleaseGraphicsResources(session.Window);
    session.Mapper->SetIntegrator(0);
    session.Mapper->SetJitter(true);
    session.Mapper->Fault = fault;
  };
}

Do HiddenByGeometry(const DeviceFaultPointer& fault)
{
  return [fault](HostileSession& session)
  {
    session.Renderer->PreserveDepthBufferOn();
    session.Mapper->Fault = fault;
  };
}

Enemies OfOpenGl()
{
  return {
    { "no_room_for_the_volume", Sending(OutOfMemoryIn("glTexImage3D")), Refused("no room for"),
      WithTextures, Drawn() },
    { "no_room_for_any_brick", Sending(AllVolumesAreTooLarge()),
      Refused("the volume needs 256000 bytes on the device, which does not take even bricks of "),
      WithTextures, Drawn() },
    { "no_room_for_a_slab", Sending(OutOfMemoryIn("glTexSubImage3D")), Refused("no room for"),
      WithTextures, Drawn() },
    { "no_room_for_cells", Editing(OutOfMemoryIn("glTexImage3D")), Refused("no room for"),
      { "single-pass", "multi-pass", "compute" }, Drawn() },
    { "no_room_for_tables", Editing(OutOfMemoryIn("glTexImage1D")), Refused("no room for"),
      WithTextures, Drawn() },
    { "no_room_for_prefixes", Editing(OutOfMemoryIn("glTexImage1D"), 2), Refused("no room for"),
      WithTextures, Drawn() },
    { "no_room_for_segments", Editing(OutOfMemoryIn("glTexImage2D"), 3), Refused("no room for"),
      { "single-pass", "multi-pass", "compute", "slices", "slices-threaded", "reference" },
      Drawn() },
    { "no_room_for_pictures", FromTheBeginning(OutOfMemoryIn("glTexImage2D")),
      Refused("no room for"),
      { "multi-pass", "compute", "slices", "slices-threaded", "opencl", "reference" }, Drawn() },
    { "no_room_for_numbers", FromTheBeginning(OutOfMemoryIn("glBufferData")),
      Refused("no room for") },
    { "no_room_for_depths", HiddenByGeometry(OutOfMemoryIn("glCopyTexImage2D")),
      Refused("no room for") },
    { "no_shader_compiles", FromTheBeginning(NoShaderCompiles()),
      Refused("a kernel does not compile: ") },
    { "no_program_links", FromTheBeginning(NoProgramLinks()), Refused("the kernels do not link") },
    { "no_framebuffer_is_complete", FromTheBeginning(NoFramebufferIsComplete()),
      Refused("cannot draw into a texture"), WithPictures, Drawn() },
    { "no_texture_unit_is_free", FromTheBeginning(NoTextureUnitIsFree()),
      Refused("all texture units") },
    { "error_of_somebody_else", Sending(ErrorOfSomebodyElse()), Drawn() },
    { "error_of_somebody_else_at_first", FromTheBeginning(ErrorOfSomebodyElse()), Drawn() },
  };
}

Enemies OfSizes()
{
  return {
    { "volume_of_four_times_the_budget",
      [](HostileSession& session)
      {
        session.Show(MakeImage(40, 40, 40, Bumpy));
        session.Mapper->SetMemoryBudgetMiB(0.06);
      },
      Drawn() },
    { "volume_longer_than_textures_may_be",
      [](HostileSession& session)
      {
        auto image = MakeImage(3000, 3, 3, Bumpy, VTK_FLOAT);
        image->SetSpacing(0.003, 4.0, 4.0);
        session.Show(image);
        session.Mapper->SetStepVoxels(4.0);
      },
      Drawn() },
  };
}

Enemies OfOpenCl()
{
  return {
    { "opencl_has_no_room_for_buffers",
      Sending(OpenClFails("clCreateBuffer", CL_MEM_OBJECT_ALLOCATION_FAILURE)),
      Refused("has no room for"), { "opencl" }, Drawn() },
    { "opencl_has_no_room_for_tables", Editing(OpenClFails("clCreateBuffer", CL_OUT_OF_RESOURCES)),
      Refused("has no room for"), { "opencl" }, Drawn() },
    { "opencl_takes_no_voxels", Sending(OpenClFails("clEnqueueWriteBuffer", CL_OUT_OF_RESOURCES)),
      Refused("clEnqueueWriteBuffer gave CL_OUT_OF_RESOURCES"), { "opencl" }, Drawn() },
    { "opencl_takes_no_tables", Editing(OpenClFails("clEnqueueWriteBuffer", CL_OUT_OF_RESOURCES)),
      Refused("clEnqueueWriteBuffer gave CL_OUT_OF_RESOURCES"), { "opencl" }, Drawn() },
    { "opencl_has_no_room_for_images",
      [](HostileSession& session)
      {
        session.Mapper->SetOpenClStorage(1);
        Sending(OpenClFails("clCreateImage", CL_MEM_OBJECT_ALLOCATION_FAILURE))(session);
      },
      Refused("has no room for"), { "opencl" }, Drawn() },
    { "opencl_takes_a_volume_in_pieces", Sending(OpenClTakesPiecesOf(100000)), Drawn(),
      { "opencl" }, Drawn() },
    { "opencl_takes_only_tiny_pieces", Sending(OpenClTakesPiecesOf(100)),
      Refused("does not take even bricks of "), { "opencl" }, Drawn() },
    { "opencl_takes_no_picture_in_one_piece", FromTheBeginning(OpenClTakesPiecesOf(30000)),
      Refused("takes at most 30000 bytes in one piece"), { "opencl" }, Drawn() },
    { "opencl_does_not_compile",
      [](HostileSession& session)
      {
        // Kernels are kept as long as the program runs; no other row needs this one.
        session.Mapper->SetBlendMode(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
        FromTheBeginning(OpenClFails("clBuildProgram", CL_BUILD_PROGRAM_FAILURE))(session);
      },
      Refused("does not compile"), { "opencl" }, Drawn() },
    { "opencl_does_not_launch", Sending(OpenClFails("clEnqueueNDRangeKernel", CL_OUT_OF_RESOURCES)),
      Refused("clEnqueueNDRangeKernel gave CL_OUT_OF_RESOURCES"), { "opencl" }, Drawn() },
    { "opencl_gives_no_picture", Sending(OpenClFails("clEnqueueMapBuffer", CL_MAP_FAILURE)),
      Refused("clEnqueueMapBuffer gave CL_MAP_FAILURE"), { "opencl" }, Drawn() },
  };
}
}

Enemies EnemiesOfMachines()
{
  Enemies all = OfOpenGl();
  for (const Enemies& group : { OfSizes(), OfOpenCl() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  if (CanRefuseMemory())
  {
    all.push_back({ "no_memory", Sending(NoMemoryFrom(100000)),
      Refused("not enough memory to draw 64000 points") });
  }
  return all;
}
}
