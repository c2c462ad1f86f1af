// Tells whether OpenGL had room for what it was given.
#ifndef volumebench_GlRoom_h
#define volumebench_GlRoom_h

#include <string>

namespace volumebench
{
/// Forgets errors that somebody else has made, before what CheckGlRoom is to judge.
void ForgetGlErrors();

/// Throws SceneError if OpenGL reports an error: "the device has no room for " and `what`.
void CheckGlRoom(const std::string& what);
}

#endif
