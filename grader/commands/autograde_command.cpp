#include "grader/commands/autograde_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/commands/context.h"
#include "grader/commands/exit_codes.h"
#include "grader/commands/export_target.h"
#include "grader/commands/output_check.h"
#include "grader/grade/grading.h"

namespace meshgrade {
namespace {

struct AutogradeOptions {
  std::string submission;
  std::string assignment;
  std::vector<std::string> writes;  ///< "gradescope=results.json"
};

/// Also refuses a submission that is not there: that is no student's doing.
void check_autograde_files(const AutogradeOptions& options,
                           const std::vector<ExportTarget>& targets) {
  std::error_code error;
  if (!std::filesystem::exists(options.submission, error)) {
    throw UserError(options.submission +
                    ": there is no such file or folder to grade; no result is written");
  }
  check_outputs(outputs_of(targets),
                {options.submission, or_standard_assignment(options.assignment)});
}

/// Grades what the platform hands over, and writes what came of it, whatever that is.
int autograde(const AutogradeOptions& options) {
  const std::vector<ExportTarget> targets = parse_export_targets(options.writes);
  const Assignment assignment = load_assignment(options.assignment);
  require_hidden_seed(assignment);
  check_autograde_files(options, targets);
  std::optional<Submission> submission;
  try {
    submission = find_submission(options.submission, assignment.submission);
  } catch (const UserError& error) {
    std::cerr << "meshgrade: not graded: " << printable(error.what()) << "\n";
    write_exports(targets, ResultStatus::kUngradable, error.what());
    return 0;
  }
  check_outputs(outputs_of(targets), files_of(*submission));
  try {
    const Report report =
        grade(assignment, *submission, find_home(), {}, [](const std::string&) {});
    write_exports(targets, report);
    return report.has_grader_error() ? kGraderFailed : 0;
  } catch (const GraderError& error) {
    write_exports(targets, ResultStatus::kGraderError, error.what());
    throw;
  }
}

}  // namespace

void add_autograde_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<AutogradeOptions>();
  CLI::App* command =
      app.add_subcommand("autograde", "Grade one submission for a platform that asks for it");
  command
      ->add_option("submission", options->submission, "The folder that the platform hands over")
      ->required();
  command
      ->add_option("--write", options->writes,
                   "FORMAT=FILE, may be repeated; \"-\" for FILE is standard output")
      ->required();
  command->add_option(
      "--assignment", options->assignment,
      "What is asked and what it is worth (TOML); the standard one if not given");
  std::string formats = "Formats:\n";
  for (const StudentExport& format : student_exports()) {
    const std::string name = format.name;
    formats += "  " + name + std::string(20 - name.size(), ' ') + format.title + "\n";
  }
  command->footer(
      formats +
      "Examples:\n"
      "  meshgrade autograde submission --write gradescope=results/results.json\n"
      "  meshgrade autograde . --write github-annotations=- --write markdown=summary.md\n"
      "A submission that holds nothing to grade gets a result that says so, and no points.\n"
      "`meshgrade bundle` writes all that a platform needs to call this.\n"
      "Exit code: 0 the result is written, 2 bad usage or no such submission: nothing is\n"
      "written, 3 an error of the grader: the result\n"
      "says so and gives no points, not even 0, where the format allows that.");
  command->callback([options, &exit_code] { exit_code = autograde(*options); });
}

}  // namespace meshgrade
