#include "JsonText.h"

#include <array>
#include <charconv>
#include <cmath>

namespace volumebench
{
std::string JsonString(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    if (letter == '"' || letter == '\\')
    {
      quoted += '\\';
    }
    // Names and settings hold no control characters; one that does must not break the line.
    quoted += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
  }
  return quoted + "\"";
}

std::string JsonNumber(double number)
{
  if (!std::isfinite(number))
  {
    return "null";
  }
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return { text.data(), end };
}

std::string JsonObject(const std::vector<JsonMember>& members)
{
  std::string text;
  for (const JsonMember& member : members)
  {
    text += (text.empty() ? "" : ", ") + JsonString(member.Name) + ": " + member.Value;
  }
  return "{" + text + "}";
}
}
