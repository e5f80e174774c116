#include "grader/app/second_run.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/build/stand_in.h"
#include "grader/judge/judge.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

std::size_t passed_cases(const JudgedExercise& exercise) {
  return static_cast<std::size_t>(std::count_if(
      exercise.cases.begin(), exercise.cases.end(),
      [](const JudgedCase& c) { return c.judgement.verdict == Verdict::kPassed; }));
}

std::string pass_instead_of(const JudgedExercise& second, std::size_t first_passed) {
  return std::to_string(passed_cases(second)) + " of " + plural(second.cases.size(), "case") +
         " pass, instead of " + std::to_string(first_passed);
}

/// The notes of a run in which the stand-ins were linked.
std::vector<std::string> notes_of_second(const std::string& causes, std::size_t first_passed,
                                         const JudgedExercise& second) {
  std::vector<std::string> notes{
      "so it was run again with a right solution of " + causes +
      " in place of yours: " + pass_instead_of(second, first_passed) + "; these points count"};
  notes.insert(notes.end(), second.notes.begin(), second.notes.end());
  return notes;
}

/// Puts the cases that did not pass through the worker with stand-ins, and judges all anew.
JudgedExercise judge_second(const Assignment& assignment, const Home& home,
                            const Candidate& candidate, const ExerciseRun& first) {
  std::vector<Outcome> outcomes = run_cases(candidate.build, pointers_to(first.cases),
                                            assignment.limits, Company::kTogether);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const bool passed = first.judged.cases[i].judgement.verdict == Verdict::kPassed;
    if (passed) outcomes[i] = first.outcomes[i];
  }
  return judge_exercise(assignment, home, candidate, *first.judged.rubric, first.cases,
                        outcomes);
}

/// Whether this one case passes, in a process of its own.
bool passes_alone(const Assignment& assignment, const Home& home, const Candidate& candidate,
                  const ExerciseRubric& rubric, const Case& asked) {
  const std::vector<Outcome> outcomes =
      run_cases(candidate.build, {&asked}, assignment.limits, Company::kTogether);
  return passed_cases(judge_exercise(assignment, home, candidate, rubric, {asked}, outcomes)) ==
         1;
}

/// A function can do all that its own exercise asks, and not what its caller relies on: which
/// of the new edges are marked is the business of both. So the last of those that are needed,
/// the one that makes new elements, is replaced by a right one; if the first failing case
/// passes then, says so. The points stay. A case that passes alone with the student's own
/// function, too, fails for what was done before it.
void tell_what_it_relies_on(const Assignment& assignment, const Home& home,
                            const Candidate& candidate,
                            const std::vector<JudgedExercise>& needed, ExerciseRun& run) {
  const auto& cases = run.judged.cases;
  const auto failed = std::find_if(cases.begin(), cases.end(), [](const JudgedCase& c) {
    return !c.judgement.findings.empty();
  });
  if (failed == cases.end() || needed.empty()) return;
  const Case& asked = run.cases[static_cast<std::size_t>(failed - cases.begin())];
  const ExerciseRubric& rubric = *needed.back().rubric;
  const std::vector<StandIn> stand_in{{rubric.name, find_exercise_judge(rubric).functions}};
  const auto changed = with_stand_ins(candidate.submission, home, stand_in);
  if (!changed) return;
  const Build build = build_submission(*changed, home, assignment.limits);
  if (!has_stand_ins(build, stand_in)) return;
  if (!passes_alone(assignment, home, {*changed, build}, *run.judged.rubric, asked)) return;
  if (passes_alone(assignment, home, candidate, *run.judged.rubric, asked)) return;
  run.judged.notes.push_back("with a right " + rubric.name + " in place of yours, " +
                             asked.id() + " passes: your " + rubric.name +
                             " is right on its own, but leaves something else than this code "
                             "relies on, such as isNew of what is new");
}

/// What to say of an exercise that is not all right. Other than for has_failure(), cases that
/// could not be judged are not its fault: a split is not wrong since the flip is not written.
const char* state_of(const JudgedExercise& exercise) {
  const auto any = [&](auto is) {
    return std::any_of(exercise.cases.begin(), exercise.cases.end(),
                       [&](const JudgedCase& c) { return is(c.judgement.verdict); });
  };
  const auto is_passed = [](Verdict v) { return v == Verdict::kPassed; };
  const auto is_open = [](Verdict v) {
    return v == Verdict::kNotImplemented || v == Verdict::kNotJudged;
  };
  if (any([&](Verdict v) { return !is_passed(v) && !is_open(v); }))
    return "fails: see there first";
  return any(is_passed) ? "is not written for all cases" : "is not written yet";
}

}  // namespace

void run_with_stand_ins(const Assignment& assignment, const Home& home,
                        const Candidate& candidate, const std::vector<JudgedExercise>& needed,
                        ExerciseRun& run) {
  std::vector<std::string> wrong;
  std::vector<StandIn> stand_ins;
  for (const JudgedExercise& exercise : needed) {
    const ExerciseRubric& rubric = *exercise.rubric;
    if (is_all_right(exercise)) continue;
    run.judged.notes.push_back("your own " + rubric.name + " is part of this and " +
                               state_of(exercise));
    wrong.push_back(rubric.name);
    stand_ins.push_back({rubric.name, find_exercise_judge(rubric).functions});
  }
  if (stand_ins.empty())
    return tell_what_it_relies_on(assignment, home, candidate, needed, run);
  const std::string causes = join(wrong, " and ");
  const auto changed = with_stand_ins(candidate.submission, home, stand_ins);
  if (!changed) {
    run.judged.notes.push_back(
        "your instructor's grader runs it again with a right solution of " + causes +
        "; this package comes without one");
    return;
  }
  const Build build = build_submission(*changed, home, assignment.limits);
  if (!has_stand_ins(build, stand_ins)) {
    run.judged.notes.push_back("it could not be run again with a right solution of " + causes +
                               ": your own cannot be taken out of its file");
    return;
  }
  JudgedExercise second = judge_second(assignment, home, {*changed, build}, run);
  const std::size_t first_passed = passed_cases(run.judged);
  if (passed_cases(second) == first_passed && !has_failure(run.judged)) return;
  std::vector<std::string> notes = notes_of_second(causes, first_passed, second);
  run.judged.cases = std::move(second.cases);
  run.judged.notes.insert(run.judged.notes.end(), notes.begin(), notes.end());
  run.judged.stand_ins = std::move(wrong);
}

}  // namespace meshgrade
