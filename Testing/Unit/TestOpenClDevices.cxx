#include "OpenCl/OpenClDevices.h"

#include "Scene/Scene.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
std::vector<OpenClDevice> TwoDevices()
{
  std::vector<OpenClDevice> devices(2);
  devices[0].Name = "Acme: Card";
  devices[1].Name = "Acme: Processor";
  return devices;
}
}

TEST(OpenClDevices, AutoIsTheFirst)
{
  EXPECT_EQ(ChooseOpenClDevice(TwoDevices(), "Auto").Name, "Acme: Card");
  EXPECT_EQ(ChooseOpenClDevice(TwoDevices(), "Acme: Processor").Name, "Acme: Processor");
}

TEST(OpenClDevices, UnknownNamesListTheKnown)
{
  for (const std::string name : { "Card", "acme: card", "" })
  {
    try
    {
      ChooseOpenClDevice(TwoDevices(), name);
      FAIL() << name;
    }
    catch (const SceneError& error)
    {
      EXPECT_EQ(std::string(error.what()),
        "there is no OpenCL device '" + name +
          "'; known are Auto, 'Acme: Card', 'Acme: Processor'");
    }
  }
}

TEST(OpenClDevices, GraphicsCardsComeBeforeProcessors)
{
  bool processors = false;
  for (const OpenClDevice& device : OpenClDevices())
  {
    EXPECT_FALSE(processors && (device.Type & CL_DEVICE_TYPE_GPU)) << device.Name;
    processors = processors || device.IsCpu();
  }
  EXPECT_EQ(OpenClDevices().empty(), !WhyNoOpenClDevice().empty());
}

TEST(OpenClApi, MissingLibraryIsSaidInOneLine)
{
  const OpenClApi api = LoadOpenCl("libNoOpenCL.so.1");
  EXPECT_NE(api.Missing.find("OpenCL is not installed: libNoOpenCL.so.1"), std::string::npos)
    << api.Missing;
  EXPECT_EQ(api.Missing.find('\n'), std::string::npos) << api.Missing;
}

TEST(OpenClApi, LibraryWithoutItsFunctionsIsSaid)
{
  const OpenClApi api = LoadOpenCl("libm.so.6");
  EXPECT_NE(api.Missing.find("libm.so.6 lacks cl"), std::string::npos) << api.Missing;
}

TEST(OpenClApi, ErrorsNameTheCall)
{
  EXPECT_NO_THROW(CheckOpenCl(CL_SUCCESS, "clFinish"));
  try
  {
    CheckOpenCl(CL_OUT_OF_RESOURCES, "clFinish");
    FAIL();
  }
  catch (const SceneError& error)
  {
    EXPECT_STREQ(error.what(), "OpenCL failed: clFinish gave CL_OUT_OF_RESOURCES (-5)");
  }
}
