// Runs a program and keeps what it says.
#ifndef volumebench_Command_h
#define volumebench_Command_h

#include <string>
#include <vector>

struct CommandResult
{
  int ExitCode;
  std::string Output; // stdout and stderr together
};

/// Throws std::runtime_error when the program cannot be started or dies from a signal.
CommandResult RunCommand(const std::vector<std::string>& words);

#endif
