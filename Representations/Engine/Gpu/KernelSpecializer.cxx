#include "Gpu/KernelSpecializer.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace volumebench
{
namespace
{
class Expander
{
public:
  Expander(const KernelLookup& lookup, KernelText& text, LineStyle style)
    : Lookup(lookup)
    , Text(text)
    , Style(style)
  {
  }

  void Expand(const std::string& path, const std::string& includedFrom)
  {
    const char* source = this->Lookup(path);
    if (!source)
    {
      throw KernelError("kernel file " + path + " is missing" +
        (includedFrom.empty() ? "" : "; " + includedFrom + " includes it"));
    }
    if (std::find(this->Open.begin(), this->Open.end(), path) != this->Open.end())
    {
      throw KernelError("kernel file " + path + " includes itself through " + includedFrom);
    }
    this->Open.push_back(path);
    const std::size_t number = this->NumberOf(path);
    this->EmitLine(1, number);
    std::istringstream lines(source);
    std::string line;
    for (int lineNumber = 1; std::getline(lines, line); ++lineNumber)
    {
      this->ExpandLine(line, path, lineNumber, number);
    }
    this->Open.pop_back();
  }

private:
  void ExpandLine(
    const std::string& line, const std::string& path, int lineNumber, std::size_t fileNumber)
  {
    static const std::regex include(R"re(^\s*#\s*include\s*"([^"]+)"\s*$)re");
    std::smatch match;
    if (std::regex_match(line, match, include))
    {
      this->Expand(match[1], path + ":" + std::to_string(lineNumber));
      this->EmitLine(lineNumber + 1, fileNumber);
    }
    else
    {
      this->Text.Source += line + "\n";
    }
  }

  void EmitLine(int line, std::size_t file)
  {
    if (this->Style == LineStyle::Names)
    {
      this->Text.Source +=
        "#line " + std::to_string(line) + " \"" + this->Text.Files[file] + "\"\n";
      return;
    }
    const std::size_t number = file * LinesPerFile + line;
    this->Text.Source += "#line " + std::to_string(number) + " " + std::to_string(file) + "\n";
  }

  std::size_t NumberOf(const std::string& path)
  {
    std::vector<std::string>& files = this->Text.Files;
    const auto found = std::find(files.begin(), files.end(), path);
    if (found != files.end())
    {
      return found - files.begin();
    }
    files.push_back(path);
    return files.size() - 1;
  }

  const KernelLookup& Lookup;
  KernelText& Text;
  const LineStyle Style;
  std::vector<std::string> Open;
};
}

KernelText SpecializeKernel(const std::string& entry, const std::string& preamble,
  const KernelLookup& lookup, LineStyle style)
{
  KernelText text;
  text.Source = preamble;
  if (!preamble.empty() && preamble.back() != '\n')
  {
    text.Source += '\n';
  }
  Expander(lookup, text, style).Expand(entry, "");
  return text;
}

std::string NameFilesInLog(const std::string& log, const std::vector<std::string>& files)
{
  static const std::regex place(R"re(^(ERROR: |WARNING: )?(\d+)[:(](\d+)\)?)re");
  std::istringstream lines(log);
  std::string result;
  std::string line;
  while (std::getline(lines, line))
  {
    std::smatch match;
    if (std::regex_search(line, match, place))
    {
      const std::size_t number = std::stoul(match[3]);
      const std::size_t file = number / LinesPerFile;
      if (file < files.size())
      {
        line = files[file] + ":" + std::to_string(number % LinesPerFile) + match.suffix().str();
      }
    }
    result += line + "\n";
  }
  return result;
}

std::string OneLine(const std::string& log)
{
  constexpr std::size_t Longest = 300;
  std::istringstream lines(log);
  std::string result;
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.find_first_not_of(" \t\r") != std::string::npos)
    {
      result += (result.empty() ? "" : "; ") + line;
    }
  }
  return result.size() > Longest ? result.substr(0, Longest) + " ..." : result;
}
}
