#include "RankPictures.h"

#include "vtkMultiProcessController.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace volumebench
{
namespace
{
constexpr int Channels = 4;
constexpr unsigned char Opaque = 255;

// Pixels from Left to Right - 1 and from Bottom to Top - 1.
struct Region
{
  int Left = 0;
  int Bottom = 0;
  int Right = 0;
  int Top = 0;

  int GetWidth() const { return std::max(this->Right - this->Left, 0); }
  int GetHeight() const { return std::max(this->Top - this->Bottom, 0); }
  vtkIdType GetPixels() const { return vtkIdType(this->GetWidth()) * this->GetHeight(); }
  bool Has(int x, int y) const
  {
    return x >= this->Left && x < this->Right && y >= this->Bottom && y < this->Top;
  }
  std::size_t IndexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y - this->Bottom) * this->GetWidth() + (x - this->Left);
  }
};

Region Common(const Region& one, const Region& other)
{
  return { std::max(one.Left, other.Left), std::max(one.Bottom, other.Bottom),
    std::min(one.Right, other.Right), std::min(one.Top, other.Top) };
}

Region Round(const Region& one, const Region& other)
{
  if (one.GetPixels() == 0 || other.GetPixels() == 0)
  {
    return one.GetPixels() == 0 ? other : one;
  }
  return { std::min(one.Left, other.Left), std::min(one.Bottom, other.Bottom),
    std::max(one.Right, other.Right), std::max(one.Top, other.Top) };
}

// Round the pixels for which a predicate on their number holds.
template <typename Predicate>
Region RegionWhere(int width, int height, const Predicate& holds)
{
  Region region{ width, height, 0, 0 };
  std::size_t pixel = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      if (holds(pixel++))
      {
        region = { std::min(region.Left, x), std::min(region.Bottom, y),
          std::max(region.Right, x + 1), y + 1 };
      }
    }
  }
  return region;
}

template <typename Value>
std::vector<Value> Cut(const Value* pixels, int width, int channels, const Region& region)
{
  std::vector<Value> cut;
  cut.reserve(channels * region.GetPixels());
  for (int y = region.Bottom; y < region.Top; ++y)
  {
    const Value* row = pixels + (static_cast<std::size_t>(y) * width + region.Left) * channels;
    cut.insert(cut.end(), row, row + static_cast<std::size_t>(region.GetWidth()) * channels);
  }
  return cut;
}

// Where all ranks have something.
struct Regions
{
  std::vector<Region> Volumes; // of each rank
  Region All;                  // of them
  Region Others;               // what any rank shows else in there

  // Rows that a rank blends.
  Region StripOf(int rank) const
  {
    const int ranks = static_cast<int>(this->Volumes.size());
    const int height = this->All.GetHeight();
    return { this->All.Left, this->All.Bottom + height * rank / ranks, this->All.Right,
      this->All.Bottom + height * (rank + 1) / ranks };
  }
};

Regions RegionsOfAll(const RankPicture& own, vtkMultiProcessController* controller)
{
  const int width = own.Volumes.Width;
  const int height = own.Volumes.Height;
  const auto* pixels = reinterpret_cast<const float(*)[Channels]>(own.Volumes.Pixels.data());
  const std::array<Region, 2> here = { RegionWhere(width, height,
                                         [pixels](std::size_t i)
                                         {
                                           return std::any_of(pixels[i], pixels[i] + Channels,
                                             [](float channel) { return channel != 0.0f; });
                                         }),
    RegionWhere(width, height, [&own](std::size_t i) { return own.Opacity[i] > 0; }) };
  constexpr int Numbers = 2 * sizeof(Region) / sizeof(int);
  std::vector<std::array<Region, 2>> all(controller->GetNumberOfProcesses());
  controller->AllGather(&here[0].Left, &all[0][0].Left, Numbers);
  Regions regions;
  for (const std::array<Region, 2>& of : all)
  {
    regions.Volumes.push_back(of[0]);
    regions.All = Round(regions.All, of[0]);
    regions.Others = Round(regions.Others, of[1]);
  }
  regions.Others = Common(regions.Others, regions.All);
  return regions;
}

// What one rank has of all to blend a strip, and makes of it.
struct Strip
{
  Region Rows;
  Region Others;                      // in them
  std::vector<Region> Regions;        // of the volumes of each rank, in them
  std::vector<vtkIdType> Offsets;     // of their first pixels' channels in Volumes
  std::vector<float> Volumes;         // one rank's behind the other's
  std::vector<unsigned char> Opacity; // in Others, of each rank
  std::vector<glm::vec4> Blended;     // in Rows, where there is nothing else
  std::vector<glm::vec4> Handed;      // in Others, to each rank
};

Strip GatherStrip(
  const RankPicture& own, const Regions& regions, int owner, vtkMultiProcessController* controller)
{
  Strip strip;
  strip.Rows = regions.StripOf(owner);
  strip.Others = Common(regions.Others, strip.Rows);
  std::vector<vtkIdType> lengths;
  vtkIdType length = 0;
  for (const Region& region : regions.Volumes)
  {
    strip.Regions.push_back(Common(region, strip.Rows));
    strip.Offsets.push_back(length);
    lengths.push_back(Channels * strip.Regions.back().GetPixels());
    length += lengths.back();
  }
  const int here = controller->GetLocalProcessId();
  const std::vector<float> sent =
    Cut(own.Volumes.Pixels.data(), own.Volumes.Width, Channels, strip.Regions[here]);
  strip.Volumes.resize(here == owner ? length : 0);
  controller->GatherV(
    sent.data(), strip.Volumes.data(), lengths[here], lengths.data(), strip.Offsets.data(), owner);
  const vtkIdType others = strip.Others.GetPixels();
  if (others > 0)
  {
    const std::vector<unsigned char> opacity =
      Cut(own.Opacity.data(), own.Volumes.Width, 1, strip.Others);
    strip.Opacity.resize(here == owner ? others * lengths.size() : 0);
    controller->Gather(opacity.data(), strip.Opacity.data(), others, owner);
  }
  return strip;
}

void BlendPixel(Strip& strip, int x, int y, const std::vector<int>& order)
{
  const bool others = strip.Others.Has(x, y);
  const std::size_t pixel = others ? strip.Others.IndexOf(x, y) : 0;
  const std::size_t each = strip.Others.GetPixels();
  glm::vec4 blended(0.0f);
  for (const int rank : order)
  {
    const Region& region = strip.Regions[rank];
    if (region.Has(x, y))
    {
      const float* volume =
        strip.Volumes.data() + strip.Offsets[rank] + Channels * region.IndexOf(x, y);
      blended += (1.0f - blended.a) * glm::vec4(volume[0], volume[1], volume[2], volume[3]);
    }
    const unsigned char opacity = others ? strip.Opacity[rank * each + pixel] : 0;
    if (opacity > 0)
    {
      strip.Handed[rank * each + pixel] = blended;
      blended = glm::vec4(0.0f);
    }
    if (opacity == Opaque)
    {
      return;
    }
  }
  // Nothing is handed twice: what the last rank shows else has left nothing blended.
  glm::vec4& last =
    others ? strip.Handed[order.back() * each + pixel] : strip.Blended[strip.Rows.IndexOf(x, y)];
  last += blended;
}

void BlendStrip(Strip& strip, const std::vector<int>& order)
{
  strip.Blended.resize(strip.Rows.GetPixels());
  strip.Handed.resize(order.size() * strip.Others.GetPixels());
  for (int y = strip.Rows.Bottom; y < strip.Rows.Top; ++y)
  {
    for (int x = strip.Rows.Left; x < strip.Rows.Right; ++x)
    {
      BlendPixel(strip, x, y, order);
    }
  }
}

void Put(const std::vector<glm::vec4>& pixels, const Region& region, PlacedPicture& picture)
{
  if (region.GetPixels() == 0)
  {
    return;
  }
  for (int y = region.Bottom; y < region.Top; ++y)
  {
    const auto* row = &pixels[region.IndexOf(region.Left, y)][0];
    const std::size_t first = static_cast<std::size_t>(y - picture.Bottom) * picture.Picture.Width +
      region.Left - picture.Left;
    std::copy_n(row, static_cast<std::size_t>(Channels) * region.GetWidth(),
      picture.Picture.Pixels.begin() + static_cast<std::ptrdiff_t>(Channels * first));
  }
}
}

PlacedPicture BlendAcrossRanks(const RankPicture& own, const std::vector<int>& order)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const Regions regions = RegionsOfAll(own, controller);
  PlacedPicture shown{ regions.All.Left, regions.All.Bottom,
    { regions.All.GetWidth(), regions.All.GetHeight(), {} } };
  shown.Picture.Pixels.resize(Channels * regions.All.GetPixels());
  const int here = controller->GetLocalProcessId();
  for (int owner = 0; owner < controller->GetNumberOfProcesses(); ++owner)
  {
    Strip strip = GatherStrip(own, regions, owner, controller);
    if (here == owner)
    {
      BlendStrip(strip, order);
      Put(strip.Blended, strip.Rows, shown);
    }
    if (strip.Others.GetPixels() > 0)
    {
      std::vector<glm::vec4> handed(strip.Others.GetPixels());
      controller->Scatter(strip.Handed.empty() ? nullptr : &strip.Handed[0][0], &handed[0][0],
        Channels * strip.Others.GetPixels(), owner);
      Put(handed, strip.Others, shown);
    }
  }
  return shown;
}
}
