// PVM volumes: streams unpacked as worked out by hand, every header, and faults by name.
#include "DdsStream.h"
#include "PvmWriter.h"
#include "TemporaryFolder.h"
#include "VolumeReading.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkVolumeBenchPvmReader.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

using namespace volumebench;

namespace
{
using Reading = VolumeReading<vtkVolumeBenchPvmReader>;

std::string Unpacked(const std::string& packed)
{
  const Bytes bytes = UnpackDds(Bytes(packed.begin(), packed.end()), [](double) {});
  return std::string(bytes.begin(), bytes.end());
}

// Smooth with some noise, so that widths differ from run to run.
std::string SomeBytes(std::size_t count)
{
  std::mt19937 random(7);
  std::string bytes(count, '\0');
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool rough = i / 500 % 3 == 0;
    bytes[i] = static_cast<char>(i / 20 + (rough ? random() % 200 : random() % 3));
  }
  return bytes;
}

std::string Counting(int count)
{
  std::string bytes;
  for (int i = 0; i < count; ++i)
  {
    bytes += static_cast<char>(i);
  }
  return bytes;
}

class PvmReader : public testing::Test
{
protected:
  void ExpectFault(const std::string& content, const std::string& cause)
  {
    ExpectRefused<vtkVolumeBenchPvmReader>(this->Folder.Write("bad.pvm", content), cause);
  }

  TemporaryFolder Folder;
};
}

TEST_F(PvmReader, StreamsAreUnpackedAsWorkedOutByHand)
{
  // Groups of one byte, strip 1; two values of 8 bits: 65 and 66 - 65, each plus 128.
  const std::string two = BytesOfBits("00 0000000000000000 0000010 111 11000001 10000001 0000000");
  EXPECT_EQ(Unpacked("DDS v3d\n" + two), "AB");
  // Five values of 2 bits would not reach 10, so the first is a run of its own; strip 2: from the
  // fourth byte on what changed a strip earlier is added: 10, 11, 12, 12 + 0 + 1, 13 - 1 + 1.
  const std::string strip =
    BytesOfBits("00 0000000000000001 0000001 111 10001010 0000100 001 11 11 10 01 0000000");
  EXPECT_EQ(Unpacked("DDS v3d\n" + strip), "\x0a\x0b\x0c\x0d\x0d");
  // Three equal values take no bits at all; two groups of two bytes: all first ones, then the
  // others.
  const std::string groups =
    BytesOfBits("01 0000000000000000 0000001 111 11000001 0000001 000 0000010 010 101 100");
  EXPECT_EQ(Unpacked("DDS v3d\n" + groups), "ABAB");
}

TEST_F(PvmReader, PackedBytesComeBack)
{
  const std::string content = SomeBytes(4001);
  for (const std::size_t skip : { 1, 2, 3, 4 })
  {
    for (const std::size_t strip : { 1, 2, 50, 5000, 65536 })
    {
      for (const bool blocks : { false, true })
      {
        EXPECT_EQ(Unpacked(PackedAsDds(content, skip, strip, blocks)), content)
          << skip << " " << strip;
      }
    }
  }
  EXPECT_EQ(Unpacked(PackedAsDds(content, 1, 1, false, 127)), content);
  EXPECT_EQ(Unpacked(PackedAsDds("", 1, 1)), "");
}

TEST_F(PvmReader, LongStreamsAreInterleavedInBlocks)
{
  std::string content(2 * (std::size_t(1) << 24) + 1001, 'a');
  for (std::size_t i = 0; i < content.size(); i += 2)
  {
    content[i] = static_cast<char>(i >> 16);
  }
  EXPECT_TRUE(Unpacked(PackedAsDds(content, 2, 1, true, 127)) == content);
}

TEST_F(PvmReader, PlainVolumesOfOneByte)
{
  const std::string path =
    this->Folder.Write("a.pvm", "PVM\n# a comment\n4 3 2\n1\n" + Counting(24));
  const Reading reading(path);
  EXPECT_TRUE(reading.Errors.empty());
  EXPECT_STREQ(reading.File->GetFault(), "");
  const int* dims = reading.Image->GetDimensions();
  EXPECT_EQ(std::vector<int>(dims, dims + 3), (std::vector<int>{ 4, 3, 2 }));
  EXPECT_EQ(reading.Image->GetScalarType(), VTK_UNSIGNED_CHAR);
  EXPECT_STREQ(reading.Image->GetPointData()->GetScalars()->GetName(), "voxels");
  EXPECT_EQ(reading.At(3, 1, 1), 3 + 4 * 1 + 12 * 1);
  EXPECT_EQ(reading.Image->GetSpacing()[2], 1.0);
  EXPECT_EQ(reading.Shares.back(), 1.0);
}

TEST_F(PvmReader, VoxelsOfTwoBytesHaveTheHigherOneFirst)
{
  const std::string content = "PVM2\n2 3 2\n0.5 1 2.25\n2\n" + Counting(24);
  for (const std::string& written : { content, PackedAsDds(content, 2, 2) })
  {
    const Reading reading(this->Folder.Write("b.pvm", written));
    EXPECT_TRUE(reading.Errors.empty());
    EXPECT_EQ(reading.Image->GetScalarType(), VTK_UNSIGNED_SHORT);
    EXPECT_EQ(reading.At(1, 2, 1), 22 * 256 + 23);
    EXPECT_EQ(reading.Image->GetSpacing()[0], 0.5);
    EXPECT_EQ(reading.Image->GetSpacing()[2], 2.25);
  }
}

TEST_F(PvmReader, TextsBehindTheVoxelsAreFieldData)
{
  using namespace std::string_literals;
  const std::string content = "PVM3\n2 2 2\n1 1 1\n1\n" + Counting(8) + "A head\0somebody\0\0CT\0"s;
  const Reading reading(this->Folder.Write("c.pvm", PackedAsDds(content, 1, 2)));
  EXPECT_TRUE(reading.Errors.empty());
  EXPECT_EQ(reading.At(1, 1, 1), 7.0);
  vtkFieldData* fields = reading.Image->GetFieldData();
  const auto text = [&](const char* name)
  {
    auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name));
    return array ? array->GetValue(0) : std::string("none");
  };
  EXPECT_EQ(text("Description"), "A head");
  EXPECT_EQ(text("Courtesy"), "somebody");
  EXPECT_EQ(text("Parameters"), "none");
  EXPECT_EQ(text("Comment"), "CT");
}

TEST_F(PvmReader, ColorsAreComponents)
{
  const Reading reading(this->Folder.Write("d.pvm", "PVM\n2 2 1\n3\n" + Counting(12)));
  EXPECT_EQ(reading.Image->GetNumberOfScalarComponents(), 3);
  EXPECT_EQ(reading.At(1, 0, 0, 2), 5.0);
}

TEST_F(PvmReader, APartIsReadAlone)
{
  const std::string content = "PVM\n6 5 4\n1\n" + Counting(120);
  for (const std::string& written : { content, PackedAsDds(content) })
  {
    for (const int first : { 0, 1 }) // whole rows are read another way
    {
      const int extent[6] = { first, 5, 2, 3, 1, 2 };
      const Reading reading(this->Folder.Write("e.pvm", written), extent);
      EXPECT_EQ(reading.Image->GetNumberOfPoints(), (6 - first) * 2 * 2);
      EXPECT_EQ(reading.At(first, 2, 1), first + 6 * 2 + 30 * 1);
      EXPECT_EQ(reading.At(5, 3, 2), 5 + 6 * 3 + 30 * 2);
    }
  }
}

TEST_F(PvmReader, AFileIsReadAgainAfterAnUpdate)
{
  const std::string path = this->Folder.Write("f.pvm", PackedAsDds("PVM\n2 2 2\n1\nabcdefgh"));
  Reading reading(path);
  reading.File->Modified();
  reading.File->Update();
  EXPECT_EQ(reading.At(1, 1, 1), 'h');
  const int extent[6] = { 0, 1, 0, 1, 1, 1 };
  reading.File->UpdateExtent(extent);
  EXPECT_TRUE(reading.Errors.empty());
}

TEST_F(PvmReader, FaultsNameTheFile)
{
  this->ExpectFault("", "no PVM volume");
  this->ExpectFault("PVM4\n1 1 1\n1\n1", "no PVM volume");
  this->ExpectFault("PVM\n2 x 2\n1\n", "height is missing or no number");
  this->ExpectFault("PVM\n2 0 2\n1\n", "height is 0, not from 1 to 1048576");
  this->ExpectFault("PVM\n2 2 99999999\n1\n", "depth is 99999999");
  this->ExpectFault("PVM2\n2 2 2\n1 -1 1\n1\n12345678", "voxel height is no number above 0");
  this->ExpectFault("PVM2\n2 2 2\n1 1 nan\n1\n12345678", "voxel depth is no number above 0");
  this->ExpectFault("PVM\n2 2 2\n5\n", "5 components");
  this->ExpectFault("PVM\n2 2 2\n1", "ends before the voxels begin");
  this->ExpectFault("PVM\n2 2 2\n1 7\n12345678", "more than the number of components");
  this->ExpectFault(
    "PVM\n2 2 2\n1\n1234567", "has 7 bytes of voxels, but its header says 2 x 2 x 2 of 1 bytes");
  this->ExpectFault("PVM\n2 2 2\n1\n123456789", "has 9 bytes of voxels");
  this->ExpectFault("PVM\n1000000 1000000 1000000\n4\n", "that is 4000000000000000000");
  this->ExpectFault(PackedAsDds("P5\n2 2\n255\n1234"), "no PVM volume");
  this->ExpectFault("DDS v3d\n", "no PVM volume");
  const std::string packed = PackedAsDds("PVM\n9 9 9\n1\n" + SomeBytes(729), 1, 9);
  this->ExpectFault(packed.substr(0, packed.size() - 30), "the compressed data end within a run");
  const Reading none("/nowhere/a.pvm");
  ASSERT_EQ(none.Errors.size(), 1u);
  EXPECT_STREQ(
    none.File->GetFault(), "/nowhere/a.pvm: cannot be opened: No such file or directory");
}

TEST_F(PvmReader, FilesAreKnownByTheirBeginning)
{
  vtkNew<vtkVolumeBenchPvmReader> reader;
  for (const char* beginning : { "PVM\n", "PVM2\n", "PVM3\n", "DDS v3d\n", "DDS v3e\n" })
  {
    EXPECT_TRUE(reader->CanReadFile(this->Folder.Write("g.pvm", beginning).c_str())) << beginning;
  }
  for (const char* beginning : { "", "PVM", "PVM4\n", "DDS v3f\n", "P5\n" })
  {
    EXPECT_FALSE(reader->CanReadFile(this->Folder.Write("g.pvm", beginning).c_str())) << beginning;
  }
  EXPECT_FALSE(reader->CanReadFile("/nowhere"));
  EXPECT_FALSE(reader->CanReadFile(nullptr));
}
