#include "grader/grade/second_run.h"

#include <algorithm>
#include <optional>

#include "grader/base/text.h"
#include "grader/build/member_splice.h"
#include "grader/build/stand_in.h"
#include "grader/judge/judge.h"
#include "grader/run/run.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

std::size_t passed_cases(const JudgedExercise& exercise) {
  return static_cast<std::size_t>(std::count_if(
      exercise.cases.begin(), exercise.cases.end(),
      [](const JudgedCase& c) { return c.judgement.verdict == Verdict::kPassed; }));
}

/// What a second run is about.
struct Question {
  const Assignment& assignment;
  const Home& home;
  const Submission& submission;
  const ExerciseRun& first;
};

/// Whether this one case passes, in a process of its own.
/// @param before  its verdict with other functions
bool passes_alone(const Assignment& assignment, const Home& home, const Candidate& candidate,
                  const ExerciseRubric& rubric, const Case& asked, Verdict before) {
  const Limits limits =
      before == Verdict::kOutOfTime ? less_time(assignment.limits) : assignment.limits;
  const std::vector<Outcome> outcomes =
      run_cases(candidate.build, {&asked}, limits, Company::kTogether);
  return passed_cases(judge_exercise(assignment, home, candidate, rubric, {asked}, outcomes)) ==
         1;
}

/// Whether the outcome of a case is right, whatever conventions other cases follow.
bool is_right_outcome(const Question& question, const Case& asked, const Outcome& outcome) {
  const ExerciseRubric& rubric = *question.first.judged.rubric;
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  return judge_case(judge, {asked, outcome, rubric, question.assignment.tolerance, false},
                    conventions)
             .verdict == Verdict::kPassed;
}

bool is_endless(const ExerciseRun& run) {
  return std::any_of(run.outcomes.begin(), run.outcomes.end(),
                     [](const Outcome& o) { return o.ending == Ending::kOutOfTime; });
}

/// The reference's solution of an exercise.
StandIn stand_in_for(const Assignment& assignment, const ExerciseRubric& rubric) {
  StandIn stand_in{rubric.name, find_exercise_judge(rubric).functions};
  stand_in.folder = assignment.folder;
  return stand_in;
}

/// Puts the cases that did not pass through the worker with stand-ins, and judges all anew.
/// Those that did pass count as they came; but one that passes alone with the same stand-ins,
/// and fails after other cases, does so by what the student's function keeps from call to call.
JudgedExercise judge_second(const Question& question, const Candidate& candidate) {
  const ExerciseRun& first = question.first;
  const Limits& limits = question.assignment.limits;
  std::vector<Outcome> outcomes =
      run_cases(candidate.build, pointers_to(first.cases),
                is_endless(first) ? less_time(limits) : limits, Company::kTogether);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Case& asked = first.cases[i];
    if (first.judged.cases[i].judgement.verdict != Verdict::kPassed) continue;
    const bool keeps_state = !is_right_outcome(question, asked, outcomes[i]) &&
                             passes_alone(question.assignment, question.home, candidate,
                                          *first.judged.rubric, asked, Verdict::kPassed);
    if (!keeps_state) outcomes[i] = first.outcomes[i];
  }
  return judge_exercise(question.assignment, question.home, candidate, *first.judged.rubric,
                        first.cases, outcomes);
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
  const std::vector<StandIn> stand_in{stand_in_for(assignment, rubric)};
  const auto changed = with_stand_ins(candidate.submission, home, stand_in);
  if (!changed) return;
  const Build build = build_submission(*changed, home, assignment.limits);
  if (!has_stand_ins(build, stand_in)) return;
  const ExerciseRubric& own = *run.judged.rubric;
  const Verdict before = failed->judgement.verdict;
  if (!passes_alone(assignment, home, {*changed, build}, own, asked, before)) return;
  if (passes_alone(assignment, home, candidate, own, asked, before)) return;
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

/// A second run: what the judge says, and by which of the right solutions.
struct SecondRun {
  JudgedExercise judged;
  std::string meaning;  ///< OpenChoice::meaning; empty for the reference as it is
};

/// One more right solution in the place of one of the stand-ins.
struct OtherStandIns {
  std::vector<StandIn> stand_ins;
  std::string meaning;
};

std::vector<OtherStandIns> other_stand_ins(const Assignment& assignment,
                                           const std::vector<StandIn>& stand_ins) {
  std::vector<OtherStandIns> others;
  for (std::size_t i = 0; i < stand_ins.size(); ++i) {
    const ExerciseRubric& rubric = *assignment.find(stand_ins[i].exercise);
    for (const OpenChoice& choice : find_exercise_judge(rubric).choices) {
      OtherStandIns other{stand_ins, choice.meaning};
      other.stand_ins[i].was = choice.was;
      other.stand_ins[i].becomes = choice.becomes;
      others.push_back(std::move(other));
    }
  }
  return others;
}

/// The case that a right solution with other choices may save: the first that ran and failed.
std::optional<JudgedCase> first_failed(const Question& question, const JudgedExercise& judged) {
  for (std::size_t i = 0; i < judged.cases.size(); ++i) {
    if (judged.cases[i].judgement.findings.empty()) continue;
    JudgedCase failed = judged.cases[i];
    failed.asked = question.first.cases[i];  // as it was before it was made smaller
    return failed;
  }
  return std::nullopt;
}

/// What the contract of the stand-ins leaves open may be what the student's code relies on: it
/// is right if it is so with one of them. Only the first failing case is asked each time.
void try_other_choices(const Question& question, const std::vector<StandIn>& stand_ins,
                       SecondRun& best) {
  const std::optional<JudgedCase> failed = first_failed(question, best.judged);
  if (!failed) return;
  for (const OtherStandIns& other : other_stand_ins(question.assignment, stand_ins)) {
    const auto changed = with_stand_ins(question.submission, question.home, other.stand_ins);
    if (!changed) continue;
    const Build build = build_submission(*changed, question.home, question.assignment.limits);
    const Candidate candidate{*changed, build};
    if (!passes_alone(question.assignment, question.home, candidate,
                      *question.first.judged.rubric, failed->asked,
                      failed->judgement.verdict)) {
      continue;
    }
    JudgedExercise judged = judge_second(question, candidate);
    if (passed_cases(judged) <= passed_cases(best.judged)) continue;
    best = {std::move(judged), other.meaning};
    if (is_all_right(best.judged)) return;
  }
}

/// Takes from the second run the cases that pass, and those that the first run says nothing
/// about. What the first run found stays where the case fails with a right solution, too.
/// @return how many cases were taken
std::size_t take_over(JudgedExercise second, JudgedExercise& first) {
  std::size_t taken = 0;
  for (std::size_t i = 0; i < first.cases.size(); ++i) {
    JudgedCase& mine = first.cases[i];
    JudgedCase& other = second.cases[i];
    const bool was_right = mine.judgement.verdict == Verdict::kPassed;
    const bool is_right = other.judgement.verdict == Verdict::kPassed;
    const bool says_nothing =
        mine.judgement.findings.empty() && !other.judgement.findings.empty();
    if (was_right ? is_right : !is_right && !says_nothing) continue;
    mine = std::move(other);
    ++taken;
  }
  return taken;
}

/// "v3, an old vertex with 5 edges: expected ..., not ...": what is left when nothing of the
/// student's own flip and split takes part.
void tell_what_still_fails(const JudgedExercise& second, const std::string& causes,
                           std::vector<std::string>& notes) {
  for (const JudgedCase& c : second.cases) {
    if (c.judgement.findings.empty()) continue;
    const Finding& finding = c.judgement.findings[0];
    notes.push_back(c.asked.id() + " fails with a right solution of " + causes +
                    ", too: " + finding.meaning +
                    (finding.element.empty() ? "" : "; look at " + finding.element) +
                    (finding.actual.empty() ? "" : ": " + finding.actual));
    return;
  }
}

void add_notes(const SecondRun& second, const std::string& causes, std::size_t first_passed,
               JudgedExercise& judged) {
  const std::string which = second.meaning.empty() ? "" : " (" + second.meaning + ")";
  judged.notes.push_back("so it was run again with a right solution of " + causes + which +
                         " in place of yours: " + std::to_string(passed_cases(judged)) +
                         " of " + plural(judged.cases.size(), "case") + " pass, instead of " +
                         std::to_string(first_passed) + "; these points count");
  std::vector<std::string> notes = second.judged.notes;
  tell_what_still_fails(second.judged, causes, notes);
  for (std::string& note : notes) {
    const auto& known = judged.notes;
    if (std::find(known.begin(), known.end(), note) == known.end())
      judged.notes.push_back(std::move(note));
  }
}

/// Whether the exercise's own functions are not there: what it calls can be as right as it
/// likes.
bool is_unwritten(const JudgedExercise& exercise) {
  return std::all_of(exercise.cases.begin(), exercise.cases.end(), [](const JudgedCase& c) {
    return c.judgement.verdict == Verdict::kNotImplemented;
  });
}

std::string why_not_run_again(const Submission& submission, const std::string& causes) {
  if (is_scotty3d(submission.dialect)) {
    return "homework for Scotty3D cannot be run with a right solution of " + causes +
           " in place of yours: first mend your own";
  }
  return "your instructor's grader runs it again with a right solution of " + causes +
         "; this package comes without one";
}

/// Runs the exercise again with right solutions of these in place of the student's.
void run_with(const Assignment& assignment, const Home& home, const Candidate& candidate,
              const std::vector<const JudgedExercise*>& wrong, ExerciseRun& run) {
  std::vector<std::string> names;
  std::vector<StandIn> stand_ins;
  for (const JudgedExercise* exercise : wrong) {
    const ExerciseRubric& rubric = *exercise->rubric;
    names.push_back(rubric.name);
    stand_ins.push_back(stand_in_for(assignment, rubric));
    const std::string note =
        "your own " + rubric.name + " is part of this and " + state_of(*exercise);
    const auto& known = run.judged.notes;
    if (std::find(known.begin(), known.end(), note) == known.end())
      run.judged.notes.push_back(note);
  }
  if (is_unwritten(run.judged)) return;
  const std::string causes = join(names, " and ");
  const auto changed = with_stand_ins(candidate.submission, home, stand_ins);
  if (!changed) {
    run.judged.notes.push_back(why_not_run_again(candidate.submission, causes));
    return;
  }
  const Build build = build_submission(*changed, home, assignment.limits);
  if (!has_stand_ins(build, stand_ins)) {
    run.judged.notes.push_back("it could not be run again with a right solution of " + causes +
                               ": your own cannot be taken out of its file");
    return;
  }
  const Question question{assignment, home, candidate.submission, run};
  SecondRun second{judge_second(question, {*changed, build}), ""};
  try_other_choices(question, stand_ins, second);
  const bool had_failure = has_failure(run.judged);
  const std::size_t first_passed = passed_cases(run.judged);
  const std::size_t taken = take_over(second.judged, run.judged);
  if (taken == 0 && !had_failure) return;
  add_notes(second, causes, first_passed, run.judged);
  if (taken > 0) run.judged.stand_ins = std::move(names);
}

/// Whether a text could ask what lies on a boundary: by isBoundary(), by the list of
/// boundaries, or since a boundary loop is no triangle; in a macro as well.
bool may_ask_for_boundaries(const std::string& text) {
  std::string code = code_only(text);
  for (const std::string& line : split_lines(text)) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line[first] == '#') code += line + "\n";
  }
  return code.find("oundar") != std::string::npos ||
         code.find("face()->degree") != std::string::npos;
}

/// Whether anything but the other exercises' functions does so: without that, a subdivision
/// cannot treat boundaries in a way of their own, whatever splits its edges.
bool asks_for_boundaries(const Assignment& assignment, const Submission& submission,
                         const ExerciseRubric& own) {
  const auto asks = [&](const SourceFile& file) {
    LeavingOut rest(file.name, file.text);
    for (const ExerciseRubric& rubric : assignment.exercises) {
      if (rubric.name == own.name) continue;
      for (const std::string& function : find_exercise_judge(rubric).functions)
        rest.remove_function(function);
    }
    return may_ask_for_boundaries(rest.text());
  };
  const auto any = [&](const std::vector<SourceFile>& files) {
    return std::any_of(files.begin(), files.end(), asks);
  };
  // Of the course's own headers only what the student has added to them.
  const MemberSplice added(submission);
  return any(submission.sources) || any(submission.headers) ||
         (!added.empty() && any(added.files()));
}

}  // namespace

void run_with_stand_ins(const Assignment& assignment, const Home& home,
                        const Candidate& candidate, const std::vector<JudgedExercise>& needed,
                        ExerciseRun& run) {
  std::vector<const JudgedExercise*> wrong;
  std::vector<const JudgedExercise*> incomplete;
  for (const JudgedExercise& exercise : needed) {
    if (!is_required_right(exercise)) wrong.push_back(&exercise);
    if (!is_all_right(exercise)) incomplete.push_back(&exercise);
  }
  if (!wrong.empty()) run_with(assignment, home, candidate, wrong, run);
  // What is missing for extra credit only may not hide how the student's own parts fit
  // together.
  const bool is_more = incomplete.size() > wrong.size() && is_required_right(run.judged) &&
                       !is_all_right(run.judged);
  if (is_more) {
    const ExerciseRubric& own = *run.judged.rubric;
    if (!asks_for_boundaries(assignment, candidate.submission, own)) return;
    run_with(assignment, home, candidate, incomplete, run);
  } else if (wrong.empty()) {
    tell_what_it_relies_on(assignment, home, candidate, needed, run);
  }
}

}  // namespace meshgrade
