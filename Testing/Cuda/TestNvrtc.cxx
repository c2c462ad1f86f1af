// The kernels of technique cuda, compiled as it compiles them but for no device in particular, and
// what is said on a machine without one.
#include "CUDA/CudaApi.h"
#include "CUDA/CudaCompiler.h"
#include "CUDA/CudaDevice.h"
#include "CUDA/VoxelTurner.h"
#include "Gpu/KernelSpecializer.h"
#include "HostScene.h"
#include "VoxelOrder/VoxelRotation.h"

#include <gtest/gtest.h>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Architectures[] = { 75, 90, 120 };

// ELF is what the driver loads as it is.
bool IsMachineCode(const CudaProgram& program)
{
  return program.Code.size() > 4 &&
    std::memcmp(program.Code.data(),
      "\x7f"
      "ELF",
      4) == 0;
}
}

class Nvrtc : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!volumebench::Nvrtc().Missing.empty())
    {
      GTEST_SKIP() << "not run: " << volumebench::Nvrtc().Missing;
    }
  }
};

// The sets of features of the image tests; the architectures take turns.
TEST_F(Nvrtc, CompilesTheRayCasterWithoutWarnings)
{
  int next = 0;
  for (const CudaPair& pair : CudaPairs())
  {
    const int architecture = Architectures[next++ % 3];
    const std::string order = next % 2 == 0 ? "#define VOLUME_IN_ORDER 1\n" : "";
    const CudaProgram program = CompileCuda(
      "RayCast.cu", FeatureDefines(FeaturesOfDefines(pair.Defines)) + order, architecture);
    EXPECT_EQ(program.Log, "") << pair.Defines << ", sm_" << architecture;
    EXPECT_TRUE(IsMachineCode(program)) << pair.Defines;
  }
}

TEST_F(Nvrtc, CompilesTheVoxelTurnerForEveryTexel)
{
  int next = 0;
  for (const CUarray_format format : { CU_AD_FORMAT_UNSIGNED_INT16, CU_AD_FORMAT_FLOAT })
  {
    for (const unsigned int channels : { 1, 2, 4 })
    {
      const int architecture = Architectures[next++ % 3];
      const std::size_t bytes = channels * (format == CU_AD_FORMAT_FLOAT ? 4 : 2);
      const CudaProgram program = CompileCuda(
        "RotateVoxels.cu", TurnDefines(format, channels, TurnLayers(bytes)), architecture);
      EXPECT_EQ(program.Log, "") << channels << " channels, sm_" << architecture;
      EXPECT_TRUE(IsMachineCode(program));
    }
  }
}

// A device that is newer than the compiler gets PTX, which its driver compiles.
TEST_F(Nvrtc, GivesPtxForArchitecturesThatItDoesNotKnow)
{
  const CudaProgram program = CompileCuda("RayCast.cu", FeatureDefines({}), 999);
  const std::string text(program.Code.begin(), program.Code.end());
  EXPECT_NE(text.find(".version"), std::string::npos);
  EXPECT_NE(text.find("castRays"), std::string::npos);
}

TEST_F(Nvrtc, NamesFileAndLineOfAMistake)
{
  try
  {
    CompileCuda("RayCast.cu", "#define floor nothing\n", 90);
    FAIL() << "compiled";
  }
  catch (const KernelError& error)
  {
    EXPECT_NE(std::string(error.what()).find("Shared/"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("nothing"), std::string::npos) << error.what();
  }
}

TEST(VoxelTurner, TakesAsManySlicesAsSharedMemoryHolds)
{
  EXPECT_EQ(TurnLayers(2), 16);
  EXPECT_EQ(TurnLayers(4), 8);
  EXPECT_EQ(TurnLayers(8), 4);
  EXPECT_EQ(TurnLayers(16), 2);
  for (const std::size_t bytes : { 2, 4, 8, 16 })
  {
    EXPECT_LE(placesOfTile(TurnTile, TurnLayers(bytes)) * bytes, 48u * 1024u);
  }
}

TEST(CudaDriver, ThatIsNotThereIsNamed)
{
  const CudaApi none = LoadCuda("libnosuchdriver.so.1");
  EXPECT_EQ(none.Missing, "there is no NVIDIA driver (libnosuchdriver.so.1)");
  const CudaApi wrong = LoadCuda("libm.so.6");
  EXPECT_NE(wrong.Missing.find("cuInit"), std::string::npos) << wrong.Missing;
}

TEST(CudaDriver, SaysInOneLineWhyThereIsNoDevice)
{
  const std::string why = CudaDevice::WhyNone();
  EXPECT_EQ(why.find('\n'), std::string::npos);
  EXPECT_EQ(why.empty(), !CudaDevice::Description().empty());
  if (!why.empty())
  {
    EXPECT_THROW(CudaDevice::Get(), UnsupportedError);
  }
}
