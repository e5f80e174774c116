#include "grader/commands/adequacy_check.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/commands/context.h"
#include "grader/grade/exercise_run.h"
#include "grader/grade/grading.h"
#include "grader/mutants/adequacy_page.h"
#include "grader/mutants/mistake_table.h"

namespace meshgrade {
namespace {

/// Mutants run into limits more often than students: a right answer needs a hundredth of these.
constexpr std::uint32_t kCaseMilliseconds = 500;
constexpr std::uint32_t kMemoryMegabytes = 1024;

/// A smaller sample is for trying things out.
constexpr std::size_t kMutantsOfAPage = 600;

Assignment strict_assignment(const std::string& name) {
  Assignment assignment = load_assignment(name);
  assignment.limits.case_cpu_ms = kCaseMilliseconds;
  assignment.limits.memory_mb = kMemoryMegabytes;
  return assignment;
}

std::vector<Original> find_originals(const Assignment& assignment,
                                     const std::vector<std::string>& wanted) {
  const std::filesystem::path source = source_folder();
  std::vector<Original> originals{
      {"reference",
       find_submission(source / "reference" / assignment.folder, assignment.submission)}};
  if (!assignment.folder.empty()) return originals;
  for (const char* style : {"textbook", "singles", "turned", "arrays", "floats"}) {
    originals.push_back(
        {style, find_submission(source / "tests" / "mutants" / style, assignment.submission)});
  }
  std::erase_if(originals, [&](const Original& original) {
    return !wanted.empty() &&
           std::find(wanted.begin(), wanted.end(), original.name) == wanted.end();
  });
  return originals;
}

void show_progress(const std::string& what, std::size_t done, std::size_t count) {
  if (::isatty(STDERR_FILENO) == 0) return;
  std::cerr << "\r\033[K" << what << ": " << done << " of " << count << std::flush;
  if (done == count) std::cerr << "\r\033[K" << std::flush;
}

/// For several submissions at a time, each on one core.
Home home_for_many() {
  Home home = find_home();
  home.cores = 1;
  return home;
}

GradeFunction quiet_grading(const Assignment& assignment, const Home& home) {
  return [&](const Submission& submission, const std::vector<std::string>& exercises) {
    return grade(assignment, submission, home, exercises, [](const std::string&) {});
  };
}

/// What does not compile as a whole is left to be graded.
FailsFunction quick_look(const Assignment& assignment, const Home& home) {
  return [&](const Submission& submission, const std::string& exercise) {
    const Build build = build_submission(submission, home, assignment.limits);
    const bool compiles =
        std::all_of(build.files.begin(), build.files.end(),
                    [](const BuiltFile& file) { return file.ok && file.left_out.empty(); });
    return compiles &&
           fails_at_once(assignment, home, {submission, build}, *assignment.find(exercise));
  };
}

Pipeline pipeline_of(const Assignment& assignment, const Home& home) {
  const auto run = [&](const Original& original, const ExerciseRubric& rubric) {
    const Build build =
        build_submission(original.submission, home, assignment.limits, BuildKind::kGrading);
    ExerciseRun ran = run_exercise(assignment, home, {original.submission, build}, rubric);
    return RightRun{original.name, std::move(ran.cases), std::move(ran.outcomes)};
  };
  return {quiet_grading(assignment, home), quick_look(assignment, home), run};
}

std::vector<KnownMistake> grade_mistakes(unsigned jobs) {
  const Assignment assignment = strict_assignment("");
  const Home home = home_for_many();
  const std::filesystem::path source = source_folder();
  const Submission reference = find_submission(source / "reference", assignment.submission);
  return grade_known_mistakes(assignment, source / "tests" / "submissions" / "wrong", reference,
                              quiet_grading(assignment, home), jobs, show_progress);
}

std::filesystem::path adequacy_page() {
  return source_folder() / "docs" / "adequacy.md";
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

int write_known_mistakes(unsigned jobs) {
  const std::filesystem::path page = adequacy_page();
  write_file_safely(page, with_mistakes(read_text(page), grade_mistakes(jobs)));
  std::cout << "wrote " << page.string() << "\n";
  return 0;
}

Adequacy measure_standard_adequacy(const AdequacyOptions& options,
                                   const JobProgress& progress) {
  const Assignment assignment = strict_assignment(options.assignment);
  if (!options.exercise.empty() && assignment.find(options.exercise) == nullptr) {
    throw UserError("\"" + options.exercise + "\" is no exercise of the assignment");
  }
  const Home home = home_for_many();
  const SurvivorList reviewed = read_survivor_list(source_folder() / "tests" / "mutants" /
                                                   assignment.folder / "survivors.toml");
  return measure_adequacy(assignment, find_originals(assignment, options.styles), reviewed,
                          options, pipeline_of(assignment, home), progress);
}

int check_adequacy(const AdequacyOptions& options, const std::string& page) {
  const Adequacy adequacy = measure_standard_adequacy(options, show_progress);
  std::cout << to_summary(adequacy);
  const bool tells_enough = !options.survivors_only &&
                            (options.mutants == 0 || options.mutants >= kMutantsOfAPage) &&
                            options.exercise.empty() && options.assignment.empty();
  if (tells_enough || !page.empty()) {
    const std::filesystem::path file =
        page.empty() ? adequacy_page() : std::filesystem::path(page);
    const std::string text = to_markdown(adequacy);
    write_file_safely(file,
                      page.empty() ? with_mistakes(text, grade_mistakes(options.jobs)) : text);
    std::cout << "wrote " << file.string() << "\n";
  }
  return adequacy.is_proven() ? 0 : 1;
}

}  // namespace meshgrade
