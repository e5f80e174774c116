#include "grader/mutants/mutant_grading.h"

#include <algorithm>
#include <cctype>

#include "grader/base/errors.h"
#include "grader/base/job_pool.h"
#include "grader/base/wire.h"

namespace meshgrade {
namespace {

/// What crosses from the process that grades.
struct Graded {
  Fate fate = Fate::kSurvived;
  std::string verdict;
  std::string first_exercise;
  std::string element;
  bool names_function = false;
  double points = 0.0;
  double points_without_parts = 0.0;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(fate, verdict, first_exercise, element, names_function, points, points_without_parts);
  }
};

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

bool contains_word(const std::string& text, const std::string& word) {
  const auto is_word = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0);
  };
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1)) {
    if ((at == 0 || !is_word(at - 1)) && !is_word(at + word.size())) return true;
  }
  return false;
}

bool is_full(const ExerciseReport& exercise) {
  return exercise.verdict == Verdict::kPassed && exercise.points >= exercise.max_points &&
         exercise.extra_points >= exercise.max_extra_points;
}

/// In an exercise of one function its name is enough. In others the first finding must name it:
/// by what to look at, or by the innermost frame of the student's stack, or, if it says
/// neither, the title of the case does.
bool names_function(const CaseReport& c, const std::string& function) {
  if (c.findings.empty()) return contains_word(c.note, function);
  const FindingReport& first = c.findings[0];
  if (contains_word(first.finding.look_at, function)) return true;
  if (!first.places.empty()) return contains_word(first.places[0].function, function);
  return contains_word(c.title, function);
}

/// A mistake that only the caller can see is named in a note of the caller's exercise.
bool blames(const std::vector<std::string>& notes, const std::string& exercise) {
  const std::string words = "with a right " + exercise + " in place of yours, ";
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.rfind(words, 0) == 0; });
}

Graded summarise(const Report& report, const Mutant& mutant, bool has_many_functions) {
  Graded graded;
  for (const FileReport& file : report.files) {
    if (file.compiled) continue;
    if (file.name != mutant.file)
      throw GraderError(file.name + " of " + mutant.original + " does not compile");
    graded.fate = Fate::kNotCompiled;
    return graded;
  }
  if (report.has_grader_error()) throw GraderError("a case ended with a grader error");
  for (const ExerciseReport& exercise : report.exercises) {
    if (is_full(exercise)) continue;
    graded.fate = Fate::kKilled;
    graded.first_exercise = exercise.name;
    graded.names_function =
        exercise.name == mutant.exercise || blames(exercise.notes, mutant.exercise);
    for (const CaseReport& c : exercise.cases) {
      if (c.verdict == Verdict::kPassed || c.verdict == Verdict::kNotJudged) continue;
      graded.verdict = verdict_name(c.verdict);
      if (!c.findings.empty()) graded.element = c.findings[0].finding.element;
      if (has_many_functions && !names_function(c, mutant.function)) {
        graded.names_function = false;
      }
      break;
    }
    break;
  }
  return graded;
}

/// The share of an exercise's points that the report gives, and that it would give if no group
/// gave a part of its points.
void add_points(const Report& report, const ExerciseRubric& rubric, Graded& graded) {
  const auto found =
      std::find_if(report.exercises.begin(), report.exercises.end(),
                   [&](const ExerciseReport& e) { return e.name == rubric.name; });
  if (found == report.exercises.end() || found->max_points <= 0.0) return;
  std::vector<std::string> earned;
  double whole = 0.0;
  for (const GroupReport& group : found->groups) {
    const auto of_name = [&](const Group& g) { return g.name == group.name; };
    const auto rule = std::find_if(rubric.groups.begin(), rubric.groups.end(), of_name);
    const bool counts = rule->needs.empty() || contains(earned, rule->needs);
    if (!counts || group.passed < group.judged || group.judged == 0) continue;
    earned.push_back(group.name);
    if (!group.extra_credit) whole += group.max_points;
  }
  graded.points = found->points / found->max_points;
  graded.points_without_parts = whole / found->max_points;
}

const Original& original_of(const std::vector<Original>& originals, const Mutant& mutant) {
  for (const Original& original : originals) {
    if (original.name == mutant.original) return original;
  }
  throw GraderError("no original named " + mutant.original);
}

}  // namespace

MutantSubmission own_exercise(const Assignment& assignment, const Original& original,
                              const Mutant& mutant) {
  const std::vector<std::string>& needed = assignment.find(mutant.exercise)->needs;
  MutantSubmission made{{}, {mutant.exercise}};
  made.submission.name = original.name;
  for (const SourceFile& file : original.submission.sources) {
    if (file.name == mutant.file) {
      made.submission.sources.push_back({file.name, mutant.text});
    } else if (contains(needed, file.name.substr(0, file.name.find('.')))) {
      made.submission.sources.push_back(file);
    }
  }
  return made;
}

MutantSubmission all_exercises(const Assignment& assignment, const Original& original,
                               const Mutant& mutant) {
  MutantSubmission made{original.submission, {}};
  made.submission.name = original.name;
  for (SourceFile& file : made.submission.sources) {
    if (file.name == mutant.file) file.text = mutant.text;
  }
  for (const ExerciseRubric& rubric : assignment.exercises)
    made.exercises.push_back(rubric.name);
  return made;
}

std::vector<Mutant> without_failing(const Assignment& assignment,
                                    const std::vector<Original>& originals,
                                    const std::vector<Mutant>& mutants,
                                    const FailsFunction& fails, unsigned jobs,
                                    const JobProgress& progress) {
  const std::string failing = "fails";
  const auto work = [&](std::size_t i) -> std::string {
    const Mutant& mutant = mutants[i];
    const auto made = own_exercise(assignment, original_of(originals, mutant), mutant);
    try {
      return fails(made.submission, mutant.exercise) ? failing : "";
    } catch (const GraderError&) {
      return "";  // grading it will say so
    }
  };
  const auto results = run_jobs(mutants.size(), jobs, work, [&](std::size_t done) {
    progress("mutants, at a glance", done, mutants.size());
  });
  std::vector<Mutant> left;
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    if (results[i] != failing) left.push_back(mutants[i]);
  }
  return left;
}

std::vector<MutantResult> grade_mutants(const Assignment& assignment,
                                        const std::vector<Original>& originals,
                                        const std::vector<Mutant>& mutants,
                                        const GradeFunction& grade, unsigned jobs,
                                        const JobProgress& progress) {
  const auto work = [&](std::size_t i) {
    const Mutant& mutant = mutants[i];
    const Original& original = original_of(originals, mutant);
    const ExerciseJudge judge = find_exercise_judge(*assignment.find(mutant.exercise));
    const auto look_at = [&](const MutantSubmission& made) {
      const Report report = grade(made.submission, made.exercises);
      Graded graded = summarise(report, mutant, judge.functions.size() > 1);
      add_points(report, *assignment.find(mutant.exercise), graded);
      return graded;
    };
    try {
      const Graded graded = look_at(own_exercise(assignment, original, mutant));
      if (graded.fate != Fate::kSurvived) return to_wire(graded);
      return to_wire(look_at(all_exercises(assignment, original, mutant)));
    } catch (const GraderError& error) {
      Graded failed;
      failed.fate = Fate::kGraderFailed;
      failed.verdict = error.what();
      return to_wire(failed);
    }
  };
  const auto results = run_jobs(mutants.size(), jobs, work, [&](std::size_t done) {
    progress("mutants", done, mutants.size());
  });
  std::vector<MutantResult> list;
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    const auto graded = from_wire<Graded>(results[i]);
    list.push_back({mutants[i], graded.fate, graded.verdict, graded.first_exercise,
                    graded.element, graded.names_function, graded.points,
                    graded.points_without_parts, wrong_pointers(mutants[i])});
  }
  return list;
}

}  // namespace meshgrade
