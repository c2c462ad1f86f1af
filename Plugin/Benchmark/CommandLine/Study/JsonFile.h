// Strict JSON: every fault is one line that names the file and the place.
#ifndef volumebench_JsonFile_h
#define volumebench_JsonFile_h

#include <nlohmann/json.hpp>

#include <string>

namespace volumebench
{
using Json = nlohmann::ordered_json;

/// Throws std::runtime_error with `name` in front; refuses a key that is twice in one object.
Json ParseJson(const std::string& text, const std::string& name);

/// Throws std::runtime_error that names the first fault, as Python's check_schema does. `schema` is
/// the name of a file in Python/volumebench.
void CheckSchema(const Json& document, const char* schema, const std::string& name);
}

#endif
