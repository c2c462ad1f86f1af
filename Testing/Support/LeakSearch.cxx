// Has lost memory searched for as soon as all tests of a program have ended, before what it holds
// is torn down.
#include <gtest/gtest.h>
#include <sanitizer/lsan_interface.h>

namespace
{
class LeakSearch : public testing::Environment
{
public:
  void TearDown() override { __lsan_do_leak_check(); }
};

[[maybe_unused]] const testing::Environment* const Search =
  testing::AddGlobalTestEnvironment(new LeakSearch);
}
