// The command line of volumebench-run.
#ifndef volumebench_Options_h
#define volumebench_Options_h

#include <stdexcept>
#include <string>
#include <vector>

namespace volumebench
{
struct Options
{
  bool Help = false;
  bool Version = false;
  bool Calibrate = false;
  bool CheckCuda = false;
  bool Quick = false;
  bool List = false; // the runs of the study, without measuring
  std::string Study;
  std::string Out;
  std::string Data;
  std::vector<std::string> Techniques; // empty: the study's
  int Device = -1;                     // as ChooseEglDevice takes it
};

/// Throws std::runtime_error that names the argument at fault.
Options ParseOptions(const std::vector<std::string>& arguments);

/// What --help prints.
const char* Usage();
}

#endif
