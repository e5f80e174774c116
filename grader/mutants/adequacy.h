#pragma once

// The proof that the grader finds mistakes, says where they are, and refuses no right answer.

#include <functional>
#include <string>
#include <vector>

#include "grader/mutants/mutant_grading.h"
#include "grader/mutants/right_answers.h"
#include "grader/mutants/single_pointers.h"
#include "grader/mutants/survivor_list.h"

namespace meshgrade {

struct AdequacyOptions {
  std::uint64_t seed = 184;
  std::size_t mutants = 0;  ///< how many to draw of all; 0: all
  std::size_t variants = 240;
  std::size_t repeated = 12;  ///< submissions that are graded three times
  unsigned jobs = 2;
  std::string assignment;           ///< as or_standard_assignment() takes it
  std::string exercise;             ///< only this one; empty: all
  std::vector<std::string> styles;  ///< names of the solutions to change; empty: all
  /// Whether the solutions are run, and spoiled in one pointer each; and whether all mutants of
  /// the textbook that set just one pointer wrong are graded, drawn or not.
  bool single_pointers = true;
  /// Whether only those mutants are graded that do not fail at a glance.
  bool survivors_only = false;
};

struct Adequacy {
  AdequacyOptions options;
  std::vector<std::string> exercises;
  std::size_t possible_mutants = 0;  ///< of which `mutants` are all, or some
  std::size_t failed_at_once = 0;    ///< mutants that were killed without being graded
  std::vector<MutantResult> mutants;
  SurvivorList reviewed;
  std::vector<std::string> unexplained;         ///< survivors that are not in the list
  std::vector<std::string> outdated;            ///< listed, but killed or not made any more
  std::vector<std::string> grader_errors;       ///< mutants that the grader itself failed on
  std::vector<SinglePointers> single_pointers;  ///< of each solution's flip and split
  VariantsResult variants;
  DeterminismResult determinism;

  bool is_proven() const {
    return unexplained.empty() && outdated.empty() && grader_errors.empty() &&
           variants.refused.empty() && determinism.differing.empty();
  }
};

/// Why a survivor is right: by its own entry in the list, or by that of the mutant that has the
/// same mistake always. Empty if there is none.
std::string reason_of(const Mutant& mutant, const SurvivorList& reviewed);

/// How many of how many.
struct Share {
  std::size_t part = 0;
  std::size_t whole = 0;

  double percent() const {
    return whole == 0 ? 100.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Of the killed mutants: those where the first finding names the pointer, the function.
Share pointers_named(const Adequacy& adequacy);
Share functions_named(const Adequacy& adequacy);

/// How submissions are graded, how they are only asked whether they fail, and how the cases of
/// one exercise are run only.
struct Pipeline {
  GradeFunction grade;
  FailsFunction fails;
  std::function<RightRun(const Original&, const ExerciseRubric&)> run;
};

Adequacy measure_adequacy(const Assignment& assignment, const std::vector<Original>& originals,
                          const SurvivorList& reviewed, const AdequacyOptions& options,
                          const Pipeline& pipeline, const JobProgress& progress);

}  // namespace meshgrade
