// Voreen's .dat headers, old .dat files, and faults by name.
#include "TemporaryFolder.h"
#include "VolumeReading.h"

#include "vtkVolumeBenchVoreenReader.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

using namespace volumebench;

namespace
{
using Reading = VolumeReading<vtkVolumeBenchVoreenReader>;

class VoreenReader : public testing::Test
{
protected:
  std::string Write(const std::string& header) { return this->Folder.Write("a.dat", header); }

  void ExpectFault(const std::string& header, const std::string& cause)
  {
    ExpectRefused<vtkVolumeBenchVoreenReader>(this->Write(header), cause);
  }

  TemporaryFolder Folder;
};

template <typename Value>
std::string BytesOf(std::initializer_list<Value> values)
{
  std::string bytes(values.size() * sizeof(Value), '\0');
  std::memcpy(bytes.data(), values.begin(), bytes.size());
  return bytes;
}
}

TEST_F(VoreenReader, AHeaderIsReadWithItsVoxels)
{
  this->Folder.Write("a b.raw", BytesOf<unsigned short>({ 0, 1, 2, 3, 4, 5, 600, 70 }));
  const Reading reading(
    this->Write("ObjectFileName:\ta b.raw\r\nTaggedFileName:\t---\nResolution:\t2 2 2\n"
                "SliceThickness:\t1 0.5 2.5\nFormat:\t\tUSHORT_12\nObjectModel:\tI\nNbrTags: 0\n"));
  EXPECT_TRUE(reading.Errors.empty());
  EXPECT_EQ(reading.Image->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(reading.At(0, 1, 1), 600.0);
  EXPECT_EQ(reading.Image->GetSpacing()[1], 0.5);
  EXPECT_EQ(reading.Image->GetSpacing()[2], 2.5);
}

TEST_F(VoreenReader, FormatsAndModels)
{
  const std::string header = "ObjectFileName: v.raw\nResolution: 2 1 1\n";
  this->Folder.Write("v.raw", BytesOf<float>({ 1.5f, -2.5f }));
  EXPECT_EQ(Reading(this->Write(header + "Format: FLOAT")).At(1, 0, 0), -2.5);
  this->Folder.Write("v.raw", BytesOf<double>({ 1.5, 1e300 }));
  EXPECT_EQ(Reading(this->Write(header + "Format: DOUBLE")).At(1, 0, 0), 1e300);
  this->Folder.Write("v.raw", BytesOf<signed char>({ 1, -2 }));
  EXPECT_EQ(Reading(this->Write(header + "Format: CHAR")).At(1, 0, 0), -2.0);
  this->Folder.Write("v.raw", BytesOf<int>({ 1, -70000 }));
  EXPECT_EQ(Reading(this->Write(header + "Format: INT")).At(1, 0, 0), -70000.0);
  this->Folder.Write("v.raw", "abcdefgh");
  const Reading colors(this->Write(header + "Format: UCHAR\nObjectModel: RGBA"));
  EXPECT_EQ(colors.Image->GetNumberOfScalarComponents(), 4);
  EXPECT_EQ(colors.At(1, 0, 0, 1), 'f');
}

TEST_F(VoreenReader, AnAbsolutePathIsTakenAsItIs)
{
  const TemporaryFolder other;
  const std::string raw = other.Write("v.raw", "ab");
  const Reading reading(
    this->Write("ObjectFileName: " + raw + "\nResolution: 2 1 1\nFormat: UCHAR"));
  EXPECT_EQ(reading.At(1, 0, 0), 'b');
}

TEST_F(VoreenReader, OldFilesHoldTheirVoxels)
{
  const std::string old = BytesOf<unsigned short>({ 3, 2, 1, 10, 11, 12, 13, 14, 1500 });
  const Reading reading(this->Write(old));
  EXPECT_TRUE(reading.Errors.empty());
  EXPECT_EQ(reading.Image->GetDimensions()[0], 3);
  EXPECT_EQ(reading.At(2, 1, 0), 1500.0);
  const int extent[6] = { 1, 2, 1, 1, 0, 0 };
  EXPECT_EQ(Reading(this->Write(old), extent).At(1, 1, 0), 14.0);
}

TEST_F(VoreenReader, FaultsNameTheFile)
{
  const std::string header = "ObjectFileName: v.raw\nResolution: 2 2 1\n";
  this->ExpectFault("", "ObjectFileName is missing");
  this->ExpectFault("Resolution: 1 1 1\nFormat: UCHAR", "ObjectFileName is missing");
  this->ExpectFault("ObjectFileName: v.raw\nFormat: UCHAR", "Resolution is missing");
  this->ExpectFault(header, "Format is missing");
  this->ExpectFault(header + "Format: HALF", "Format \"HALF\" is unknown; known are CHAR, DOUBLE");
  this->ExpectFault(header + "Format: U\r\x01Z", "Format \"U??Z\" is unknown");
  this->ExpectFault(header + "Format: UCHAR\nObjectModel: YUV", "ObjectModel \"YUV\" is unknown");
  this->ExpectFault(header + "Format: UCHAR\nSliceThickness: 1 1", "is not three numbers");
  this->ExpectFault(header + "Format: UCHAR\nSliceThickness: 1 0 1", "each must be above 0");
  this->ExpectFault("ObjectFileName: v.raw\nResolution: 2 -2 1\nFormat: UCHAR", "-2 is not from 1");
  this->ExpectFault(
    "ObjectFileName: v.raw\nResolution: 2 2 1 1\nFormat: UCHAR", "not three numbers");
  this->ExpectFault(header + "Format: UCHAR", "v.raw: cannot be opened: No such file");
  this->Folder.Write("v.raw", "12345");
  this->ExpectFault(header + "Format: UCHAR", "have 5 bytes, but it says 2 x 2 x 1 of 1 bytes");
}

TEST_F(VoreenReader, FilesAreKnownByTheirBeginning)
{
  vtkNew<vtkVolumeBenchVoreenReader> reader;
  EXPECT_TRUE(reader->CanReadFile(this->Write("Format: UCHAR\nObjectFileName: a.raw").c_str()));
  EXPECT_TRUE(reader->CanReadFile(this->Write(BytesOf<unsigned short>({ 1, 1, 2, 7, 7 })).c_str()));
  EXPECT_FALSE(reader->CanReadFile(this->Write("TITLE = \"a Tecplot file\"").c_str()));
  EXPECT_FALSE(reader->CanReadFile(this->Write("").c_str()));
  EXPECT_FALSE(reader->CanReadFile("/nowhere"));
}
