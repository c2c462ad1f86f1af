// Volumes of studies: generated values in closed form, files of each kind, and faults by name.
#include "Study/Generators.h"
#include "Study/VolumeFile.h"
#include "TemporaryFolder.h"
#include "TextFile.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volumebench;

namespace
{
class VolumeFile : public testing::Test
{
protected:
  std::string FaultOf(const char* name)
  {
    try
    {
      const Json dataset = { { "name", name } };
      CheckVolume(dataset, this->Folder.GetPath());
      ReadVolume(dataset, this->Folder.GetPath());
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  }

  void ExpectFault(const char* name, const std::string& cause)
  {
    const std::string fault = this->FaultOf(name);
    EXPECT_NE(fault.find(cause), std::string::npos) << "'" << fault << "' lacks '" << cause << "'";
  }

  TemporaryFolder Folder;
};

double ValueAt(const Json& dataset, int i, int j, int k)
{
  return Generate(dataset)->GetScalarComponentAsDouble(i, j, k, 0);
}
}

TEST_F(VolumeFile, GeneratedValuesAreThoseOfTheirEquations)
{
  const Json wave = { { "name", "waves" }, { "dims", { 5, 9, 17 } }, { "scalar_type", "float32" } };
  const double pi = std::acos(-1.0);
  const double x = std::sin(4.0 * pi * 0.25 + 0.5);
  const double y = std::sin(3.0 * pi * 0.375 + 1.7);
  const double z = std::sin(5.0 * pi * 0.75 + 2.9);
  EXPECT_NEAR(ValueAt(wave, 1, 3, 12), (3.0 + x + y + z) / 6.0, 1e-6);

  // The foci are at z = 1 and -1 of an axis from -2 to 2; the corners are nought.
  const Json oval = { { "name", "lemniscate" }, { "dims", { 5, 5, 9 } }, { "extent", 2.0 } };
  EXPECT_EQ(ValueAt(oval, 2, 2, 6), 65535.0);
  EXPECT_EQ(ValueAt(oval, 2, 2, 2), 65535.0);
  EXPECT_EQ(ValueAt(oval, 4, 0, 8), 0.0);
  // The middle lies on the lemniscate, where the field is 1/2.
  const double corner = 1.0 / (1.0 + std::sqrt((2.0 + 1.0) * (2.0 + 9.0)));
  EXPECT_NEAR(ValueAt(oval, 2, 2, 4), 65535.0 * (0.5 - corner) / (1.0 - corner), 0.51);

  const Json ball = { { "name", "ball" }, { "dims", { 201, 201, 201 } } };
  EXPECT_EQ(ValueAt(ball, 162, 100, 100), 255.0); // radius 0.62
  EXPECT_EQ(ValueAt(ball, 200, 100, 100), 0.0);
}

// Testing/Python asks the same of the other implementation; sines may differ in their last digit.
TEST_F(VolumeFile, GeneratedVoxelsAreThoseOfThePythonPackage)
{
  const Json rows =
    ParseJson(ReadTextFile(VOLUMEBENCH_GENERATED_VOLUMES), VOLUMEBENCH_GENERATED_VOLUMES);
  std::vector<std::string> generators;
  for (const Json& row : rows)
  {
    const Json& dataset = row["dataset"];
    generators.push_back(dataset["name"]);
    SCOPED_TRACE(generators.back());
    const auto image = Generate(dataset);
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    double sum = 0.0;
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      sum += scalars->GetTuple1(i);
    }
    const double mean = row["mean"];
    EXPECT_NEAR(sum / static_cast<double>(scalars->GetNumberOfTuples()), mean, 1e-3);
    for (const Json& voxel : row["voxels"])
    {
      const double found = image->GetScalarComponentAsDouble(voxel[0], voxel[1], voxel[2], 0);
      EXPECT_NEAR(found, voxel[3].get<double>(), 1.0) << voxel;
    }
    EXPECT_EQ(
      Json(std::vector<double>(image->GetSpacing(), image->GetSpacing() + 3)), row["spacing"]);
  }
  EXPECT_EQ(generators, GeneratorNames());
}

TEST_F(VolumeFile, ASeedAndASpacingMayBeGiven)
{
  const auto voxels = [](const Json& dataset)
  {
    const auto image = Generate(dataset);
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    const auto* first = static_cast<unsigned char*>(scalars->GetVoidPointer(0));
    return std::vector<unsigned char>(first, first + scalars->GetNumberOfTuples());
  };
  Json speckle = { { "name", "speckle" }, { "dims", { 12, 12, 12 } } };
  const auto first = voxels(speckle);
  EXPECT_EQ(first, voxels(speckle));
  speckle["seed"] = 2;
  EXPECT_NE(first, voxels(speckle));
  speckle["spacing"] = { 1.0, 2.0, 3.0 };
  EXPECT_EQ(Generate(speckle)->GetSpacing()[2], 3.0);
}

TEST_F(VolumeFile, AShellFillsItsShareOfTheBox)
{
  for (const double share : { 0.02, 0.1, 0.3, 0.6, 0.95 })
  {
    const auto image = Generate({ { "name", "any" }, { "generator", "shell" },
      { "dims", { 96, 96, 96 } }, { "scalar_type", "float32" }, { "share", share } });
    vtkDataArray* values = image->GetPointData()->GetScalars();
    vtkIdType filled = 0;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      filled += values->GetTuple1(i) > 0.0;
    }
    const double found = static_cast<double>(filled) / values->GetNumberOfTuples();
    EXPECT_NEAR(found, share, 0.06 * share) << share;
    EXPECT_EQ(image->GetScalarComponentAsDouble(48, 48, 48, 0) > 0.5, share >= 0.5);
  }
}

TEST_F(VolumeFile, RawFilesAreReadAsTheirSidecarSays)
{
  std::string bytes;
  for (char i = 0; i < 12; ++i)
  {
    bytes += { '\0', i }; // big-endian
  }
  this->Folder.Write("head.raw", bytes);
  this->Folder.Write("head.json",
    R"({"dims": [2, 3, 2], "scalar_type": "uint16", "spacing": [1, 1, 4], "byte_order": "big"})");
  const OpenVolume volume = ReadVolume({ { "name", "head" } }, this->Folder.GetPath());
  EXPECT_EQ(volume.ScalarType, "uint16");
  EXPECT_EQ(volume.Dims, (std::array<int, 3>{ 2, 3, 2 }));
  EXPECT_EQ(volume.MeanSpacing, 2.0);
  EXPECT_EQ(volume.Range[1], 11.0);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(1, 2, 1, 0), 11.0);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 1, 0, 0), 2.0);
}

TEST_F(VolumeFile, HeadersAreRead)
{
  this->Folder.Write("cube.mhd",
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 2 2\n"
    "ElementType = MET_UCHAR\nElementDataFile = cube.bin\n");
  this->Folder.Write("cube.bin", "abcdefgh");
  EXPECT_EQ(ReadVolume({ { "name", "cube" } }, this->Folder.GetPath()).Range[0], 'a');
  // VTK takes a first axis of less than ten for components.
  this->Folder.Write("slab.nrrd",
    "NRRD0004\ntype: int8\ndimension: 3\nsizes: 16 4 4\nencoding: raw\n\n" +
      std::string(255, '\x07') + "\xff");
  const OpenVolume slab = ReadVolume({ { "name", "slab" } }, this->Folder.GetPath());
  EXPECT_EQ(slab.ScalarType, "int8");
  EXPECT_EQ(slab.Range[0], -1.0);
  this->Folder.Write(
    "grid.vti", R"(<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
    <ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">
    <PointData Scalars="s"><DataArray type="Float32" Name="s" format="ascii">0 1 2 3 4 5 6 7.5
    </DataArray></PointData></Piece></ImageData></VTKFile>)");
  EXPECT_EQ(ReadVolume({ { "name", "grid" } }, this->Folder.GetPath()).Range[1], 7.5);
}

TEST_F(VolumeFile, CompressedVoxelsAreRead)
{
  using namespace std::string_literals;
  // 63 zeros and a nine.
  const std::string gzipped =
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x63\x60\xa0\x08\x70\x02\x00\x92\xdb\x51\x0c\x40\x00\x00\x00"s;
  const std::string deflated = "\x78\xda\x63\x60\xa0\x08\x70\x02\x00\x00\x49\x00\x0a"s;
  this->Folder.Write("slab.nrrd",
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 16 2 2\nencoding: gzip\n\n" + gzipped);
  this->Folder.Write("cube.mhd",
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nCompressedData = True\nDimSize = 16 2 2\n"
    "ElementType = MET_UCHAR\nElementDataFile = cube.zraw\n");
  this->Folder.Write("cube.zraw", deflated);
  for (const char* name : { "slab", "cube" })
  {
    const OpenVolume volume = ReadVolume({ { "name", name } }, this->Folder.GetPath());
    EXPECT_EQ(volume.Dims, (std::array<int, 3>{ 16, 2, 2 })) << name;
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(15, 1, 1, 0), 9.0) << name;
    EXPECT_EQ(volume.Range[0], 0.0);
  }
}

TEST_F(VolumeFile, PvmAndVoreenVolumesAreRead)
{
  this->Folder.Write("one.pvm", "PVM2\n2 2 2\n1 2 3\n1\nabcdefgh");
  const OpenVolume one = ReadVolume({ { "name", "one" } }, this->Folder.GetPath());
  EXPECT_EQ(one.Range[1], 'h');
  EXPECT_EQ(one.MeanSpacing, 2.0);
  this->Folder.Write("two.dat", "ObjectFileName: two.raw\nResolution: 2 2 2\nFormat: UCHAR\n");
  this->Folder.Write("two.raw", "abcdefgi"); // has no .json of its own, and needs none
  CheckVolume({ { "name", "two" } }, this->Folder.GetPath());
  EXPECT_EQ(ReadVolume({ { "name", "two" } }, this->Folder.GetPath()).Range[1], 'i');
}

TEST_F(VolumeFile, FaultsNameTheFile)
{
  this->Folder.Write("few.pvm", "PVM\n2 2 2\n1\nabc");
  this->ExpectFault("few", "few.pvm: has 3 bytes of voxels");
  this->Folder.Write("lone.dat", "ObjectFileName: none.raw\nResolution: 2 2 2\nFormat: UCHAR\n");
  this->ExpectFault("lone", "none.raw: cannot be opened");
  this->ExpectFault("nowhere", "dataset \"nowhere\": no file");
  this->Folder.Write("short.raw", "12345");
  this->ExpectFault("short", "short.json is missing");
  this->Folder.Write("short.json", R"({"dims": [2, 2, 2], "scalar_type": "uint8"})");
  this->ExpectFault(
    "short", "has 5 bytes, but short.json says 2 x 2 x 2 of uint8, that is 8 bytes");
  this->Folder.Write("short.json", R"({"dims": [2, 2], "scalar_type": "uint8"})");
  this->ExpectFault("short", "short.json: \"dims\"");
  this->Folder.Write("broken.mhd", "not a header");
  this->ExpectFault("broken", "broken.mhd: cannot be read as .mhd");
  this->Folder.Write("broken2.vti", "<VTKFile type=\"ImageData\"");
  this->ExpectFault("broken2", "broken2.vti: cannot be read as .vti");
  this->Folder.Write("broken3.nii", "nothing");
  this->ExpectFault("broken3", "broken3.nii: cannot be read as .nii");
  this->Folder.Write("flat.raw", "1234");
  this->Folder.Write("flat.json", R"({"dims": [2, 2, 1], "scalar_type": "uint8"})");
  this->ExpectFault("flat", "flat.raw: is 2 x 2 x 1 voxels");
}
