#include "grader/grade/source_hints.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

TEST(SourceHints, WholeNumbersAreDividedWithoutAPoint) {
  for (const char* whole : {"x = 3 / 8 * y;", "u = 3/16;", "return 3 / (8 * n);", "u = 3 / n;"})
    EXPECT_TRUE(divides_whole_numbers(whole)) << whole;
  for (const char* real : {"x = 3.0 / 8.0;", "x = 3. / 8;", "x = 3 / 8.0;",
                           "x = 3 / (8.0 * n);", "x = sum / 2;", "// 3 / 8", "x = .375;"}) {
    EXPECT_FALSE(divides_whole_numbers(real)) << real;
  }
}

TEST(SourceHints, StaticVariableIsNamedWithItsLine) {
  EXPECT_EQ(find_static_variable("void f() {\n  static int calls = 0;\n}\n"),
            "line 2: static int calls = 0");
  EXPECT_EQ(find_static_variable("static const int n = 4;\nstatic int f(int x);\n"), "");
  EXPECT_EQ(find_static_variable("// static int calls = 0;\n"), "");
}

TEST(SourceHints, FreeFunctionIsADefinitionWithoutItsClass) {
  const std::string free = "int x;\nstd::vector<P> evaluateStep(const V& points) {\n}\n";
  EXPECT_EQ(find_free_function(free, "evaluateStep"), 2);
  EXPECT_EQ(find_free_function("V B::evaluateStep(const V& p) const {\n}\n", "evaluateStep"),
            0);
  EXPECT_EQ(find_free_function("void f() {\n  evaluateStep(p);\n}\n", "evaluateStep"), 0);
  EXPECT_EQ(find_free_function("V evaluateStep(V p);\n", "evaluateStep"), 0);
}

TEST(SourceHints, FileMayBeAsLongAsItLikes) {
  const std::string space(300'000, ' ');
  const std::string digits(300'000, '7');
  EXPECT_FALSE(divides_whole_numbers("x = 3" + space + "/ 8.0; y = " + digits + ";"));
  EXPECT_FALSE(divides_whole_numbers("x = 3 / (" + digits));
  EXPECT_EQ(find_static_variable("static int table[] = {" + digits + "};").size(), 88U);
  EXPECT_EQ(find_free_function("int step" + space + "(int x) {}", "step"), 0);
}

TEST(SourceHints, TextTellsWholeNumbersFromAPointThatIsNotSet) {
  const Misconception whole{"integer-division", ""};
  const Misconception unset{"new-position-not-set", ""};
  for (const bool divides : {true, false}) {
    Submission submission;
    submission.sources = {{"a.cpp", std::string("void M::upsample() { x = 3 / 8") +
                                        (divides ? "" : ".0") + "; }\n"}};
    JudgedExercise exercise;
    exercise.cases.resize(1);
    Finding finding;
    finding.likely = {unset, whole};
    exercise.cases[0].judgement.findings = {finding};
    tell_apart_by_source(submission, {"M::upsample"}, exercise);
    const Misconceptions& likely = exercise.cases[0].judgement.findings[0].likely;
    ASSERT_EQ(likely.size(), 1U);
    EXPECT_EQ(likely[0].name, divides ? whole.name : unset.name);
  }
}

}  // namespace
}  // namespace meshgrade
