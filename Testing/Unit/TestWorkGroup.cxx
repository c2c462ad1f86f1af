#include "Scene/WorkGroup.h"

#include <gtest/gtest.h>

#include <set>

using namespace volumebench;

TEST(WorkGroup, NamesAndShapesBelongTogether)
{
  std::set<std::string> names;
  for (const glm::ivec2& shape : WorkGroupShapes())
  {
    EXPECT_EQ(ParseWorkGroup(WorkGroupName(shape)), shape);
    EXPECT_NE(WorkGroupNames().find(WorkGroupName(shape)), std::string::npos);
    names.insert(WorkGroupName(shape));
  }
  EXPECT_EQ(names.size(), WorkGroupShapes().size());
}

TEST(WorkGroup, AutoIsLeftToMeasuring)
{
  EXPECT_EQ(ParseWorkGroup("Auto"), glm::ivec2(0, 0));
}

TEST(WorkGroup, WhatIsNotOfferedIsRefused)
{
  for (const char* text :
    { "", "auto", "3x3", "8", "8x", "x8", "8 x 8", "8x8 ", "1024x1024", "-8x8" })
  {
    EXPECT_EQ(ParseWorkGroup(text), glm::ivec2(-1, -1)) << text;
  }
}

TEST(WorkGroup, EveryDeviceTakesTheShapes)
{
  for (const glm::ivec2& shape : WorkGroupShapes())
  {
    // OpenGL 4.3 promises 1024 invocations and 1024 along x and y.
    EXPECT_LE(shape.x * shape.y, 1024);
    EXPECT_GE(shape.x * shape.y, 4);
  }
}
