#include "GlCalibration.h"

#include "GlFetch.h"
#include "Repeats.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <stdexcept>

namespace volumebench
{
namespace
{
constexpr int TableEntries = 1024;

struct GlFormatName
{
  const char* Name;
  GLenum Internal;
  GLenum Type;
};

template <typename Texel>
GlFormatName FormatOf();
template <>
GlFormatName FormatOf<std::uint8_t>()
{
  return { "R8", GL_R8, GL_UNSIGNED_BYTE };
}
template <>
GlFormatName FormatOf<std::uint16_t>()
{
  return { "R16", GL_R16, GL_UNSIGNED_SHORT };
}
template <>
GlFormatName FormatOf<float>()
{
  return { "R32F", GL_R32F, GL_FLOAT };
}

void CheckUpload(const char* what)
{
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    throw std::runtime_error(
      std::string("the device takes no ") + what + " (OpenGL error " + std::to_string(error) + ")");
  }
}

template <typename Texel>
void UploadVolume(vtkOpenGLRenderWindow* window, GlTexture& texture, int side)
{
  const GlFormatName format = FormatOf<Texel>();
  const std::vector<Texel> texels = CalibrationVolume<Texel>(side);
  texture.Bind(GL_TEXTURE_3D);
  texture.SetSampling(true);
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_3D, 0, static_cast<GLint>(format.Internal), side, side, side, 0, GL_RED,
    format.Type, texels.data());
  texture.Unbind();
  CheckUpload("volume");
}

void UploadTable(GlTexture& texture)
{
  std::vector<float> table;
  for (int i = 0; i < TableEntries; ++i)
  {
    const auto value = static_cast<float>(CalibrationValue(3.0 * i, TableEntries));
    table.insert(table.end(), { value, 0.9F * value, 0.8F * value, 0.7F * value });
  }
  texture.Bind(GL_TEXTURE_1D);
  texture.SetSampling(true);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA32F, TableEntries, 0, GL_RGBA, GL_FLOAT, table.data());
  texture.Unbind();
  CheckUpload("table");
}

// A shader stage with what it is called.
class Stage
{
public:
  Stage(vtkOpenGLRenderWindow* window, bool compute)
    : Path(compute ? "gl-compute" : "gl-fragment")
    , Fetch(window, compute)
  {
  }

  FetchRate Measure(const CalibrationSettings& settings, const FetchPattern& pattern,
    GlTexture& texture, double scale)
  {
    const int side = GrowPicture(
      settings, [&](int pixels) { this->Fetch.Prepare(pattern, texture, pixels); },
      [&] { return this->Fetch.TimeMs(1); });
    const RepeatedWork work =
      MeasureRepeats(settings, [&](int times) { return this->Fetch.TimeMs(times); });
    CheckSums(pattern, glm::ivec2(side), this->Fetch.ReadSums(), 4, scale, this->Path);
    FetchRate rate;
    rate.Path = this->Path;
    rate.Entries = pattern.Entries;
    const auto amount = static_cast<double>(pattern.FetchesPerPixel() * side * side);
    rate.FetchCount = amount * work.Times;
    rate.PerSecond = RatePerSecond(work, amount);
    return rate;
  }

private:
  const char* Path;
  GlFetch Fetch;
};

struct Job
{
  FetchKind Kind;
  const char* KindName;
  FetchOrder Order;
};

class GlLaboratory
{
public:
  GlLaboratory(vtkOpenGLRenderWindow* window, const CalibrationSettings& settings,
    const CalibrationProgress& progress, Calibration& result)
    : Window(window)
    , Settings(settings)
    , Progress(progress)
    , Result(result)
  {
    this->Stages.push_back(std::make_unique<Stage>(window, false));
    if (GLEW_VERSION_4_3)
    {
      this->Stages.push_back(std::make_unique<Stage>(window, true));
    }
  }

  ~GlLaboratory()
  {
    this->Window->MakeCurrent();
    this->Texture.Release();
  }
  GlLaboratory(const GlLaboratory&) = delete;
  GlLaboratory& operator=(const GlLaboratory&) = delete;

  template <typename Texel>
  void MeasureVolumes(const std::vector<Job>& jobs)
  {
    const char* format = FormatOf<Texel>().Name;
    for (const int side : this->Settings.Sides)
    {
      this->Progress(std::string("gl ") + format + " " + std::to_string(side));
      this->Texture.Release();
      UploadVolume<Texel>(this->Window, this->Texture, side);
      for (const Job& job : jobs)
      {
        this->MeasureJob(job, side, format, TexelScale<Texel>::Scale);
      }
    }
  }

  void MeasureTable()
  {
    this->Progress("gl table");
    this->Texture.Release();
    UploadTable(this->Texture);
    this->MeasureJob({ FetchKind::Table, "table", FetchOrder::Axis }, TableEntries, "RGBA32F", 1.0);
  }

private:
  void MeasureJob(const Job& job, int entries, const char* format, double scale)
  {
    const FetchPattern pattern = MakeFetchPattern(job.Kind, job.Order, entries);
    for (const auto& stage : this->Stages)
    {
      FetchRate rate = stage->Measure(this->Settings, pattern, this->Texture, scale);
      rate.Kind = job.KindName;
      rate.Order = FetchOrderName(job.Order);
      rate.Format = format;
      this->Result.Fetches.push_back(rate);
    }
  }

  vtkOpenGLRenderWindow* Window;
  const CalibrationSettings& Settings;
  const CalibrationProgress& Progress;
  Calibration& Result;
  GlTexture Texture;
  std::vector<std::unique_ptr<Stage>> Stages;
};

CopyRate MeasureCopy(const CalibrationSettings& settings)
{
  const auto bytes = static_cast<GLsizeiptr>(settings.CopyBytes);
  const std::vector<unsigned char> ones(static_cast<std::size_t>(bytes), 1);
  GLuint buffers[2] = {};
  glGenBuffers(2, buffers);
  glBindBuffer(GL_COPY_READ_BUFFER, buffers[0]);
  glBufferData(GL_COPY_READ_BUFFER, bytes, ones.data(), GL_STATIC_COPY);
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffers[1]);
  glBufferData(GL_COPY_WRITE_BUFFER, bytes, nullptr, GL_STATIC_COPY);
  CheckUpload("buffers to copy");
  GlTimer timer;
  const RepeatedWork work = MeasureRepeats(settings,
    [&](int times)
    {
      timer.Start();
      for (int i = 0; i < times; ++i)
      {
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytes);
      }
      timer.Stop();
      glFinish();
      return timer.ElapsedMs();
    });
  std::vector<unsigned char> copied(ones.size());
  glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, bytes, copied.data());
  timer.Release();
  glDeleteBuffers(2, buffers);
  if (copied != ones)
  {
    throw std::runtime_error("the device's copy is not what was copied");
  }
  return { "gl", static_cast<double>(bytes), RatePerSecond(work, static_cast<double>(bytes)) };
}
}

void CalibrateGl(vtkOpenGLRenderWindow* window, const CalibrationSettings& settings,
  const CalibrationProgress& progress, Calibration& result)
{
  const std::vector<Job> samples = {
    { FetchKind::Trilinear, "trilinear", FetchOrder::Axis },
    { FetchKind::Trilinear, "trilinear", FetchOrder::Oblique },
    { FetchKind::Trilinear, "trilinear", FetchOrder::Rays },
  };
  GlLaboratory laboratory(window, settings, progress, result);
  laboratory.MeasureVolumes<std::uint16_t>(samples);
  laboratory.MeasureVolumes<float>(samples);
  laboratory.MeasureVolumes<std::uint8_t>({ { FetchKind::Texel, "texel", FetchOrder::Oblique } });
  laboratory.MeasureTable();
  progress("gl copy");
  result.Copies.push_back(MeasureCopy(settings));
}
}
