#include "grader/commands/check_command.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>

#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/commands/console.h"
#include "grader/commands/context.h"
#include "grader/commands/figure_files.h"
#include "grader/commands/grading_options.h"
#include "grader/commands/output_check.h"
#include "grader/commands/progress_store.h"
#include "grader/commands/replay_command.h"
#include "grader/commands/require_sandbox.h"
#include "grader/grade/grading.h"
#include "grader/grade/sanitized_replay.h"
#include "grader/report/gcc_report.h"
#include "grader/report/html_report.h"
#include "grader/report/json_report.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

constexpr const char* kForPeople = "text";
constexpr const char* kForEditors = "gcc";

struct CheckOptions : GradingOptions {
  std::string format = kForPeople;
  std::string json;
  std::string figures;
  std::string html;
  bool verbose = false;
  bool timing = false;
  bool require_sandbox = false;
};

int exit_status(const Report& report) {
  if (report.has_grader_error()) return 3;
  return report.points < report.max_points ? 1 : 0;
}

std::string figures_text(std::size_t pictures, const std::string& folder) {
  if (pictures == 0) return "\nno pictures: nothing that went wrong can be drawn\n";
  return "\n" + plural(pictures, "picture") + " of what is wrong, in " + folder + "\n";
}

std::string timing_text(const StageTimes& times, std::chrono::steady_clock::time_point begin) {
  const std::chrono::duration<double, std::milli> all =
      std::chrono::steady_clock::now() - begin;
  return "\nWhat took how long (some of it side by side, or as a part of another line):\n" +
         to_table(times.stages(), all.count());
}

void check_named_files(const CheckOptions& options, const Submission& submission) {
  std::vector<Output> outputs;
  if (!options.json.empty()) outputs.push_back({"--json", options.json});
  if (!options.html.empty()) outputs.push_back({"--html", options.html});
  std::vector<std::filesystem::path> inputs = files_of(submission);
  inputs.emplace_back(options.submission);
  inputs.push_back(or_standard_assignment(options.assignment));
  check_outputs(outputs, inputs);
}

std::string text_for_people(const Report& report, const CheckOptions& options) {
  TerminalStyle style;
  style.color = use_color(options.color);
  style.verbose = options.verbose;
  style.figures = options.figures;
  style.again = [&](const std::string& case_id) {
    return replay_command_line(case_id, options.submission, options.assignment);
  };
  return to_terminal(report, style);
}

int check(const CheckOptions& options) {
  const Assignment assignment = load_assignment_of(options.assignment, options.submission);
  const Submission submission = find_submission(options.submission, assignment.submission);
  check_named_files(options, submission);
  const auto times = options.timing ? std::make_shared<StageTimes>() : nullptr;
  const auto begin = std::chrono::steady_clock::now();
  const Home home = find_home({!options.no_cache, times});
  if (options.require_sandbox) require_sandbox(home.sandbox);
  const Progress progress = terminal_progress();
  const FigureFolder figures(options.figures);
  Report report = grade(assignment, submission, home, options.exercises, progress);
  // The sanitizers ask for more rights than a strict sandbox leaves.
  if (!options.require_sandbox) {
    explain_first_crash(assignment, submission, home, progress, report);
  }
  progress("");
  if (times) report.timing = times->stages();
  remember_or_warn(options.submission, report);
  const std::size_t pictures =
      options.figures.empty() ? 0 : write_figures(report, options.figures);
  std::cout << (options.format == kForEditors ? to_gcc(report, submission, assignment)
                                              : text_for_people(report, options));
  if (!options.figures.empty()) std::cout << figures_text(pictures, options.figures);
  if (times) std::cout << timing_text(*times, begin);
  std::cout << std::flush;
  if (!options.json.empty()) write_file_safely(options.json, to_json(report));
  if (!options.html.empty()) {
    write_file_safely(options.html, to_html(report, viewer_page()));
    std::cout << "The report as a page: " << options.html << '\n';
  }
  return exit_status(report);
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Grade one submission");
  add_grading_options(*command, *options);
  command
      ->add_option("--format", options->format,
                   "What is printed: text, or gcc: a line for each exercise in the form of a "
                   "compiler's messages, for editors")
      ->check(CLI::IsMember({kForPeople, kForEditors}))
      ->capture_default_str();
  add_output_option(*command, "--json", options->json, "Write the report to this file as JSON");
  command->add_option("--figures", options->figures,
                      "Draw what is wrong: SVG pictures in this folder, one for each case");
  add_output_option(*command, "--html", options->html,
                    "Write the report to this file as a page for the browser");
  command->add_flag("-v,--verbose", options->verbose, "Show every case and every finding");
  command->add_flag("--timing", options->timing,
                    "Show how long the stages of the check took, also in the JSON report");
  command->add_flag("--require-sandbox", options->require_sandbox, kRequireSandboxHelp);
  command->footer(
      "Examples:\n"
      "  meshgrade check student_skeleton\n"
      "  meshgrade check my_homework edge_flip edge_split\n"
      "  meshgrade check my_homework --json report.json\n"
      "  meshgrade check my_homework edge_split --figures pictures\n"
      "  meshgrade check my_homework --html report.html\n"
      "  meshgrade check my_homework --format gcc\n"
      "  meshgrade check my_homework --timing\n"
      "Exit code: 0 all required points, 1 points lost, 2 bad usage or unreadable input,\n"
      "3 an error of the grader, 130 stopped by Ctrl-C, 143 by TERM.");
  command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace meshgrade
