#include "Gpu/GlTimer.h"

#include "Gpu/GlContextGuard.h"

#include "vtk_glew.h"

#include <limits>

namespace volumebench
{
namespace
{
void EndSoftwareBatch()
{
  if (IsSoftwareGl())
  {
    glFinish();
  }
}
}

void GlTimer::Start()
{
  if (!this->Queries[0])
  {
    glGenQueries(2, this->Queries);
  }
  glQueryCounter(this->Queries[0], GL_TIMESTAMP);
  EndSoftwareBatch();
  this->Started = true;
  this->Stopped = false;
}

void GlTimer::Stop()
{
  if (this->Started)
  {
    EndSoftwareBatch();
    glQueryCounter(this->Queries[1], GL_TIMESTAMP);
    this->Stopped = true;
  }
}

double GlTimer::ElapsedMs()
{
  if (!this->Stopped)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  GLuint64 begin = 0;
  GLuint64 end = 0;
  glGetQueryObjectui64v(this->Queries[0], GL_QUERY_RESULT, &begin);
  glGetQueryObjectui64v(this->Queries[1], GL_QUERY_RESULT, &end);
  return static_cast<double>(end - begin) * 1.0e-6;
}

void GlTimer::Release()
{
  if (this->Queries[0])
  {
    glDeleteQueries(2, this->Queries);
  }
  this->Forget();
}

void GlTimer::Forget()
{
  this->Queries[0] = this->Queries[1] = 0;
  this->Started = this->Stopped = false;
}
}
