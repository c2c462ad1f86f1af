#include "JsonSchema.h"

#include <map>
#include <regex>
#include <stdexcept>

namespace volumebench
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr std::size_t LongestValue = 120; // characters of a value in a message

std::string Shown(const Json& value)
{
  const std::string text = value.dump();
  return text.size() > LongestValue ? text.substr(0, LongestValue) + " ..." : text;
}

bool IsWhole(const Json& value)
{
  return value.is_number_integer() ||
    (value.is_number_float() && value.get<double>() == std::floor(value.get<double>()));
}

bool HasType(const Json& value, const std::string& type)
{
  static const std::map<std::string, bool (*)(const Json&)> types = {
    { "object", [](const Json& v) { return v.is_object(); } },
    { "array", [](const Json& v) { return v.is_array(); } },
    { "string", [](const Json& v) { return v.is_string(); } },
    { "boolean", [](const Json& v) { return v.is_boolean(); } },
    { "null", [](const Json& v) { return v.is_null(); } },
    { "number", [](const Json& v) { return v.is_number(); } },
    { "integer", [](const Json& v) { return IsWhole(v); } },
  };
  return types.at(type)(value);
}

class Checker
{
public:
  explicit Checker(const Json& root)
    : Root(root)
  {
  }

  // The fault of a value, or nothing; `key` is its place in the document.
  std::string Fault(const Json& value, const Json& schema, const std::string& key) const
  {
    for (const auto& [keyword, rule] : schema.items())
    {
      const auto found = Rules().find(keyword);
      if (found == Rules().end())
      {
        throw std::logic_error("the schema keyword '" + keyword + "' is not known");
      }
      const std::string fault = (this->*found->second)(value, rule, schema, key);
      if (!fault.empty())
      {
        return fault;
      }
    }
    return {};
  }

private:
  using Rule = std::string (Checker::*)(
    const Json&, const Json&, const Json&, const std::string&) const;

  static const std::map<std::string, Rule>& Rules()
  {
    static const std::map<std::string, Rule> rules = { { "$schema", &Checker::Nothing },
      { "title", &Checker::Nothing }, { "description", &Checker::Nothing },
      { "definitions", &Checker::Nothing }, { "$ref", &Checker::Reference },
      { "type", &Checker::Type }, { "const", &Checker::Constant },
      { "enum", &Checker::OneOfValues }, { "minimum", &Checker::Minimum },
      { "maximum", &Checker::Maximum }, { "exclusiveMinimum", &Checker::ExclusiveMinimum },
      { "exclusiveMaximum", &Checker::ExclusiveMaximum }, { "minItems", &Checker::MinItems },
      { "maxItems", &Checker::MaxItems }, { "uniqueItems", &Checker::UniqueItems },
      { "items", &Checker::Items }, { "required", &Checker::Required },
      { "properties", &Checker::Properties },
      { "additionalProperties", &Checker::AdditionalProperties },
      { "minProperties", &Checker::MinProperties }, { "minLength", &Checker::MinLength },
      { "maxLength", &Checker::MaxLength }, { "pattern", &Checker::Pattern },
      { "oneOf", &Checker::OneOf } };
    return rules;
  }

  static std::string Told(const Json& schema, const std::string& key, const std::string& what)
  {
    const std::string place = key.empty() ? "" : "\"" + key + "\": ";
    const std::string expected = schema.value("description", "");
    return place + what + (expected.empty() ? "" : " (expected: " + expected + ")");
  }

  static std::string Below(const std::string& key, const std::string& name)
  {
    return key.empty() ? name : key + "." + name;
  }

  std::string Nothing(const Json&, const Json&, const Json&, const std::string&) const
  {
    return {};
  }

  std::string Reference(
    const Json& value, const Json& rule, const Json&, const std::string& key) const
  {
    const std::string path = rule.get<std::string>();
    return this->Fault(value, this->Root.at(Json::json_pointer(path.substr(1))), key);
  }

  std::string Type(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const Json types = rule.is_array() ? rule : Json::array({ rule });
    for (const Json& type : types)
    {
      if (HasType(value, type.get<std::string>()))
      {
        return {};
      }
    }
    return Told(schema, key, Shown(value) + " is not of type " + rule.dump());
  }

  std::string Constant(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    return value == rule ? "" : Told(schema, key, Shown(value) + " is not " + rule.dump());
  }

  std::string OneOfValues(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool found = std::find(rule.begin(), rule.end(), value) != rule.end();
    return found ? "" : Told(schema, key, Shown(value) + " is not one of " + rule.dump());
  }

  // A keyword about numbers holds for other types by itself.
  template <typename Holds>
  static std::string Bound(const Json& value, const Json& rule, const Json& schema,
    const std::string& key, const char* what, Holds holds)
  {
    if (!value.is_number() || holds(value.get<double>(), rule.get<double>()))
    {
      return {};
    }
    return Told(schema, key, Shown(value) + " is " + what + " " + rule.dump());
  }

  std::string Minimum(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    return Bound(value, rule, schema, key, "below", std::greater_equal<>());
  }

  std::string Maximum(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    return Bound(value, rule, schema, key, "above", std::less_equal<>());
  }

  std::string ExclusiveMinimum(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    return Bound(value, rule, schema, key, "not above", std::greater<>());
  }

  std::string ExclusiveMaximum(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    return Bound(value, rule, schema, key, "not below", std::less<>());
  }

  std::string MinItems(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool few = value.is_array() && value.size() < rule.get<std::size_t>();
    return few ? Told(schema, key, Shown(value) + " is too short") : "";
  }

  std::string MaxItems(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool many = value.is_array() && value.size() > rule.get<std::size_t>();
    return many ? Told(schema, key, Shown(value) + " is too long") : "";
  }

  std::string UniqueItems(
    const Json& value, const Json&, const Json& schema, const std::string& key) const
  {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
    {
      if (std::find(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(i), value[i]) !=
        value.begin() + static_cast<std::ptrdiff_t>(i))
      {
        return Told(schema, key, Shown(value[i]) + " is in the list twice");
      }
    }
    return {};
  }

  std::string Items(const Json& value, const Json& rule, const Json&, const std::string& key) const
  {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
    {
      if (rule.is_array() && i >= rule.size())
      {
        break;
      }
      const std::string place = key + "[" + std::to_string(i) + "]";
      const std::string fault = this->Fault(value[i], rule.is_array() ? rule[i] : rule, place);
      if (!fault.empty())
      {
        return fault;
      }
    }
    return {};
  }

  std::string Required(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    for (const Json& name : rule)
    {
      if (value.is_object() && !value.contains(name.get<std::string>()))
      {
        return Told(schema, key, name.dump() + " is missing");
      }
    }
    return {};
  }

  std::string Properties(
    const Json& value, const Json& rule, const Json&, const std::string& key) const
  {
    if (!value.is_object())
    {
      return {};
    }
    for (const auto& [name, part] : rule.items())
    {
      const auto found = value.find(name);
      const std::string fault =
        found == value.end() ? "" : this->Fault(*found, part, Below(key, name));
      if (!fault.empty())
      {
        return fault;
      }
    }
    return {};
  }

  std::string AdditionalProperties(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    if (!value.is_object())
    {
      return {};
    }
    for (const auto& [name, part] : value.items())
    {
      if (schema.contains("properties") && schema["properties"].contains(name))
      {
        continue;
      }
      const bool allowed = !rule.is_boolean() || rule.get<bool>();
      const std::string fault = !allowed
        ? Told(schema, key, "there is no key \"" + name + "\" here")
        : rule.is_object() ? this->Fault(part, rule, Below(key, name))
                           : "";
      if (!fault.empty())
      {
        return fault;
      }
    }
    return {};
  }

  std::string MinProperties(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool few = value.is_object() && value.size() < rule.get<std::size_t>();
    return few ? Told(schema, key, "holds too few keys") : "";
  }

  std::string MinLength(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool few =
      value.is_string() && value.get_ref<const std::string&>().size() < rule.get<std::size_t>();
    return few ? Told(schema, key, Shown(value) + " is too short") : "";
  }

  std::string MaxLength(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool many =
      value.is_string() && value.get_ref<const std::string&>().size() > rule.get<std::size_t>();
    return many ? Told(schema, key, Shown(value) + " is too long") : "";
  }

  std::string Pattern(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    const bool bad = value.is_string() &&
      !std::regex_search(value.get_ref<const std::string&>(), std::regex(rule.get<std::string>()));
    return bad ? Told(schema, key, Shown(value) + " is not such a text") : "";
  }

  std::string OneOf(
    const Json& value, const Json& rule, const Json& schema, const std::string& key) const
  {
    int matches = 0;
    for (const Json& choice : rule)
    {
      matches += this->Fault(value, choice, key).empty() ? 1 : 0;
    }
    return matches == 1 ? "" : Told(schema, key, Shown(value) + " is none of these");
  }

  const Json& Root;
};
}

std::string FindSchemaFault(const Json& document, const Json& schema)
{
  const Checker checker(schema);
  if (document.is_object() && document.contains("schema") && schema.contains("properties") &&
    schema["properties"].contains("schema"))
  {
    const std::string fault =
      checker.Fault(document["schema"], schema["properties"]["schema"], "schema");
    if (!fault.empty())
    {
      return fault;
    }
  }
  return checker.Fault(document, schema, "");
}
}
