// Grids and arrays that cannot be drawn, or hardly.
#include "HostileSession.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace volumebench::test
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double Smallest = std::numeric_limits<double>::denorm_min();

using Image = vtkSmartPointer<vtkImageData>;

Image Bumps(int side = 6)
{
  return MakeImage(side, side, side, Bumpy);
}

Image Constant(double value, int type = VTK_DOUBLE)
{
  return MakeImage(
    5, 5, 5, [value](double, double, double) { return value; }, type);
}

std::function<void(HostileSession&)> WithSpacing(double x, double y, double z)
{
  return Showing(
    [=]
    {
      Image image = Bumps();
      image->SetSpacing(x, y, z);
      return image;
    });
}

// Values and the unit distance grow with the box, so that its picture does not change.
std::function<void(HostileSession&)> ScaledBy(double factor)
{
  return [factor](HostileSession& session)
  {
    Image image = Bumps();
    image->SetSpacing(factor, factor, factor);
    session.Show(image);
    auto property = MakeConstantProperty(0.3);
    property->SetScalarOpacityUnitDistance(factor);
    session.Show(property);
    session.Renderer->ResetCamera();
  };
}

std::function<void(HostileSession&)> WithDirection(const std::array<double, 9>& matrix)
{
  return Showing(
    [matrix]
    {
      Image image = Bumps();
      image->SetDirectionMatrix(matrix.data());
      return image;
    });
}

// Point data "field" of another length than the grid has points.
std::function<void(HostileSession&)> WithValues(vtkIdType count)
{
  return Showing(
    [count]
    {
      Image image = Bumps();
      vtkNew<vtkFloatArray> values;
      values->SetName("field");
      values->SetNumberOfTuples(count);
      values->Fill(1.0);
      image->GetPointData()->SetScalars(values);
      return image;
    });
}

// Ghosts of points or cells, `count` of them, all with these bits.
std::function<void(HostileSession&)> WithGhosts(bool cells, vtkIdType count, int bits)
{
  return Showing(
    [=]
    {
      Image image = Bumps();
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      ghosts->SetNumberOfValues(count);
      ghosts->FillValue(static_cast<unsigned char>(bits));
      vtkDataSetAttributes* attributes = image->GetPointData();
      if (cells)
      {
        attributes = image->GetCellData();
      }
      attributes->AddArray(ghosts);
      return image;
    });
}

std::function<void(HostileSession&)> WithComponents(int components, bool dependent)
{
  return [=](HostileSession& session)
  {
    Image image = Bumps();
    vtkNew<vtkFloatArray> values;
    values->SetName("field");
    values->SetNumberOfComponents(components);
    values->SetNumberOfTuples(image->GetNumberOfPoints());
    values->Fill(0.5);
    image->GetPointData()->SetScalars(values);
    session.Show(image);
    auto property = MakeConstantProperty(0.3);
    property->SetIndependentComponents(!dependent);
    session.Show(property);
  };
}

Enemies OfGrids()
{
  return {
    { "no_input", [](HostileSession& s) { s.Show(static_cast<vtkDataObject*>(nullptr)); },
      Empty() },
    { "no_points", Showing([] { return Image::New(); }), Refused("the image is empty") },
    { "one_point", Showing([] { return Bumps(1); }), Refused("one point thick (1 x 1 x 1") },
    { "one_point_thick", Showing([] { return MakeImage(6, 1, 6, Bumpy); }),
      Refused("one point thick (6 x 1 x 6") },
    { "spacing_zero", WithSpacing(1.0, 0.0, 1.0), Refused("spacing of 0") },
    { "spacing_nan", WithSpacing(NotANumber, 1.0, 1.0), Refused("a spacing of nan") },
    { "spacing_infinite", WithSpacing(1.0, 1.0, Infinity), Refused("a spacing of inf") },
    { "spacing_negative", WithSpacing(-1.0, 1.0, 1.0), Drawn() },
    { "spacing_uneven", WithSpacing(1.0, 1e6, 1.0), Drawn() },
    { "spacing_small", ScaledBy(1e-12), Drawn() },
    { "spacing_large", ScaledBy(1e12), Drawn() },
    { "spacing_tiny", ScaledBy(1e-200), Refused("the voxels have an edge of 1e-200") },
    { "spacing_huge", ScaledBy(1e200), Refused("the voxels have an edge of 1e+200") },
    { "origin_nan",
      Showing(
        []
        {
          Image image = Bumps();
          image->SetOrigin(0.0, NotANumber, 0.0);
          return image;
        }),
      Refused("origin") },
    { "origin_infinite",
      Showing(
        []
        {
          Image image = Bumps();
          image->SetOrigin(-Infinity, 0.0, 0.0);
          return image;
        }),
      Refused("origin") },
    { "direction_singular", WithDirection({ 1, 0, 0, 0, 1, 0, 0, 0, 0 }), Refused("direction") },
    { "direction_zero", WithDirection({}), Refused("direction") },
    { "direction_nan", WithDirection({ 1, 0, 0, 0, NotANumber, 0, 0, 0, 1 }),
      Refused("direction") },
    { "direction_sheared", WithDirection({ 1, 0.9, 0, 0, 1, 0.9, 0, 0, 1 }), Drawn() },
    { "grid_of_another_kind", Showing([] { return vtkSmartPointer<vtkMultiBlockDataSet>::New(); }),
      Refused("no block of the vtkMultiBlockDataSet") },
    { "block_that_is_no_image",
      Showing(
        []
        {
          vtkNew<vtkRectilinearGrid> grid;
          grid->SetDimensions(3, 3, 3);
          auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
          blocks->SetBlock(0, grid);
          return blocks;
        }),
      Refused("vtkRectilinearGrid in block 1") },
    { "blocks_that_overlap",
      Showing(
        []
        {
          auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
          blocks->SetBlock(0, Bumps());
          blocks->SetBlock(1, Bumps(5));
          return blocks;
        }),
      Refused("the blocks 1 and 2 overlap") },
    { "blocks_of_nothing_and_one",
      Showing(
        []
        {
          auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
          blocks->SetBlock(0, nullptr);
          blocks->SetBlock(2, vtkNew<vtkImageData>());
          blocks->SetBlock(3, Bumps());
          return blocks;
        }),
      Drawn() },
  };
}

Enemies OfArrays()
{
  return {
    { "no_arrays",
      Showing(
        []
        {
          Image image = Bumps();
          image->GetPointData()->Initialize();
          return image;
        }),
      Refused("no scalars") },
    { "array_of_words",
      [](HostileSession& session)
      {
        Image image = Bumps();
        vtkNew<vtkStringArray> words;
        words->SetName("words");
        words->SetNumberOfValues(image->GetNumberOfPoints());
        image->GetPointData()->AddArray(words);
        session.Show(image);
        session.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
        session.Mapper->SelectScalarArray("words");
      },
      Refused("the array 'words' holds string values") },
    { "array_that_is_not_there",
      [](HostileSession& session)
      {
        session.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
        session.Mapper->SelectScalarArray("nowhere");
      },
      Refused("no array 'nowhere'") },
    { "array_of_number_99",
      [](HostileSession& session)
      {
        session.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
        session.Mapper->SelectScalarArray(99);
      },
      Refused("no scalars") },
    { "array_of_number_minus_1",
      [](HostileSession& session)
      {
        session.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
        session.Mapper->SelectScalarArray(-1);
      },
      Refused("no scalars") },
    { "field_data", Set(&vtkVolumeBenchMapper::SetScalarMode, VTK_SCALAR_MODE_USE_FIELD_DATA),
      Refused("field data have no place on the grid") },
    { "array_too_short", WithValues(215), Refused("'field' has 215 values for 216 points") },
    { "array_too_long", WithValues(217), Refused("'field' has 217 values for 216 points") },
    { "array_empty", WithValues(0), Refused("'field' has 0 values for 216 points") },
    { "ghosts_of_points_too_few", WithGhosts(false, 3, vtkDataSetAttributes::HIDDENPOINT),
      Refused("3 values for 216 points") },
    { "ghosts_of_cells_too_few", WithGhosts(true, 3, vtkDataSetAttributes::HIDDENCELL),
      Refused("3 values for 125 cells") },
    { "ghosts_of_cells_too_many", WithGhosts(true, 5000, vtkDataSetAttributes::HIDDENCELL),
      Refused("5000 values for 125 cells") },
    { "ghosts_that_hide_all", WithGhosts(false, 216, vtkDataSetAttributes::HIDDENPOINT), Empty() },
    { "component_that_is_not_there",
      [](HostileSession& session)
      {
        WithComponents(3, false)(session);
        session.Mapper->SetVectorComponent(3);
      },
      Refused("has 3 components; component 3 was asked for") },
    { "three_dependent_components", WithComponents(3, true), Refused("has 3 components") },
    { "projection_of_dependent_components",
      [](HostileSession& session)
      {
        WithComponents(2, true)(session);
        session.Mapper->SetBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
      },
      Refused("dependent components have several") },
    { "all_nan", Showing([] { return Constant(NotANumber); }), Refused("no finite value") },
    { "all_infinite", Showing([] { return Constant(-Infinity, VTK_FLOAT); }),
      Refused("no finite value") },
    { "one_value_that_is_finite",
      Showing(
        []
        {
          return MakeImage(5, 5, 5,
            [](double i, double j, double k) { return i + j + k > 0.0 ? NotANumber : 2.0; });
        }),
      Empty() },
    { "as_wide_as_doubles",
      Showing(
        []
        {
          return MakeImage(
            5, 5, 5, [](double i, double, double) { return (0.5 * i - 1.0) * Largest; },
            VTK_DOUBLE);
        }),
      Refused("32-bit floats over such a range cannot tell apart the values from 0 to 4"),
      { "single-pass", "multi-pass", "compute", "slices", "slices-threaded", "opencl" }, Drawn() },
    { "outliers_that_stand_for_no_value",
      Showing(
        []
        {
          return MakeImage(6, 6, 6,
            [](double i, double j, double k) { return i + j + k > 0.0 ? Bumpy(i, j, k) : -1e30; });
        }),
      Refused("from -1e+30 to "),
      { "single-pass", "multi-pass", "compute", "slices", "slices-threaded", "opencl" }, Drawn() },
    { "as_small_as_doubles",
      Showing(
        []
        {
          return MakeImage(
            5, 5, 5, [](double i, double, double) { return i * Smallest; }, VTK_DOUBLE);
        }),
      Empty() },
    { "whole_numbers_beyond_doubles",
      Showing(
        []
        {
          return MakeImage(
            5, 5, 5, [](double i, double, double) { return i * 2e18; }, VTK_LONG_LONG);
        }),
      Drawn() },
    { "bits",
      Showing(
        []
        {
          Image image = Bumps();
          vtkNew<vtkBitArray> bits;
          bits->SetName("field");
          bits->SetNumberOfTuples(216);
          bits->Fill(1.0);
          image->GetPointData()->SetScalars(bits);
          return image;
        }),
      Drawn() },
  };
}
}

Enemies EnemiesOfData()
{
  Enemies all = OfGrids();
  for (const Enemy& enemy : OfArrays())
  {
    all.push_back(enemy);
  }
  return all;
}
}
