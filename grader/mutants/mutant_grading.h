#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/mutants/localisation.h"
#include "grader/mutants/mutant.h"
#include "grader/report/report.h"

namespace meshgrade {

/// The ordinary way from a submission to its report, for these exercises only.
using GradeFunction = std::function<Report(const Submission& submission,
                                           const std::vector<std::string>& exercises)>;

/// Whether an exercise of a submission that compiles fails, whatever is to be said of it.
using FailsFunction =
    std::function<bool(const Submission& submission, const std::string& exercise)>;

/// Told how many of how many jobs are done.
using JobProgress =
    std::function<void(const std::string& what, std::size_t done, std::size_t count)>;

enum class Fate { kKilled, kSurvived, kNotCompiled, kGraderFailed };

struct MutantResult {
  Mutant mutant;
  Fate fate = Fate::kSurvived;
  std::string verdict;          ///< of the first case that is not passed; or the grader's error
  std::string first_exercise;   ///< that loses points, in the order of the report
  std::string element;          ///< of the first finding of its first case that is not passed
  bool names_function = false;  ///< exercise and finding name the function with the mistake

  double points = 0.0;                ///< of its exercise, 1 for all; extra credit aside
  double points_without_parts = 0.0;  ///< the same if groups gave all of theirs or none

  /// Of mutants that only set a pointer wrong.
  std::set<PointerName> wrong_pointers;
  bool names_pointer() const { return wrong_pointers.count(named_pointer(element)) != 0; }
};

/// What a mutant is graded as.
struct MutantSubmission {
  Submission submission;
  std::vector<std::string> exercises;
};
/// The exercise of the mutant's file alone, with the original's other files that it needs.
MutantSubmission own_exercise(const Assignment& assignment, const Original& original,
                              const Mutant& mutant);
/// The whole submission, and all exercises.
MutantSubmission all_exercises(const Assignment& assignment, const Original& original,
                               const Mutant& mutant);

/// Those that do not fail in their own exercise, and those that do not compile: to be graded.
/// It takes a part of the time of grading all.
std::vector<Mutant> without_failing(const Assignment& assignment,
                                    const std::vector<Original>& originals,
                                    const std::vector<Mutant>& mutants,
                                    const FailsFunction& fails, unsigned jobs,
                                    const JobProgress& progress);

/// Grades all, `jobs` at a time: by the exercise of the file, and if that finds nothing, by the
/// others, which may call its functions. (The first exercise that loses points is the same as
/// if all were graded at once: exercises come before those that call them.)
std::vector<MutantResult> grade_mutants(const Assignment& assignment,
                                        const std::vector<Original>& originals,
                                        const std::vector<Mutant>& mutants,
                                        const GradeFunction& grade, unsigned jobs,
                                        const JobProgress& progress);

}  // namespace meshgrade
