// Numbers as messages give them: six digits, however large or small.
#ifndef volumebench_NumberText_h
#define volumebench_NumberText_h

#include <cstdio>
#include <string>

namespace volumebench
{
inline std::string NumberText(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", number);
  return text;
}
}

#endif
