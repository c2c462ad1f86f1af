#include "VtkSampleCounter.h"

#include "Error/FloatPicture.h"

#include "vtkShaderProperty.h"
#include "vtkVolume.h"

#include <limits>

namespace volumebench
{
namespace
{
struct Replacement
{
  const char* Tag;
  const char* Text;
};

const Replacement Replacements[] = {
  { "//VTK::Base::Dec", "float sampleCount = 0.0;\n//VTK::Base::Dec" },
  // The first tag inside of the loop: what would end the loop or skip the sample comes after it.
  { "//VTK::Base::Impl", "sampleCount += 1.0;\n//VTK::Base::Impl" },
  // The last tag of the shader, after the colour is written. Alpha 1 covers what was there before.
  { "//VTK::DepthPass::Exit",
    "//VTK::DepthPass::Exit\n  fragOutput0 = vec4(sampleCount, 0.0, 0.0, 1.0);" },
};
}

// Changes the property that the volume has: VTK would not notice that it is given an older one
// back.
VtkSampleCounter::VtkSampleCounter(vtkVolume* volume)
  : Shader(volume->GetShaderProperty())
{
  for (const Replacement& item : Replacements)
  {
    this->Shader->AddFragmentShaderReplacement(item.Tag, true, item.Text, false);
  }
}

VtkSampleCounter::~VtkSampleCounter()
{
  for (const Replacement& item : Replacements)
  {
    this->Shader->ClearFragmentShaderReplacement(item.Tag, true);
  }
}

SampleCount VtkSampleCounter::CountOf(const FloatPicture& picture)
{
  SampleCount count = SumSampleCounts(picture);
  count.RaysTerminated = std::numeric_limits<double>::quiet_NaN();
  return count;
}
}
