// The rules of the table of features: what a scene has, and why it does without the rest.
#ifndef volumebench_FeatureRules_h
#define volumebench_FeatureRules_h

#include "Scene/Scene.h"

namespace volumebench
{
/// Modes that add up emission and absorption, as against those that project one value.
bool Composites(const Scene& s);
bool HasMode(const Scene& s, BlendMode mode);
/// Whether macrocells say how long steps are.
bool HasGradedSteps(const Scene& s);
/// Whether rays have so many steps that rounding needs to be compensated.
bool HasLongRays(const Scene& s);
bool HasOneColor(const Scene& s);
/// Whether a step of Segment may be so deep that the order of the colours within it shows.
bool HasStiffSteps(const Scene& s);
/// Whether looking for empty macrocells gives more than it costs.
bool HasEmptyCells(const Scene& s);
/// Whether the box round what can be seen is smaller than the volume's.
bool HasEmptyMargin(const Scene& s);
/// Whether some ray may be deep enough to stop early.
bool CanStop(const Scene& s);
/// Whether the transfer function has a third straight piece.
bool HasMoreRamps(const Scene& s);
/// Why features are left out, after their labels; OffOrProjecting: what only Composite and Gradient
/// have, given whether it is switched on.
const char* OffOrProjecting(bool on);
const char* WhyNoEarlyEnd(const Scene& s);
const char* WhyNoEmptyCells(const Scene& s);
const char* WhyNoEmptyMargin(const Scene& s);
const char* WhyNotIntegrator(const Scene& s, Integrator integrator);
}

#endif
