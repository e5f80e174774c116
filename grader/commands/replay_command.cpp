#include "grader/commands/replay_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/base/errors.h"
#include "grader/cases/case_list.h"
#include "grader/cases/mesh_input.h"
#include "grader/commands/console.h"
#include "grader/commands/context.h"
#include "grader/commands/debugger.h"
#include "grader/commands/figure_files.h"
#include "grader/commands/grading_options.h"
#include "grader/commands/progress_store.h"
#include "grader/grade/dialect_fit.h"
#include "grader/grade/grading.h"
#include "grader/grade/sanitized_replay.h"
#include "grader/judge/operations_judge.h"
#include "grader/report/terminal_report.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

struct ReplayOptions {
  std::string case_id;
  std::string submission;
  std::string assignment;
  std::string figures;
  std::string color = "auto";
  bool debug = false;
  bool sanitize = false;
  bool no_cache = false;
};

/// What a replay works on.
struct Replay {
  Assignment assignment;
  Submission submission;
  Home home;
  Case asked;
};

Replay prepare(const ReplayOptions& options) {
  Replay replay;
  const std::filesystem::path submission = given_or_last(options.submission, personal_store());
  replay.assignment = load_assignment_of(options.assignment, submission);
  replay.submission = find_submission(submission, replay.assignment.submission);
  replay.assignment = fit_to_dialect(replay.assignment, replay.submission.dialect);
  replay.home = find_home({!options.no_cache});
  replay.asked = find_case(replay.assignment, replay.home.meshes, options.case_id);
  return replay;
}

int print_case(Report report, const ReplayOptions& options) {
  if (!options.figures.empty()) write_figures(report, options.figures);
  TerminalStyle style;
  style.color = use_color(options.color);
  style.verbose = true;
  style.figures = options.figures;
  std::cout << cases_to_terminal(report, style) << std::flush;
  if (report.has_grader_error()) return 3;
  return report.exercises.at(0).cases.at(0).verdict == Verdict::kPassed ? 0 : 1;
}

Build build(const Replay& replay, BuildKind kind) {
  const Progress progress = terminal_progress();
  progress("compiling");
  Build build =
      build_submission(replay.submission, replay.home, replay.assignment.limits, kind);
  progress("");
  return build;
}

int replay_plainly(const Replay& replay, const ReplayOptions& options) {
  const Build built = build(replay, BuildKind::kGrading);
  return print_case(
      grade_case_fully(replay.assignment, replay.submission, replay.home, built, replay.asked),
      options);
}

int replay_under_sanitizers(const Replay& replay, const ReplayOptions& options) {
  const Progress progress = terminal_progress();
  progress("compiling for the sanitizers");
  const auto [report, log] =
      replay_sanitized(replay.assignment, replay.submission, replay.home, replay.asked);
  progress("");
  const int exit_code = print_case(report, options);
  std::cout << "\n"
            << (log.empty() ? "the sanitizers found nothing\n" : "the sanitizers say:\n" + log);
  return log.empty() ? exit_code : 1;
}

/// How the report calls the corners of a flip or split.
std::string letters_for(const Case& asked) {
  if (asked.exercise != "edge_flip" && asked.exercise != "edge_split") return {};
  return corner_letters(from_wire<OperationsInput>(asked.input));
}

int replay_in_debugger(Replay replay) {
  require_debugger();
  const ExerciseRubric* rubric = replay.assignment.find(replay.asked.exercise);
  const ExerciseJudge judge = find_exercise_judge(*rubric);
  replay.asked = shown_case(replay.assignment, replay.submission, replay.home,
                            build(replay, BuildKind::kGrading), replay.asked);
  const Build built = build(replay, BuildKind::kDebug);
  for (const BuiltFile& file : built.files) {
    if (!file.ok) std::cerr << file.name << " does not compile:\n" << file.messages << "\n";
  }
  Limits& limits = replay.assignment.limits;
  limits.memory_mb = 0;
  limits.case_cpu_ms = 0;  // none
  limits.case_wall_ms = INT32_MAX;
  const FileDescriptor tasks = make_task_file({&replay.asked}, limits, Company::kAlone);
  std::cout << replay.asked.id() << ": " << replay.asked.title << "\n" << std::flush;
  return run_debugger(
      built, tasks,
      {judge.functions, replay.submission.folder,
       replay.home.include / "gdb" / "meshedit_printers.py", letters_for(replay.asked)});
}

int replay(const ReplayOptions& options) {
  const FigureFolder figures(options.figures);
  Replay replay = prepare(options);
  if (options.debug) return replay_in_debugger(std::move(replay));
  if (options.sanitize) return replay_under_sanitizers(replay, options);
  return replay_plainly(replay, options);
}

}  // namespace

std::string replay_command_line(const std::string& case_id, const std::string& submission,
                                const std::string& assignment) {
  return called_as() + " replay " + case_id + " " + shell_word(submission) +
         (assignment.empty() ? "" : " --assignment " + shell_word(assignment));
}

void add_replay_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "Run one case again, and show all of it");
  command->add_option("case", options->case_id, "Its name, for example edge_split:boundary/7")
      ->required();
  command->add_option("submission", options->submission,
                      "The folder with the C++ files; the one checked last if not given");
  command->add_option(
      "--assignment", options->assignment,
      "The assignment that the case is of (TOML); the standard one if not given");
  command->add_option("--color", options->color, "When to use color")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  CLI::Option* figures = command->add_option(
      "--figures", options->figures, "Draw what is wrong: an SVG picture in this folder");
  CLI::Option* debug = command->add_flag("--debug", options->debug,
                                         "Start gdb, stopped at the function to be written");
  debug->excludes(figures);
  command
      ->add_flag("--sanitize", options->sanitize,
                 "Run under the address and undefined-behaviour sanitizers")
      ->excludes(debug);
  add_cache_option(*command, options->no_cache);
  command->footer(
      "Examples:\n"
      "  meshgrade replay edge_split:boundary/7\n"
      "  meshgrade replay edge_split:boundary/7 my_homework --debug\n"
      "  meshgrade replay edge_split:boundary/7 my_homework --sanitize\n"
      "Exit code: 0 the case passes, 1 it does not, 2 bad usage or unreadable input,\n"
      "3 an error of the grader; with --debug that of the debugger.");
  command->callback([options, &exit_code] { exit_code = replay(*options); });
}

}  // namespace meshgrade
