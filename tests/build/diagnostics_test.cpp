#include "grader/build/diagnostics.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

const char* const kOfGcc =
    "In file included from mine.h:1,\n"
    "                 from a.cpp:2:\n"
    "other.h:3:5: warning: unused variable 'x' [-Wunused-variable]\n"
    "    3 | int x;\n"
    "      |     ^\n"
    "a.cpp: In function 'int f()':\n"
    "a.cpp:5:7: warning: unused variable 'y' [-Wunused-variable]\n"
    "    5 |   int y;\n"
    "a.cpp:5:7: note: declared here\n"
    "a.cpp:6:3: error: 'z' was not declared in this scope\n"
    "    6 |   z = 1;\n"
    "a.cpp:6:3: note: suggested alternative\n"
    "a.cpp:7:1: warning: no return statement in function returning non-void [-Wreturn-type]\n"
    "a.cpp:8:3: error: expected ';'\n";

TEST(Diagnostics, FirstErrorComesFirstWithItsFunction) {
  EXPECT_EQ(without_warnings(kOfGcc),
            "a.cpp: In function 'int f()':\n"
            "a.cpp:6:3: error: 'z' was not declared in this scope\n"
            "    6 |   z = 1;\n"
            "a.cpp:6:3: note: suggested alternative\n"
            "a.cpp:8:3: error: expected ';'\n");
}

TEST(Diagnostics, FormOfClangIsUnderstood) {
  const std::string messages =
      "a.cpp:5:7: warning: unused variable 'y' [-Wunused-variable]\n"
      "  int y;\n"
      "      ^\n"
      "In file included from a.cpp:2:\n"
      "./mine.h:6:3: error: use of undeclared identifier 'z'\n"
      "z = 1;\n"
      "^\n"
      "1 warning and 1 error generated.\n";
  EXPECT_EQ(without_warnings(messages),
            "In file included from a.cpp:2:\n"
            "./mine.h:6:3: error: use of undeclared identifier 'z'\n"
            "z = 1;\n"
            "^\n"
            "1 warning and 1 error generated.\n");
}

TEST(Diagnostics, WhatTheLinkerSaysStays) {
  const std::string linker =
      "/usr/bin/ld: ./a.cpp:12: undefined reference to `f()'\n"
      "collect2: error: ld returned 1 exit status\n";
  EXPECT_EQ(without_warnings(linker), linker);
  const std::string both = "a.cpp:1:1: error: x\na.cpp:2:1: warning: y [-Wz]\n" + linker;
  EXPECT_EQ(without_warnings(both), "a.cpp:1:1: error: x\n" + linker);
}

TEST(Diagnostics, WithoutAnErrorNothingIsLost) {
  const std::string limit = "compiling took longer than 2 seconds and was stopped\n";
  EXPECT_EQ(without_warnings(limit), limit);
  const std::string warning = "a.cpp:1:1: warning: y [-Wz]\n";
  EXPECT_EQ(without_warnings(warning), warning);
  EXPECT_EQ(without_warnings(""), "");
}

TEST(Diagnostics, WarningsHavePlaceTextAndOption) {
  const std::vector<CompilerWarning> warnings = warnings_in(kOfGcc);
  ASSERT_EQ(warnings.size(), 3U);
  EXPECT_EQ(warnings[0].file, "other.h");
  EXPECT_EQ(warnings[2].file, "a.cpp");
  EXPECT_EQ(warnings[2].line, 7);
  EXPECT_EQ(warnings[2].text, "no return statement in function returning non-void");
  EXPECT_EQ(warnings[2].option, "-Wreturn-type");
}

}  // namespace
}  // namespace meshgrade
