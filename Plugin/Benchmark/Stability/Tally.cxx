#include "Stability/Tally.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace volumebench
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::string Formatted(const char* format, double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}

double RatioOf(double error, double limit)
{
  if (std::isnan(error))
  {
    return Infinity;
  }
  return error > 0.0 ? error / limit : 0.0;
}
}

Tally::Tally()
  : Error(NotANumber)
  , Limit(NotANumber)
{
}

void Tally::Note(double error, double limit, const std::string& what)
{
  const double ratio = RatioOf(error, limit);
  const bool firstNan = std::isnan(error) && !std::isnan(this->Error);
  ++this->Count;
  if (ratio > this->Ratio || firstNan)
  {
    this->Ratio = ratio;
    this->Error = error;
    this->Limit = limit;
    this->What = what;
  }
}

void Tally::Remark(const std::string& sentence)
{
  this->Remarks += (this->Remarks.empty() ? "" : " ") + sentence;
}

bool Tally::IsPassed() const
{
  return this->Count > 0 && this->Ratio <= 1.0;
}

std::string Tally::Text() const
{
  if (this->Count == 0)
  {
    return this->Remarks;
  }
  std::string text = "Worst of " + std::to_string(this->Count) + ": " + this->What + ", " +
    ErrorText(this->Error) + " against " + ErrorText(this->Limit) + ".";
  return this->Remarks.empty() ? text : text + " " + this->Remarks;
}

double ObservedOrder(const std::vector<double>& errors)
{
  if (errors.size() < 2)
  {
    return NotANumber;
  }
  for (const double error : errors)
  {
    if (!(error > 0.0))
    {
      return NotANumber;
    }
  }
  return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

std::string ErrorText(double error)
{
  return Formatted("%.2g", error);
}

std::string PlainText(double number)
{
  return Formatted("%g", number);
}
}
