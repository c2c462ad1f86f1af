// Programs that VTK 9.2 cannot make (compute), the timer, and messages that name our files.
#include "Gpu/GlProgram.h"
#include "Gpu/GlTimer.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtk_glew.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volumebench;

namespace
{
class GlContext : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Window->SetShowWindow(false);
    this->Window->SetUseOffScreenBuffers(true);
    this->Window->SetSize(16, 16);
    this->Window->Render();
    this->Window->MakeCurrent();
  }

  vtkOpenGLRenderWindow* GlWindow() { return vtkOpenGLRenderWindow::SafeDownCast(this->Window); }

  vtkNew<vtkRenderWindow> Window;
};

KernelText Text(const std::string& source)
{
  return { source, { "Test.comp" } };
}
}

TEST_F(GlContext, ComputeProgramsRun)
{
  GlProgram program;
  program.Build({ { GlStage::Compute, Text(R"(#version 430 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Numbers { uint numbers[]; };
void main() { numbers[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x * 3u; }
)") } });
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  std::vector<GLuint> numbers(128, 7);
  glBufferData(GL_SHADER_STORAGE_BUFFER, 512, numbers.data(), GL_DYNAMIC_COPY);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
  program.Bind(this->GlWindow());
  glDispatchCompute(2, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  GlProgram::Unbind();
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 512, numbers.data());
  for (GLuint i = 0; i < 128; ++i)
  {
    EXPECT_EQ(numbers[i], 3 * i);
  }
  glDeleteBuffers(1, &buffer);
  program.Release();
}

TEST_F(GlContext, CompilerMessagesNameTheFileAndLine)
{
  const auto lookup = [](const std::string& path)
  {
    return path == "Main.frag" ? "#include \"Shared/Part.h\"\nvoid main() {}\n"
                               : "\n\nint x = nix;\n";
  };
  const KernelText broken = SpecializeKernel("Main.frag", "#version 330 core", lookup);
  GlProgram program;
  try
  {
    program.Build({ { GlStage::Fragment, broken } });
    FAIL() << "a broken kernel compiled";
  }
  catch (const KernelError& error)
  {
    EXPECT_NE(std::string(error.what()).find("Shared/Part.h:3"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(program.IsBuilt());
}

TEST_F(GlContext, TimerMeasuresAndAbsentIsNaN)
{
  GlTimer timer;
  EXPECT_TRUE(std::isnan(timer.ElapsedMs()));
  timer.Start();
  EXPECT_TRUE(std::isnan(timer.ElapsedMs()));
  glClear(GL_COLOR_BUFFER_BIT);
  timer.Stop();
  EXPECT_GE(timer.ElapsedMs(), 0.0);
  EXPECT_LT(timer.ElapsedMs(), 10000.0);
  timer.Release();
}
