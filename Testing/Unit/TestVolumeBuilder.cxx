#include "Scene/VolumeBuilder.h"

#include "TestVolumes.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
const ArrayRequest PointField{ VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1,
  "field" };

Volume Build(vtkImageData* image, const ArrayRequest& request = PointField, int component = 0)
{
  return VolumeBuilder().Build(image, request, { component }, false, nullptr);
}

std::string FailureOf(vtkImageData* image, const ArrayRequest& request = PointField)
{
  try
  {
    Build(image, request);
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}

double Index(double i, double, double)
{
  return i;
}
}

TEST(VolumeBuilder, PointDataReachFromFirstToLastTexel)
{
  auto image = MakeImage(5, 3, 2, Index);
  image->SetSpacing(2.0, 1.0, 1.0);
  image->SetOrigin(10.0, 0.0, 0.0);
  const Volume volume = Build(image);
  EXPECT_EQ(volume.Texels, glm::ivec3(5, 3, 2));
  EXPECT_EQ(volume.BoxHalf, glm::dvec3(2.0, 1.0, 0.5));
  // The middle of the box is voxel (0, 0, 0).
  EXPECT_EQ(glm::dvec3(volume.VoxelToWorld[3]), glm::dvec3(14.0, 1.0, 0.5));
  EXPECT_EQ(volume.FiniteRange[0], 0.0);
  EXPECT_EQ(volume.FiniteRange[1], 4.0);
}

TEST(VolumeBuilder, ExtentMovesTheVolume)
{
  auto image = MakeImage(5, 3, 2, Index);
  image->SetExtent(10, 14, 0, 2, 0, 1);
  EXPECT_EQ(glm::dvec3(Build(image).VoxelToWorld[3]), glm::dvec3(12.0, 1.0, 0.5));
}

TEST(VolumeBuilder, CellDataReachHalfATexelFurther)
{
  auto image = MakeImage(5, 3, 2, Index);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(3.0);
  image->GetCellData()->AddArray(cells);
  const Volume volume =
    Build(image, { VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "cells" });
  EXPECT_EQ(volume.Texels, glm::ivec3(4, 2, 1));
  EXPECT_EQ(volume.BoxHalf, glm::dvec3(2.0, 1.0, 0.5));
}

TEST(VolumeBuilder, DirectionAndActorMatricesApply)
{
  auto image = MakeImage(3, 3, 3, Index);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  vtkNew<vtkMatrix4x4> actor;
  actor->SetElement(0, 3, 100.0);
  const Volume volume = VolumeBuilder().Build(image, PointField, {}, false, actor);
  const glm::dvec4 alongX = volume.VoxelToWorld * glm::dvec4(1.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(alongX, glm::dvec4(0.0, 1.0, 0.0, 0.0));
  EXPECT_EQ(volume.VoxelToWorld[3].x, volume.VoxelToData[3].x + 100.0);
}

TEST(VolumeBuilder, SmallIntegersKeepTheirBits)
{
  for (const int type :
    { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT })
  {
    const Volume volume = Build(MakeImage(3, 3, 3, Index, type));
    EXPECT_EQ(volume.Format, TexelFormat::Unsigned16) << type;
    EXPECT_EQ(volume.Mapping.Normalize(volume.FiniteRange[0]), 0.0) << "counted from the smallest";
    const double values = volume.Scalars->GetDataTypeMax() - volume.Scalars->GetDataTypeMin();
    EXPECT_EQ(volume.Mapping.Normalize(volume.FiniteRange[0] + values), 1.0) << type;
  }
}

TEST(VolumeBuilder, OtherTypesAreStoredOverTheirRange)
{
  for (const int type : { VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE })
  {
    const Volume volume = Build(MakeImage(5, 3, 3, Index, type));
    EXPECT_EQ(volume.Format, TexelFormat::Float32) << type;
    EXPECT_EQ(volume.Mapping.Normalize(0.0), 0.0) << type;
    EXPECT_EQ(volume.Mapping.Normalize(4.0), 1.0) << type;
  }
}

TEST(VolumeBuilder, TheLargestDoublesDoNotOverflow)
{
  const double huge = std::numeric_limits<double>::max();
  const Volume volume = Build(MakeImage(
    3, 2, 2, [=](double i, double, double) { return (i - 1.0) * huge; }, VTK_DOUBLE));
  EXPECT_EQ(volume.Mapping.Normalize(-huge), 0.0);
  EXPECT_EQ(volume.Mapping.Normalize(0.0), 0.5);
  EXPECT_EQ(volume.Mapping.Normalize(huge), 1.0);
}

TEST(VolumeBuilder, NonFiniteVoxelsAreFlaggedAndOutOfTheRange)
{
  auto image = MakeImage(4, 2, 2,
    [](double i, double j, double)
    { return i == 1 && j == 0 ? std::nan("") : (i == 2 && j == 1 ? INFINITY : i); });
  const Volume volume = Build(image);
  EXPECT_TRUE(volume.HasNonFinite);
  EXPECT_EQ(volume.FiniteRange[1], 3.0);
  EXPECT_FALSE(Build(MakeImage(4, 2, 2, Index)).HasNonFinite);
}

TEST(VolumeBuilder, MagnitudeAndComponent)
{
  auto image = MakeImage(2, 2, 2, Index);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("field");
  vectors->SetNumberOfComponents(2);
  vectors->SetNumberOfTuples(8);
  for (int i = 0; i < 8; ++i)
  {
    vectors->SetTuple2(i, 3.0 * i, 4.0 * i);
  }
  image->GetPointData()->AddArray(vectors);
  EXPECT_EQ(Build(image, PointField, -1).FiniteRange[1], 35.0);
  EXPECT_EQ(Build(image, PointField, 1).FiniteRange[1], 28.0);
  EXPECT_THROW(Build(image, PointField, 2), SceneError);
}

TEST(VolumeBuilder, ScalarsIgnoreComponentAndMagnitude)
{
  auto image = MakeImage(5, 3, 2, Index);
  for (const int component : { -1, 0, 2 })
  {
    EXPECT_EQ(Build(image, PointField, component).Component, 0);
    EXPECT_EQ(Build(image, PointField, component).FiniteRange[1], 4.0);
  }
}

TEST(VolumeBuilder, NamesWhatCannotBeDrawn)
{
  vtkNew<vtkImageData> empty;
  EXPECT_NE(FailureOf(empty).find("the image is empty"), std::string::npos);
  EXPECT_NE(
    FailureOf(MakeImage(4, 1, 4, Index)).find("one point thick (4 x 1 x 4"), std::string::npos);
  EXPECT_NE(FailureOf(MakeImage(2, 2, 2, Index),
              { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "none" })
              .find("no array 'none'"),
    std::string::npos);
  auto nan = MakeImage(2, 2, 2, [](double, double, double) { return std::nan(""); });
  EXPECT_NE(FailureOf(nan).find("no finite value"), std::string::npos);

  auto image = MakeImage(2, 2, 2, Index);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(8);
  image->GetPointData()->AddArray(words);
  EXPECT_NE(
    FailureOf(image, { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "words" })
      .find("'words' holds string values"),
    std::string::npos);
}

TEST(VolumeBuilder, StampFollowsTheDataAndNotTheTransform)
{
  auto image = MakeImage(3, 3, 3, Index);
  const ChangeStamp first = Build(image).Stamp;
  image->SetSpacing(2.0, 2.0, 2.0);
  EXPECT_EQ(Build(image).Stamp, first);
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_NE(Build(image).Stamp, first);
}

namespace
{
vtkSmartPointer<vtkImageData> MakeChannels(int components, int type)
{
  auto image = MakeImage(3, 3, 3, Index);
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  array->SetName("field");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(27);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetComponent(i / components, i % components, 10.0 * (i % components) + (i > 30));
  }
  image->GetPointData()->AddArray(array);
  return image;
}

Volume BuildDependent(vtkImageData* image)
{
  return VolumeBuilder().Build(image, PointField, { 0, true }, false, nullptr);
}
}

TEST(VolumeBuilder, TwoDependentComponentsAreColourAndOpacity)
{
  const Volume volume = BuildDependent(MakeChannels(2, VTK_DOUBLE));
  EXPECT_EQ(volume.Channels, 2);
  EXPECT_EQ(volume.Component, 1);
  EXPECT_EQ(volume.FiniteRange[0], 10.0);
  EXPECT_EQ(volume.FiniteRange[1], 11.0);
  EXPECT_EQ(volume.ColorRange[0], 0.0);
  EXPECT_EQ(volume.ColorRange[1], 1.0);
  EXPECT_EQ(volume.Mapping.Normalize(11.0), 1.0);
  EXPECT_EQ(volume.ColorMapping.Normalize(1.0), 1.0);
}

TEST(VolumeBuilder, FourDependentComponentsAreRgbaAsTheyAre)
{
  const Volume bytes = BuildDependent(MakeChannels(4, VTK_UNSIGNED_CHAR));
  EXPECT_EQ(bytes.Channels, 4);
  EXPECT_EQ(bytes.Component, 3);
  EXPECT_EQ(bytes.Format, TexelFormat::Unsigned16);
  EXPECT_EQ(bytes.ColorMapping.Normalize(255.0), 1.0);
  EXPECT_EQ(bytes.FiniteRange[1], 31.0);
  const Volume floats = BuildDependent(MakeChannels(4, VTK_FLOAT));
  EXPECT_EQ(floats.Format, TexelFormat::Float32);
  EXPECT_EQ(floats.ColorMapping.Normalize(1.0), 1.0);
  EXPECT_EQ(floats.ColorMapping.Normalize(0.0), 0.0);
}

TEST(VolumeBuilder, OtherNumbersOfDependentComponentsAreRefused)
{
  EXPECT_THROW(BuildDependent(MakeChannels(3, VTK_FLOAT)), SceneError);
  EXPECT_THROW(BuildDependent(MakeChannels(5, VTK_FLOAT)), SceneError);
  EXPECT_EQ(BuildDependent(MakeChannels(1, VTK_FLOAT)).Channels, 1);
}

TEST(VolumeBuilder, GhostsAreTakenWhereTheyHide)
{
  auto image = MakeImage(3, 3, 3, Index);
  image->AllocatePointGhostArray()->SetValue(4, vtkDataSetAttributes::DUPLICATEPOINT);
  image->AllocateCellGhostArray();
  EXPECT_FALSE(Build(image).HasBlanks());
  const ChangeStamp before = Build(image).Stamp;
  image->GetCellGhostArray()->SetValue(3, vtkDataSetAttributes::DUPLICATECELL);
  image->GetCellGhostArray()->Modified();
  EXPECT_TRUE(Build(image).CellGhosts);
  EXPECT_FALSE(Build(image).PointGhosts);
  EXPECT_NE(Build(image).Stamp, before);
  image->GetPointGhostArray()->SetValue(4, vtkDataSetAttributes::HIDDENPOINT);
  image->GetPointGhostArray()->Modified();
  EXPECT_TRUE(Build(image).PointGhosts);
}
