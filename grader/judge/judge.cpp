#include "grader/judge/judge.h"

#include <algorithm>
#include <csignal>
#include <map>

#include "grader/base/errors.h"
#include "grader/base/protocol.h"
#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/judge/findings.h"
#include "grader/judge/library_check.h"
#include "grader/judge/local_operation_judge.h"
#include "grader/operations/local_operation_list.h"
#include "meshedit/fault.h"

namespace meshgrade {

#define MESHGRADE_EXERCISE(name) ExerciseJudge name##_judge(const ExerciseRubric& rubric);
#include "exercise_list.inc"
#undef MESHGRADE_EXERCISE

namespace {

using meshedit::FaultKind;

const char* signal_text(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "it used memory that is not its own (segmentation fault)";
    case SIGFPE:
      return "it divided a whole number by zero (floating point exception)";
    case SIGABRT:
      return "it was aborted";
    case SIGILL:
      return "it ran into a place that is no code: does a function end without a return?";
    case SIGTRAP:
      return "it ran into a trap: an assertion of its own that does not hold?";
    case SIGKILL:
      return "it was killed";
    default:
      return "a signal ended it";
  }
}

struct FaultWords {
  const char* rule;
  const char* meaning;
  const char* advice;
};

FaultWords fault_words(FaultKind kind) {
  switch (kind) {
    case FaultKind::kUnsetHandle:
      return {"unset-handle", "a handle is given an element before it is used",
              "which handle on this line was never set? New elements begin with all pointers "
              "unset"};
    case FaultKind::kDeletedHandle:
      return {"deleted-handle", "no handle to a deleted element is used",
              "what was deleted, and who still points to it"};
    case FaultKind::kPastEndHandle:
      return {"past-end-handle", "the end of a list is compared with, never used",
              "the condition of the loop around this line"};
    case FaultKind::kForeignHandle:
      return {"foreign-handle", "handles of one mesh are not put into another",
              "is there a copy of the mesh? Use handles of the mesh that was passed in"};
    case FaultKind::kOutOfSteps:
      return {"out-of-steps",
              "the number of handle uses stays in proportion to the size of the mesh",
              "a loop that never comes back to where it began, or one that searches the whole "
              "mesh again and again"};
    case FaultKind::kEndReference:
      return {"end-reference", "a reference that leads to no element is compared, never used",
              "pointers of new and of erased elements are end() until they are set, and a loop "
              "over a list ends there"};
    case FaultKind::kFailedAssertion:
      return {"assertion", "what the code itself asserts holds",
              "print what stands in the assertion before this line"};
    case FaultKind::kNotImplemented:
      break;
  }
  return {"not-implemented", "the function is written", ""};
}

bool is_known(std::uint32_t kind) {
  return kind >= static_cast<std::uint32_t>(FaultKind::kUnsetHandle) &&
         kind <= static_cast<std::uint32_t>(FaultKind::kFailedAssertion);
}

void judge_stub(const ExerciseJudge& judge, const std::string& function,
                CaseJudgement& judgement) {
  const auto& own = judge.functions;
  if (std::find(own.begin(), own.end(), function) == own.end()) {
    judgement.verdict = Verdict::kNotJudged;
    judgement.note = "it calls " + function + ", which is not implemented";
    return;
  }
  judgement.verdict = Verdict::kNotImplemented;
  judgement.note = function + " is not implemented";
}

/// What stands before the subject of a fault.
std::string article(FaultKind kind) {
  return kind == FaultKind::kFailedAssertion ? "the assertion " : "a ";
}

void judge_fault(const ExerciseJudge& judge, const JudgeTask& task, CaseJudgement& judgement) {
  const Outcome& outcome = task.outcome;
  const auto kind =
      is_known(outcome.fault_kind) ? FaultKind{outcome.fault_kind} : FaultKind::kUnsetHandle;
  if (kind == FaultKind::kNotImplemented) {
    return judge_stub(judge, task.rubric.by_other_names(outcome.subject), judgement);
  }
  const bool endless = kind == FaultKind::kOutOfSteps;
  judgement.verdict = endless ? Verdict::kOutOfSteps : Verdict::kCrashed;
  const FaultWords words = fault_words(kind);
  const std::string what =
      endless ? "the code used handles more often than any good solution: "
                "it was stopped"
              : article(kind) + outcome.subject + " " + meshedit::describe(kind);
  Finding finding =
      make_finding(words.rule, words.meaning, "", outcome.subject, "", what, words.advice);
  finding.stack = outcome.stack;
  judgement.findings.push_back(std::move(finding));
}

/// The endings by a limit.
void tell_limit(const Outcome& outcome, Verdict& verdict, Finding& finding) {
  switch (outcome.ending) {
    case Ending::kOutOfTime:
      verdict = Verdict::kOutOfTime;
      finding.rule = "out-of-time";
      finding.actual = outcome.subject.empty() ? "the time limit was reached" : outcome.subject;
      finding.look_at = "a loop that does not end, or waiting (sleep, input)";
      break;
    case Ending::kOutOfMemory:
      verdict = Verdict::kOutOfMemory;
      finding.rule = "out-of-memory";
      finding.actual = "the memory limit was reached";
      finding.look_at = "a loop that adds elements without end";
      break;
    case Ending::kTooManyProcesses:
      verdict = Verdict::kTooManyProcesses;
      finding.rule = "process-limit";
      finding.actual = "the code started more processes or threads than are allowed";
      finding.look_at = "calls of fork(), and threads in a loop";
      break;
    case Ending::kTooManyFiles:
      verdict = Verdict::kTooManyFiles;
      finding.rule = "file-limit";
      finding.actual = "the code had as many files open as are allowed";
      finding.look_at = "files that are opened and never closed";
      break;
    default:
      verdict = Verdict::kTooMuchOutput;
      finding.rule = "output-limit";
      finding.look_at = "a loop that prints without end";
      finding.actual = "the code printed or left behind more than is allowed";
      break;
  }
}

/// The worker tells how a case ended, and says nothing more of an exit. Where it could not even
/// tell that, there is a subject; its own status may then also be that of a student's
/// constructor: which of them it was, nobody can know.
void tell_exit(const Outcome& outcome, Finding& finding) {
  finding.rule = "exit";
  if (outcome.code == kWorkerFailedStatus && !outcome.subject.empty()) {
    finding.actual =
        outcome.subject + ": most likely this machine had no memory or no processes left";
    finding.look_at =
        "nothing at first: run the check again. If it stays, calls of exit() in constructors "
        "of "
        "global objects";
    return;
  }
  finding.look_at = "calls of exit()";
  finding.actual =
      "the code ended the whole program (exit status " + std::to_string(outcome.code) + ")";
}

/// @param what  what the exception says; the words of libstdc++ and libc++
std::string exception_hint(const std::string& what) {
  const auto says = [&](const char* words) { return what.find(words) != std::string::npos; };
  if (says("bad optional access") || says("bad_optional_access"))
    return "value() of a std::optional that holds nothing: a function that refuses returns "
           "std::nullopt; ask has_value() first";
  if (says("_M_range_check") || says("::at:") || what.ends_with("::at"))
    return "at() with a place or a key that is not there";
  return "what throws there, and with which values it is called";
}

/// All endings but kDone, kFault and kLibraryCheck.
void judge_ending(const Outcome& outcome, CaseJudgement& judgement) {
  Finding finding;
  finding.stack = outcome.stack;
  judgement.verdict = Verdict::kCrashed;
  switch (outcome.ending) {
    case Ending::kSignal:
      finding.rule = "crash";
      finding.actual = std::string("the program crashed: ") + signal_text(outcome.code);
      break;
    case Ending::kExit:
      tell_exit(outcome, finding);
      break;
    case Ending::kException:
      finding.rule = "exception";
      finding.actual = "an exception left the function: " + outcome.subject;
      finding.look_at = exception_hint(outcome.subject);
      break;
    default:
      tell_limit(outcome, judgement.verdict, finding);
      break;
  }
  finding.meaning = "the function does its work and returns";
  judgement.findings.push_back(std::move(finding));
}

void judge_steps_safely(const ExerciseJudge& judge, const JudgeTask& task,
                        Conventions& conventions, CaseJudgement& judgement) {
  try {
    judge.judge_steps(task, conventions, judgement);
  } catch (const WireError& error) {
    judgement.findings.push_back(make_finding(
        "malformed", "the worker writes down what the code left behind", "", "",
        "a well-formed result", std::string("a result that cannot be read: ") + error.what(),
        "does the code write over memory that is not its own?"));
  }
}

/// Only a picture is lost if the state that the code was stopped in is malformed.
void show_stop(const ExerciseJudge& judge, const JudgeTask& task, CaseJudgement& judgement) {
  if (judge.show_stop == nullptr || !task.explain || judgement.findings.empty()) return;
  if (task.outcome.interrupted.empty()) return;
  try {
    judge.show_stop(task, judgement.findings[0]);
  } catch (const WireError&) {
  }
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPassed:
      return "passed";
    case Verdict::kFailed:
      return "failed";
    case Verdict::kNotImplemented:
      return "not implemented";
    case Verdict::kNotCompiled:
      return "not compiled";
    case Verdict::kCrashed:
      return "crashed";
    case Verdict::kOutOfTime:
      return "out of time";
    case Verdict::kOutOfSteps:
      return "out of steps";
    case Verdict::kOutOfMemory:
      return "out of memory";
    case Verdict::kTooMuchOutput:
      return "too much output";
    case Verdict::kTooManyProcesses:
      return "too many processes";
    case Verdict::kTooManyFiles:
      return "too many open files";
    case Verdict::kNotJudged:
      return "not judged";
    case Verdict::kGraderError:
      return "grader error";
  }
  return "grader error";
}

std::optional<Verdict> find_verdict(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Verdict::kGraderError); ++i) {
    if (name == verdict_name(static_cast<Verdict>(i))) return static_cast<Verdict>(i);
  }
  return std::nullopt;
}

void require_all_steps(const Outcome& outcome, std::size_t asked) {
  if (outcome.ending == Ending::kDone && outcome.steps.size() < asked) {
    throw WireError("too few steps");
  }
}

namespace {

/// Points for pointers take a judge that counts them.
/// Its functions by the names that the submission's skeleton has for them.
ExerciseJudge fit_to_rubric(ExerciseJudge judge, const ExerciseRubric& rubric) {
  for (const Group& group : rubric.groups) {
    if (group.partial != Partial::kPointers || judge.counts_pointers) continue;
    throw UserError(group.place + ": " + rubric.name +
                    " sets no pointers: partial can be \"none\" or \"cases\" here");
  }
  for (std::string& function : judge.functions)
    function = rubric.by_other_names(std::move(function));
  return judge;
}

/// Functions are called what they are in the student's skeleton.
void use_other_names(const ExerciseRubric& rubric, CaseJudgement& judgement) {
  if (rubric.other_names.empty()) return;
  judgement.note = rubric.by_other_names(std::move(judgement.note));
  for (Finding& finding : judgement.findings) {
    for (std::string* text :
         {&finding.meaning, &finding.expected, &finding.actual, &finding.look_at})
      *text = rubric.by_other_names(std::move(*text));
  }
}

}  // namespace

ExerciseJudge find_exercise_judge(const ExerciseRubric& rubric) {
  using MakeJudge = ExerciseJudge (*)(const ExerciseRubric&);
  static const std::map<std::string, MakeJudge> judges{
#define MESHGRADE_EXERCISE(name) {#name, name##_judge},
#include "exercise_list.inc"
#undef MESHGRADE_EXERCISE
  };
  if (const LocalOperation* operation = find_local_operation(rubric.name))
    return fit_to_rubric(local_operation_judge(rubric, *operation), rubric);
  const auto found = judges.find(rubric.name);
  if (found == judges.end()) {
    throw UserError(rubric.place + ": there is no exercise \"" + rubric.name + "\"");
  }
  return fit_to_rubric(found->second(rubric), rubric);
}

namespace {

CaseJudgement judge_as_it_is(const ExerciseJudge& judge, const JudgeTask& task,
                             Conventions& conventions) {
  CaseJudgement judgement;
  const Outcome& outcome = task.outcome;
  if (outcome.ending == Ending::kWorkerFailed) {
    judgement.verdict = Verdict::kGraderError;
    judgement.note = "the worker failed: " + outcome.subject;
    return judgement;
  }
  if (outcome.ending == Ending::kSkipped) {
    judgement.verdict = Verdict::kOutOfTime;
    judgement.note = outcome.lost
                         ? "not run: cases before this one reached a limit for all of them "
                           "together"
                         : "not run: too many cases like this one ran out of time before it";
    return judgement;
  }
  judge_steps_safely(judge, task, conventions, judgement);
  if (judgement.verdict == Verdict::kNotJudged) return judgement;
  const bool wrong_before = !judgement.findings.empty();
  if (outcome.ending == Ending::kFault) {
    judge_fault(judge, task, judgement);
    if (!wrong_before) show_stop(judge, task, judgement);
  } else if (outcome.ending == Ending::kLibraryCheck) {
    judgement.verdict = Verdict::kCrashed;
    judgement.findings.push_back(library_check_finding(outcome));
    if (!wrong_before) show_stop(judge, task, judgement);
  } else if (outcome.ending != Ending::kDone) {
    judge_ending(outcome, judgement);
  }
  if (wrong_before) judgement.verdict = Verdict::kFailed;
  return judgement;
}

}  // namespace

CaseJudgement judge_case(const ExerciseJudge& judge, const JudgeTask& task,
                         Conventions& conventions) {
  CaseJudgement judgement = judge_as_it_is(judge, task, conventions);
  use_other_names(task.rubric, judgement);
  return judgement;
}

}  // namespace meshgrade
