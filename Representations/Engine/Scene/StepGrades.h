// How long the steps in each macrocell may be for a picture to keep its error target.
#ifndef volumebench_StepGrades_h
#define volumebench_StepGrades_h

#include "VolumeBenchEngineModule.h"

#include "Scene/MacrocellGrid.h"
#include "Scene/Scene.h"

#include <cstdint>
#include <vector>

namespace volumebench
{
/// Steps are the scene's times a power of two from 2^FinestGrade to 2^CoarsestGrade.
constexpr int FinestGrade = -5;
constexpr int CoarsestGrade = 3;
constexpr int GradeCount = CoarsestGrade - FinestGrade + 1;

/// Grade of a cell in which steps of any length are exact: one value, or values that show alike.
constexpr int ExactGrade = 15;

struct StepGrades
{
  /// Of each cell, from FinestGrade on; cells that show nothing have ExactGrade too.
  std::vector<std::int8_t> Grades;

  /// The error that is expected of the picture: above the target where the finest steps are too
  /// long for it.
  double ExpectedError = 0.0;

  /// Steps per voxel, as a mean over the cells weighted by how much of them is seen.
  double StepsPerVoxel = 0.0;
};

/// Errors that are expected of a picture whose steps are all alike.
struct IntegratorErrors
{
  double Midpoint = 0.0;
  double Segment = 0.0;
};

/// The longest steps with which the errors of all cells, as far as they can be seen along the axes,
/// stay within the scene's target.
VOLUMEBENCHENGINE_EXPORT StepGrades GradeSteps(
  const MacrocellGrid& grid, const std::vector<glm::vec2>& changes, const Scene& scene);

/// For the scene's step, whatever its integrator and its error target are.
VOLUMEBENCHENGINE_EXPORT IntegratorErrors ExpectErrors(
  const MacrocellGrid& grid, const std::vector<glm::vec2>& changes, const Scene& scene);
}

#endif
