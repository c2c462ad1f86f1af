// A volume in blocks: the picture of the whole from everywhere, and one line for what has no order.
#include "EveryTechnique.h"

#include "Error/ImageError.h"
#include "Techniques/Technique.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkRectilinearGrid.h"

#include <cmath>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Side = 9;
constexpr int Middle = 4;

vtkSmartPointer<vtkImageData> Part(vtkImageData* whole, int i, int j, int k)
{
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->DeepCopy(whole);
  const auto low = [](int side) { return side ? Middle : 0; };
  const auto high = [](int side) { return side ? Side - 1 : Middle; };
  int extent[6] = { low(i), high(i), low(j), high(j), low(k), high(k) };
  part->Crop(extent);
  return part;
}

// Eight parts, in an order that is right from nowhere.
vtkSmartPointer<vtkPartitionedDataSet> Eighths(vtkImageData* whole)
{
  auto parts = vtkSmartPointer<vtkPartitionedDataSet>::New();
  for (const int corner : { 5, 2, 7, 0, 3, 6, 1, 4 })
  {
    parts->SetPartition(
      parts->GetNumberOfPartitions(), Part(whole, corner & 1, (corner >> 1) & 1, corner >> 2));
  }
  return parts;
}

// Colours and opacity that no range but the whole's gives.
vtkSmartPointer<vtkVolumeProperty> ColoredProperty()
{
  auto property = BumpyProperty();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  color->AddRGBPoint(4.0, 0.0, 0.5, 1.0);
  property->SetColor(color);
  return property;
}

struct WholeAndBlocks
{
  explicit WholeAndBlocks(const std::string& technique)
    : Image(MakeImage(Side, Side, Side, Bumpy))
    , Whole(technique, this->Image, ColoredProperty())
    , Blocks(technique, this->Image, ColoredProperty())
  {
    this->Blocks.Mapper->SetInputDataObject(Eighths(this->Image));
    for (RenderScene* scene : { &this->Whole, &this->Blocks })
    {
      scene->Mapper->SetStepVoxels(0.1);
    }
  }

  double WorstDifference()
  {
    const FloatPicture whole = this->Whole.Picture();
    const FloatPicture blocks = this->Blocks.Picture();
    EXPECT_EQ(this->Blocks.Mapper->GetFailure(), "");
    double worst = 0.0;
    for (std::size_t i = 0; i < whole.Pixels.size(); ++i)
    {
      worst = std::max<double>(worst, std::abs(whole.Pixels[i] - blocks.Pixels[i]));
    }
    return worst;
  }

  vtkSmartPointer<vtkImageData> Image;
  RenderScene Whole;
  RenderScene Blocks;
};

std::string FailureOf(RenderScene& scene)
{
  scene.Mapper->GlobalWarningDisplayOff();
  const FloatPicture picture = scene.Picture();
  scene.Mapper->GlobalWarningDisplayOn();
  for (const float value : picture.Pixels)
  {
    EXPECT_EQ(value, 0.0f);
  }
  return scene.Mapper->GetFailure();
}

// At a seam one step is cut in two, which moves a midpoint by half a step of 0.1 voxels.
constexpr double SeamTolerance = 1e-3;
}

class Blocks : public EveryTechnique
{
};

TEST_P(Blocks, LookLikeTheWholeFromEverywhere)
{
  WholeAndBlocks scenes(GetParam());
  for (const bool parallel : { false, true })
  {
    for (const auto& [x, y, z] : { std::array<double, 3>{ 1.0, 0.7, 1.6 }, { -1.0, 0.4, 0.3 },
           { 0.2, -1.0, -0.4 }, { 0.0, 0.0, 1.0 }, { -0.5, -0.6, -0.7 } })
    {
      for (RenderScene* scene : { &scenes.Whole, &scenes.Blocks })
      {
        scene->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
        scene->LookFrom(x, y, z);
      }
      EXPECT_LE(scenes.WorstDifference(), SeamTolerance) << x << " " << y << " " << z;
    }
  }
}

TEST_P(Blocks, LookLikeTheWholeFromInsideAndUnderAnyTransform)
{
  WholeAndBlocks scenes(GetParam());
  for (RenderScene* scene : { &scenes.Whole, &scenes.Blocks })
  {
    vtkCamera* camera = scene->Renderer->GetActiveCamera();
    camera->SetPosition(3.0, 5.0, 4.5);
    camera->SetFocalPoint(8.0, 1.0, 3.0);
    scene->Renderer->ResetCameraClippingRange();
  }
  EXPECT_LE(scenes.WorstDifference(), SeamTolerance);
  for (RenderScene* scene : { &scenes.Whole, &scenes.Blocks })
  {
    scene->Volume->SetOrientation(20.0, 30.0, 40.0);
    scene->Volume->SetScale(-1.0, 0.5, 1.7);
    scene->LookFrom(1.0, 0.2, -0.6);
  }
  EXPECT_LE(scenes.WorstDifference(), SeamTolerance);
}

TEST_P(Blocks, EmptyOnesAreSkippedAndBlocksMayComeAndGo)
{
  auto image = MakeImage(Side, Side, Side, Bumpy);
  RenderScene whole(GetParam(), image, ColoredProperty());
  const FloatPicture expected = whole.Picture();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(1, image);
  blocks->SetBlock(2, vtkNew<vtkImageData>());
  whole.Mapper->SetInputDataObject(Eighths(image));
  whole.Picture();
  whole.Mapper->SetInputDataObject(blocks);
  EXPECT_EQ(whole.Picture().Pixels, expected.Pixels);
  whole.Mapper->SetBlendMode(vtkVolumeMapper::COMPOSITE_BLEND);
  blocks->SetBlock(1, nullptr);
  EXPECT_NE(FailureOf(whole).find("no block of the vtkMultiBlockDataSet"), std::string::npos);
}

TEST_P(Blocks, CostsAreThoseOfAllBlocks)
{
  WholeAndBlocks scenes(GetParam());
  scenes.WorstDifference();
  const SetUpCosts whole = scenes.Whole.Mapper->GetSetUpCosts();
  const SetUpCosts blocks = scenes.Blocks.Mapper->GetSetUpCosts();
  EXPECT_GT(blocks.BytesOnDevice, whole.BytesOnDevice);
  EXPECT_GT(blocks.UploadMs, 0.0);
  EXPECT_EQ(std::isnan(blocks.GridMs), std::isnan(whole.GridMs));
  EXPECT_EQ(scenes.Blocks.Mapper->GetFeatures(), scenes.Whole.Mapper->GetFeatures());
}

TEST_P(Blocks, WhatHasNoOrderIsNamed)
{
  auto image = MakeImage(Side, Side, Side, Bumpy);
  RenderScene scene(GetParam(), image, ColoredProperty());
  auto parts = Eighths(image);
  scene.Mapper->SetInputDataObject(parts);
  scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");

  scene.Mapper->SetBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  EXPECT_NE(FailureOf(scene).find("8 blocks"), std::string::npos);
  scene.Mapper->SetBlendMode(vtkVolumeMapper::COMPOSITE_BLEND);

  parts->SetPartition(8, image);
  parts->GetMetaData(8u)->Set(vtkCompositeDataSet::NAME(), "all");
  EXPECT_NE(FailureOf(scene).find("and 'all' overlap"), std::string::npos);

  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(2, 2, 2);
  parts->SetPartition(8, grid);
  EXPECT_NE(FailureOf(scene).find("a vtkRectilinearGrid in block 'all' cannot be drawn"),
    std::string::npos);

  auto turned = MakeImage(3, 3, 3, Bumpy);
  turned->SetOrigin(20.0, 0.0, 0.0);
  turned->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  parts->SetPartition(8, turned);
  EXPECT_NE(FailureOf(scene).find("different direction matrices"), std::string::npos);

  parts->SetPartition(8, MakeImage(1, 3, 3, Bumpy));
  EXPECT_NE(FailureOf(scene).find("one point thick"), std::string::npos);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Blocks);
