#include "grader/app/autograde_command.h"

#include <CLI/CLI.hpp>
#include <ctime>
#include <iostream>
#include <memory>
#include <optional>

#include "grader/app/context.h"
#include "grader/app/grading.h"
#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/exports/exports.h"

namespace meshgrade {
namespace {

constexpr int kGraderFailed = 3;

struct AutogradeOptions {
  std::string submission;
  std::string assignment;
  std::vector<std::string> writes;  ///< "gradescope=results.json"
};

/// One form in which the result is wanted, and where.
struct Wanted {
  const StudentExport* format = nullptr;
  std::string file;  ///< "-": to standard output
};

std::vector<Wanted> read_wanted(const std::vector<std::string>& writes) {
  std::vector<Wanted> wanted;
  for (const std::string& write : writes) {
    const std::size_t equals = write.find('=');
    const std::string name = write.substr(0, equals);
    const StudentExport* format = find_student_export(name);
    if (equals == std::string::npos || format == nullptr) {
      std::vector<std::string> known;
      for (const StudentExport& each : student_exports())
        known.emplace_back(each.name);
      throw UserError("--write " + write + ": write FORMAT=FILE, where FORMAT is one of " +
                      join(known, ", "));
    }
    wanted.push_back({format, write.substr(equals + 1)});
  }
  return wanted;
}

/// What came of it, whatever happens: a platform gets a result for every submission.
struct Graded {
  ResultStatus status = ResultStatus::kGraded;
  std::string reason;
  std::optional<Report> report;
};

Graded grade_for_host(const AutogradeOptions& options, const Assignment& assignment) {
  Graded graded;
  std::optional<Submission> submission;
  try {
    submission = find_submission(options.submission, assignment.submission);
  } catch (const UserError& error) {
    graded.status = ResultStatus::kUngradable;
    graded.reason = error.what();
    return graded;
  }
  try {
    Report report = grade(assignment, *submission, find_home(), {}, [](const std::string&) {});
    if (report.has_grader_error())
      throw GraderError("a case ended with an error of the grader");
    graded.report = student_view(std::move(report));
  } catch (const GraderError& error) {
    graded.status = ResultStatus::kGraderError;
    graded.reason = error.what();
  }
  return graded;
}

std::string time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
  return text;
}

int autograde(const AutogradeOptions& options) {
  const std::vector<Wanted> wanted = read_wanted(options.writes);
  const Assignment assignment = read_assignment(or_standard_assignment(options.assignment));
  require_hidden_seed(assignment);
  const Graded graded = grade_for_host(options, assignment);
  ExportOptions how;
  how.time = time_now();
  const StudentResult result{"submission", graded.status, printable(graded.reason),
                             graded.report ? &*graded.report : nullptr};
  for (const Wanted& want : wanted) {
    const std::string text = want.format->write(result, how);
    if (want.file == "-") {
      std::cout << text << std::flush;
    } else {
      write_file_safely(want.file, text);
    }
  }
  if (graded.status == ResultStatus::kGraded) return 0;
  std::cerr << "meshgrade: " << status_name(graded.status) << ": " << printable(graded.reason)
            << "\n";
  return graded.status == ResultStatus::kGraderError ? kGraderFailed : 0;
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
      "Exit code: 0 the result is written, 2 bad usage, 3 an error of the grader: the result\n"
      "says so and gives no points, not even 0, where the format allows that.");
  command->callback([options, &exit_code] { exit_code = autograde(*options); });
}

}  // namespace meshgrade
