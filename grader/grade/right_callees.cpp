#include "grader/grade/right_callees.h"

#include <set>

#include "grader/base/contains.h"
#include "grader/base/text.h"
#include "grader/build/stand_in.h"
#include "grader/judge/judge.h"
#include "grader/judge/tell_apart.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

bool is_about(const Case& asked, const std::string& function) {
  return !asked.calls.empty() && asked.calls.front() == function;
}

bool is_passed(const JudgedCase& c) {
  return c.judgement.verdict == Verdict::kPassed;
}

/// The functions of which a case of their own does not pass. A case that was made smaller may
/// be about another function than the one that it was.
std::set<std::string> failing_functions(const ExerciseRun& run) {
  std::set<std::string> failing;
  for (std::size_t i = 0; i < run.cases.size(); ++i) {
    const std::vector<std::string>& calls = run.cases[i].calls;
    if (!is_passed(run.judged.cases[i]) && !calls.empty()) failing.insert(calls.front());
  }
  return failing;
}

/// Places of the cases about a function that another function may be to blame for.
std::vector<std::size_t> failed_cases(const ExerciseRun& run, const std::string& function) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < run.cases.size(); ++i) {
    const JudgedCase& c = run.judged.cases[i];
    const bool unwritten = c.judgement.note == function + " is not implemented";
    if (is_about(run.cases[i], function) && !is_passed(c) && !unwritten) places.push_back(i);
  }
  return places;
}

/// "evaluateStep" of "BezierPatch::evaluateStep".
std::string short_name(const std::string& function) {
  return function.substr(function.rfind(':') + 1);
}

std::string short_names(const std::vector<std::string>& functions) {
  std::vector<std::string> names;
  for (const std::string& function : functions)
    names.push_back(short_name(function));
  return join(names, " and ");
}

class CalleeRun {
 public:
  CalleeRun(const Assignment& assignment, const Home& home, const Candidate& candidate,
            ExerciseRun& run)
      : assignment_(assignment),
        home_(home),
        candidate_(candidate),
        run_(run),
        functions_(find_exercise_judge(*run.judged.rubric).functions) {}

  /// Runs the cases about `caller` again. `wrong` are the functions that fail and that it may
  /// call, `replaced` these and what they may call in turn.
  void repeat(const std::string& caller, const std::vector<std::string>& wrong,
              const std::vector<std::string>& replaced,
              const std::vector<std::size_t>& places) {
    const std::string names = short_names(wrong);
    const std::string note =
        short_name(caller) + " may call your " + names + ", which fails: see there first";
    StandIn stand_in{run_.judged.rubric->name, replaced, all_but(replaced)};
    stand_in.folder = assignment_.folder;
    const auto changed = with_stand_ins(candidate_.submission, home_, {stand_in});
    if (!changed) {
      run_.judged.notes.push_back(note +
                                  ". Your instructor's grader runs it again with a right " +
                                  names + "; this package comes without one");
      return;
    }
    const Build build = build_submission(*changed, home_, assignment_.limits);
    if (!has_stand_ins(build, {stand_in})) {
      run_.judged.notes.push_back(note + ". It could not be run again with a right " + names +
                                  ": yours cannot be taken out of its file");
      return;
    }
    const std::size_t passed = replace({*changed, build}, places);
    run_.judged.notes.push_back(note + ". So it was run again with a right " + names +
                                " in place of yours: " + std::to_string(passed) + " of " +
                                plural(places.size(), "case") +
                                " that had failed pass; these points count");
  }

 private:
  std::vector<std::string> all_but(const std::vector<std::string>& some) const {
    std::vector<std::string> others;
    for (const std::string& function : functions_) {
      if (!contains(some, function)) others.push_back(function);
    }
    return others;
  }

  /// @return how many of the cases pass now
  std::size_t replace(const Candidate& changed, const std::vector<std::size_t>& places) {
    std::vector<Case> cases;
    for (std::size_t place : places)
      cases.push_back(run_.cases[place]);
    const std::vector<Outcome> outcomes =
        run_cases(changed.build, pointers_to(cases), assignment_.limits, Company::kTogether);
    JudgedExercise second =
        judge_exercise(assignment_, home_, changed, *run_.judged.rubric, cases, outcomes);
    std::size_t passed = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      passed += is_passed(second.cases[i]) ? 1 : 0;
      run_.judged.cases[places[i]] = std::move(second.cases[i]);
    }
    return passed;
  }

  const Assignment& assignment_;
  const Home& home_;
  const Candidate& candidate_;
  ExerciseRun& run_;
  std::vector<std::string> functions_;
};

}  // namespace

void run_with_right_callees(const Assignment& assignment, const Home& home,
                            const Candidate& candidate, const ExerciseRun& whole,
                            ExerciseRun& run) {
  std::set<std::string> failing = failing_functions(whole);
  for (const std::string& function : find_exercise_judge(*run.judged.rubric).functions) {
    const std::vector<std::size_t> places = failed_cases(run, function);
    if (places.empty()) continue;
    std::vector<std::string> wrong;
    std::vector<std::string> replaced;
    for (const std::string& callee : run.cases[places[0]].calls) {
      if (callee == function) continue;
      if (failing.count(callee) != 0) wrong.push_back(callee);
      if (!wrong.empty()) replaced.push_back(callee);
    }
    if (wrong.empty()) continue;
    CalleeRun(assignment, home, candidate, run).repeat(function, wrong, replaced, places);
    if (failed_cases(run, function).empty()) failing.erase(function);
  }
  // What a caller's numbers looked like before must not speak for its callee.
  std::vector<CaseJudgement*> told;
  for (JudgedCase& c : run.judged.cases)
    told.push_back(&c.judgement);
  tell_apart(told);
}

bool has_callees(const Case& asked, const ExerciseRubric& rubric) {
  const std::vector<std::string> functions = find_exercise_judge(rubric).functions;
  return asked.calls.size() > 1 && contains(functions, asked.calls[1]);
}

}  // namespace meshgrade
