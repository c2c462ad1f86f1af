// The scenes that every technique must draw alike and close to one converged reference. Each names
// what it is about; together they cover what a scene can ask for.
#ifndef volumebench_ConformanceScene_h
#define volumebench_ConformanceScene_h

#include "RenderScene.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace volumebench::test
{
struct ConformanceScene
{
  std::string Name;
  double StepVoxels = 0.5; // at which every technique must be as close as TestConformance.cxx says
  std::function<vtkSmartPointer<vtkImageData>()> Image; // null when its file is missing
  std::function<vtkSmartPointer<vtkVolumeProperty>()> Property;
  std::function<void(RenderScene&)> Arrange = [](RenderScene&) {};
  bool NearlyEmpty = false; // the others must show something worth comparing
  bool Translucent = false; // thin enough a medium for 8-bit slices to lose what they should show
};

inline std::ostream& operator<<(std::ostream& out, const ConformanceScene& scene)
{
  return out << scene.Name;
}

using ConformanceScenes = std::vector<ConformanceScene>;

///@{
/// The groups of the table, a file each.
ConformanceScenes ScenesOfViews();      // cameras, near plane, clip planes, cropping, grids
ConformanceScenes ScenesOfArrays();     // scalar types x blend modes, components, hidden parts
ConformanceScenes ScenesOfAppearance(); // lights, gradient opacity, opacity, opaque geometry
ConformanceScenes ScenesOfData();       // scanned and simulated volumes, and stand-ins for them
///@}

/// Dimensions of the generated volumes.
constexpr int ConformanceSize[3] = { 20, 17, 14 };

/// A smooth field between 0 and 1 with a few maxima and minima, the same along no axis.
inline double Hills(double i, double j, double k)
{
  return 0.5 + 0.25 * std::sin(0.55 * i + 0.3 * j + 0.2) + 0.25 * std::cos(0.5 * k - 0.25 * i);
}

/// Blue to white to red; extinction grows linearly with the value to `extinction` at `high`.
inline vtkSmartPointer<vtkVolumeProperty> HillsProperty(
  double extinction = 0.25, double low = 0.0, double high = 1.0)
{
  auto property = MakeLinearExtinctionProperty(extinction / (high - low), 0.0, high - low, 257);
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  for (int i = 0; i <= 256; ++i)
  {
    const double share = i / 256.0;
    opacity->AddPoint(low + share * (high - low), OpacityOfExtinction(extinction * share));
  }
  color->AddRGBPoint(low, 0.1, 0.2, 0.9);
  color->AddRGBPoint(0.5 * (low + high), 0.9, 0.9, 0.9);
  color->AddRGBPoint(high, 0.9, 0.2, 0.1);
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  return property;
}

inline vtkSmartPointer<vtkImageData> HillsImage(int type = VTK_FLOAT, double scale = 1.0)
{
  const int* n = ConformanceSize;
  return MakeImage(
    n[0], n[1], n[2], [=](double i, double j, double k) { return scale * Hills(i, j, k); }, type);
}

/// A scene of the standard volume.
inline ConformanceScene HillsScene(
  const std::string& name, double stepVoxels, std::function<void(RenderScene&)> arrange)
{
  ConformanceScene scene;
  scene.Name = name;
  scene.StepVoxels = stepVoxels;
  scene.Image = [] { return HillsImage(); };
  scene.Property = [] { return HillsProperty(); };
  scene.Arrange = std::move(arrange);
  return scene;
}
}

#endif
