#include "Command.h"

#include <sys/wait.h>

#include <cstdio>
#include <stdexcept>

namespace
{
constexpr int FirstShellError = 126; // 126: not executable, 127: not found, above: a signal

std::string Quoted(const std::string& word)
{
  std::string quoted = "'";
  for (const char c : word)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}
}

CommandResult RunCommand(const std::vector<std::string>& words)
{
  std::string line;
  for (const std::string& word : words)
  {
    line += Quoted(word) + " ";
  }
  FILE* pipe = popen((line + "2>&1 </dev/null").c_str(), "r");
  if (!pipe)
  {
    throw std::runtime_error("cannot start " + line);
  }
  CommandResult result{ 0, "" };
  char buffer[4096];
  for (std::size_t count; (count = fread(buffer, 1, sizeof(buffer), pipe)) > 0;)
  {
    result.Output.append(buffer, count);
  }
  const int status = pclose(pipe);
  result.ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : FirstShellError;
  if (result.ExitCode >= FirstShellError)
  {
    throw std::runtime_error("cannot run " + line + "\n" + result.Output);
  }
  return result;
}
