// Checks JSON against a schema, with those keywords of JSON Schema (draft 7) that the schemas in
// Python/volumebench use.
#ifndef volumebench_JsonSchema_h
#define volumebench_JsonSchema_h

#include <nlohmann/json.hpp>

#include <string>

namespace volumebench
{
/// What is wrong with the document, by its key, or nothing. A wrong "schema" number comes first,
/// since it explains all else. Throws std::logic_error for a keyword that is not known here.
std::string FindSchemaFault(
  const nlohmann::ordered_json& document, const nlohmann::ordered_json& schema);
}

#endif
