#include <gtest/gtest.h>

#include <csignal>

#include "grader/base/protocol.h"
#include "grader/judge/judge.h"
#include "meshedit/fault.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using meshedit::FaultKind;

CaseJudgement judge(const std::string& id, const Outcome& outcome) {
  const Case& c = standard_case(id);
  const ExerciseRubric& rubric = *standard_rubric().find(c.exercise);
  const ExerciseJudge exercise = find_exercise_judge(rubric);
  Conventions conventions = exercise.conventions;
  return judge_case(exercise, {c, outcome, rubric, 1e-5}, conventions);
}

Outcome ended(Ending ending, std::int32_t code = 0, const std::string& subject = "") {
  Outcome outcome;
  outcome.ending = ending;
  outcome.code = code;
  outcome.subject = subject;
  outcome.stack = {{"meshedit::HalfedgeMesh::flipEdge", "edge_flip.cpp", 12}};
  return outcome;
}

Outcome fault(FaultKind kind, const std::string& subject) {
  Outcome outcome = ended(Ending::kFault, 0, subject);
  outcome.fault_kind = static_cast<std::uint32_t>(kind);
  return outcome;
}

void expect(const CaseJudgement& judgement, Verdict verdict, const std::string& rule,
            const std::string& words) {
  EXPECT_EQ(judgement.verdict, verdict);
  ASSERT_EQ(judgement.findings.size(), 1U);
  const Finding& finding = judgement.findings[0];
  EXPECT_EQ(finding.rule, rule);
  EXPECT_NE(finding.actual.find(words), std::string::npos) << finding.actual;
  ASSERT_EQ(finding.stack.size(), 1U);
  EXPECT_EQ(finding.stack[0].line, 12);
}

TEST(JudgeCase, EveryEndingHasItsVerdictAndRule) {
  const std::string id = "edge_flip:basic/1";
  expect(judge(id, ended(Ending::kSignal, SIGSEGV)), Verdict::kCrashed, "crash",
         "segmentation fault");
  expect(judge(id, ended(Ending::kSignal, SIGFPE)), Verdict::kCrashed, "crash", "by zero");
  expect(judge(id, ended(Ending::kSignal, SIGABRT)), Verdict::kCrashed, "crash", "aborted");
  expect(judge(id, ended(Ending::kSignal, SIGILL)), Verdict::kCrashed, "crash", "return");
  expect(judge(id, ended(Ending::kExit, 7)), Verdict::kCrashed, "exit", "status 7");
  expect(judge(id, ended(Ending::kExit, kWorkerFailedStatus)), Verdict::kCrashed, "exit",
         "status 91");
  expect(judge(id, ended(Ending::kExit, kWorkerFailedStatus, "the program ended before this")),
         Verdict::kCrashed, "exit", "no processes left");
  expect(judge(id, ended(Ending::kException, 0, "bad thing")), Verdict::kCrashed, "exception",
         "bad thing");
  expect(judge(id, ended(Ending::kOutOfTime)), Verdict::kOutOfTime, "out-of-time", "time");
  expect(judge(id, ended(Ending::kOutOfMemory)), Verdict::kOutOfMemory, "out-of-memory",
         "memory");
  expect(judge(id, ended(Ending::kOutputLimit)), Verdict::kTooMuchOutput, "output-limit",
         "more");
  expect(judge(id, ended(Ending::kTooManyProcesses)), Verdict::kTooManyProcesses,
         "process-limit", "processes");
  expect(judge(id, ended(Ending::kTooManyFiles)), Verdict::kTooManyFiles, "file-limit", "open");
}

TEST(JudgeCase, FailureOfTheWorkerIsNeverTheStudents) {
  const CaseJudgement judgement =
      judge("edge_flip:basic/1", ended(Ending::kWorkerFailed, 0, "no such exercise"));
  EXPECT_EQ(judgement.verdict, Verdict::kGraderError);
  EXPECT_TRUE(judgement.findings.empty());
  EXPECT_NE(judgement.note.find("no such exercise"), std::string::npos);
}

TEST(JudgeCase, EveryMisuseOfAHandleHasItsRule) {
  const std::string id = "edge_flip:basic/1";
  const std::pair<FaultKind, std::string> faults[] = {
      {FaultKind::kUnsetHandle, "unset-handle"},
      {FaultKind::kDeletedHandle, "deleted-handle"},
      {FaultKind::kPastEndHandle, "past-end-handle"},
      {FaultKind::kForeignHandle, "foreign-handle"}};
  for (const auto& [kind, rule] : faults) {
    expect(judge(id, fault(kind, "vertex handle")), Verdict::kCrashed, rule,
           std::string("vertex handle ") + meshedit::describe(kind));
  }
  expect(judge(id, fault(FaultKind::kOutOfSteps, "half-edge handle")), Verdict::kOutOfSteps,
         "out-of-steps", "stopped");
}

/// As GCC's library, Clang's library and a place alone tell it.
TEST(JudgeCase, WhatTheStandardLibraryRefusesIsToldInPlainWords) {
  const auto expect_words = [](const std::string& subject, const std::string& rule,
                               const std::string& words) {
    SCOPED_TRACE(subject);
    expect(judge("edge_flip:basic/1", ended(Ending::kLibraryCheck, 0, subject)),
           Verdict::kCrashed, rule, words);
  };
  expect_words(
      "__n < this->size() in std::vector<_Tp, _Alloc>::reference std::vector<_Tp, "
      "_Alloc>::operator[](size_type) [with _Tp = std::vector<int>; _Alloc = std::allo",
      "index-out-of-range", "an index of a std::vector is out of range");
  expect_words(
      "__pos <= size() in std::__cxx11::basic_string<_CharT, _Traits, _Alloc>::reference "
      "std::__cxx11::basic_string<_CharT, _Traits, _Alloc>::operator[](size_type) [with",
      "index-out-of-range", "an index of a std::string is");
  expect_words("!this->empty() in void std::deque<_Tp, _Alloc>::pop_back() [with _Tp = int]",
               "empty-container", "pop_back() of a std::deque that is empty");
  expect_words(
      "this->_M_is_engaged() in constexpr _Tp& std::_Optional_base_impl<_Tp, _Dp>::_M_get()",
      "empty-container", "a std::optional was used that holds nothing");
  expect_words(
      "get() != pointer() in typename std::add_lvalue_reference<_Tp>::type "
      "std::unique_ptr<_Tp, _Dp>::operator*() const [with _Tp = int]",
      "empty-container", "a std::unique_ptr was used that holds nothing");
  expect_words(
      "in std::__1::vector<int, std::__1::allocator<int> >::operator[][abi:ne190107](unsigned "
      "long)",
      "index-out-of-range", "an index of a std::vector is out of range");
  expect_words("vector:1425: assertion __n < size() failed: vector[] index out of bounds",
               "index-out-of-range", "an index of a container of the standard library");
  expect_words("!(__hi < __lo) in constexpr const _Tp& std::clamp(const _Tp&, const _Tp&, ...",
               "library-check", "std::clamp");
}

TEST(JudgeCase, UnknownFaultIsAFaultNevertheless) {
  Outcome outcome = fault(FaultKind::kUnsetHandle, "?");
  outcome.fault_kind = 4'000'000'000U;
  EXPECT_EQ(judge("edge_flip:basic/1", outcome).verdict, Verdict::kCrashed);
}

TEST(JudgeCase, OwnStubIsNotImplementedAndAnothersIsNotJudged) {
  const CaseJudgement own =
      judge("edge_split:basic/1", fault(FaultKind::kNotImplemented, "HalfedgeMesh::splitEdge"));
  EXPECT_EQ(own.verdict, Verdict::kNotImplemented);
  EXPECT_NE(own.note.find("HalfedgeMesh::splitEdge"), std::string::npos);
  const CaseJudgement other = judge(
      "loop_subdivision:basic/1", fault(FaultKind::kNotImplemented, "HalfedgeMesh::splitEdge"));
  EXPECT_EQ(other.verdict, Verdict::kNotJudged);
  EXPECT_NE(other.note.find("HalfedgeMesh::splitEdge"), std::string::npos);
}

TEST(JudgeCase, WrongStepBeforeACrashIsToldFirst) {
  Outcome outcome = ended(Ending::kSignal, SIGSEGV);
  CurveStep wrong{{{0, 0}}, {}};
  outcome.steps = {to_wire(wrong)};
  const CaseJudgement judgement = judge("bezier_curve:whole/1", outcome);
  EXPECT_EQ(judgement.verdict, Verdict::kFailed);
  ASSERT_EQ(judgement.findings.size(), 2U);
  EXPECT_EQ(judgement.findings[0].rule, "input");
  EXPECT_EQ(judgement.findings[1].rule, "crash");
}

TEST(JudgeCase, NormalsAreToldApartByWhatIsWrong) {
  const std::string id = "vertex_normal:basic/1";
  const Outcome right = right_outcome(standard_case(id));
  const auto rule = [&](Point3 first) {
    Outcome outcome = right;
    outcome.steps[0] = to_wire(first);
    const CaseJudgement judgement = judge(id, outcome);
    EXPECT_EQ(judgement.verdict, Verdict::kFailed);
    EXPECT_EQ(judgement.findings.at(0).element, "v0");
    return judgement.findings.at(0).rule;
  };
  const auto n = from_wire<Point3>(right.steps[0]);
  EXPECT_EQ(rule({2 * n[0], 2 * n[1], 2 * n[2]}), "unit-length");
  EXPECT_EQ(rule({-n[0], -n[1], -n[2]}), "value");
  EXPECT_EQ(rule({NAN, NAN, NAN}), "finite");
}

TEST(JudgeCase, CurveStepsAreToldApartByWhatIsWrong) {
  const std::string id = "bezier_curve:basic/9";  // four points
  const auto right = from_wire<CurveStep>(right_outcome(standard_case(id)).steps[0]);
  const auto rule = [&](auto change) {
    CurveStep step = right;
    change(step);
    Outcome outcome;
    outcome.steps = {to_wire(step)};
    return judge(id, outcome).findings.at(0).rule;
  };
  EXPECT_EQ(rule([](CurveStep& s) { s.result[1][0] += 0.1; }), "value");
  EXPECT_EQ(rule([](CurveStep& s) { s.result[1][0] = NAN; }), "value");
  EXPECT_EQ(rule([](CurveStep& s) { s.result.resize(1); }), "count");
  EXPECT_EQ(rule([](CurveStep& s) { s.result.clear(); }), "count");
  EXPECT_EQ(rule([](CurveStep& s) { s.input_after.pop_back(); }), "input");
}

TEST(JudgeOptions, UnknownOnesAreRefusedWithTheNamesOfTheChoices) {
  ExerciseRubric rubric = *standard_rubric().find("loop_subdivision");
  rubric.options["vertex_rule"] = {"butterfly", "a.toml:7"};
  const std::string wrong_value = user_error([&] { find_exercise_judge(rubric); });
  for (const char* word :
       {"a.toml:7: ", "vertex_rule", "butterfly", "either", "loop", "warren"})
    EXPECT_NE(wrong_value.find(word), std::string::npos) << wrong_value;
  rubric.options = {{"vertex", {"loop", "a.toml:3"}}};
  const std::string wrong_name = user_error([&] { find_exercise_judge(rubric); });
  for (const char* word : {"a.toml:3: ", "\"vertex\"", "vertex_rule", "corner_rule"})
    EXPECT_NE(wrong_name.find(word), std::string::npos) << wrong_name;
  ExerciseRubric flip = *standard_rubric().find("edge_flip");
  flip.options["anything"].value = "x";
  EXPECT_NE(user_error([&] { find_exercise_judge(flip); }).find("anything"), std::string::npos);
  flip.options.clear();
  ExerciseRubric curve = *standard_rubric().find("bezier_curve");
  curve.groups[0].partial = Partial::kPointers;
  EXPECT_NE(user_error([&] { find_exercise_judge(curve); }).find("sets no pointers"),
            std::string::npos);
  flip.name = "edge_collapse";
  EXPECT_NE(user_error([&] { find_exercise_judge(flip); }).find("edge_collapse"),
            std::string::npos);
}

}  // namespace
}  // namespace meshgrade
