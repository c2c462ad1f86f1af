#include "JsonFile.h"

#include "EmbeddedFiles.h"
#include "JsonSchema.h"

#include <set>
#include <stdexcept>
#include <vector>

namespace volumebench
{
namespace
{
std::string PlaceOf(const std::string& text, std::size_t byte)
{
  std::size_t line = 1;
  std::size_t lineBegin = 0;
  for (std::size_t i = 0; i + 1 < byte && i < text.size(); ++i)
  {
    if (text[i] == '\n')
    {
      ++line;
      lineBegin = i + 1;
    }
  }
  return "line " + std::to_string(line) + ", column " +
    std::to_string(byte > lineBegin ? byte - lineBegin : 1);
}

// Keeps the keys of each open object, since the parser itself lets the last of two win.
class UniqueKeys
{
public:
  explicit UniqueKeys(std::string name)
    : Name(std::move(name))
  {
  }

  bool operator()(int, Json::parse_event_t event, const Json& parsed)
  {
    if (event == Json::parse_event_t::object_start)
    {
      this->Open.emplace_back();
    }
    else if (event == Json::parse_event_t::object_end)
    {
      this->Open.pop_back();
    }
    else if (event == Json::parse_event_t::key &&
      !this->Open.back().insert(parsed.get<std::string>()).second)
    {
      throw std::runtime_error(
        this->Name + ": key " + parsed.dump() + " appears twice in one object");
    }
    return true;
  }

private:
  std::string Name;
  std::vector<std::set<std::string>> Open;
};
}

Json ParseJson(const std::string& text, const std::string& name)
{
  try
  {
    return Json::parse(text, UniqueKeys(name));
  }
  catch (const Json::parse_error& fault)
  {
    throw std::runtime_error(name + ": " + PlaceOf(text, fault.byte) + ": not valid JSON");
  }
  catch (const Json::exception& fault)
  {
    throw std::runtime_error(name + ": not valid JSON: " + fault.what());
  }
}

void CheckSchema(const Json& document, const char* schema, const std::string& name)
{
  const std::string path = std::string("Python/volumebench/") + schema;
  const char* text = EmbeddedFile(path);
  if (!text)
  {
    throw std::logic_error("no schema " + path);
  }
  const std::string fault = FindSchemaFault(document, ParseJson(text, path));
  if (!fault.empty())
  {
    throw std::runtime_error(name + ": " + fault);
  }
}
}
