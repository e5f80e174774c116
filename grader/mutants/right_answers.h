#pragma once

#include <string>
#include <vector>

#include "grader/mutants/mutant_grading.h"

namespace meshgrade {

/// How right answers fared.
struct VariantsResult {
  std::size_t drawn = 0;             ///< files
  std::size_t different = 0;         ///< of them no two the same
  std::vector<std::string> refused;  ///< what lost points, and why
};

/// Draws at least `count` variants of the originals' files, grades them as whole submissions
/// and expects full points.
VariantsResult grade_variants(const std::vector<Original>& originals, std::size_t count,
                              std::uint64_t seed, const GradeFunction& grade, unsigned jobs,
                              const JobProgress& progress);

/// Whether the same submission gives the same report.
struct DeterminismResult {
  std::size_t submissions = 0;
  std::vector<std::string> differing;  ///< ids of mutants with two different reports
};

/// Grades mutants three times: one at a time, and all of them twice with two at a time.
/// Compares the JSON reports byte for byte.
DeterminismResult compare_runs(const Assignment& assignment,
                               const std::vector<Original>& originals,
                               const std::vector<Mutant>& mutants, const GradeFunction& grade,
                               const JobProgress& progress);

}  // namespace meshgrade
