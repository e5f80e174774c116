// What student code can do to the worker, from end to end: each case gets its ending, and the
// cases after it still run.

#include "grader/run/run.h"

#include <gtest/gtest.h>

#include <csignal>

#include "grader/cases/mesh_input.h"
#include "meshedit/fault.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/submissions.h"

namespace meshgrade {
namespace {

Case normal_case(const std::string& file, std::uint64_t budget = 100'000) {
  return {"vertex_normal", "basic", 1, file, to_wire(NormalInput{sample_polygons(file)}),
          budget};
}

Limits quick_limits() {
  Limits limits;
  limits.case_cpu_ms = 400;
  limits.case_wall_ms = 1500;
  limits.run_seconds = 30;
  limits.memory_mb = 512;
  limits.result_mb = 8;
  return limits;
}

/// Runs a case on a tetrahedron, one on an octahedron, and the tetrahedron again.
std::vector<Outcome> run_three(const SourceFile& source, const Limits& limits = quick_limits(),
                               Company company = Company::kTogether) {
  const Build build = build_sources({source});
  EXPECT_TRUE(build.files.at(0).ok) << build.files[0].messages;
  const Case small = normal_case("tetrahedron.obj");
  const Case large = normal_case("octahedron.off");
  return run_cases(build, {&small, &large, &small}, limits, company);
}

/// A normal that is harmless on the octahedron only: `harm` stands in line 6 for the others.
SourceFile harmful(const std::string& harm, const std::string& helpers = "") {
  return normal_file("  if (degree() != 4) {\n    " + harm + "\n  }\n  return {0, 0, 1};",
                     helpers);
}

/// Both tetrahedra end in the same way, and the octahedron between them is done.
void expect_endings(const std::vector<Outcome>& outcomes, Ending ending) {
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].ending, ending);
  EXPECT_EQ(outcomes[1].ending, Ending::kDone);
  EXPECT_EQ(outcomes[1].steps.size(), 6U);
  EXPECT_EQ(outcomes[2].ending, ending);
}

void expect_place(const Outcome& outcome, int line) {
  ASSERT_FALSE(outcome.stack.empty());
  EXPECT_EQ(outcome.stack[0].file, "normal.cpp");
  EXPECT_EQ(outcome.stack[0].line, line);
  EXPECT_NE(outcome.stack[0].function.find("normal"), std::string::npos);
}

TEST(RunCases, StepsOfARightSubmissionArrive) {
  const std::vector<Outcome> outcomes = run_three(normal_file("  return {1, 2, 3};"));
  expect_endings(outcomes, Ending::kDone);
  ASSERT_EQ(outcomes[0].steps.size(), 4U);
  EXPECT_EQ(from_wire<Point3>(outcomes[0].steps[0]), (Point3{1, 2, 3}));
}

TEST(RunCases, CrashCostsOneCaseAndNamesItsLine) {
  const auto outcomes = run_three(harmful("*(volatile int*)8 = 1;"));
  expect_endings(outcomes, Ending::kSignal);
  EXPECT_EQ(outcomes[0].code, SIGSEGV);
  expect_place(outcomes[0], 6);
}

TEST(RunCases, AbortAndDoubleFreeAreSignals) {
  const auto aborted = run_three(harmful("std::abort();", "#include <cstdlib>"));
  expect_endings(aborted, Ending::kSignal);
  EXPECT_EQ(aborted[0].code, SIGABRT);
  expect_place(aborted[0], 6);
  const auto freed =
      run_three(harmful("char* volatile p = new char[999]; delete[] p; delete[] p;"));
  expect_endings(freed, Ending::kSignal);
}

TEST(RunCases, ExitIsNotAResult) {
  for (const char* call : {"std::exit(0);", "std::_Exit(90);", "std::_Exit(92);"}) {
    expect_endings(run_three(harmful(call, "#include <cstdlib>")), Ending::kExit);
  }
}

TEST(RunCases, ExceptionIsCaughtWithItsText) {
  const auto outcomes = run_three(
      harmful("throw std::runtime_error(\"two\\nlines \\033[31m\");", "#include <stdexcept>"));
  expect_endings(outcomes, Ending::kException);
  EXPECT_EQ(outcomes[0].subject, "two lines ?[31m");
}

TEST(RunCases, EndlessHandleWalkRunsOutOfSteps) {
  const auto outcomes =
      run_three(harmful("for (HalfedgeCIter h = halfedge();; h = h->next()) {}"));
  expect_endings(outcomes, Ending::kFault);
  EXPECT_EQ(outcomes[0].fault_kind,
            static_cast<std::uint32_t>(meshedit::FaultKind::kOutOfSteps));
  expect_place(outcomes[0], 6);
}

TEST(RunCases, UnsetHandleIsAFaultWithItsPlace) {
  const auto outcomes = run_three(harmful("HalfedgeCIter h; (void)h->next();"));
  expect_endings(outcomes, Ending::kFault);
  EXPECT_EQ(outcomes[0].fault_kind,
            static_cast<std::uint32_t>(meshedit::FaultKind::kUnsetHandle));
  expect_place(outcomes[0], 6);
}

TEST(RunCases, WhatTheStandardLibraryRefusesHasItsPlace) {
  const std::string includes =
      "#include <array>\n#include <deque>\n#include <memory>\n#include <optional>\n"
      "#include <string>\n#include <vector>\n";
  for (const char* misuse : {
           "std::vector<int> v(degree()); v[degree()] = 1;",
           "std::vector<Vector3D> v(degree()); v[-1] = Vector3D();",
           "std::array<int, 3> a{}; a[degree()] = 1;",
           "std::deque<int> d(degree()); d[degree()] = 1;",
           "std::string s(degree(), 'x'); s[degree() + 1] = 'y';",
           "std::vector<int> v(degree() - 3); v.back() = 1;",
           "std::vector<int> v(degree() - 3); v.pop_back();",
           "std::optional<int> o; *o = static_cast<int>(degree());",
           "std::unique_ptr<int> p; *p = static_cast<int>(degree());",
       }) {
    SourceFile source = harmful(misuse, includes);
    const auto outcomes = run_three(source);
    SCOPED_TRACE(misuse);
    expect_endings(outcomes, Ending::kLibraryCheck);
    expect_place(outcomes[0], 12);
    EXPECT_EQ(outcomes[0].output, "");
  }
}

TEST(RunCases, IndexWithinAVectorIsFine) {
  expect_endings(run_three(harmful("std::vector<int> v(degree()); v[degree() - 1] = v.front();",
                                   "#include <vector>")),
                 Ending::kDone);
}

TEST(RunCases, EndlessLoopWithoutHandlesRunsOutOfTime) {
  const auto outcomes = run_three(harmful("for (volatile int i = 0;; ++i) {}"));
  expect_endings(outcomes, Ending::kOutOfTime);
  expect_place(outcomes[0], 6);
}

TEST(RunCases, SleepRunsOutOfTime) {
  expect_endings(run_three(harmful("::sleep(60);", "#include <unistd.h>")), Ending::kOutOfTime);
}

TEST(RunCases, EndlessRecursionIsACrash) {
  const auto outcomes =
      run_three(harmful("return deep(1) > 0 ? Vector3D(1, 0, 0) : Vector3D(0, 1, 0);",
                        "namespace { int deep(int n) { volatile char a[999]; a[n % 9] = 1; "
                        "return deep(n + 1) + a[n % 9]; } }"));
  expect_endings(outcomes, Ending::kSignal);
  EXPECT_EQ(outcomes[0].code, SIGSEGV);
  ASSERT_FALSE(outcomes[0].stack.empty());
  EXPECT_EQ(outcomes[0].stack[0].file, "normal.cpp");
}

TEST(RunCases, HugeAllocationRunsOutOfMemory) {
  expect_endings(run_three(harmful("std::vector<char> v; v.resize(std::size_t{1} << 40U);",
                                   "#include <vector>")),
                 Ending::kOutOfMemory);
}

TEST(RunCases, WhatOthersKeptIsNotTakenFromACaseAfterOneThatRanOutOfMemory) {
  const SourceFile source = normal_file(
      "  if (degree() == 3) std::vector<char>(std::size_t{1} << 40U);\n  keep();\n"
      "  return {0, 0, 1};",
      "#include <vector>\nnamespace { void keep() { static std::vector<std::vector<char>> all; "
      "all.emplace_back(std::size_t{16} << 20U); } }");
  const Build build = build_sources({source});
  ASSERT_TRUE(build.files.at(0).ok) << build.files[0].messages;
  const Case hungry = normal_case("tetrahedron.obj");
  const Case other = normal_case("octahedron.off");
  Limits limits = quick_limits();
  limits.case_cpu_ms = 4000;  // it is about memory, and some machines hand it out slowly
  limits.case_wall_ms = 8000;
  const auto outcomes =
      run_cases(build, {&hungry, &other, &other, &other}, limits, Company::kTogether);
  ASSERT_EQ(outcomes.size(), 4U);
  EXPECT_EQ(outcomes[0].ending, Ending::kOutOfMemory);
  for (std::size_t i = 1; i < outcomes.size(); ++i)
    EXPECT_EQ(outcomes[i].ending, Ending::kDone) << i;
}

TEST(RunCases, OutputIsKeptInPartAndCounted) {
  const auto outcomes = run_three(harmful(
      "for (int i = 0; i < 100000; ++i) std::cout << \"noise\\033\";", "#include <iostream>"));
  expect_endings(outcomes, Ending::kDone);
  EXPECT_EQ(outcomes[0].output.size(), kKeptOutputBytes);
  EXPECT_EQ(outcomes[0].output.substr(0, 12), "noise?noise?");
  EXPECT_EQ(outcomes[0].output_bytes, 4U * 600'000U);
  EXPECT_TRUE(outcomes[1].output.empty());
}

TEST(RunCases, OutputFloodEndsTheCase) {
  Limits limits = quick_limits();
  limits.case_cpu_ms = 5000;
  const auto outcomes =
      run_three(harmful("std::string s(1 << 16, 'x'); for (;;) std::cout << s << std::flush;",
                        "#include <iostream>"),
                limits);
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].ending, Ending::kOutputLimit);
  EXPECT_EQ(outcomes[1].ending, Ending::kDone);
}

TEST(RunCases, StaticConstructorThatExitsCostsAllCasesButIsNoErrorOfTheGrader) {
  for (const char* status : {"0", "91", "127"}) {
    const auto outcomes = run_three(
        normal_file("  return {};", std::string("#include <cstdlib>\nstatic struct S { S() { "
                                                "std::_Exit(") +
                                        status + "); } } s;"));
    ASSERT_EQ(outcomes.size(), 3U);
    for (const Outcome& outcome : outcomes) {
      EXPECT_EQ(outcome.ending, Ending::kExit);
      EXPECT_TRUE(outcome.steps.empty());
    }
  }
}

TEST(RunCases, StaticConstructorThatHangsIsStopped) {
  Limits limits = quick_limits();
  limits.run_seconds = 1;
  const auto outcomes =
      run_three(normal_file("  return {};",
                            "#include <unistd.h>\nstatic struct S { S() { ::close(1); "
                            "::close(2); for (;;) ::sleep(9); } } s;"),
                limits);
  EXPECT_EQ(outcomes.at(0).ending, Ending::kOutOfTime);
  EXPECT_EQ(outcomes.at(1).ending, Ending::kSkipped);
  EXPECT_EQ(outcomes.at(2).ending, Ending::kSkipped);
}

TEST(RunCases, ThreadLeftRunningDoesNoHarm) {
  const auto outcomes = run_three(harmful("std::thread([] { for (;;) ::sleep(1); }).detach();",
                                          "#include <thread>\n#include <unistd.h>"));
  expect_endings(outcomes, Ending::kDone);
}

TEST(RunCases, WorkerKilledFromInsideLeavesAnOutcomeForEveryCase) {
  const auto outcomes = run_three(harmful("::kill(::getppid(), 9); ::kill(::getpid(), 9);",
                                          "#include <csignal>\n#include <unistd.h>"));
  ASSERT_EQ(outcomes.size(), 3U);
  for (const Outcome& outcome : outcomes)
    EXPECT_NE(outcome.ending, Ending::kDone);
}

TEST(RunCases, ForgedResultFileCountsForNothing) {
  const auto outcomes = run_three(harmful(
      "::pwrite(4, \"forged result file, not a frame\", 31, 0);", "#include <unistd.h>"));
  ASSERT_EQ(outcomes.size(), 3U);
  for (const Outcome& outcome : outcomes)
    EXPECT_NE(outcome.ending, Ending::kDone);
}

Case in_group(Case c, const std::string& group) {
  c.group = group;
  return c;
}

TEST(RunCases, FamilyThatRunsOutOfTimeIsGivenUpAlone) {
  const Build build = build_sources({harmful("for (volatile int i = 0;; ++i) {}")});
  const Case endless = normal_case("tetrahedron.obj");
  const Case other = in_group(normal_case("octahedron.off"), "stress");
  const auto outcomes =
      run_cases(build, {&endless, &endless, &endless, &endless, &other, &endless},
                quick_limits(), Company::kTogether);
  ASSERT_EQ(outcomes.size(), 6U);
  for (std::size_t i : {0U, 1U, 2U})
    EXPECT_EQ(outcomes[i].ending, Ending::kOutOfTime) << i;
  EXPECT_EQ(outcomes[3].ending, Ending::kSkipped);
  EXPECT_EQ(outcomes[4].ending, Ending::kDone) << "it is of another family";
  EXPECT_EQ(outcomes[4].steps.size(), 6U);
  EXPECT_EQ(outcomes[5].ending, Ending::kSkipped);
}

TEST(RunCases, ForgedResultsAndKilledWorkersCostOnlyTheirFamily) {
  for (const char* harm : {"::pwrite(4, \"forged result file, not a frame\", 31, 0);",
                           "::kill(::getppid(), 9); ::kill(::getpid(), 9);"}) {
    const Build build =
        build_sources({harmful(harm, "#include <csignal>\n#include <unistd.h>")});
    const Case before = in_group(normal_case("octahedron.off"), "basic");
    const Case spoils = in_group(normal_case("tetrahedron.obj"), "boundary");
    const Case after = in_group(normal_case("octahedron.off"), "stress");
    const auto outcomes =
        run_cases(build, {&before, &spoils, &after}, quick_limits(), Company::kTogether);
    ASSERT_EQ(outcomes.size(), 3U);
    EXPECT_EQ(outcomes[0].ending, Ending::kDone) << harm;
    EXPECT_NE(outcomes[1].ending, Ending::kDone) << harm;
    EXPECT_TRUE(outcomes[1].lost) << harm;
    EXPECT_EQ(outcomes[2].ending, Ending::kDone) << harm;
  }
}

TEST(RunCases, StateLeaksBetweenCasesTogetherButNotAlone) {
  const SourceFile counter =
      normal_file("  static int calls = 0;\n  return {double(++calls), 0, 0};");
  const auto last = [](const std::vector<Outcome>& outcomes) {
    return from_wire<Point3>(outcomes.at(2).steps.at(3))[0];
  };
  EXPECT_EQ(last(run_three(counter)), 14);
  EXPECT_EQ(last(run_three(counter, quick_limits(), Company::kAlone)), 4);
}

TEST(RunCases, MissingFunctionIsNotImplemented) {
  const auto outcomes = run_three({"empty.cpp", "int nothing;\n"});
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(outcome.ending, Ending::kFault);
    EXPECT_EQ(outcome.fault_kind,
              static_cast<std::uint32_t>(meshedit::FaultKind::kNotImplemented));
    EXPECT_EQ(outcome.subject, "Vertex::normal");
  }
}

TEST(RunCases, InputThatTheWorkerCannotReadIsTheGradersFault) {
  const Build build = build_sources({normal_file("  return {};")});
  Case broken = normal_case("tetrahedron.obj");
  broken.input.resize(10);
  const auto outcomes = run_cases(build, {&broken}, quick_limits(), Company::kTogether);
  EXPECT_EQ(outcomes.at(0).ending, Ending::kWorkerFailed);
}

}  // namespace
}  // namespace meshgrade
