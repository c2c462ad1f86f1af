// One window, volume and mapper that bad input and faults are tried on one after another: after
// each of them the same session must draw its good scene again, to the last bit.
#ifndef volumebench_HostileSession_h
#define volumebench_HostileSession_h

#include "DeviceFault.h"
#include "RenderScene.h"
#include "StateChecker.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace volumebench::test
{
/// What a picture must be. Words are part of the one line that says why nothing is drawn.
struct Outcome
{
  enum Kinds
  {
    Refused, // nothing is drawn, and one line says why
    Empty,   // nothing is drawn, and nothing need be said
    Drawn,   // colours, some of them opaque
    Same     // as the good scene
  };
  Kinds Kind;
  std::string Words;
};

inline Outcome Refused(const std::string& words)
{
  return { Outcome::Refused, words };
}

inline Outcome Empty()
{
  return { Outcome::Empty, {} };
}

inline Outcome Drawn()
{
  return { Outcome::Drawn, {} };
}

inline Outcome Same()
{
  return { Outcome::Same, {} };
}

/// Draws with a fault, where it is given one, and keeps the state of OpenGL before and after.
class HostileMapper : public StateChecker
{
public:
  static HostileMapper* New();
  DeviceFaultPointer Fault;

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
};

class HostileSession
{
public:
  explicit HostileSession(const std::string& technique);

  /// The session of a technique, which lives as long as the program does.
  static HostileSession& Of(const std::string& technique);

  /// Ends the fault and arranges the good scene: data, functions, camera and all settings. Data and
  /// functions are the same objects each time, as what is kept of them on a device may be stale.
  void ArrangeGood();

  ///@{
  /// Shows other data, or other functions.
  void Show(vtkDataObject* data);
  void Show(vtkVolumeProperty* property);
  ///@}

  vtkCamera* Camera() { return this->Renderer->GetActiveCamera(); }

  /// Draws twice and returns the second picture; what VTK and we report is in Messages.
  FloatPicture Draw();

  /// Fails the test unless the session draws what it must.
  void Expect(const Outcome& outcome);

  /// Fails the test unless the good scene is drawn as it was at the very first.
  void ExpectGood();

  const std::string Technique;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<HostileMapper> Mapper;
  std::vector<std::string> Messages; // our own, without what VTK puts in front

private:
  void ArrangeMapper();
  void ExpectRefusal(const FloatPicture& picture, const std::string& words);

  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkVolumeProperty> Property;
  FloatPicture Good;
};

/// A row of the table.
struct Enemy
{
  const char* Name;
  std::function<void(HostileSession&)> Do;
  Outcome Expected;
  // The techniques that alone are hurt, if not all are, and what others draw.
  std::vector<std::string> Only = {};
  Outcome Others = Same();
};

inline std::ostream& operator<<(std::ostream& out, const Enemy& enemy)
{
  return out << enemy.Name;
}

using Enemies = std::vector<Enemy>;

/// What a row does that gives one setting of the mapper a value.
template <typename Setter, typename Value>
std::function<void(HostileSession&)> Set(Setter setter, Value value)
{
  return [setter, value](HostileSession& session) { (session.Mapper->*setter)(value); };
}

/// What a row does that shows what `make` returns: data or a property.
template <typename Make>
std::function<void(HostileSession&)> Showing(Make make)
{
  return [make](HostileSession& session) { session.Show(make()); };
}

///@{
/// The groups of the table, a file each.
Enemies EnemiesOfSettings();
Enemies EnemiesOfData();      // grids and arrays
Enemies EnemiesOfFunctions(); // transfer functions, lights
Enemies EnemiesOfViews();     // cameras, windows, crop boxes, planes
Enemies EnemiesOfMachines();  // faults of devices, drivers, memory
///@}
}

#endif
