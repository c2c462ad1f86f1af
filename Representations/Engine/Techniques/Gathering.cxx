#include "Techniques/Gathering.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

namespace volumebench
{
bool ProjectsValue(const FeatureSet& features)
{
  return Has(features, Feature::MaximumBlend) || Has(features, Feature::MinimumBlend) ||
    Has(features, Feature::AverageBlend);
}

glm::vec4 EmptyRay(const FeatureSet& features)
{
  if (Has(features, Feature::SampleCount) || !ProjectsValue(features) ||
    Has(features, Feature::AverageBlend))
  {
    return glm::vec4(0.0f);
  }
  return { Has(features, Feature::MaximumBlend) ? -1.0e30f : 1.0e30f, 0.0f, 0.0f, 0.0f };
}

void BlendOver(vtkOpenGLRenderWindow* window)
{
  constexpr bool BackToFront = true;
  BlendAsGathered(window, FeatureSet(), BackToFront);
}

void BlendAsGathered(vtkOpenGLRenderWindow* window, const FeatureSet& features, bool backToFront)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  if (Has(features, Feature::SampleCount) || Has(features, Feature::AverageBlend))
  {
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  else if (ProjectsValue(features))
  {
    const GLenum extreme = Has(features, Feature::MaximumBlend) ? GL_MAX : GL_MIN;
    state->vtkglBlendEquationSeparate(extreme, extreme);
  }
  else if (backToFront)
  {
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
  {
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
}
}
