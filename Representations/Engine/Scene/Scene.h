// One scene as every technique receives it: plain structs with defaults, filled by SceneBuilder.
#ifndef volumebench_Scene_h
#define volumebench_Scene_h

#include "Scene/SharedTable.h"

#include "vtkSmartPointer.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace volumebench
{
class ExactTransferFunction;
struct CellMap;

/// A scene that cannot be drawn honestly. The message is one line that names the cause.
class SceneError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The technique cannot run on this machine or in this context, whatever the scene.
class UnsupportedError : public SceneError
{
public:
  using SceneError::SceneError;
};

/// Whoever watches the window has stopped the frame; there is nothing wrong with the scene.
class AbortedError : public SceneError
{
public:
  using SceneError::SceneError;
};

/// One value per struct answers "did it change?": equal stamps mean equal contents.
using ChangeStamp = std::size_t;

/// How values lie in the volume texture: stored value v in [0, 1] means 2 * (v * HalfSpan +
/// HalfBase). Halves keep a span near the largest double finite.
struct ValueMapping
{
  double HalfBase = 0.0;
  double HalfSpan = 0.5;

  double Normalize(double value) const { return (0.5 * value - this->HalfBase) / this->HalfSpan; }
};

enum class TexelFormat
{
  Unsigned16, // R16: 8- and 16-bit data; filtered with more than 8-bit weights
  Float32     // R32F: everything else
};

/// Some of a volume's texels: Size of them on each axis from First on.
struct TexelBox
{
  glm::ivec3 First{ 0 };
  glm::ivec3 Size{ 0 };
};

/// The field: one channel, or with dependent components two (colour by the first, opacity by the
/// second) or four (red, green, blue, opacity by the fourth). Voxel space has its origin in the
/// middle of the box and one unit per voxel edge.
struct Volume
{
  vtkSmartPointer<vtkDataArray> Scalars;
  std::string Name;
  int Component = 0; // of one channel; -1 for the magnitude
  int Channels = 1;  // 1, 2 or 4
  glm::ivec3 Texels{ 0 };
  std::optional<TexelBox> Part; // that goes to the device, of a volume in bricks
  glm::dvec3 BoxHalf{ 0.0 };    // voxels
  glm::dmat4 VoxelToWorld{ 1.0 };
  glm::dmat4 VoxelToData{ 1.0 }; // before the actor's own matrix: space of crop box and opacity
  ValueMapping Mapping;          // of the channel that opacity is looked up by
  ValueMapping ColorMapping;     // of the others
  TexelFormat Format = TexelFormat::Float32;
  double FiniteRange[2] = { 0.0, 1.0 }; // of the channel that opacity is looked up by
  double ColorRange[2] = { 0.0, 1.0 };  // of the first of two channels
  bool HasNonFinite = false;            // NaN or infinite voxels: their cells are left blank
  vtkSmartPointer<vtkUnsignedCharArray> PointGhosts; // null unless some point is hidden
  vtkSmartPointer<vtkUnsignedCharArray> CellGhosts;  // null unless some cell is
  bool CellCentred = false;
  bool Nearest = false;
  ChangeStamp Stamp = 0;
  ChangeStamp TexelStamp = 0; // of the texels alone, however they are filtered

  bool HasBlanks() const { return this->HasNonFinite || this->PointGhosts || this->CellGhosts; }

  /// The texels that go to the device.
  TexelBox Held() const { return this->Part.value_or(TexelBox{ glm::ivec3(0), this->Texels }); }
};

/// Entries (red, green, blue, extinction per data unit), equally spaced: extinctions from Low to
/// High, colours from ColorLow to ColorHigh, which differ when a component of its own gives them.
struct TransferFunction
{
  SharedTable<glm::vec4> Table;
  double MaximumExtinction = 0.0;
  double Low = 0.0;
  double High = 1.0;
  double ColorLow = 0.0;
  double ColorHigh = 1.0;
  double UnitDistance = 1.0; // data units over which the opacities are given

  /// The functions themselves, over which the table is sampled.
  std::shared_ptr<const ExactTransferFunction> Exact;

  /// The same in place of Table where that is few straight pieces, as Scene/Ramps.h makes them; else
  /// empty. RampOpacity: the largest over the unit distance.
  SharedTable<glm::vec4> Ramps;
  double RampOpacity = 0.0;

  /// For PreIntegrated: SegmentSize x SegmentSize entries over (front, back) from Low to High; row
  /// by row of back, as SegmentTable makes them. Empty unless the scene needs it.
  SharedTable<glm::vec4> Segments;
  int SegmentSize = 0;

  /// For Segment: integrals of colour times extinction (xyz) and of extinction (w) up to each entry
  /// of the table, and to one more on either side, in whole units. The last bit of x marks entries
  /// that Table is too coarse for. Empty unless the scene needs it.
  SharedTable<glm::ivec4> Prefix;
  double PrefixColorUnit = 0.0;      // extinction times colour per unit and entry
  double PrefixExtinctionUnit = 0.0; // extinction per unit and entry
  bool OneColor = false;             // all that is seen has the same colour

  /// The colour of all that can be seen, if it is one: then tables need extinctions alone.
  std::optional<glm::vec3> Color;

  /// Factor of the extinction by gradient magnitude from GradientLow to GradientHigh (data units);
  /// empty without gradient opacity.
  std::vector<float> GradientTable;
  double GradientLow = 0.0;
  double GradientHigh = 1.0;
  ChangeStamp Stamp = 0;
  ChangeStamp ExtinctionStamp = 0; // of what the macrocells are judged by, which colours are not
};

struct Camera
{
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToClip{ 1.0 };
  bool Parallel = false;
  double NearDepth = 0.0;
  double FarDepth = 1.0;
  glm::ivec4 Viewport{ 0 }; // x, y, width, height in pixels
};

enum class Integrator
{
  Left = 0,     // sample at the beginning of a step, first order (as VTK's mapper)
  Midpoint = 1, // sample in its middle, second order
  Segment = 2,  // prefix integrals between its ends, second order or better, exact for narrow peaks
  PreIntegrated = 3, // table over the values at both ends of a step
  Automatic = 4      // Midpoint where that suffices, else Segment; a built scene has either
};

enum class RaySetUp
{
  Box,       // every pixel of the box's screen rectangle tests its ray against the box
  Rasterised // the box's back faces are drawn and only the pixels they cover cast a ray
};

enum class SliceExtent
{
  VertexDepth,    // depths of the box's nearest and farthest vertex
  VertexDistance, // their distances from the eye
  CentralRay      // entry and exit of the ray through the middle of the picture
};

enum class SliceTarget
{
  Float32,
  Float16,
  Unsigned8
};

struct Slicing
{
  SliceExtent Extent = SliceExtent::VertexDepth;
  SliceTarget Target = SliceTarget::Float32;
  int Threads = 0; // 0: as many as pay
  bool BackToFront = false;
};

/// Where an OpenCL kernel finds the volume and the tables that it filters.
enum class OpenClStorage
{
  Auto,   // what suits the device
  Images, // filtered by the device
  Buffers // filtered by the kernel
};

struct OpenClChoice
{
  std::string Device = "Auto"; // "PLATFORM: DEVICE", or a graphics card or else a CPU
  OpenClStorage Storage = OpenClStorage::Auto;
  int Lanes = 0; // rays side by side on a CPU: 1, 8 or 16; 0 for as many as its vectors hold
};

enum class ReferenceMethod
{
  CellExact,
  Midpoint // StepVoxels, its half and its quarter, extrapolated (Richardson)
};

/// What is done for the path of a view through the volume's memory.
enum class VoxelOrder
{
  Naive,
  BlockShape,     // work groups shaped by the view
  InPlaceRotation // and voxels turned on the device where rays run along the smallest stride
};

/// How a picture that CUDA makes gets to OpenGL.
enum class PictureTransfer
{
  RegisterOnce,      // in a buffer of both
  RegisterEachFrame, // the same, made known to CUDA anew for every picture
  ThroughHost
};

struct Sampling
{
  Integrator Integration = Integrator::Midpoint;
  bool ChoosesIntegrator = false; // Automatic was asked for
  RaySetUp SetUp = RaySetUp::Rasterised;
  double StepVoxels = 0.5;
  bool Jitter = false; // move each pixel's steps by a random share of one
  int JitterSeed = 0;  // 0 to MostJitterSeed
  int TableSize = 0;   // entries of the transfer-function table; 0: as many as it needs
  bool SkipsEmptySpace = true;
  int MacrocellVoxels = 0;           // edge of a macrocell; 0: by the size of the volume
  double ErrorTarget = 0.0;          // root mean square of a picture; 0: all steps are alike
  bool StepsMayVary = false;         // the technique can take steps of different lengths
  double TerminationThreshold = 0.0; // remaining transmittance at which a ray stops
  glm::ivec2 WorkGroup{ 0 };         // pixels of a compute work group; 0: to be found by measuring
  VoxelOrder Order = VoxelOrder::Naive;
  PictureTransfer Transfer = PictureTransfer::RegisterOnce;
  Slicing Slices;
  OpenClChoice OpenCl;
  ReferenceMethod Method = ReferenceMethod::CellExact; // of technique reference
  double MemoryBudgetMiB = 0.0; // that voxels may take on the device; 0: as it has
};

enum class BlendMode
{
  Composite,
  Maximum,
  Minimum,
  Average,
  Gradient // Composite weighted by the difference of the neighbours along the ray
};

struct Compositing
{
  BlendMode Mode = BlendMode::Composite;
};

/// What is recorded besides the picture, or in place of it.
struct Measurement
{
  bool CountSamples = false;
  bool ShowSamples = false; // as colours
  bool TimeStages = false;
};

struct Light
{
  glm::dvec4 Position{ 0.0 }; // world; w 0: direction to the light
  glm::dvec3 Color{ 1.0 };    // times intensity
};

struct Lighting
{
  bool Enabled = false;
  double Ambient = 0.1;
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10.0;
  double Damping = 0.0; // gradient, in data ranges per voxel, below which lighting fades
  std::vector<Light> Lights;
};

struct Clip
{
  bool Crop = false;
  glm::dvec3 CropLow{ 0.0 }; // data coordinates
  glm::dvec3 CropHigh{ 1.0 };
  unsigned int CropRegionFlags = 0; // VTK's 27 regions; 0: no cropping, or only to the box
  bool Empty = false;               // cropping leaves no region
  std::vector<glm::dvec4> Planes;   // world; dot(xyz, point) + w is positive where it is kept
  bool OpaqueGeometry = false;      // something in the depth buffer may hide part of the volume
};

/// What of the volume need not be looked at.
struct Skipping
{
  /// Null: all of it is, because skipping is off or the blend mode needs every value.
  std::shared_ptr<const CellMap> Cells;
  double GridMs = std::numeric_limits<double>::quiet_NaN(); // that making it took
};

/// A box of a volume that is too large to be drawn at once, with the texels that drawing it reads.
/// Corners are in voxels from the middle of the volume's box.
struct Brick
{
  TexelBox Texels;
  glm::dvec3 Low{ 0.0 }; // it is between these; far away where the volume ends
  glm::dvec3 High{ 0.0 };
  glm::dvec3 SlabNormal{ 0.0 }; // and where this times the place is between the next two
  double SlabLow = 0.0;
  double SlabHigh = 0.0;
  glm::dvec3 SeenLow{ 0.0 }; // box round all of it that can be seen
  glm::dvec3 SeenHigh{ 0.0 };
  ChangeStamp Stamp = 0; // of its texels
};

/// What this process draws of a volume of which others draw the rest, so that samples lie where
/// those of the whole would. Corners are in voxels from the middle of what it holds.
struct Share
{
  glm::dvec3 WholeLow{ 0.0 };
  glm::dvec3 WholeHigh{ 0.0 };
  glm::dvec3 Low{ 0.0 }; // it is between these; far away where the volume ends
  glm::dvec3 High{ 0.0 };
  glm::dvec3 SlabNormal{ 0.0 }; // and where this times the place is between the next two
  double SlabLow = 0.0;
  double SlabHigh = 0.0;
};

struct Scene
{
  volumebench::Volume Volume;
  volumebench::TransferFunction TransferFunction;
  volumebench::Camera Camera;
  volumebench::Sampling Sampling;
  volumebench::Compositing Compositing;
  volumebench::Lighting Lighting;
  volumebench::Clip Clip;
  volumebench::Measurement Measurement;
  volumebench::Skipping Skipping;

  /// Front to back, without those that show nothing. Null: the volume is drawn at once.
  std::shared_ptr<const std::vector<volumebench::Brick>> Bricks;
  std::optional<volumebench::Brick> Brick;                     // that is drawn now
  std::optional<volumebench::Share> Share;                     // empty: all is drawn
  double BrickBytes = std::numeric_limits<double>::infinity(); // that bricks may take together
};

/// Ghost flags that keep a point or cell from being drawn. Duplicate points are only needed by
/// their neighbours' cells; duplicate cells are drawn by the process that owns them.
constexpr unsigned char HiddenPointBits = vtkDataSetAttributes::HIDDENPOINT;
constexpr unsigned char HiddenCellBits =
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;

constexpr int MostSliceThreads = 16;

/// Seeds travel in a float, which holds whole numbers up to here.
constexpr int MostJitterSeed = 16777215;

/// The smallest step that is drawn; a shorter one would only hang the machine.
constexpr double SmallestStepVoxels = 1.0 / 1024.0;

/// Folds one more value into a stamp.
template <typename T>
void ExtendStamp(ChangeStamp& stamp, const T& value)
{
  stamp ^= std::hash<T>{}(value) + 0x9e3779b97f4a7c15ULL + (stamp << 6) + (stamp >> 2);
}
}

#endif
