// The schemas that the program carries: every keyword is known, and each fault is found and named.
#include "Study/EmbeddedFiles.h"
#include "Study/JsonFile.h"
#include "Study/JsonSchema.h"
#include "Study/StudyDocument.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
Json SchemaOf(const std::string& name)
{
  return ParseJson(EmbeddedFile("Python/volumebench/" + name), name);
}

std::string FaultOf(const char* schema, const char* document)
{
  return FindSchemaFault(Json::parse(document), Json::parse(schema));
}

void ExpectFault(const char* schema, const char* document, const std::string& cause)
{
  const std::string fault = FaultOf(schema, document);
  EXPECT_NE(fault.find(cause), std::string::npos)
    << document << " against " << schema << ": '" << fault << "' lacks '" << cause << "'";
}

std::string ParseFault(const std::string& text)
{
  try
  {
    ParseJson(text, "file.json");
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}
}

TEST(JsonSchema, AcceptsWhatTheProjectShips)
{
  for (const std::string& name : EmbeddedNames("Data/TransferFunctions"))
  {
    const std::string path = "Data/TransferFunctions/" + name + ".json";
    EXPECT_EQ(FindSchemaFault(
                ParseJson(EmbeddedFile(path), path), SchemaOf("transfer_function_schema.json")),
      "")
      << path;
  }
  int studies = 0;
  for (const std::string& name : EmbeddedNames("Python/Studies"))
  {
    const std::string path = "Python/Studies/" + name + ".json";
    const Json study = ParseJson(EmbeddedFile(path), path);
    if (!study.contains("kind"))
    {
      EXPECT_EQ(FindSchemaFault(study, SchemaOf("study_schema.json")), "") << path;
      ++studies;
    }
  }
  EXPECT_GE(studies, 3);
}

// A key that Python's schema gains must not be ignored here.
TEST(JsonSchema, EveryKeyOfAStudyIsHeeded)
{
  const auto schema = SchemaOf("study_schema.json"); // items() refers to it
  for (const auto& [key, rule] : schema["properties"].items())
  {
    EXPECT_TRUE(IsStudyKey(key)) << key;
  }
}

TEST(JsonSchema, FaultsAreFoundAndNamed)
{
  ExpectFault(R"({"type": "object"})", "[]", "not of type");
  ExpectFault(R"({"type": ["string", "null"]})", "1", "not of type");
  ExpectFault(R"({"type": "integer"})", "1.5", "not of type");
  ExpectFault(R"({"const": 1})", "2", "2 is not 1");
  ExpectFault(R"({"enum": ["a", "b"]})", "\"c\"", "not one of");
  ExpectFault(R"({"minimum": 2})", "1", "below 2");
  ExpectFault(R"({"maximum": 2})", "2.5", "above 2");
  ExpectFault(R"({"exclusiveMinimum": 0})", "0", "not above 0");
  ExpectFault(R"({"exclusiveMaximum": 1})", "1", "not below 1");
  ExpectFault(R"({"minItems": 1})", "[]", "too short");
  ExpectFault(R"({"maxItems": 1})", "[1, 2]", "too long");
  ExpectFault(R"({"uniqueItems": true})", "[1, 2, 1]", "twice");
  ExpectFault(R"({"items": {"type": "number"}})", R"([1, "x"])", "\"[1]\"");
  ExpectFault(R"({"items": [{"type": "number"}, {"maximum": 1}]})", "[5, 5]", "\"[1]\"");
  ExpectFault(R"({"required": ["a"]})", "{}", "\"a\" is missing");
  ExpectFault(R"({"properties": {"a": {"properties": {"b": {"minimum": 1}}}}})",
    R"({"a": {"b": 0}})", "\"a.b\"");
  ExpectFault(
    R"({"properties": {"a": {}}, "additionalProperties": false})", R"({"c": 1})", "\"c\"");
  ExpectFault(R"({"additionalProperties": {"minimum": 1}})", R"({"c": 0})", "\"c\"");
  ExpectFault(R"({"minProperties": 1})", "{}", "too few");
  ExpectFault(R"({"minLength": 1})", "\"\"", "too short");
  ExpectFault(R"({"maxLength": 1})", "\"ab\"", "too long");
  ExpectFault(R"({"pattern": "^a"})", "\"b\"", "not such a text");
  ExpectFault(R"({"oneOf": [{"type": "null"}, {"type": "number"}]})", "true", "none of these");
  ExpectFault(
    R"({"definitions": {"d": {"minimum": 3}}, "$ref": "#/definitions/d"})", "1", "below 3");
  ExpectFault(R"({"description": "two", "const": 2})", "1", "(expected: two)");
  ExpectFault(R"({"required": ["a"], "properties": {"schema": {"const": 1}}})", R"({"schema": 2})",
    "\"schema\"");
}

TEST(JsonSchema, WhatFitsPasses)
{
  const char* schema = R"({"type": "object", "required": ["a"], "additionalProperties": false,
    "properties": {"a": {"type": "array", "minItems": 1, "items": {"type": "integer", "minimum": 0}},
    "b": {"oneOf": [{"type": "null"}, {"type": "string", "pattern": "^x"}]}}})";
  EXPECT_EQ(FaultOf(schema, R"({"a": [1, 2.0], "b": "xy"})"), "");
  EXPECT_EQ(FaultOf(schema, R"({"a": [0], "b": null})"), "");
}

TEST(JsonSchema, AnUnknownKeywordIsOurFault)
{
  EXPECT_THROW(FindSchemaFault(1, Json::parse(R"({"multipleOf": 2})")), std::logic_error);
}

TEST(JsonFile, FaultsNameFileAndPlace)
{
  EXPECT_EQ(ParseFault("{\n \"a\": 1,\n \"b\" 2}"), "file.json: line 3, column 6: not valid JSON");
  EXPECT_NE(
    ParseFault(R"({"a": {"b": 1, "b": 2}})").find("\"b\" appears twice"), std::string::npos);
  EXPECT_EQ(ParseFault(R"({"a": {"b": 1}, "b": [{"b": 2}, {"b": 3}]})"), "");
  EXPECT_NE(ParseFault(R"({"a": NaN})"), "");
  EXPECT_NE(ParseFault(R"({"a": 1e999})"), "");
  EXPECT_NE(ParseFault(""), "");
}
