#include "grader/grade/exercise_run.h"

#include <algorithm>
#include <set>
#include <string>

#include "grader/base/text.h"
#include "grader/cases/case_list.h"
#include "grader/grade/compile_blame.h"
#include "grader/grade/compile_warnings.h"
#include "grader/grade/handle_references.h"
#include "grader/grade/left_over_calls.h"
#include "grader/grade/right_callees.h"
#include "grader/grade/shrinking.h"
#include "grader/grade/source_hints.h"
#include "grader/judge/judge.h"
#include "grader/judge/tell_apart.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

/// At most this many failed cases are explained in full; the others get their verdict.
constexpr std::size_t kMostExplained = 8;

/// At most this many failed cases of an exercise are made smaller; these, too, are explained.
constexpr std::size_t kMostShrunk = 3;

/// A case that was not run says nothing about its own function where it also calls another
/// exercise's, and the cases like it that were run are all that one's fault.
void excuse_not_run(const ExerciseJudge& judge, const std::vector<const Case*>& cases,
                    const std::vector<Outcome>& outcomes,
                    std::vector<CaseJudgement>& judgements) {
  const auto calls_other = [&](const Case& c) {
    return std::any_of(c.calls.begin(), c.calls.end(), [&](const std::string& function) {
      const auto& own = judge.functions;
      return std::find(own.begin(), own.end(), function) == own.end();
    });
  };
  const auto is_blamed = [&](const Case& asked) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const bool alike = cases[i]->group == asked.group && cases[i]->calls == asked.calls;
      if (alike && outcomes[i].ending == Ending::kOutOfTime && !judgements[i].excused)
        return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (outcomes[i].ending != Ending::kSkipped || !calls_other(*cases[i])) continue;
    if (is_blamed(*cases[i])) continue;
    judgements[i].verdict = Verdict::kNotJudged;
    judgements[i].excused = true;
    judgements[i].note = "not run: in cases like this one before it, " +
                         join({cases[i]->calls.begin() + 1, cases[i]->calls.end()}, ", ") +
                         " did not end";
  }
}

/// Judges cases in order; in full the first `explained` of those that failed, and as many of
/// those that were stopped.
std::vector<CaseJudgement> judge_all(const Assignment& assignment, const ExerciseRubric& rubric,
                                     const std::vector<const Case*>& cases,
                                     const std::vector<Outcome>& outcomes,
                                     Conventions& conventions, std::size_t explained) {
  const ExerciseJudge judge = find_exercise_judge(rubric);
  std::vector<CaseJudgement> judgements;
  std::size_t stopped = explained;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::size_t& left = outcomes[i].ending == Ending::kDone ? explained : stopped;
    judgements.push_back(judge_case(
        judge, {*cases[i], outcomes[i], rubric, assignment.tolerance, left > 0}, conventions));
    if (!judgements.back().findings.empty() && left > 0) --left;
  }
  excuse_not_run(judge, cases, outcomes, judgements);
  return judgements;
}

bool deserves_second_run(const CaseJudgement& judgement) {
  switch (judgement.verdict) {
    case Verdict::kFailed:
    case Verdict::kCrashed:
    case Verdict::kOutOfSteps:
    case Verdict::kOutOfMemory:
      return true;
    default:
      return false;
  }
}

/// Which cases run once more: all that an exercise has of one kind, or some of it.
using Places = std::vector<std::size_t>;

Places places_that_deserve_it(const std::vector<CaseJudgement>& judgements) {
  Places places;
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    if (deserves_second_run(judgements[i])) places.push_back(i);
  }
  return places;
}

/// Those that are explained in full, and as many more from all over the others.
Places some_of(const Places& places) {
  if (places.size() <= 2 * kMostExplained) return places;
  Places some(places.begin(), places.begin() + kMostExplained);
  const std::size_t others = places.size() - kMostExplained;
  for (std::size_t i = 1; i <= kMostExplained; ++i)
    some.push_back(places[kMostExplained - 1 + i * others / kMostExplained]);
  return some;
}

/// @return those of the places whose cases pass when each has a process of its own
Places pass_alone(const Assignment& assignment, const ExerciseRubric& rubric,
                  const Build& build, const std::vector<Case>& cases, Conventions conventions,
                  const Places& places) {
  std::vector<const Case*> failed;
  for (std::size_t place : places)
    failed.push_back(&cases[place]);
  const std::vector<Outcome> outcomes =
      run_cases(build, failed, assignment.limits, Company::kAlone);
  const auto alone = judge_all(assignment, rubric, failed, outcomes, conventions, 0);
  Places passed;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (alone[i].verdict == Verdict::kPassed) passed.push_back(places[i]);
  }
  return passed;
}

/// Runs failed cases once more, each in a process of its own, and says so where that helps.
/// If that helps none of some, the others are not asked.
void run_again_alone(const Assignment& assignment, const Home& home,
                     const ExerciseRubric& rubric, const Build& build,
                     const std::vector<Case>& cases, const Conventions& conventions,
                     std::vector<CaseJudgement>& judgements) {
  const Places all = places_that_deserve_it(judgements);
  if (all.empty()) return;
  const StageTimer timer(home.times.get(), "run failures again, alone");
  const Places some = some_of(all);
  const auto ask = [&](const Places& places) {
    return pass_alone(assignment, rubric, build, cases, conventions, places);
  };
  Places passed = ask(some);
  if (!passed.empty() && some.size() < all.size()) passed = ask(all);
  for (std::size_t place : passed) {
    CaseJudgement& judgement = judgements[place];
    judgement.passes_alone = true;
    judgement.note =
        "this case passes when it is run alone: the code keeps something from one call to the "
        "next, in a global or static variable? Only a check of the whole exercise shows it";
    for (Finding& finding : judgement.findings)
      finding.likely.clear();  // the numbers are right in a fresh process
  }
}

bool can_be_smaller(const JudgedCase& judged) {
  const Verdict verdict = judged.judgement.verdict;
  return (verdict == Verdict::kFailed || verdict == Verdict::kCrashed ||
          verdict == Verdict::kOutOfSteps) &&
         judged.judgement.note.empty() && !judged.judgement.excused;
}

/// Only the first failures: the others most likely have the same reason. Not those of which
/// nothing came back: of a smaller case, too, nothing would.
void make_failures_smaller(const Assignment& assignment, const Home& home,
                           const Candidate& candidate, const std::vector<Outcome>& outcomes,
                           JudgedExercise& exercise) {
  std::size_t left = kMostShrunk;
  std::vector<Case> all;
  for (std::size_t i = 0; i < outcomes.size() && left > 0; ++i) {
    JudgedCase& judged = exercise.cases[i];
    if (outcomes[i].lost || !can_be_smaller(judged)) continue;
    const StageTimer timer(home.times.get(), "make failures smaller");
    // Those of the whole exercise, also where only one of them is judged.
    if (all.empty()) all = make_cases(assignment, *exercise.rubric, home.meshes);
    auto smaller = shrink(assignment, home, candidate, *exercise.rubric, all, judged);
    if (!smaller) continue;
    judged = std::move(*smaller);
    --left;
  }
}

}  // namespace

bool has_failure(const JudgedExercise& exercise) {
  return std::any_of(exercise.cases.begin(), exercise.cases.end(), [](const JudgedCase& c) {
    return c.judgement.verdict != Verdict::kPassed &&
           c.judgement.verdict != Verdict::kNotImplemented;
  });
}

namespace {

bool is_right(const JudgedCase& judged) {
  return judged.judgement.verdict == Verdict::kPassed || judged.judgement.excused;
}

}  // namespace

bool is_all_right(const JudgedExercise& exercise) {
  return std::all_of(exercise.cases.begin(), exercise.cases.end(), is_right);
}

bool is_required_right(const JudgedExercise& exercise) {
  std::set<std::string> extra;
  for (const Group& group : exercise.rubric->groups) {
    if (group.extra_credit) extra.insert(group.name);
  }
  return std::all_of(exercise.cases.begin(), exercise.cases.end(), [&](const JudgedCase& c) {
    return is_right(c) || extra.count(c.asked.group) != 0;
  });
}

namespace {

/// What there is to say of right answers, once each.
void note_right_answers(JudgedExercise& judged) {
  for (const JudgedCase& c : judged.cases) {
    const std::string& note = c.judgement.note;
    if (c.judgement.verdict != Verdict::kPassed || note.empty()) continue;
    if (std::find(judged.notes.begin(), judged.notes.end(), note) == judged.notes.end())
      judged.notes.push_back(note);
  }
}

}  // namespace

JudgedExercise judge_exercise(const Assignment& assignment, const Home& home,
                              const Candidate& candidate, const ExerciseRubric& rubric,
                              const std::vector<Case>& cases,
                              const std::vector<Outcome>& outcomes) {
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  std::vector<CaseJudgement> judgements;
  {
    const StageTimer timer(home.times.get(), "judge");
    judgements = judge_all(assignment, rubric, pointers_to(cases), outcomes, conventions,
                           kMostExplained);
  }
  run_again_alone(assignment, home, rubric, candidate.build, cases, conventions, judgements);
  JudgedExercise judged;
  judged.rubric = &rubric;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    blame_compilation(assignment, candidate.submission, candidate.build, judge, cases[i],
                      judgements[i]);
    name_free_function(candidate.submission, judge.functions, judgements[i]);
    judged.cases.push_back(
        {cases[i], std::move(judgements[i]), outcomes[i].output, outcomes[i].output_bytes, ""});
  }
  make_failures_smaller(assignment, home, candidate, outcomes, judged);
  std::vector<CaseJudgement*> told;
  for (JudgedCase& c : judged.cases)
    told.push_back(&c.judgement);
  tell_apart(told);
  tell_apart_by_source(candidate.submission, judge.functions, judged);
  name_static_variable(candidate.submission, judge.functions, judged);
  note_right_answers(judged);
  note_handle_references(candidate.submission, judge.functions, judged);
  note_left_over_calls(candidate.submission, judge.functions, judged);
  add_compiler_warnings(candidate.submission, candidate.build, judge, judged);
  if (conventions.size() == 1 && !has_failure(judged)) {
    judged.notes.push_back("found: " + *conventions.begin());
  }
  return judged;
}

ExerciseRun run_exercise(const Assignment& assignment, const Home& home,
                         const Candidate& candidate, const ExerciseRubric& rubric) {
  ExerciseRun run;
  {
    const StageTimer timer(home.times.get(), "make the cases");
    run.cases = make_cases(assignment, rubric, home.meshes);
  }
  run.outcomes =
      run_cases(candidate.build, pointers_to(run.cases), assignment.limits, Company::kTogether);
  run.judged = judge_exercise(assignment, home, candidate, rubric, run.cases, run.outcomes);
  if (is_all_right(run.judged)) return run;
  const StageTimer timer(home.times.get(), "run with right solutions");
  run_with_right_callees(assignment, home, candidate, run, run);
  return run;
}

bool fails_at_once(const Assignment& assignment, const Home& home, const Candidate& candidate,
                   const ExerciseRubric& rubric) {
  const std::vector<Case> cases = make_cases(assignment, rubric, home.meshes);
  const std::vector<const Case*> asked = pointers_to(cases);
  const std::vector<Outcome> outcomes =
      run_cases(candidate.build, asked, assignment.limits, Company::kTogether);
  Conventions conventions = find_exercise_judge(rubric).conventions;
  const auto judgements = judge_all(assignment, rubric, asked, outcomes, conventions, 0);
  return std::any_of(judgements.begin(), judgements.end(), [](const CaseJudgement& judgement) {
    return judgement.verdict != Verdict::kPassed && !judgement.excused;
  });
}

}  // namespace meshgrade
