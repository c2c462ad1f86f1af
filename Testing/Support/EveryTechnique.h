// A fixture whose tests run once for each technique that this machine supports.
#ifndef volumebench_EveryTechnique_h
#define volumebench_EveryTechnique_h

#include "Contestant.h"
#include "RenderScene.h"
#include "Techniques/TechniqueTable.h"

#include <gtest/gtest.h>

namespace volumebench::test
{
/// Whether the technique draws on a device beside OpenGL's, where tests count no objects.
inline bool HasDeviceOfItsOwn(const std::string& technique)
{
  return technique == "cuda";
}

/// Why this machine cannot run a technique on a device of its own; empty when it can. OpenGL is
/// there in every test that draws.
inline std::string WhyNotHere(const std::string& technique)
{
  return FindTechnique(technique)->Create()->WhyNoDevice();
}

/// Those that this machine can run; TestTechniques.cxx tells of the others.
inline std::vector<std::string> AllTechniques()
{
  std::vector<std::string> ids;
  for (const TechniqueRow& row : TechniqueTable())
  {
    if (WhyNotHere(row.Id).empty())
    {
      ids.emplace_back(row.Id);
    }
  }
  return ids;
}

inline bool IsSliced(const std::string& technique)
{
  return technique.rfind("slices", 0) == 0;
}

/// Whether step and integrator matter to the technique: to all but the exact one.
inline bool HasSteps(const std::string& technique)
{
  return Contestant::TakesSteps(technique);
}

/// Whether a ray may stop at the termination threshold.
inline bool StopsEarly(const std::string& technique)
{
  return HasSteps(technique) && !IsSliced(technique);
}

inline std::string TestNameOf(const ::testing::TestParamInfo<std::string>& info)
{
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class EveryTechnique : public ::testing::TestWithParam<std::string>
{
};
}

#define VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Suite)                                                     \
  INSTANTIATE_TEST_SUITE_P(Techniques, Suite,                                                      \
    ::testing::ValuesIn(volumebench::test::AllTechniques()), volumebench::test::TestNameOf)

#endif
