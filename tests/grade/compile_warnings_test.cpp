// A warning of the compiler stands with the failures of the function that it is about, and
// nowhere else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::Not;

Report grade_sources(const std::vector<SourceFile>& sources,
                     const std::vector<std::string>& exercises) {
  Submission submission;
  submission.sources = sources;
  return grade(read_assignment(standard_assignment()), submission, find_home(), exercises,
               [](const std::string&) {});
}

/// `last` stands in line 6, the brace that ends the function in line 7.
SourceFile normal(const std::string& last, const std::string& helper = "") {
  return {"vertex_normal.cpp", "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n" +
                                   helper +
                                   "\nVector3D Vertex::normal() const {\n"
                                   "  if (degree() == 3) return Vector3D(0, 0, 1);\n  " +
                                   last + "\n}\n}\n"};
}

std::size_t count_with_first_rule(const ExerciseReport& exercise, const std::string& rule) {
  std::size_t count = 0;
  for (const CaseReport& c : exercise.cases)
    count += !c.findings.empty() && c.findings[0].finding.rule == rule ? 1 : 0;
  return count;
}

std::size_t count_failed(const ExerciseReport& exercise) {
  std::size_t count = 0;
  for (const CaseReport& c : exercise.cases)
    count += c.verdict != Verdict::kPassed ? 1 : 0;
  return count;
}

TEST(CompileWarnings, MissingReturnIsTheFirstFindingOfEachFailure) {
  const Report report = grade_sources({normal("")}, {"vertex_normal"});
  const ExerciseReport& exercise = report.exercises.at(0);
  EXPECT_GT(count_failed(exercise), 0U);
  EXPECT_EQ(count_with_first_rule(exercise, "missing-return"), count_failed(exercise));
  for (const CaseReport& c : exercise.cases) {
    if (c.verdict == Verdict::kPassed) continue;
    const FindingReport& first = c.findings.at(0);
    EXPECT_THAT(first.finding.actual, HasSubstr("the compiler warns: "));
    EXPECT_EQ(first.places.at(0).file, "vertex_normal.cpp");
    EXPECT_EQ(first.places.at(0).line, 7);
  }
}

TEST(CompileWarnings, MissingReturnOfAHelperIsFoundAsWell) {
  const Report report =
      grade_sources({normal("return help(degree());",
                            "static Vector3D help(Size n) { if (n == 3) return Vector3D(); }")},
                    {"vertex_normal"});
  const ExerciseReport& exercise = report.exercises.at(0);
  EXPECT_GT(count_failed(exercise), 0U);
  EXPECT_EQ(count_with_first_rule(exercise, "missing-return"), count_failed(exercise));
}

TEST(CompileWarnings, WarningStandsWithTheFailuresOfItsFunctionAlone) {
  const SourceFile warned = normal("int unused; return Vector3D();");
  const SourceFile other{"other.cpp",
                         "static int far() { int other; return 1; }\n"
                         "int near() { return far(); }\n"};
  const Report report = grade_sources({warned, other}, {"vertex_normal", "edge_flip"});
  EXPECT_THAT(report.exercises.at(0).notes.at(0),
              HasSubstr("the compiler warns: vertex_normal.cpp:6: unused variable"));
  EXPECT_EQ(report.exercises.at(0).notes.size(), 1U);
  EXPECT_TRUE(report.exercises.at(1).notes.empty());
  TerminalStyle all;
  all.verbose = true;
  EXPECT_THAT(to_terminal(report, all), Not(HasSubstr("other.cpp")));
}

TEST(CompileWarnings, OfAFileThatDoesNotCompileTheFirstErrorIsShownFirst) {
  const Report report =
      grade_sources({{"a.cpp", "static int f() { int unused; return 1; }\nint b = nothing;\n"}},
                    {"vertex_normal"});
  const std::string text = to_terminal(report, {});
  EXPECT_THAT(text, HasSubstr("a.cpp:2:9: error: "));
  EXPECT_THAT(text, Not(HasSubstr("unused")));
}

}  // namespace
}  // namespace meshgrade
