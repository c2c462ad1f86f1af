// Whether OpenCL shares a texture with OpenGL, by what a device and a context say of themselves.
#include "OpenCl/GlSharing.h"

#include "OpenCl/OpenClSession.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
using Properties = std::vector<cl_context_properties>;

constexpr const char* Extensions = "cl_khr_fp64 cl_khr_gl_sharing cl_khr_icd ";

GlContext ContextOf(GlPlatform platform)
{
  return { platform, reinterpret_cast<void*>(0x10), reinterpret_cast<void*>(0x20) };
}
}

TEST(GlSharing, TellsTheContextAndTheDisplayOfEachPlatform)
{
  EXPECT_EQ(GlSharingProperties(Extensions, ContextOf(GlPlatform::Glx)),
    (Properties{ CL_GL_CONTEXT_KHR, 0x10, CL_GLX_DISPLAY_KHR, 0x20 }));
  EXPECT_EQ(GlSharingProperties(Extensions, ContextOf(GlPlatform::Egl)),
    (Properties{ CL_GL_CONTEXT_KHR, 0x10, CL_EGL_DISPLAY_KHR, 0x20 }));
}

TEST(GlSharing, NeedsTheExtensionAndAContext)
{
  EXPECT_TRUE(GlSharingProperties(Extensions, {}).empty());
  for (const char* without : { "", "cl_khr_icd", "cl_khr_gl_sharing_more cl_khr_icd",
         "my_cl_khr_gl_sharing", "cl_khr_gl_event" })
  {
    EXPECT_TRUE(GlSharingProperties(without, ContextOf(GlPlatform::Glx)).empty()) << without;
  }
}

TEST(GlSharing, HasNoContextWhereNoneIsCurrent)
{
  EXPECT_TRUE(CurrentGlContext() == GlContext());
}

// PoCL has no such extension; a device that claims it must still be the one that draws.
TEST(GlSharing, IsNotForDevicesThatDoNotDraw)
{
  if (OpenClDevices().empty())
  {
    GTEST_SKIP() << WhyNoOpenClDevice();
  }
  OpenClDevice device = OpenClDevices().back();
  if (!device.IsCpu())
  {
    GTEST_SKIP() << "the device may draw";
  }
  EXPECT_EQ(OpenClSession::Sharing(device, ContextOf(GlPlatform::Egl)), nullptr);
  device.Extensions = Extensions;
  EXPECT_EQ(OpenClSession::Sharing(device, ContextOf(GlPlatform::Egl)), nullptr);
}
