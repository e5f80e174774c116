#include "grader/mutants/right_answers.h"

#include <set>

#include "grader/base/job_pool.h"
#include "grader/base/random.h"
#include "grader/base/wire.h"
#include "grader/mutants/variants.h"
#include "grader/report/json_report.h"

namespace meshgrade {
namespace {

/// Each file is drawn from any of the originals.
Submission draw_submission(const std::vector<Original>& originals, Random& random) {
  Submission drawn;
  drawn.name = "variant";
  for (const SourceFile& file : originals.at(0).submission.sources) {
    const Original& from =
        originals[random.below(static_cast<std::uint32_t>(originals.size()))];
    for (const SourceFile& other : from.submission.sources) {
      if (other.name == file.name) {
        drawn.sources.push_back({file.name, make_variant(other.text, random)});
      }
    }
  }
  return drawn;
}

std::string first_finding(const ExerciseReport& exercise) {
  for (const CaseReport& c : exercise.cases) {
    if (c.verdict == Verdict::kPassed) continue;
    const std::string what = c.findings.empty() ? c.note
                                                : c.findings[0].finding.element + ": " +
                                                      c.findings[0].finding.actual;
    return c.title + ": " + what;
  }
  return "no finding";
}

/// What is wrong with the report of a right answer, a line for each exercise.
std::vector<std::string> find_losses(const Report& report) {
  std::vector<std::string> losses;
  for (const FileReport& file : report.files) {
    if (!file.compiled) losses.push_back(file.name + " does not compile: " + file.messages);
  }
  for (const ExerciseReport& exercise : report.exercises) {
    if (exercise.points >= exercise.max_points &&
        exercise.extra_points >= exercise.max_extra_points) {
      continue;
    }
    losses.push_back(exercise.name + ": " + first_finding(exercise));
  }
  return losses;
}

struct Losses {
  std::vector<std::string> lines;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(lines);
  }
};

}  // namespace

VariantsResult grade_variants(const std::vector<Original>& originals, std::size_t count,
                              std::uint64_t seed, const GradeFunction& grade, unsigned jobs,
                              const JobProgress& progress) {
  std::vector<Submission> submissions;
  std::set<std::string> texts;
  VariantsResult result;
  Random random(seed, "variants");
  while (result.drawn < count) {
    submissions.push_back(draw_submission(originals, random));
    for (const SourceFile& file : submissions.back().sources)
      texts.insert(file.name + file.text);
    result.drawn += submissions.back().sources.size();
  }
  result.different = texts.size();
  const auto work = [&](std::size_t i) {
    return to_wire(Losses{find_losses(grade(submissions[i], {}))});
  };
  const auto losses = run_jobs(submissions.size(), jobs, work, [&](std::size_t done) {
    progress("variants", done, submissions.size());
  });
  for (std::size_t i = 0; i < losses.size(); ++i) {
    for (const std::string& line : from_wire<Losses>(losses[i]).lines) {
      result.refused.push_back("submission " + std::to_string(i) + " of seed " +
                               std::to_string(seed) + ": " + line);
    }
  }
  return result;
}

DeterminismResult compare_runs(const Assignment& assignment,
                               const std::vector<Original>& originals,
                               const std::vector<Mutant>& mutants, const GradeFunction& grade,
                               const JobProgress& progress) {
  std::vector<MutantSubmission> submissions;
  for (const Mutant& mutant : mutants) {
    for (const Original& original : originals) {
      if (original.name != mutant.original) continue;
      submissions.push_back(own_exercise(assignment, original, mutant));
    }
  }
  const std::size_t n = submissions.size();
  const auto work = [&](std::size_t i) {
    return to_json(grade(submissions[i % n].submission, submissions[i % n].exercises));
  };
  const auto tell = [&](std::size_t done) { progress("reports to compare", done, 3 * n); };
  const auto alone = run_jobs(n, 1, work, tell);
  const auto together = run_jobs(2 * n, 2, work, [&](std::size_t done) { tell(n + done); });
  DeterminismResult result{n, {}};
  for (std::size_t i = 0; i < n; ++i) {
    if (alone[i] == together[i] && alone[i] == together[n + i]) continue;
    result.differing.push_back(mutants[i].id());
  }
  return result;
}

}  // namespace meshgrade
