// Damaged volume files: a picture or one line that names the file, never a crash. As many files as
// the environment variable VOLUMEBENCH_FUZZ_FILES says, 400 without it.
#include "PvmWriter.h"
#include "TemporaryFolder.h"
#include "VolumeReading.h"

#include "vtkVolumeBenchPvmReader.h"
#include "vtkVolumeBenchVoreenReader.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

using namespace volumebench;

namespace
{
int FileCount()
{
  const char* given = std::getenv("VOLUMEBENCH_FUZZ_FILES");
  return given ? std::atoi(given) : 400;
}

// One to eight changes: a byte, a bit, a piece taken out, doubled or cut off, or a hostile number.
std::string Damaged(std::string bytes, std::mt19937& random)
{
  const char* const numbers[] = { "0", "-1", "99999999999999999999", "1048576", "nan", "1e999",
    "" };
  const unsigned int changes = 1 + random() % 8;
  for (unsigned int i = 0; i < changes && !bytes.empty(); ++i)
  {
    // Half of the changes hit the header.
    const std::size_t reach = random() % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 40);
    const std::size_t place = random() % reach;
    const std::size_t length = random() % 12;
    switch (random() % 6)
    {
      case 0:
        bytes[place] = static_cast<char>(random());
        break;
      case 1:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.erase(place, length);
        break;
      case 3:
        bytes.insert(place, bytes.substr(place, length));
        break;
      case 4:
        bytes.resize(random() % 4 ? bytes.size() : place);
        break;
      default:
        bytes.replace(place, 1, numbers[random() % std::size(numbers)]);
    }
  }
  return bytes;
}

std::string Voxels(int count)
{
  std::string bytes;
  for (int i = 0; i < count; ++i)
  {
    bytes += static_cast<char>(i * i / 7);
  }
  return bytes;
}

/// Adds one to `refused` or `read`.
template <typename Reader>
void ReadDamaged(const std::string& path, const std::string& bytes, int& refused, int& read)
{
  const VolumeReading<Reader> reading(path);
  const std::string fault = reading.File->GetFault();
  ASSERT_EQ(reading.Errors.size(), fault.empty() ? 0u : 1u) << testing::PrintToString(bytes);
  if (fault.empty())
  {
    ASSERT_GT(reading.Image->GetNumberOfPoints(), 0) << testing::PrintToString(bytes);
    ++read;
    return;
  }
  ASSERT_EQ(fault.find(path + ": "), 0u) << fault;
  ASSERT_EQ(fault.find_first_of("\n\r"), std::string::npos) << fault;
  ASSERT_GT(fault.size(), path.size() + 10) << fault;
  ASSERT_EQ(reading.Image->GetNumberOfPoints(), 0) << fault;
  ++refused;
}

template <typename Reader>
void ReadManyDamaged(const std::vector<std::string>& good, const TemporaryFolder& folder, int seed)
{
  std::mt19937 random(static_cast<unsigned int>(seed));
  int refused = 0;
  int read = 0;
  for (int i = 0; i < FileCount() && !testing::Test::HasFatalFailure(); ++i)
  {
    const std::string bytes = Damaged(good[random() % good.size()], random);
    ReadDamaged<Reader>(folder.Write("damaged", bytes), bytes, refused, read);
  }
  std::cout << refused << " files refused, " << read << " read\n";
  EXPECT_GT(refused, read); // the damage matters, ...
  EXPECT_GT(read, 0);       // ... and not all die at the first byte
}
}

TEST(ReaderFuzz, DamagedPvmFilesAreReadOrRefused)
{
  using namespace std::string_literals;
  const std::string one = "PVM\n6 5 4\n1\n" + Voxels(120);
  const std::string two = "PVM2\n6 5 4\n1 1.5 2\n2\n" + Voxels(240);
  const std::string three = "PVM3\n6 5 4\n1 1.5 2\n1\n" + Voxels(120) + "a\0b\0c\0d\0"s;
  const std::vector<std::string> good = { one, two, three, PackedAsDds(one, 1, 6),
    PackedAsDds(two, 2, 6), PackedAsDds(three), PackedAsDds(two, 4, 30, true) };
  ReadManyDamaged<vtkVolumeBenchPvmReader>(good, TemporaryFolder(), 20151);
}

TEST(ReaderFuzz, DamagedVoreenFilesAreReadOrRefused)
{
  using namespace std::string_literals;
  const TemporaryFolder folder;
  folder.Write("v.raw", Voxels(24));
  const std::string header = "ObjectFileName:\tv.raw\nResolution:\t4 3 2\nSliceThickness:\t1 1 2\n";
  const std::vector<std::string> good = { header + "Format:\tUCHAR\nObjectModel:\tI\n",
    "Resolution: 2 3 2\nFormat: USHORT\nObjectFileName: v.raw\n", "\x4\0\x3\0\x2\0"s + Voxels(48) };
  ReadManyDamaged<vtkVolumeBenchVoreenReader>(good, folder, 20152);
}
