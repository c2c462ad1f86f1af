#include "Gpu/KernelSpecializer.h"

#include <gtest/gtest.h>

#include <map>

using namespace volumebench;

namespace
{
KernelLookup LookupIn(const std::map<std::string, std::string>& files)
{
  return [files](const std::string& path) -> const char*
  {
    static std::map<std::string, std::string> kept; // the pointers must outlive the call
    kept = files;
    const auto found = kept.find(path);
    return found == kept.end() ? nullptr : found->second.c_str();
  };
}
}

TEST(KernelSpecializer, ExpandsIncludesAndNumbersLines)
{
  const auto lookup = LookupIn(
    { { "main.frag", "one\n  # include \"Shared/a.h\"\nthree\n" }, { "Shared/a.h", "A\n" } });
  const KernelText text = SpecializeKernel("main.frag", "#version 330", lookup);
  EXPECT_EQ(text.Source, "#version 330\n#line 1 0\none\n#line 100001 1\nA\n#line 3 0\nthree\n");
  EXPECT_EQ(text.Files, (std::vector<std::string>{ "main.frag", "Shared/a.h" }));
}

TEST(KernelSpecializer, IncludesTheSameFileTwice)
{
  const auto lookup = LookupIn({ { "m", "#include \"a\"\n#include \"a\"\n" }, { "a", "x\n" } });
  const KernelText text = SpecializeKernel("m", "", lookup);
  EXPECT_EQ(text.Source, "#line 1 0\n#line 100001 1\nx\n#line 2 0\n#line 100001 1\nx\n#line 3 0\n");
}

TEST(KernelSpecializer, NumbersLinesByFileNameForTheCLanguages)
{
  const auto lookup =
    LookupIn({ { "main.cl", "one\n#include \"Shared/a.h\"\nthree\n" }, { "Shared/a.h", "A\n" } });
  EXPECT_EQ(SpecializeKernel("main.cl", "", lookup, LineStyle::Names).Source,
    "#line 1 \"main.cl\"\none\n#line 1 \"Shared/a.h\"\nA\n#line 3 \"main.cl\"\nthree\n");
}

TEST(KernelSpecializer, LeavesOtherLinesAlone)
{
  const auto lookup = LookupIn({ { "m", "// #include \"a\"\n#if X\n" } });
  EXPECT_EQ(SpecializeKernel("m", "", lookup).Source, "#line 1 0\n// #include \"a\"\n#if X\n");
}

TEST(KernelSpecializer, NamesAMissingFileAndWhoIncludesIt)
{
  const auto lookup = LookupIn({ { "m", "\n#include \"gone.h\"\n" } });
  try
  {
    SpecializeKernel("m", "", lookup);
    FAIL() << "no error";
  }
  catch (const KernelError& error)
  {
    EXPECT_STREQ(error.what(), "kernel file gone.h is missing; m:2 includes it");
  }
}

TEST(KernelSpecializer, RefusesFilesThatIncludeEachOther)
{
  const auto lookup = LookupIn({ { "a", "#include \"b\"\n" }, { "b", "#include \"a\"\n" } });
  EXPECT_THROW(SpecializeKernel("a", "", lookup), KernelError);
}

TEST(KernelSpecializer, NamesFilesInCompilerLogs)
{
  const std::vector<std::string> files{ "SinglePass.frag", "Shared/Ray.h" };
  EXPECT_EQ(NameFilesInLog("1:100014(3): error: no\n", files), "Shared/Ray.h:14(3): error: no\n");
  EXPECT_EQ(NameFilesInLog("0(7) : error C0000\n", files), "SinglePass.frag:7 : error C0000\n");
  EXPECT_EQ(NameFilesInLog("ERROR: 1:100002: 'x'\n", files), "Shared/Ray.h:2: 'x'\n");
  // As Mesa says it, which forgets the file number.
  EXPECT_EQ(NameFilesInLog("0:100014(3): error: no\n", files), "Shared/Ray.h:14(3): error: no\n");
  EXPECT_EQ(NameFilesInLog("9:900014(3): error\n", files), "9:900014(3): error\n");
}

TEST(KernelSpecializer, FindsTheEmbeddedKernels)
{
  ASSERT_NE(EmbeddedKernel("Shared/Integrate.h"), nullptr);
  EXPECT_EQ(EmbeddedKernel("Shared/None.h"), nullptr);
  for (const std::string& path : EmbeddedKernelPaths())
  {
    EXPECT_NE(EmbeddedKernel(path), nullptr) << path;
  }
}
