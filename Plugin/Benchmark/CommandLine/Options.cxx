#include "Options.h"

#include <functional>
#include <map>

namespace volumebench
{
namespace
{
[[noreturn]] void Fail(const std::string& what)
{
  throw std::runtime_error("command line: " + what + " (--help lists the options)");
}

std::vector<std::string> Names(const std::string& text)
{
  std::vector<std::string> names;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(',', begin);
    const std::string name = text.substr(begin, end - begin);
    if (name.empty())
    {
      Fail("--techniques " + text + ": an id is empty");
    }
    names.push_back(name);
  }
  return names;
}

int DeviceNumber(const std::string& text)
{
  if (text.empty() || text.size() > 3 || text.find_first_not_of("0123456789") != std::string::npos)
  {
    Fail("--device " + text + ": not the number of a device");
  }
  return std::stoi(text);
}

void Check(const Options& options)
{
  if (options.Help || options.Version)
  {
    return;
  }
  if (options.Calibrate && options.CheckCuda)
  {
    Fail("--calibrate and --check-cuda are two runs");
  }
  const bool alone = options.Calibrate || options.CheckCuda;
  const std::string what = options.CheckCuda ? "--check-cuda" : "--calibrate";
  if (alone == !options.Study.empty())
  {
    Fail(alone ? what + " takes no study" : "a study file or --calibrate is needed");
  }
  if (alone && (!options.Data.empty() || !options.Techniques.empty()))
  {
    Fail("--data and --techniques do not apply to " + what);
  }
  if (alone && options.List)
  {
    Fail("--list does not apply to " + what);
  }
  if (!alone && !options.List && options.Out.empty())
  {
    Fail("--out DIR is needed");
  }
}
}

Options ParseOptions(const std::vector<std::string>& arguments)
{
  Options options;
  const std::map<std::string, bool*> switches = { { "--help", &options.Help },
    { "--version", &options.Version }, { "--calibrate", &options.Calibrate },
    { "--check-cuda", &options.CheckCuda }, { "--quick", &options.Quick },
    { "--list", &options.List } };
  const std::map<std::string, std::function<void(const std::string&)>> values = {
    { "--out", [&](const std::string& text) { options.Out = text; } },
    { "--data", [&](const std::string& text) { options.Data = text; } },
    { "--techniques", [&](const std::string& text) { options.Techniques = Names(text); } },
    { "--device", [&](const std::string& text) { options.Device = DeviceNumber(text); } }
  };
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    if (switches.count(argument))
    {
      *switches.at(argument) = true;
    }
    else if (values.count(name))
    {
      if (equals == std::string::npos && ++i == arguments.size())
      {
        Fail(name + " needs a value");
      }
      values.at(name)(equals == std::string::npos ? arguments[i] : argument.substr(equals + 1));
    }
    else if (argument.rfind('-', 0) == 0 || !options.Study.empty())
    {
      Fail("'" + argument + "' is not known");
    }
    else
    {
      options.Study = argument;
    }
  }
  Check(options);
  return options;
}

const char* Usage()
{
  return R"(volumebench-run: measures volume rendering where there is no ParaView and no X server

  volumebench-run STUDY.json --out DIR [--data DIR] [--techniques A,B] [--quick]
      measures path "engine" of a study; results.json and settings.json in DIR
  volumebench-run STUDY.json --list [...]
      prints the runs, one a line as JSON, without measuring
  volumebench-run --calibrate [--out FILE] [--quick]
      measures what this machine can fetch and copy a second (FILE: calibration.json)

  volumebench-run --check-cuda [--out FILE] [--quick]
      tells whether technique cuda is right on this device, what turning voxels takes by slices to a
      block, and the registers of its kernels; needs no OpenGL (FILE: cuda-check.json)

  --data DIR     folder with volumes and transfer functions, searched by name
  --techniques   these in place of the study's
  --quick        what the study calls quick; a calibration of a few seconds
  --device N     EGL device N, counted from 0; default: the first that works
  --version, --help

Exit code 1: every row failed, or a check; 2: bad input or no OpenGL, told in one line.
)";
}
}
