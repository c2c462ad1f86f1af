// Every technique against the exact reference for each scene of the table, and against each other.
// A test draws its reference once and then all techniques.
#include "ConformanceScene.h"
#include "EveryTechnique.h"
#include "Error/ImageError.h"
#include "KeptPictures.h"
#include "Scene/IntegratorChoice.h"

#include <iostream>
#include <map>
#include <memory>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Size = 128;
constexpr double FineStep = 1.0 / 128.0;
constexpr double MostRmse = 2e-3; // quarter of a step of an 8-bit picture: a half
constexpr double MostP999 = 0.02;
constexpr double MostApart = 1e-4; // between ray casters, which take the same samples
constexpr double FloatRounding = 2e-5;

enum Target
{
  Float32 = 0,
  Float16 = 1,
  Bytes = 2
};

struct Settings
{
  double Step = 1.0;
  int SetUp = 1;
  int Extent = 0;
  int Target = Float32;
  int Order = 0;
};

// Those that sample, by rays or by slices.
std::vector<std::string> Techniques(bool sliced)
{
  std::vector<std::string> ids = AllTechniques();
  ids.erase(std::remove_if(ids.begin(), ids.end(),
              [=](const std::string& id) { return !HasSteps(id) || IsSliced(id) != sliced; }),
    ids.end());
  return ids;
}

void HideLowValues(vtkPiecewiseFunction& opacity)
{
  constexpr double Hidden = 0.55; // of the function's range
  constexpr int Points = 129;
  const double low = opacity.GetRange()[0];
  const double high = opacity.GetRange()[1];
  std::vector<double> values(Points);
  opacity.GetTable(low, high, Points, values.data());
  opacity.RemoveAllPoints();
  for (int i = 0; i < Points; ++i)
  {
    const double share = i / (Points - 1.0);
    opacity.AddPoint(low + share * (high - low), share < Hidden ? 0.0 : values[i]);
  }
}

double MeanAlpha(const FloatPicture& picture)
{
  double sum = 0.0;
  int covered = 0;
  for (std::size_t i = 3; i < picture.Pixels.size(); i += 4)
  {
    sum += picture.Pixels[i];
    covered += picture.Pixels[i] > 0.0f;
  }
  return covered > 0 ? sum / covered : 0.0;
}

ConformanceScenes AllScenes()
{
  ConformanceScenes all;
  for (const auto& group :
    { ScenesOfViews(), ScenesOfArrays(), ScenesOfAppearance(), ScenesOfData() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}
}

class Conformance : public ::testing::TestWithParam<ConformanceScene>
{
protected:
  void SetUp() override
  {
    this->Image = GetParam().Image();
    if (!this->Image)
    {
      GTEST_SKIP() << "the file of the scene " << GetParam().Name
                   << " is missing; VOLUMEBENCH_DATA names the folder";
    }
  }

  FloatPicture Draw(const std::string& technique, const Settings& settings)
  {
    std::unique_ptr<RenderScene>& scene = this->Scenes[technique];
    if (!scene)
    {
      scene = std::make_unique<RenderScene>(technique, this->Image, GetParam().Property());
      scene->Window->SetSize(Size, Size);
      GetParam().Arrange(*scene);
    }
    vtkVolumeBenchMapper* mapper = scene->Mapper;
    mapper->SetStepVoxels(settings.Step);
    mapper->SetRaySetUp(settings.SetUp);
    mapper->SetSliceExtent(settings.Extent);
    mapper->SetSliceTarget(settings.Target);
    mapper->SetSliceOrder(settings.Order);
    FloatPicture picture = scene->Picture();
    EXPECT_EQ(mapper->GetFailure(), "");
    return picture;
  }

  // The error against the reference, which must be within the tolerances of the suite.
  double MeetReference(const std::string& name, const FloatPicture& picture)
  {
    const ImageError error = CompareImages(picture, this->Reference);
    EXPECT_LE(error.Rmse, MostRmse) << name;
    EXPECT_LE(error.P999, MostP999) << name;
    if (!(error.Rmse <= MostRmse && error.P999 <= MostP999))
    {
      ADD_FAILURE() << "see "
                    << KeepPictures(GetParam().Name + "-" + name, picture, this->Reference);
    }
    std::cout << "[ MEASURED ] " << GetParam().Name << " step " << GetParam().StepVoxels << " "
              << name << " rmse " << error.Rmse << " p999 " << error.P999 << "\n";
    return error.Rmse;
  }

  // The exact one, which fine steps must come close to.
  void DrawReference()
  {
    this->Reference = this->Draw("reference", {});
    const FloatPicture fine = this->Draw(AllTechniques().front(), { FineStep, 0 });
    const ImageError error = CompareImages(fine, this->Reference);
    EXPECT_LE(error.Rmse, 0.1 * MostRmse) << "fine steps do not meet the reference";
    EXPECT_LE(error.P999, 0.1 * MostP999) << "fine steps do not meet the reference";
    if (!(error.Rmse <= 0.1 * MostRmse && error.P999 <= 0.1 * MostP999))
    {
      ADD_FAILURE() << "see " << KeepPictures(GetParam().Name + "-fine", fine, this->Reference);
    }
    const double mean = MeanAlpha(this->Reference);
    std::cout << "[ MEASURED ] " << GetParam().Name << " fine steps rmse " << error.Rmse << " p999 "
              << error.P999 << " mean alpha " << mean << "\n";
    EXPECT_GE(mean, GetParam().NearlyEmpty ? 1e-4 : 0.05) << "there is nothing to compare";
  }

  void CompareRayCasters()
  {
    const FloatPicture expected = this->Draw(AllTechniques().front(), { 1.0, 0 });
    for (const std::string& technique : Techniques(false))
    {
      for (const int setUp : { 0, 1 })
      {
        const FloatPicture picture = this->Draw(technique, { 1.0, setUp });
        const double apart = CompareImages(picture, expected).Rmse;
        EXPECT_LE(apart, MostApart) << technique << " with ray set-up " << setUp;
        if (!(apart <= MostApart))
        {
          ADD_FAILURE() << "see "
                        << KeepPictures(GetParam().Name + "-apart-" + technique, picture, expected);
        }
      }
    }
  }

  void CompareSlices(const std::string& technique, double errorOfRays)
  {
    const double step = GetParam().StepVoxels;
    const FloatPicture plain = this->Draw(technique, { step });
    const double error = this->MeetReference(technique, plain);
    EXPECT_LE(error, 1.5 * errorOfRays + FloatRounding) << technique << " against single-pass";
    for (const int extent : { 1, 2 })
    {
      this->MeetReference(technique + "-extent-" + std::to_string(extent),
        this->Draw(technique, { step, 1, extent }));
    }
    const FloatPicture reversed = this->Draw(technique, { step, 1, 0, Float32, 1 });
    EXPECT_LE(CompareImages(reversed, plain).Rmse, 1e-5) << technique << " back to front";
    if (GetParam().Translucent)
    {
      this->CompareTargets(technique, error);
    }
  }

  void CompareTargets(const std::string& technique, double error)
  {
    const double step = GetParam().StepVoxels;
    const double halves =
      CompareImages(this->Draw(technique, { step, 1, 0, Float16 }), this->Reference).Rmse;
    const double bytes =
      CompareImages(this->Draw(technique, { step, 1, 0, Bytes }), this->Reference).Rmse;
    std::cout << "[ MEASURED ] " << GetParam().Name << " " << technique << " rgba32f " << error
              << " rgba16f " << halves << " rgba8 " << bytes << "\n";
    EXPECT_GT(bytes, 3.0 * error) << technique;
    EXPECT_LE(halves, bytes) << technique;
    EXPECT_GE(halves, 0.9 * error) << technique;
  }

  void CompareSkipping(const std::string& technique)
  {
    constexpr double MostChanged = 1e-6;
    this->Draw(technique, {});
    RenderScene& scene = *this->Scenes[technique];
    HideLowValues(*scene.Volume->GetProperty()->GetScalarOpacity());
    scene.Mapper->SetMacrocellVoxels(4);
    for (const int integrator : { 1, 2 })
    {
      scene.Mapper->SetIntegrator(integrator);
      scene.Mapper->SetSkipping(false);
      const FloatPicture all = this->Draw(technique, {});
      scene.Mapper->SetSkipping(true);
      const FloatPicture skipped = this->Draw(technique, {});
      EXPECT_FALSE(CompareImages(skipped, all).Linf > MostChanged)
        << technique << ", integrator " << integrator << ", off by "
        << CompareImages(skipped, all).Linf;
    }
  }

  // Automatic draws what Midpoint or Segment does, and Midpoint only where it is good enough.
  void CompareChoice(double step)
  {
    const std::string technique = AllTechniques().front();
    std::map<int, FloatPicture> pictures;
    for (const int integrator : { 1, 2, 4 })
    {
      this->Draw(technique, { step });
      this->Scenes[technique]->Mapper->SetIntegrator(integrator);
      pictures[integrator] = this->Draw(technique, { step });
    }
    this->Scenes[technique]->Mapper->SetIntegrator(1);
    const bool midpoint = pictures[4].Pixels == pictures[1].Pixels;
    EXPECT_TRUE(midpoint || pictures[4].Pixels == pictures[2].Pixels) << "neither of both";
    const double ofMidpoint = CompareImages(pictures[1], this->Reference).Rmse;
    const double ofSegment = CompareImages(pictures[2], this->Reference).Rmse;
    std::cout << "[ MEASURED ] " << GetParam().Name << " step " << step << " automatic is "
              << (midpoint ? "Midpoint" : "Segment") << "; rmse " << ofMidpoint << " and "
              << ofSegment << "\n";
    EXPECT_LE(midpoint ? ofMidpoint : ofSegment, std::max(SufficientError, 1.05 * ofSegment))
      << "at step " << step;
  }

  vtkSmartPointer<vtkImageData> Image;
  FloatPicture Reference;
  std::map<std::string, std::unique_ptr<RenderScene>> Scenes; // by technique
};

TEST_P(Conformance, EveryTechniqueMeetsTheReference)
{
  this->DrawReference();
  this->CompareRayCasters();
  double errorOfRays = 0.0;
  for (const std::string& technique : Techniques(false))
  {
    const double error =
      this->MeetReference(technique, this->Draw(technique, { GetParam().StepVoxels }));
    errorOfRays = technique == AllTechniques().front() ? error : errorOfRays;
  }
  for (const std::string& technique : Techniques(true))
  {
    this->CompareSlices(technique, errorOfRays);
  }
  for (const double step : { 2.0, 1.0, 0.5 })
  {
    this->CompareChoice(step);
  }
}

// The scenes show something almost everywhere; for this they lose the lower part of their values.
TEST_P(Conformance, SkippingChangesNothing)
{
  for (const std::string& technique : Techniques(false))
  {
    this->CompareSkipping(technique);
  }
  for (const std::string& technique : Techniques(true))
  {
    this->CompareSkipping(technique);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Conformance, ::testing::ValuesIn(AllScenes()),
  [](const auto& info) { return info.param.Name; });
