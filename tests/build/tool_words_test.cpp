#include "grader/build/tool_words.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

ProcessResult failed(const std::string& output) {
  ProcessResult result;
  result.status = 1;
  result.output = output;
  return result;
}

TEST(DeadCompiler, IsKnownByItsWordsOrASignal) {
  EXPECT_TRUE(is_dead_compiler(failed("a.cpp:3:1: internal compiler error: in tsubst\n")));
  EXPECT_TRUE(
      is_dead_compiler(failed("g++: fatal error: Killed signal terminated program cc1plus\n"
                              "compilation terminated.\n")));
  ProcessResult killed;
  killed.signal = 9;
  EXPECT_TRUE(is_dead_compiler(killed));
}

TEST(DeadCompiler, IsNotWhatTheCodeSaysAboutIt) {
  EXPECT_FALSE(
      is_dead_compiler(failed("a.cpp:1:2: error: #error x: internal compiler error: in tsubst\n"
                              "    1 | #error x: internal compiler error: in tsubst\n")));
  ProcessResult slow;
  slow.timed_out = true;
  slow.signal = 9;
  EXPECT_FALSE(is_dead_compiler(slow));
  EXPECT_FALSE(is_dead_compiler(ProcessResult{}));
}

TEST(ExplainLinkError, NamesTheFunctionAndTheOtherFile) {
  EXPECT_EQ(
      explain_link_error("/usr/bin/ld: b.cpp.o: in function `helper(int)':\n"
                         "b.cpp:(.text+0x0): multiple definition of `meshedit::helper(int)'; "
                         "a.cpp.o:a.cpp:(.text+0x0): first defined here\n"),
      "meshedit::helper is defined in a.cpp as well; make one of them static, or rename "
      "it");
  EXPECT_EQ(explain_link_error("b.cpp:(.text+0x0): multiple definition of `run()'; "
                               "kit/libworker.a(run.cpp.o):run.cpp:(.text+0x0): first defined "
                               "here\n"),
            "run is defined in the grader as well; make one of them static, or rename it");
}

TEST(ExplainLinkError, HasNothingToSayAboutOtherErrors) {
  EXPECT_EQ(explain_link_error("a.cpp:1: undefined reference to `f()'\n"), "");
  EXPECT_EQ(explain_link_error(""), "");
}

}  // namespace
}  // namespace meshgrade
