#include "Scene/WorkGroup.h"

namespace volumebench
{
const std::vector<glm::ivec2>& WorkGroupShapes()
{
  static const std::vector<glm::ivec2> shapes = { { 4, 1 }, { 2, 2 }, { 8, 1 }, { 4, 2 }, { 16, 1 },
    { 8, 2 }, { 4, 4 }, { 32, 1 }, { 16, 2 }, { 8, 4 }, { 64, 1 }, { 32, 2 }, { 16, 4 }, { 8, 8 },
    { 128, 1 }, { 64, 2 }, { 32, 4 }, { 16, 8 }, { 16, 16 }, { 32, 16 } };
  return shapes;
}

std::string WorkGroupName(glm::ivec2 shape)
{
  return std::to_string(shape.x) + "x" + std::to_string(shape.y);
}

glm::ivec2 ParseWorkGroup(const std::string& text)
{
  if (text == "Auto")
  {
    return { 0, 0 };
  }
  for (const glm::ivec2& shape : WorkGroupShapes())
  {
    if (text == WorkGroupName(shape))
    {
      return shape;
    }
  }
  return { -1, -1 };
}

std::string WorkGroupNames()
{
  std::string names;
  for (const glm::ivec2& shape : WorkGroupShapes())
  {
    names += (names.empty() ? "" : ", ") + WorkGroupName(shape);
  }
  return names;
}
}
