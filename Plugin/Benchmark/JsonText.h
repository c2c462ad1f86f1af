// JSON objects as one line of text: what a cell of the result table can hold of nested values.
#ifndef volumebench_JsonText_h
#define volumebench_JsonText_h

#include "VolumeBenchBenchmarkModule.h"

#include <string>
#include <vector>

namespace volumebench
{
struct JsonMember
{
  std::string Name;
  std::string Value; // JSON text
};

VOLUMEBENCHBENCHMARK_EXPORT std::string JsonString(const std::string& text);
/// The shortest text that reads back as the number; null when it is not finite.
VOLUMEBENCHBENCHMARK_EXPORT std::string JsonNumber(double number);
VOLUMEBENCHBENCHMARK_EXPORT std::string JsonObject(const std::vector<JsonMember>& members);
}

#endif
