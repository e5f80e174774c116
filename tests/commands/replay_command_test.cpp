// `meshgrade replay` as a student calls it.

#include <iomanip>
#include <sstream>

#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;
using testing::Not;

class ReplayCommand : public CommandLine {};

TEST_F(ReplayCommand, ShowsTheCaseAndFailsWithIt) {
  const Said said = call({"replay", "edge_flip:basic/1", wrong("edge_flip/next_wrong")});
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.output, HasSubstr("edge_flip:basic/1: flip the edge"));
  EXPECT_THAT(said.output, HasSubstr("h3.next"));
}

TEST_F(ReplayCommand, PassesWithTheReference) {
  const Said said = call({"replay", "edge_split:boundary/1", reference()});
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, HasSubstr("passed"));
}

TEST_F(ReplayCommand, IsPrintedByCheckAsACommandThatWorks) {
  const Said check = call({"check", wrong("edge_flip/next_wrong"), "edge_flip"});
  const std::string start = "    again     ./meshgrade replay ";
  const std::size_t at = check.output.find(start);
  ASSERT_NE(at, std::string::npos) << check.output;
  const std::size_t end = check.output.find('\n', at);
  std::istringstream words(check.output.substr(at + start.size(), end - at - start.size()));
  std::string case_id;
  std::string submission;
  words >> case_id >> std::quoted(submission, '\'');
  const Said replay = call({"replay", case_id, submission});
  EXPECT_EQ(replay.status, 1);
  EXPECT_THAT(replay.output, HasSubstr(case_id));
}

TEST_F(ReplayCommand, TakesTheSubmissionThatWasCheckedLast) {
  EXPECT_EQ(call({"replay", "edge_flip:basic/1"}).status, 2);
  call({"check", wrong("edge_flip/next_wrong"), "edge_flip"});
  EXPECT_EQ(call({"replay", "edge_flip:basic/1"}).status, 1);
}

TEST_F(ReplayCommand, TellsOfACaseThatDoesNotExist) {
  const Said said = call({"replay", "edge_flip:basic/100000", reference()});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("edge_flip:basic/100000"));
}

TEST_F(ReplayCommand, SanitizersNameTheLineOfABufferOverflow) {
  write(
      "bezier_curve.cpp",
      "#include \"meshedit/meshedit.h\"\n"
      "namespace meshedit {\n"
      "std::vector<Vector2D> BezierCurve::evaluateStep(const std::vector<Vector2D>& points) {\n"
      "  return {points[0] + points.data()[points.size()]};\n"
      "}\n"
      "}\n");
  const Said said = call({"replay", "bezier_curve:basic/1", folder_.string(), "--sanitize"});
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.output, HasSubstr("heap-buffer-overflow"));
  EXPECT_THAT(said.output,
              HasSubstr("bezier_curve.cpp:4, meshedit::BezierCurve::evaluateStep"));
  EXPECT_THAT(said.output, Not(HasSubstr("/tmp/")));
  EXPECT_THAT(said.output, Not(HasSubstr("grader/worker")));
}

TEST_F(ReplayCommand, SanitizersFindNothingInTheReference) {
  const Said said = call({"replay", "edge_split:stress/1", reference(), "--sanitize"});
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, HasSubstr("the sanitizers found nothing"));
}

TEST_F(ReplayCommand, DebuggerStopsAtTheStudentsFunction) {
  if (std::system("gdb --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "gdb is not installed";
  const Said said =
      call({"replay", "edge_flip:basic/1", wrong("edge_flip/next_wrong"), "--debug"},
           "print 6 * 7\nprint e0\nnext 2\nprint h\nkill\n");
  if (said.output.find("ptrace: Operation not permitted") != std::string::npos) {
    GTEST_SKIP() << "no process may be debugged here";
  }
  EXPECT_THAT(said.output, HasSubstr("hit Breakpoint 1, meshedit::HalfedgeMesh::flipEdge"));
  EXPECT_THAT(said.output, HasSubstr("= 42"));
  // Handles print as the report names them.
  EXPECT_THAT(said.output, testing::ContainsRegex("= e[0-9]+ \\(bc -> v[0-9]+\\)"));
  EXPECT_THAT(said.output, testing::ContainsRegex("= h[0-9]+ \\(bc -> v[0-9]+\\)"));
}

}  // namespace
}  // namespace meshgrade
