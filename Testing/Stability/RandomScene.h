// A scene drawn at random from all that ParaView lets a user set, wild values included. Equal seeds
// give equal scenes, so every technique is tried with the same ones.
#ifndef volumebench_RandomScene_h
#define volumebench_RandomScene_h

#include "RenderScene.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <random>
#include <string>

namespace volumebench::test
{
class RandomScene
{
public:
  static constexpr int Size = 20; // pixels of the picture

  RandomScene(unsigned seed, const std::string& technique);

  RenderScene& Get() { return *this->Scene; }

  /// Step, integrator, sizes and the like in one line, for messages.
  std::string Describe() const { return this->Text; }

  bool IsLit() const { return this->Lit; }
  bool IsComposite() const { return this->Composite; }
  /// Whether some voxels are not finite: the borders of their cells are found by sampling.
  bool HasHoles() const { return this->Holes; }

  ///@{
  /// Replaces the functions: one colour for all values, and also one extinction.
  void UseOneColor(const glm::dvec3& color);
  void UseOneMedium(const glm::dvec3& color, double extinction);
  ///@}

  /// Length of the box's diagonal in data units.
  double GetDiagonal() const { return this->Diagonal; }

private:
  double Uniform(double low, double high);
  double PowerOfTen(double low, double high);
  int Whole(int low, int high);
  bool Chance(double share) { return this->Uniform(0.0, 1.0) < share; }

  vtkSmartPointer<vtkImageData> DrawImage();
  void DrawValues(vtkImageData* image);
  vtkSmartPointer<vtkVolumeProperty> DrawProperty(vtkImageData* image);
  void DrawSampling(const std::string& technique);
  void DrawSurroundings();
  void DrawCamera();

  std::mt19937_64 Random;
  std::unique_ptr<RenderScene> Scene;
  std::string Text;
  bool OnCells = false;
  bool Lit = false;
  bool Holes = false;
  bool Composite = true;
  double Diagonal = 0.0;
};
}

#endif
