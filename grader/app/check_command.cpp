#include "grader/app/check_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/app/console.h"
#include "grader/app/context.h"
#include "grader/app/grading.h"
#include "grader/app/grading_options.h"
#include "grader/app/progress_store.h"
#include "grader/app/replay_command.h"
#include "grader/report/json_report.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

struct CheckOptions : GradingOptions {
  std::string json;
  bool verbose = false;
};

int exit_status(const Report& report) {
  if (report.has_grader_error()) return 3;
  return report.points < report.max_points ? 1 : 0;
}

int check(const CheckOptions& options) {
  const Assignment assignment = read_assignment(or_standard_assignment(options.assignment));
  const Submission submission = find_submission(options.submission, assignment.submission);
  const Progress progress = terminal_progress();
  const Report report = grade(assignment, submission, find_home(), options.exercises, progress);
  progress("");
  remember_or_warn(options.submission, report);
  TerminalStyle style;
  style.color = use_color(options.color);
  style.verbose = options.verbose;
  style.again = [&](const std::string& case_id) {
    return replay_command_line(case_id, options.submission, options.assignment);
  };
  std::cout << to_terminal(report, style) << std::flush;
  if (!options.json.empty()) write_file_safely(options.json, to_json(report));
  return exit_status(report);
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Grade one submission");
  add_grading_options(*command, *options);
  command->add_option("--json", options->json, "Write the report to this file as JSON");
  command->add_flag("-v,--verbose", options->verbose, "Show every case and every finding");
  command->footer(
      "Examples:\n"
      "  meshgrade check student_skeleton\n"
      "  meshgrade check my_homework edge_flip edge_split\n"
      "  meshgrade check my_homework --json report.json\n"
      "Exit code: 0 all required points, 1 points lost, 2 bad usage or unreadable input,\n"
      "3 an error of the grader.");
  command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace meshgrade
