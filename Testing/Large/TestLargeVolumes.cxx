// Volumes that exceed the axis, the texture or the memory that a software renderer takes, against
// the exact picture.
#include "RenderScene.h"

#include "Error/ImageError.h"
#include "Techniques/Technique.h"

#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <unistd.h>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Gibibyte = 1024.0 * 1024.0 * 1024.0;

// A smooth field from 0 to 1 over the whole volume, whatever its size.
double Waves(double x, double y, double z)
{
  return 0.5 + 0.25 * std::sin(9.0 * x + 4.0 * y) + 0.25 * std::cos(7.0 * z - 5.0 * x);
}

template <typename Array>
vtkSmartPointer<vtkImageData> LargeImage(const glm::ivec3& dims, double largest)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dims.x, dims.y, dims.z);
  image->SetSpacing(1.0 / dims.x, 1.0 / dims.y, 1.0 / dims.z);
  vtkNew<Array> values;
  values->SetName("field");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  auto* value = values->GetPointer(0);
  using Value = std::remove_pointer_t<decltype(value)>;
  std::vector<Value> row(dims.x);
  for (int z = 0; z < dims.z; ++z)
  {
    for (int y = 0; y < dims.y; ++y, value += dims.x)
    {
      // Rows of four are alike, which takes a quarter of the time.
      for (int x = 0; y % 4 == 0 && x < dims.x; ++x)
      {
        row[x] = static_cast<Value>(largest *
          Waves(static_cast<double>(x) / dims.x, static_cast<double>(y) / dims.y,
            static_cast<double>(z) / dims.z));
      }
      std::copy(row.begin(), row.end(), value);
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

bool HasMemory(double bytes)
{
  return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * sysconf(_SC_PAGESIZE) > bytes;
}

void ExpectTheExactPicture(vtkImageData* image, double largest)
{
  auto property = MakeLinearExtinctionProperty(4.0 / largest, 0.0, largest, 257);
  RenderScene exact("reference", image, property);
  const FloatPicture expected = exact.Picture();
  ASSERT_EQ(exact.Mapper->GetFailure(), "");
  for (const std::string technique : { "single-pass", "slices" })
  {
    RenderScene scene(technique, image, property);
    scene.Mapper->SetStepVoxels(1.0);
    const FloatPicture picture = scene.Picture();
    ASSERT_EQ(scene.Mapper->GetFailure(), "");
    EXPECT_NE(scene.Mapper->GetFeatures().find("bricks"), std::string::npos);
    const ImageError error = CompareImages(picture, expected);
    EXPECT_LE(error.Rmse, 1e-3) << technique;
    std::cout << "[ MEASURED ] " << technique << " rmse " << error.Rmse << ", "
              << scene.Mapper->GetSetUpCosts().BytesOnDevice << " bytes on the device\n";
  }
}
}

TEST(LargeVolumes, OfEightThousandVoxelsOnAnAxis)
{
  ExpectTheExactPicture(LargeImage<vtkUnsignedCharArray>({ 8192, 64, 64 }, 255.0), 255.0);
}

TEST(LargeVolumes, OfAThousandVoxelsOnEveryAxis)
{
  if (!HasMemory(6.0 * Gibibyte))
  {
    GTEST_SKIP() << "less than 6 GiB of memory are free";
  }
  ExpectTheExactPicture(LargeImage<vtkUnsignedCharArray>({ 1024, 1024, 1024 }, 255.0), 255.0);
}

TEST(LargeVolumes, OfTwoGibibytes)
{
  if (!HasMemory(8.0 * Gibibyte))
  {
    GTEST_SKIP() << "less than 8 GiB of memory are free";
  }
  ExpectTheExactPicture(LargeImage<vtkFloatArray>({ 1024, 1024, 512 }, 1.0), 1.0);
}
