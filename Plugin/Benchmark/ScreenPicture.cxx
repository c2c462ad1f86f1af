#include "ScreenPicture.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr int Levels = 256;

std::array<float, Levels> MakeLinearLevels()
{
  std::array<float, Levels> levels{};
  for (int i = 0; i < Levels; ++i)
  {
    const double value = i / (Levels - 1.0);
    const double linear = value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92;
    levels[i] = static_cast<float>(linear);
  }
  return levels;
}

// From linear sRGB to CIE XYZ, each row divided by its sum: what it gives for white is then 1.
glm::mat3 MakeRelativeXyzMatrix()
{
  const double rows[3][3] = { { 10135552.0, 8788810.0, 4435075.0 },
    { 2613072.0, 8788810.0, 887015.0 }, { 1425312.0, 8788810.0, 70074185.0 } };
  glm::mat3 matrix(0.0f);
  for (int row = 0; row < 3; ++row)
  {
    const double sum = rows[row][0] + rows[row][1] + rows[row][2];
    for (int column = 0; column < 3; ++column)
    {
      matrix[column][row] = static_cast<float>(rows[row][column] / sum);
    }
  }
  return matrix;
}

const glm::mat3& RelativeXyzMatrix()
{
  static const glm::mat3 matrix = MakeRelativeXyzMatrix();
  return matrix;
}

float CubeRootOrLine(float value)
{
  constexpr float Knee = 6.0f / 29.0f;
  return value > Knee * Knee * Knee ? std::cbrt(value)
                                    : value / (3.0f * Knee * Knee) + 4.0f / 29.0f;
}

unsigned char Rounded(float value)
{
  // A NaN becomes black: no comparison with it holds.
  const float cut = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
  return static_cast<unsigned char>(std::lround(cut * 255.0f));
}
}

ScreenPicture ToScreen(const FloatPicture& picture, const PixelBox& box)
{
  ScreenPicture screen{ box.Width(), box.Height(), {} };
  screen.Pixels.reserve(static_cast<std::size_t>(3) * screen.Width * screen.Height);
  for (int y = box.Bottom; y <= box.Top; ++y)
  {
    for (int x = box.Left; x <= box.Right; ++x)
    {
      // Premultiplied over black: the colour itself.
      const float* pixel =
        picture.Pixels.data() + 4 * (static_cast<std::size_t>(y) * picture.Width + x);
      screen.Pixels.push_back(Rounded(pixel[0]));
      screen.Pixels.push_back(Rounded(pixel[1]));
      screen.Pixels.push_back(Rounded(pixel[2]));
    }
  }
  return screen;
}

glm::vec3 LinearRgb(const unsigned char* pixel)
{
  static const std::array<float, Levels> levels = MakeLinearLevels();
  return { levels[pixel[0]], levels[pixel[1]], levels[pixel[2]] };
}

glm::vec3 RelativeXyz(const glm::vec3& linearRgb)
{
  return RelativeXyzMatrix() * linearRgb;
}

glm::vec3 LinearRgbOfXyz(const glm::vec3& relativeXyz)
{
  static const glm::mat3 inverse = glm::inverse(RelativeXyzMatrix());
  return inverse * relativeXyz;
}

glm::vec3 Lab(const glm::vec3& relativeXyz)
{
  const float x = CubeRootOrLine(relativeXyz.x);
  const float y = CubeRootOrLine(relativeXyz.y);
  const float z = CubeRootOrLine(relativeXyz.z);
  return { 116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z) };
}

glm::vec3 OpponentColor(const glm::vec3& relativeXyz)
{
  return { 116.0f * relativeXyz.y - 16.0f, 500.0f * (relativeXyz.x - relativeXyz.y),
    200.0f * (relativeXyz.y - relativeXyz.z) };
}

glm::vec3 XyzOfOpponentColor(const glm::vec3& opponent)
{
  const float y = (opponent.x + 16.0f) / 116.0f;
  return { y + opponent.y / 500.0f, y, y - opponent.z / 200.0f };
}
}
