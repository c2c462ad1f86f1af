// Two hundred volumes one after the other: memory stays what it was.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "Techniques/Technique.h"

#include <fstream>
#include <unistd.h>

#ifdef __SANITIZE_ADDRESS__
extern "C" std::size_t __sanitizer_get_current_allocated_bytes(); // GCC has no header for it
#endif

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Edge = 40; // 256 kB a volume

// What the process has in memory. The address sanitizer keeps freed blocks for a while, to see who
// uses them, and does not count them.
double HeldMebibytes()
{
  constexpr double BytesPerMebibyte = 1024.0 * 1024.0;
#ifdef __SANITIZE_ADDRESS__
  return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / BytesPerMebibyte;
#else
  std::ifstream statistics("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  statistics >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / BytesPerMebibyte;
#endif
}

vtkSmartPointer<vtkImageData> VolumeAt(int step)
{
  return MakeImage(
    Edge, Edge, Edge,
    [step](double i, double j, double k)
    { return std::max(0.0, 1.0 - std::hypot(i - 0.2 * step, j - 20.0, k - 20.0) / 15.0); },
    VTK_FLOAT);
}
}

class TimeSeries : public EveryTechnique
{
};

TEST_P(TimeSeries, TakesNoMoreMemoryTheLongerItIs)
{
  constexpr int Steps = 200;
  constexpr int Settled = 40;
  constexpr double MostMebibytes = 8.0; // 160 volumes are 40
  for (const bool inBricks : { false, true })
  {
    RenderScene scene(GetParam(), VolumeAt(0), HillsProperty());
    scene.Mapper->SetWorkGroupShape("8x8");
    scene.Mapper->SetStepVoxels(2.0);
    scene.Mapper->SetMemoryBudgetMiB(inBricks ? 0.15 : 0.0);
    double settled = 0.0;
    std::size_t bytes = 0;
    for (int step = 0; step < Steps; ++step)
    {
      scene.Mapper->SetInputData(VolumeAt(step));
      scene.Window->Render();
      ASSERT_EQ(scene.Mapper->GetFailure(), "");
      settled = step == Settled ? HeldMebibytes() : settled;
      const std::size_t held = scene.Mapper->GetSetUpCosts().BytesOnDevice;
      bytes = step <= Settled ? std::max(bytes, held) : bytes;
      EXPECT_LE(held, bytes + bytes / 4) << "step " << step;
    }
    EXPECT_LE(HeldMebibytes() - settled, MostMebibytes) << (inBricks ? "in bricks" : "whole");
    if (!HasSteps(GetParam()))
    {
      break; // reads the volume where it is
    }
  }
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(TimeSeries);
