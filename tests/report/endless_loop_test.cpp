#include "grader/report/endless_loop.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

int told_line(const std::string& source, int line) {
  const auto loop = enclosing_loop(source, line);
  return loop ? loop->line : 0;
}

TEST(EndlessLoop, IsTheOneAroundTheLine) {
  EXPECT_EQ(told_line("void f() {\n  while (go()) {\n    step();\n  }\n  end();\n}\n", 3), 2);
  EXPECT_EQ(told_line("void f() {\n  while (go()) {\n    step();\n  }\n  end();\n}\n", 5), 0);
}

TEST(EndlessLoop, OfDoHasItsLineAtTheEnd) {
  EXPECT_EQ(told_line("void f() {\n  do {\n    step();\n  } while (go());\n}\n", 3), 4);
}

TEST(EndlessLoop, NeedsNoBraces) {
  EXPECT_EQ(told_line("void f() {\n  while (go())\n    step(\n      1);\n  end();\n}\n", 4), 2);
  EXPECT_EQ(told_line("void f() {\n  while (go())\n    step();\n  end();\n}\n", 4), 0);
}

TEST(EndlessLoop, IsNotTheOneThatCounts) {
  const std::string nested =
      "void f() {\n  while (go()) {\n    for (int i = 0; i < 9; ++i) {\n      step();\n    }\n"
      "  }\n}\n";
  EXPECT_EQ(told_line(nested, 4), 2);
  const std::string empty = "void f() {\n  for (;;) {\n    step();\n  }\n}\n";
  ASSERT_TRUE(enclosing_loop(empty, 3));
  EXPECT_FALSE(enclosing_loop(empty, 3)->counts);
}

TEST(EndlessLoop, IsTheOneThatCountsIfThereIsNoOther) {
  const std::string counting =
      "void f() {\n  for (auto e = b(); e != end(); ++e)\n    split(e);\n}";
  ASSERT_TRUE(enclosing_loop(counting, 3));
  EXPECT_EQ(enclosing_loop(counting, 3)->line, 2);
  EXPECT_TRUE(enclosing_loop(counting, 3)->counts);
}

TEST(EndlessLoop, IsNoWordInACommentOrAString) {
  EXPECT_EQ(
      told_line("void f() {\n  // while (true) {\n  say(\"for (;;) {\");\n  end();\n}\n", 4),
      0);
}

TEST(EndlessLoop, SurvivesBracesThatDoNotClose) {
  EXPECT_EQ(told_line("void f() {\n  while (go() {\n    step();\n", 3), 2);
  EXPECT_EQ(told_line("do", 1), 1);
  EXPECT_EQ(told_line("for", 1), 1);
}

}  // namespace
}  // namespace meshgrade
