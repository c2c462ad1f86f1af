#include "Scene/TransferFunctionTable.h"

#include "TestVolumes.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
constexpr int LargestSize = 16384;

vtkSmartPointer<vtkVolumeProperty> Ramp(double low, double high)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(low, 0.0, 0.0, 1.0);
  color->AddRGBPoint(high, 1.0, 0.0, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(low, 0.0);
  opacity->AddPoint(high, 0.5);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(2.0);
  return property;
}
}

TEST(TransferFunctionTable, ExtinctionIsTheLogarithmOfTransparency)
{
  EXPECT_DOUBLE_EQ(ExtinctionOfOpacity(0.5, 2.0), std::log(2.0) / 2.0);
  EXPECT_EQ(ExtinctionOfOpacity(0.0, 1.0), 0.0);
  EXPECT_EQ(ExtinctionOfOpacity(-1.0, 1.0), 0.0);
  // Full opacity is clamped to 1 - 2^-24, so its extinction is finite.
  EXPECT_NEAR(ExtinctionOfOpacity(1.0, 1.0), 24.0 * std::log(2.0), 1e-9);
  // Thin media keep their digits.
  EXPECT_NEAR(ExtinctionOfOpacity(1e-9, 1.0), 1e-9, 1e-17);
}

TEST(TransferFunctionTable, EndsAreExact)
{
  const double range[2] = { 0.0, 100.0 };
  const TransferFunction function = BuildTransferFunction(Ramp(20.0, 60.0), range, { LargestSize });
  EXPECT_EQ(function.Low, 20.0);
  EXPECT_EQ(function.High, 60.0);
  ASSERT_GE(function.Table.size(), 4096u);
  EXPECT_EQ(function.Table.front(), glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
  EXPECT_EQ(function.Table.back().x, 1.0f);
  EXPECT_NEAR(function.Table.back().w, std::log(2.0) / 2.0, 1e-7);
}

TEST(TransferFunctionTable, DomainStaysInsideTheData)
{
  const double range[2] = { 30.0, 40.0 };
  const TransferFunction function = BuildTransferFunction(Ramp(20.0, 60.0), range, { LargestSize });
  EXPECT_EQ(function.Low, 30.0);
  EXPECT_EQ(function.High, 40.0);
}

TEST(TransferFunctionTable, DataOutsideTheFunctionsTakeTheirEnd)
{
  const double range[2] = { 70.0, 80.0 };
  const TransferFunction function = BuildTransferFunction(Ramp(20.0, 60.0), range, { LargestSize });
  EXPECT_NEAR(function.Table.front().w, std::log(2.0) / 2.0, 1e-7);
  EXPECT_NEAR(function.Table.back().w, std::log(2.0) / 2.0, 1e-7);
}

TEST(TransferFunctionTable, WithoutClampingOutsideIsTransparent)
{
  auto property = Ramp(20.0, 60.0);
  property->GetScalarOpacity()->ClampingOff();
  const double range[2] = { 0.0, 100.0 };
  const TransferFunction function = BuildTransferFunction(property, range, { LargestSize });
  EXPECT_EQ(function.High, 100.0);
  EXPECT_EQ(function.Table.back().w, 0.0f);
}

TEST(TransferFunctionTable, CloseKnotsMakeItFiner)
{
  auto property = Ramp(0.0, 100.0);
  const double range[2] = { 0.0, 100.0 };
  EXPECT_EQ(BuildTransferFunction(property, range, { LargestSize }).Table.size(), 4096u);
  property->GetScalarOpacity()->AddPoint(50.0, 0.1);
  property->GetScalarOpacity()->AddPoint(50.2, 0.9);
  EXPECT_EQ(BuildTransferFunction(property, range, { LargestSize }).Table.size(), 4096u);
  property->GetScalarOpacity()->AddPoint(50.1, 0.3);
  EXPECT_NEAR(BuildTransferFunction(property, range, { LargestSize }).Table.size(), 8000.0, 1.0);
  property->GetScalarOpacity()->AddPoint(50.001, 0.2);
  EXPECT_EQ(BuildTransferFunction(property, range, { 2048 }).Table.size(), 2048u);
}

TEST(TransferFunctionTable, TheUserMaySayHowFineItIs)
{
  auto property = Ramp(0.0, 100.0);
  const double range[2] = { 0.0, 100.0 };
  EXPECT_EQ(BuildTransferFunction(property, range, { LargestSize, 2 }).Table.size(), 2u);
  EXPECT_EQ(BuildTransferFunction(property, range, { LargestSize, 300 }).Table.size(), 300u);
  EXPECT_THROW(BuildTransferFunction(property, range, { LargestSize, 1 }), SceneError);
  EXPECT_THROW(BuildTransferFunction(property, range, { LargestSize, 20000 }), SceneError);
}

TEST(TransferFunctionTable, ConstantDataGiveAConstantTable)
{
  const double range[2] = { 60.0, 60.0 };
  const TransferFunction function = BuildTransferFunction(Ramp(20.0, 60.0), range, { LargestSize });
  for (const glm::vec4& entry : function.Table)
  {
    ASSERT_EQ(entry, function.Table.front());
  }
  EXPECT_NEAR(function.Table.front().w, std::log(2.0) / 2.0, 1e-7);
}

TEST(TransferFunctionTable, NamesWhatIsWrong)
{
  const double range[2] = { 0.0, 1.0 };
  auto property = Ramp(0.0, 1.0);
  property->SetScalarOpacityUnitDistance(0.0);
  EXPECT_THROW(BuildTransferFunction(property, range, { LargestSize }), SceneError);
  property = Ramp(0.0, 1.0);
  property->GetScalarOpacity()->RemoveAllPoints();
  EXPECT_THROW(BuildTransferFunction(property, range, { LargestSize }), SceneError);
  property = Ramp(0.0, 1.0);
  property->GetRGBTransferFunction()->RemoveAllPoints();
  EXPECT_THROW(BuildTransferFunction(property, range, { LargestSize }), SceneError);
}

TEST(TransferFunctionTable, StampChangesWithItsSources)
{
  const double range[2] = { 0.0, 1.0 };
  auto property = Ramp(0.0, 1.0);
  const ChangeStamp first = BuildTransferFunction(property, range, { LargestSize }).Stamp;
  EXPECT_EQ(BuildTransferFunction(property, range, { LargestSize }).Stamp, first);
  EXPECT_NE(BuildTransferFunction(property, range, { LargestSize, 300 }).Stamp, first);
  property->GetScalarOpacity()->AddPoint(0.5, 0.5);
  EXPECT_NE(BuildTransferFunction(property, range, { LargestSize }).Stamp, first);
}
