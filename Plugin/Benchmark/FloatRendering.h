// What a renderer shows as a float picture, and such a picture as a file.
#ifndef volumebench_FloatRendering_h
#define volumebench_FloatRendering_h

#include "VolumeBenchBenchmarkModule.h"

#include "Error/FloatPicture.h"

#include <string>

class vtkRenderer;

namespace volumebench
{
/// Renders the renderer's visible props with their mappers as they are set now into a float
/// framebuffer of the renderer's size. Throws std::runtime_error when there is no OpenGL window or
/// no float framebuffer. The renderer and its window are left as found.
VOLUMEBENCHBENCHMARK_EXPORT FloatPicture RenderToFloat(vtkRenderer* renderer);

/// Writes the pixels as they are in memory; the file appears whole or not at all. Throws
/// std::runtime_error that names the file.
VOLUMEBENCHBENCHMARK_EXPORT void WriteFloatPicture(
  const FloatPicture& picture, const std::string& path);
}

#endif
