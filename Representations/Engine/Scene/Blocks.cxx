#include "Scene/Blocks.h"

#include "Scene/FromVtk.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace volumebench
{
namespace
{
// Neighbours share a face, up to the rounding of their origins.
constexpr double FaceTolerance = 1e-6; // of the larger block's longest edge
constexpr double SameDirection = 1e-9;

[[noreturn]] void RefuseKind(const char* kind)
{
  throw SceneError(
    std::string("a ") + kind + " cannot be drawn: only image data (uniform grids) can");
}

std::string NameOf(vtkCompositeDataIterator* iterator, int number)
{
  vtkInformation* information =
    iterator->HasCurrentMetaData() ? iterator->GetCurrentMetaData() : nullptr;
  const char* name = information ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? "'" + std::string(name) + "'" : std::to_string(number);
}

std::vector<Block> BlocksOfComposite(vtkCompositeDataSet* composite)
{
  std::vector<Block> blocks;
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  iterator->SkipEmptyNodesOff();
  int number = 0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    ++number;
    vtkDataObject* data = iterator->GetCurrentDataObject();
    auto* image = vtkImageData::SafeDownCast(data);
    if (image && image->GetNumberOfPoints() > 0)
    {
      blocks.push_back({ image, NameOf(iterator, number) });
    }
    else if (data && !image && data->GetNumberOfElements(vtkDataObject::POINT) > 0)
    {
      RefuseKind(
        (std::string(data->GetClassName()) + " in block " + NameOf(iterator, number)).c_str());
    }
  }
  if (blocks.empty())
  {
    // One image comes as one block where ParaView shows it.
    throw SceneError(number == 1
        ? "the image is empty"
        : std::string("no block of the ") + composite->GetClassName() + " has a point to draw");
  }
  return blocks;
}

double Largest(const glm::dvec3& values)
{
  return std::max({ values.x, values.y, values.z });
}

struct Box
{
  glm::dvec3 Low;
  glm::dvec3 High;
};

glm::dmat3 DirectionOf(vtkImageData* image)
{
  glm::dmat3 direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction[column][row] = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  return direction;
}

// The image in the space where its axes are those of the coordinate system.
Box BoxOf(vtkImageData* image, const glm::dmat3& toAxes)
{
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  const glm::dvec3 middle = toAxes * glm::dvec3(origin[0], origin[1], origin[2]);
  const glm::dvec3 step(spacing[0], spacing[1], spacing[2]);
  const glm::dvec3 first = middle + step * glm::dvec3(extent[0], extent[2], extent[4]);
  const glm::dvec3 last = middle + step * glm::dvec3(extent[1], extent[3], extent[5]);
  return { glm::min(first, last), glm::max(first, last) };
}

// Eye (w 1), or for parallel projection the direction to it (w 0).
glm::dvec4 EyeInData(const Camera& camera, const glm::dmat4& dataToWorld)
{
  return glm::inverse(camera.WorldToView * dataToWorld) *
    (camera.Parallel ? glm::dvec4(0.0, 0.0, 1.0, 0.0) : glm::dvec4(0.0, 0.0, 0.0, 1.0));
}

enum class Relation
{
  Overlap,
  Apart, // neither can hide the other
  FirstInFront,
  SecondInFront
};

// Every axis along which the boxes lie apart gives a plane between them, and the box on the eye's
// side of a plane is never hidden by the other.
Relation RelationOf(const Box& first, const Box& second, const glm::dvec4& eye)
{
  const double edge = std::max(Largest(first.High - first.Low), Largest(second.High - second.Low));
  bool apart = false;
  bool firstHidden = true;
  bool secondHidden = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool below = first.High[axis] <= second.Low[axis] + FaceTolerance * edge;
    const bool above = second.High[axis] <= first.Low[axis] + FaceTolerance * edge;
    if (!below && !above)
    {
      continue;
    }
    apart = true;
    const double plane =
      0.5 * (below ? first.High[axis] + second.Low[axis] : second.High[axis] + first.Low[axis]);
    const double side = eye[axis] - eye.w * plane;
    firstHidden = firstHidden && !(below ? side <= 0.0 : side >= 0.0);
    secondHidden = secondHidden && !(below ? side >= 0.0 : side <= 0.0);
  }
  if (!apart)
  {
    return Relation::Overlap;
  }
  if (firstHidden == secondHidden)
  {
    return Relation::Apart;
  }
  return secondHidden ? Relation::FirstInFront : Relation::SecondInFront;
}

std::vector<Box> BoxesOf(const std::vector<Block>& blocks, const glm::dmat3& direction)
{
  const glm::dmat3 toAxes = glm::inverse(direction);
  std::vector<Box> boxes;
  for (const Block& block : blocks)
  {
    const glm::dmat3 other = DirectionOf(block.Image) - direction;
    for (int column = 0; column < 3; ++column)
    {
      if (Largest(glm::abs(other[column])) > SameDirection)
      {
        throw SceneError("the blocks " + blocks.front().Name + " and " + block.Name +
          " have different direction matrices, so they cannot be drawn in order");
      }
    }
    boxes.push_back(BoxOf(block.Image, toAxes));
  }
  return boxes;
}

// For each block the blocks that it can hide.
std::vector<std::vector<std::size_t>> HiddenBy(
  const std::vector<Block>& blocks, const std::vector<Box>& boxes, const glm::dvec4& eye)
{
  std::vector<std::vector<std::size_t>> hidden(blocks.size());
  for (std::size_t first = 0; first < blocks.size(); ++first)
  {
    for (std::size_t second = first + 1; second < blocks.size(); ++second)
    {
      switch (RelationOf(boxes[first], boxes[second], eye))
      {
        case Relation::Overlap:
          throw SceneError("the blocks " + blocks[first].Name + " and " + blocks[second].Name +
            " overlap: what both hold would be drawn twice");
        case Relation::FirstInFront:
          hidden[first].push_back(second);
          break;
        case Relation::SecondInFront:
          hidden[second].push_back(first);
          break;
        case Relation::Apart:
          break;
      }
    }
  }
  return hidden;
}
}

std::vector<Block> BlocksOf(vtkDataObject* input)
{
  if (!input)
  {
    throw SceneError("the mapper has no input");
  }
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    return BlocksOfComposite(composite);
  }
  auto* image = vtkImageData::SafeDownCast(input);
  if (!image)
  {
    RefuseKind(input->GetClassName());
  }
  return { { image, {} } };
}

std::vector<std::size_t> BackToFront(
  const std::vector<Block>& blocks, const Camera& camera, const glm::dmat4& dataToWorld)
{
  const glm::dmat3 direction = DirectionOf(blocks.front().Image);
  const glm::dvec4 eye = glm::dmat4(glm::inverse(direction)) * EyeInData(camera, dataToWorld);
  const auto hidden = HiddenBy(blocks, BoxesOf(blocks, direction), eye);

  // A block's turn comes when all that it can hide are drawn.
  std::vector<std::vector<std::size_t>> hiders(blocks.size());
  std::vector<std::size_t> waitsFor(blocks.size());
  std::vector<std::size_t> ready;
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    waitsFor[block] = hidden[block].size();
    for (const std::size_t other : hidden[block])
    {
      hiders[other].push_back(block);
    }
    if (hidden[block].empty())
    {
      ready.push_back(block);
    }
  }
  for (std::size_t next = 0; next < ready.size(); ++next)
  {
    for (const std::size_t hider : hiders[ready[next]])
    {
      if (--waitsFor[hider] == 0)
      {
        ready.push_back(hider);
      }
    }
  }
  if (ready.size() < blocks.size())
  {
    const auto stuck =
      std::find_if(waitsFor.begin(), waitsFor.end(), [](std::size_t count) { return count > 0; });
    throw SceneError("the block " + blocks[stuck - waitsFor.begin()].Name +
      " is in a ring of blocks that hide each other: from here they cannot be drawn in order");
  }
  return ready;
}
}
