// The command line of volumebench-run: what is taken, and that what is not is named.
#include "Options.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
std::string FaultOf(const std::vector<std::string>& arguments)
{
  try
  {
    ParseOptions(arguments);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

void ExpectFault(const std::vector<std::string>& arguments, const std::string& cause)
{
  const std::string fault = FaultOf(arguments);
  EXPECT_NE(fault.find(cause), std::string::npos) << "'" << fault << "' lacks '" << cause << "'";
}
}

TEST(Options, AreTakenInBothForms)
{
  const Options options = ParseOptions(
    { "demo.json", "--out=results", "--techniques", "compute,slices", "--quick", "--device=2" });
  EXPECT_EQ(options.Study, "demo.json");
  EXPECT_EQ(options.Out, "results");
  EXPECT_EQ(options.Techniques, (std::vector<std::string>{ "compute", "slices" }));
  EXPECT_TRUE(options.Quick);
  EXPECT_FALSE(options.Calibrate);
  EXPECT_EQ(options.Device, 2);
}

TEST(Options, FaultsNameTheArgument)
{
  ExpectFault({}, "a study file or --calibrate");
  ExpectFault({ "a.json" }, "--out DIR");
  ExpectFault({ "a.json", "b.json", "--out", "x" }, "'b.json'");
  ExpectFault({ "a.json", "--out" }, "--out needs a value");
  ExpectFault({ "a.json", "--out", "x", "--speed" }, "'--speed'");
  ExpectFault({ "a.json", "--out", "x", "--quick=1" }, "'--quick=1'");
  ExpectFault({ "a.json", "--out", "x", "--device", "-1" }, "--device -1");
  ExpectFault({ "a.json", "--out", "x", "--techniques", "a,,b" }, "--techniques a,,b");
  ExpectFault({ "a.json", "--calibrate" }, "no study");
  ExpectFault({ "--calibrate", "--data", "x" }, "--data");
  EXPECT_EQ(FaultOf({ "--calibrate" }), "");
  ExpectFault({ "--check-cuda", "--calibrate" }, "two runs");
  ExpectFault({ "a.json", "--check-cuda" }, "--check-cuda takes no study");
  ExpectFault({ "--check-cuda", "--techniques", "cuda" }, "do not apply to --check-cuda");
  EXPECT_EQ(FaultOf({ "--check-cuda", "--out", "x" }), "");
  EXPECT_EQ(FaultOf({ "--help" }), "");
}
