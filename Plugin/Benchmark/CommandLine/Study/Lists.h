// Lists of names, for messages and look-ups.
#ifndef volumebench_Lists_h
#define volumebench_Lists_h

#include <algorithm>
#include <string>
#include <vector>

namespace volumebench
{
/// The texts with ", " between them.
inline std::string Joined(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
  {
    all += (all.empty() ? "" : ", ") + text;
  }
  return all;
}

inline bool Holds(const std::vector<std::string>& list, const std::string& item)
{
  return std::find(list.begin(), list.end(), item) != list.end();
}
}

#endif
