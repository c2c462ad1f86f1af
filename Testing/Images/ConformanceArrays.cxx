// Scenes about what the array holds: every scalar type with every blend mode, components, parts
// that are hidden.
#include "ConformanceScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkUnsignedCharArray.h"

namespace volumebench::test
{
namespace
{
struct ScalarType
{
  const char* Name;
  int Type;
  double Scale; // of the field, so that it fills a fair part of the type
};

constexpr ScalarType ScalarTypes[] = { { "uint8", VTK_UNSIGNED_CHAR, 250.0 },
  { "int16", VTK_SHORT, 3000.0 }, { "uint16", VTK_UNSIGNED_SHORT, 60000.0 },
  { "float", VTK_FLOAT, 1.0 }, { "double", VTK_DOUBLE, 1.0e12 } };

struct Mode
{
  const char* Name;
  int BlendMode;
  double Step;
  double Extinction;
};

// The extreme along a ray lies between two samples: finer steps find it more closely.
constexpr Mode Modes[] = { { "composite", vtkVolumeMapper::COMPOSITE_BLEND, 1.0, 0.25 },
  { "maximum", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, 0.5, 0.8 },
  { "minimum", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, 0.25, 1.5 },
  { "average", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, 1.0, 1.0 },
  { "gradient", vtkVolumeBenchMapper::GRADIENT_BLEND, 0.5, 1.0 } };

void AddTypesAndModes(ConformanceScenes& scenes)
{
  for (const ScalarType& type : ScalarTypes)
  {
    for (const Mode& mode : Modes)
    {
      ConformanceScene scene;
      scene.Name = std::string(type.Name) + "_" + mode.Name;
      scene.StepVoxels = mode.Step;
      scene.Image = [=] { return HillsImage(type.Type, type.Scale); };
      scene.Property = [=] { return HillsProperty(mode.Extinction, 0.0, type.Scale); };
      scene.Arrange = [=](RenderScene& render) { render.Mapper->SetBlendMode(mode.BlendMode); };
      scenes.push_back(scene);
    }
  }
}

// Every component is the field moved a little, times `scale`.
vtkSmartPointer<vtkImageData> Channels(int components, int type, double scale)
{
  auto image = HillsImage();
  vtkSmartPointer<vtkDataArray> scalars;
  scalars.TakeReference(vtkDataArray::CreateDataArray(type));
  scalars->SetName("channels");
  scalars->SetNumberOfComponents(components);
  scalars->SetNumberOfTuples(image->GetNumberOfPoints());
  const int* n = ConformanceSize;
  for (vtkIdType tuple = 0; tuple < scalars->GetNumberOfTuples(); ++tuple)
  {
    for (int component = 0; component < components; ++component)
    {
      const double value =
        Hills(tuple % n[0] + 3 * component, (tuple / n[0]) % n[1], tuple / (n[0] * n[1]));
      scalars->SetComponent(tuple, component, scale * value);
    }
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

ConformanceScene ChannelScene(
  const std::string& name, int components, int type, double scale, bool dependent)
{
  ConformanceScene scene;
  scene.Name = name;
  scene.StepVoxels = 1.0;
  scene.Image = [=] { return Channels(components, type, scale); };
  scene.Property = [=]
  {
    auto property = HillsProperty(0.25, 0.0, scale);
    property->SetIndependentComponents(!dependent);
    return property;
  };
  return scene;
}

void AddComponents(ConformanceScenes& scenes)
{
  scenes.push_back(ChannelScene("two_by_component", 2, VTK_FLOAT, 1.0, false));
  scenes.back().Arrange = [](RenderScene& scene) { scene.Mapper->SetVectorComponent(1); };
  scenes.push_back(ChannelScene("three_by_magnitude", 3, VTK_SHORT, 1000.0, false));
  scenes.back().Arrange = [](RenderScene& scene)
  { scene.Mapper->SetVectorMode(vtkVolumeBenchMapper::Magnitude); };
  scenes.push_back(ChannelScene("four_by_component", 4, VTK_UNSIGNED_CHAR, 250.0, false));
  scenes.back().Arrange = [](RenderScene& scene) { scene.Mapper->SetVectorComponent(3); };
  scenes.push_back(ChannelScene("two_dependent", 2, VTK_FLOAT, 1.0, true));
  scenes.push_back(ChannelScene("two_dependent_uint16", 2, VTK_UNSIGNED_SHORT, 60000.0, true));
  scenes.push_back(ChannelScene("rgba_uint8", 4, VTK_UNSIGNED_CHAR, 250.0, true));
  scenes.push_back(ChannelScene("rgba_float", 4, VTK_FLOAT, 1.0, true));
}

vtkSmartPointer<vtkImageData> WithHiddenCells(bool cellData)
{
  auto image = HillsImage();
  if (cellData)
  {
    vtkNew<vtkDoubleArray> cells;
    cells->SetName("cells");
    for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
    {
      cells->InsertNextValue(image->GetPointData()->GetScalars()->GetComponent(cell, 0));
    }
    image->GetCellData()->SetScalars(cells);
    image->GetPointData()->Initialize();
  }
  vtkUnsignedCharArray* ghosts = image->AllocateCellGhostArray();
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    const bool hidden = cell % 19 > 11 && (cell / 19) % 16 > 7;
    ghosts->SetValue(cell, hidden ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  return image;
}

// The borders of hidden cells are met to half a step, as a sample counts for the whole of its own.
void AddHidden(ConformanceScenes& scenes)
{
  scenes.push_back(HillsScene("hidden_cells", 0.25, [](RenderScene&) {}));
  scenes.back().Image = [] { return WithHiddenCells(false); };
  scenes.push_back(HillsScene("hidden_cells_of_cell_data", 0.125,
    [](RenderScene& scene)
    {
      scene.Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
      scene.Mapper->SelectScalarArray("cells");
    }));
  scenes.back().Image = [] { return WithHiddenCells(true); };
  scenes.push_back(HillsScene("hidden_points", 0.25, [](RenderScene&) {}));
  scenes.back().Image = []
  {
    auto image = HillsImage();
    for (const vtkIdType point : { 1500, 1501, 1502, 2000, 2500, 3000, 4000 })
    {
      image->AllocatePointGhostArray()->SetValue(point, vtkDataSetAttributes::HIDDENPOINT);
    }
    return image;
  };
  scenes.push_back(HillsScene("nan_voxels", 0.25, [](RenderScene&) {}));
  scenes.back().Image = []
  {
    auto image = HillsImage();
    for (const vtkIdType point : { 1500, 1501, 2000, 2500, 3000, 3001, 4000 })
    {
      image->GetPointData()->GetScalars()->SetComponent(point, 0, std::nan(""));
    }
    return image;
  };
}
}

ConformanceScenes ScenesOfArrays()
{
  ConformanceScenes scenes;
  AddTypesAndModes(scenes);
  AddComponents(scenes);
  AddHidden(scenes);
  return scenes;
}
}
