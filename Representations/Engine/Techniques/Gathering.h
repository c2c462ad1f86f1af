// How the parts of rays that are drawn one after the other, slices or bricks, make pixels: the
// formulas of `accumulate` in Shared/Composite.h as OpenGL's blending.
#ifndef volumebench_Gathering_h
#define volumebench_Gathering_h

#include "Scene/Features.h"

#include <glm/vec4.hpp>

class vtkOpenGLRenderWindow;

namespace volumebench
{
/// Whether pixels are made of one value of the field, in the blend modes that project it.
bool ProjectsValue(const FeatureSet& features);

/// What a pixel is before anything is gathered: emptyRay of Shared/Composite.h.
glm::vec4 EmptyRay(const FeatureSet& features);

/// Blends premultiplied colour over what is there; depth is not tested.
void BlendOver(vtkOpenGLRenderWindow* window);

/// Blends what is drawn from now on with what is there; depth is not tested. The equation is to be
/// set back to GL_FUNC_ADD.
void BlendAsGathered(vtkOpenGLRenderWindow* window, const FeatureSet& features, bool backToFront);
}

#endif
