#include "Scene/TransferFunctionTable.h"

#include "Scene/ExactTransferFunction.h"
#include "Scene/NumberText.h"
#include "Scene/PropertyFunctions.h"
#include "Scene/Ramps.h"

#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace volumebench
{
namespace
{
constexpr int SmallestSize =
  4096; // costs nothing over 1024, and halves the error of sharp functions
constexpr double EntriesPerKnotGap = 8.0;

struct Domain
{
  double Low;
  double High;
};

// The domain of a table: where the functions change, but no further than the data reach.
Domain ChooseDomain(const std::set<double>& knots, bool clamping, const double dataRange[2])
{
  const double low = std::max(dataRange[0], *knots.begin());
  const double high = std::min(dataRange[1], *knots.rbegin());
  return clamping && low < high ? Domain{ low, high } : Domain{ dataRange[0], dataRange[1] };
}

int ChooseSize(const std::set<double>& knots, const Domain& domain, const TableSizes& sizes)
{
  if (sizes.Fixed != 0)
  {
    return sizes.Fixed;
  }
  double closest = domain.High - domain.Low;
  double previous = domain.Low;
  for (const double knot : knots)
  {
    if (knot > domain.Low && knot < domain.High)
    {
      closest = knot > previous ? std::min(closest, knot - previous) : closest;
      previous = knot;
    }
  }
  const double wanted = EntriesPerKnotGap * (domain.High - domain.Low) / closest;
  const double upper = std::max(sizes.Largest, 2);
  return static_cast<int>(std::min(std::max<double>(SmallestSize, wanted), upper));
}

// Chooses the domains of opacity and colour; returns the size of the table.
int ChooseDomains(const PropertyFunctions& functions, const double range[2],
  const double* colorRange, const TableSizes& sizes, TransferFunction& result)
{
  std::set<double> opacityKnots = functions.OpacityKnots();
  std::set<double> colorKnots = functions.ColorKnots();
  if (!colorRange)
  {
    opacityKnots.insert(colorKnots.begin(), colorKnots.end());
    colorKnots = opacityKnots;
  }
  const bool clamping = functions.Clamping();
  const Domain opacity = ChooseDomain(opacityKnots, clamping, range);
  const Domain color = ChooseDomain(colorKnots, clamping, colorRange ? colorRange : range);
  result.Low = opacity.Low;
  result.High = opacity.High;
  result.ColorLow = color.Low;
  result.ColorHigh = color.High;
  return std::max(ChooseSize(opacityKnots, opacity, sizes), ChooseSize(colorKnots, color, sizes));
}

void Fill(
  const PropertyFunctions& functions, double unitDistance, int size, TransferFunction& result)
{
  const std::vector<double> opacity = functions.SampleOpacity(result.Low, result.High, size);
  const std::vector<double> color = functions.SampleColor(result.ColorLow, result.ColorHigh, size);
  std::vector<glm::vec4> table(size);
  for (int i = 0; i < size; ++i)
  {
    const double extinction = ExtinctionOfOpacity(opacity[i], unitDistance);
    const double* rgb = color.data() + std::ptrdiff_t(3) * i;
    table[i] = glm::vec4(rgb[0], rgb[1], rgb[2], extinction);
    result.MaximumExtinction = std::max(result.MaximumExtinction, extinction);
  }
  result.Table = std::move(table);
}
}

namespace
{
constexpr int GradientTableSize = 1024;

// The colour of all entries that add to what is seen, if it is one: those with extinction, and
// their neighbours, with which they are filtered.
std::optional<glm::vec3> ColorOf(const SharedTable<glm::vec4>& table)
{
  std::optional<glm::vec3> color;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const bool seen = table[i].w > 0.0f || (i > 0 && table[i - 1].w > 0.0f) ||
      (i + 1 < table.size() && table[i + 1].w > 0.0f);
    const glm::vec3 own(table[i]);
    if (!seen)
    {
      continue;
    }
    color = color.value_or(own); // the first
    if (!IsColor(own, *color))
    {
      return {};
    }
  }
  return color;
}

// Asks HasGradientOpacity first: reading the function creates one, which would slow VTK's mappers.
void FillGradientTable(vtkVolumeProperty* property, TransferFunction& result)
{
  if (!property->HasGradientOpacity(0) || property->GetDisableGradientOpacity(0))
  {
    return;
  }
  vtkPiecewiseFunction* function = property->GetGradientOpacity(0);
  if (function->GetSize() < 1)
  {
    return;
  }
  CheckPoints(function, "gradient opacity");
  function->GetRange(result.GradientLow, result.GradientHigh);
  if (!(result.GradientHigh > result.GradientLow))
  {
    result.GradientHigh = result.GradientLow + 1.0;
  }
  result.GradientTable.resize(GradientTableSize);
  function->GetTable(
    result.GradientLow, result.GradientHigh, GradientTableSize, result.GradientTable.data());
  for (float& factor : result.GradientTable)
  {
    factor = std::clamp(factor, 0.0f, 1.0f);
  }
  ExtendStamp(result.Stamp, function->GetMTime());
}
}

namespace
{
void AddRamps(TransferFunction& function)
{
  const RampTable ramps = BuildRamps(*function.Exact,
    { function.Low, function.High, static_cast<int>(function.Table.size()) });
  function.Ramps = ramps.Entries;
  function.RampOpacity = ramps.LargestOpacity;
}
}

bool IsColor(const glm::vec3& first, const glm::vec3& second)
{
  constexpr float Rounding = 3.0e-7f;
  const glm::vec3 off = glm::abs(first - second);
  return std::max({ off.x, off.y, off.z }) <= Rounding;
}

double CheckedUnitDistance(vtkVolumeProperty* property)
{
  const double unitDistance = property->GetScalarOpacityUnitDistance(0);
  if (!(unitDistance > 0.0) || !std::isfinite(unitDistance))
  {
    throw SceneError(
      "the scalar opacity unit distance is " + NumberText(unitDistance) + ", not positive");
  }
  return unitDistance;
}

double ExtinctionOfOpacity(double opacity, double unitDistance)
{
  const double largest = 1.0 - std::ldexp(1.0, -24);
  return -std::log1p(-std::clamp(opacity, 0.0, largest)) / unitDistance;
}

TransferFunction BuildTransferFunction(vtkVolumeProperty* property, const double dataRange[2],
  const TableSizes& sizes, const double* colorRange)
{
  if (sizes.Fixed != 0 && (sizes.Fixed < 2 || sizes.Fixed > sizes.Largest))
  {
    throw SceneError("the transfer-function table is to have " + std::to_string(sizes.Fixed) +
      " entries; it can have 2 to " + std::to_string(sizes.Largest) +
      ", or 0 for as many as it needs");
  }
  const double unitDistance = CheckedUnitDistance(property);
  const PropertyFunctions functions(property);
  TransferFunction result;
  const int size = ChooseDomains(functions, dataRange, colorRange, sizes, result);
  Fill(functions, unitDistance, size, result);

  result.Color = ColorOf(result.Table);
  result.UnitDistance = unitDistance;
  FillGradientTable(property, result);

  result.Exact = std::make_shared<const ExactTransferFunction>(property);
  // Whoever chooses the size of the table wants it looked up, and a component of its own has its
  // colours elsewhere.
  if (sizes.Fixed == 0 && !colorRange)
  {
    AddRamps(result);
  }

  ExtendStamp(result.Stamp, functions.GetStamp());
  ExtendStamp(result.Stamp, size);
  ExtendStamp(result.Stamp, unitDistance);
  ExtendStamp(result.Stamp, dataRange[0]);
  ExtendStamp(result.Stamp, dataRange[1]);
  ExtendStamp(result.Stamp, result.ColorLow);
  ExtendStamp(result.Stamp, result.ColorHigh);
  return result;
}
}
