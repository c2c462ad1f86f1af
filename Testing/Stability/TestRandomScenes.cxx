// What must hold for any scene, tried with scenes drawn at random: a picture or one clear error,
// opacities in [0, 1], no colour brighter than its opacity allows, one colour kept as it is, and a
// volume cut in two equal to the whole. VOLUMEBENCH_RANDOM_SCENES and VOLUMEBENCH_RANDOM_SEED try
// more of them, or others.
#include "EveryTechnique.h"
#include "RandomScene.h"

#include "vtkPlane.h"

#include <cmath>
#include <cstdlib>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
const glm::dvec3 OneColor(0.75, 0.5, 0.25);

unsigned FromEnvironment(const char* name, unsigned otherwise)
{
  const char* text = std::getenv(name);
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// Runs a check on every scene, with the scene in the message of what fails.
template <typename Check>
void ForEveryScene(const std::string& technique, const Check& check)
{
  const unsigned first = FromEnvironment("VOLUMEBENCH_RANDOM_SEED", 1);
  const unsigned count = FromEnvironment("VOLUMEBENCH_RANDOM_SCENES", 20);
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    RandomScene scene(seed, technique);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + scene.Describe());
    check(scene);
    if (::testing::Test::HasFatalFailure())
    {
      return;
    }
  }
}

// Composited light: finite, opacity in [0, 1], colours no brighter than opacity.
void ExpectLight(const FloatPicture& picture)
{
  constexpr float Rounding = 2e-6f;
  for (std::size_t i = 0; i < picture.Pixels.size(); i += 4)
  {
    const float* rgba = &picture.Pixels[i];
    for (int channel = 0; channel < 4; ++channel)
    {
      ASSERT_TRUE(std::isfinite(rgba[channel])) << "pixel " << i / 4 << " channel " << channel;
      ASSERT_GE(rgba[channel], 0.0f) << "pixel " << i / 4 << " channel " << channel;
      ASSERT_LE(rgba[channel], rgba[3] + Rounding) << "pixel " << i / 4 << " channel " << channel;
    }
    ASSERT_LE(rgba[3], 1.0f + Rounding) << "pixel " << i / 4;
  }
}

void ExpectOneColor(const FloatPicture& picture)
{
  for (std::size_t i = 0; i < picture.Pixels.size(); i += 4)
  {
    const float* rgba = &picture.Pixels[i];
    for (int channel = 0; channel < 3; ++channel)
    {
      ASSERT_NEAR(rgba[channel], OneColor[channel] * rgba[3], 1e-6 + 1e-5 * rgba[3])
        << "pixel " << i / 4 << " channel " << channel;
    }
  }
}

// The picture of the part of the volume on one side of the plane.
FloatPicture Half(RandomScene& scene, vtkPlane* plane, double side)
{
  vtkNew<vtkPlane> kept;
  kept->SetOrigin(plane->GetOrigin());
  double normal[3];
  plane->GetNormal(normal);
  kept->SetNormal(side * normal[0], side * normal[1], side * normal[2]);
  scene.Get().Mapper->RemoveAllClippingPlanes();
  scene.Get().Mapper->AddClippingPlane(kept);
  FloatPicture picture = scene.Get().Picture();
  scene.Get().Mapper->RemoveAllClippingPlanes();
  return picture;
}

// Through the middle of what is drawn, so that the eye looks along its normal.
vtkSmartPointer<vtkPlane> PlaneAcross(RandomScene& scene)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  double box[6];
  std::copy_n(scene.Get().Volume->GetBounds(), 6, box);
  plane->SetOrigin(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
  vtkCamera* camera = scene.Get().Renderer->GetActiveCamera();
  plane->SetNormal(camera->GetDirectionOfProjection());
  return plane;
}
}

class RandomScenes : public EveryTechnique
{
};

TEST_P(RandomScenes, GiveAPictureOrOneClearError)
{
  int drawn = 0;
  int scenes = 0;
  ForEveryScene(GetParam(),
    [&](RandomScene& scene)
    {
      const FloatPicture picture = scene.Get().Picture();
      EXPECT_EQ(scene.Get().Mapper->GetFailure(), "");
      ExpectLight(picture);
      ++scenes;
      for (std::size_t i = 3; i < picture.Pixels.size(); i += 4)
      {
        if (picture.Pixels[i] > 0.0f)
        {
          ++drawn;
          break;
        }
      }
    });
  EXPECT_GT(drawn, scenes / 3) << "too many pictures are empty for the test to mean anything";
}

TEST_P(RandomScenes, KeepAConstantColour)
{
  ForEveryScene(GetParam(),
    [](RandomScene& scene)
    {
      if (!scene.IsLit())
      {
        scene.UseOneColor(OneColor);
        ExpectOneColor(scene.Get().Picture());
      }
    });
}

TEST_P(RandomScenes, EqualTheirTwoHalvesOneBehindTheOther)
{
  ForEveryScene(GetParam(),
    [](RandomScene& scene)
    {
      if (!scene.IsComposite() || scene.IsLit() || scene.HasHoles())
      {
        return;
      }
      scene.Get().Mapper->SetTerminationThreshold(0.0);
      scene.UseOneMedium(OneColor, 2.0 / scene.GetDiagonal());
      const auto plane = PlaneAcross(scene);
      const FloatPicture whole = scene.Get().Picture();
      const FloatPicture front = Half(scene, plane, -1.0);
      const FloatPicture back = Half(scene, plane, 1.0);
      for (std::size_t i = 0; i < whole.Pixels.size(); ++i)
      {
        const double passing = 1.0 - front.Pixels[4 * (i / 4) + 3];
        ASSERT_NEAR(front.Pixels[i] + passing * back.Pixels[i], whole.Pixels[i], 1e-5)
          << "pixel " << i / 4 << " channel " << i % 4;
      }
    });
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(RandomScenes);
