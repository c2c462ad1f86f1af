// One stability case being tried with one technique and integrator, or with a peer: draws what the
// case asks for and gathers what it measures.
#ifndef volumebench_Trial_h
#define volumebench_Trial_h

#include "VolumeBenchBenchmarkModule.h"

#include "Contestant.h"
#include "Error/FloatPicture.h"
#include "Stability/Shot.h"
#include "Stability/Tally.h"
#include "Stage.h"

#include <glm/vec4.hpp>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace volumebench
{
/// Who is tried. Peers and techniques without integrators have the integrator NoIntegrator.
struct Subject
{
  std::string Technique;
  int Integrator = 0; // vtkVolumeBenchMapper's number
  bool Peer = false;
};

constexpr int NoIntegrator = -1;

/// The subject drew nothing and said why.
class Refusal : public std::runtime_error
{
public:
  Refusal(const std::string& message, bool unsupported)
    : std::runtime_error(message)
    , Unsupported(unsupported)
  {
  }
  bool Unsupported; // by this machine, or by a peer as such: no fault of the subject
};

/// The case asks for what the subject does not have; the message is a sentence that says so.
class NotApplicable : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class VOLUMEBENCHBENCHMARK_EXPORT Trial
{
public:
  Trial(Stage& stage, const Subject& subject, bool quick);
  ~Trial();
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  const Subject& Who() const { return this->Tried; }
  bool Is(int integrator) const { return this->Tried.Integrator == integrator; }
  /// Whether to leave out what takes long and adds little.
  bool IsQuick() const { return this->Quick; }

  /// Throws Refusal.
  FloatPicture Draw(const Shot& shot);

  /// Our mapper as it drew last; null for peers and before the first picture.
  vtkVolumeBenchMapper* GetMapper();

  volumebench::Tally Tally;

private:
  void Arrange(const Shot& shot);
  void ArrangeMapper(const Shot& shot);
  void ArrangeView(const Shot& shot);

  Stage& Scene;
  Subject Tried;
  bool Quick;
  std::unique_ptr<Contestant> Drawn;
  vtkSmartPointer<vtkImageData> Image; // as they were drawn last
  vtkSmartPointer<vtkVolumeProperty> Property;
  std::string Errors; // what VTK reported while drawing
};

/// Premultiplied RGBA that a pixel should have; x and y are its middle, in pixels.
using ExpectedPixel = std::function<glm::dvec4(double x, double y)>;

/// Largest absolute difference over all pixels and channels; NaN when the picture holds one.
VOLUMEBENCHBENCHMARK_EXPORT double WorstDifference(
  const FloatPicture& picture, const ExpectedPixel& expected);

/// The same between two pictures of one size.
VOLUMEBENCHBENCHMARK_EXPORT double WorstDifference(const FloatPicture& a, const FloatPicture& b);
}

#endif
