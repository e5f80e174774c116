#include "grader/commands/watch_command.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <ctime>
#include <future>
#include <iostream>
#include <memory>
#include <optional>

#include "grader/base/cancel.h"
#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/commands/console.h"
#include "grader/commands/context.h"
#include "grader/commands/file_watch.h"
#include "grader/commands/grading_options.h"
#include "grader/commands/progress_store.h"
#include "grader/commands/replay_command.h"
#include "grader/grade/grading.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

volatile std::sig_atomic_t watch_interrupted = 0;

bool is_interrupted() {
  return watch_interrupted != 0;
}

/// Ctrl-C ends the check that is running, and the program; the second one ends it at once.
void catch_watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { watch_interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

const ExerciseReport* find(const Report& report, const std::string& name) {
  for (const ExerciseReport& exercise : report.exercises) {
    if (exercise.name == name) return &exercise;
  }
  return nullptr;
}

double all_points(const ExerciseReport& exercise) {
  return exercise.points + exercise.extra_points;
}

/// "edge_flip: failed -> passed (+20)"; empty if nothing has changed.
std::string change_text(const ExerciseReport& before, const ExerciseReport& after) {
  const double gain = all_points(after) - all_points(before);
  if (before.verdict == after.verdict && gain == 0.0) return {};
  std::string text = after.name + ": " + verdict_name(before.verdict);
  if (before.verdict != after.verdict)
    text += std::string(" -> ") + verdict_name(after.verdict);
  if (gain != 0.0) text += std::string(gain > 0.0 ? " (+" : " (") + number_text(gain) + ")";
  return text + "\n";
}

/// The report with nothing but the first failure in it. What is not written yet is no failure,
/// unless there is no other.
Report first_failure_of(Report report) {
  std::vector<ExerciseReport> kept;
  for (bool stubs : {false, true}) {
    for (const ExerciseReport& exercise : report.exercises) {
      const CaseReport* first = first_failure(exercise);
      const bool is_stub = exercise.verdict == Verdict::kNotImplemented;
      if (first == nullptr || is_stub != stubs || !kept.empty()) continue;
      kept.push_back({});
      kept.back().cases.push_back(*first);
    }
  }
  report.exercises = std::move(kept);
  return report;
}

std::string clock_time() {
  char text[16];
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::strftime(text, sizeof text, "%H:%M:%S", ::localtime_r(&now, &parts));
  return text;
}

class Watch {
 public:
  explicit Watch(const GradingOptions& options)
      : options_(options),
        assignment_(load_assignment_of(options.assignment, options.submission)),
        home_(find_home({!options.no_cache})) {
    choose_exercises(assignment_, options.exercises);  // a wrong name is told at once
    style_.color = use_color(options.color);
    style_.all_shown_by =
        called_as() + " check " + shell_word(options.submission) + " --verbose shows all";
    style_.again = [this](const std::string& case_id) {
      return replay_command_line(case_id, options_.submission, options_.assignment);
    };
  }

  int run() {
    const Submission found =  // so is a wrong folder
        find_submission(options_.submission, assignment_.submission);
    catch_watch_interrupts();
    const bool is_folder = std::filesystem::is_directory(options_.submission);
    FileWatch files(is_folder ? found.folder : std::filesystem::path(options_.submission));
    std::cout << "watching " << options_.submission << "; Ctrl-C ends it\n" << std::flush;
    do {
      check_unless_changed(files);
    } while (!is_interrupted() && (is_stale_ || files.wait_for_change(is_interrupted)));
    std::cout << "\n";
    return 0;
  }

 private:
  /// A check that takes long is of no use any more once a file is saved again.
  void check_unless_changed(FileWatch& files) {
    std::atomic<bool> done{false};
    std::future<void> checking = std::async(std::launch::async, [&] {
      check();
      done = true;
    });
    is_stale_ = files.wait_for_change([&] { return done || is_interrupted(); });
    std::optional<Cancellation> cancellation;
    if (!done) cancellation.emplace();
    checking.get();
  }

  /// Whatever is wrong with the files now may be right after the next change.
  void check() {
    try {
      const Progress progress = terminal_progress();
      const Submission submission =
          find_submission(options_.submission, assignment_.submission);
      Report report = grade(assignment_, submission, home_, options_.exercises, progress);
      progress("");
      remember_or_warn(options_.submission, report);
      print(report);
      last_ = std::move(report);
    } catch (const Cancelled&) {
      terminal_progress()("");
    } catch (const UserError& error) {
      std::cout << "\n" << clock_time() << "  " << error.what() << "\n" << std::flush;
    }
  }

  void print(const Report& report) const {
    std::cout << "\n"
              << clock_time() << "  " << number_text(report.points) << " of "
              << number_text(report.max_points) << " points\n";
    if (last_) std::cout << changes_text(*last_, report);
    const Report failure = first_failure_of(report);
    std::cout << cases_to_terminal(failure, style_) << std::flush;
  }

  const GradingOptions& options_;
  Assignment assignment_;
  Home home_;
  TerminalStyle style_;
  std::optional<Report> last_;
  bool is_stale_ = false;  ///< whether a file has changed during the last check
};

}  // namespace

std::string changes_text(const Report& before, const Report& after) {
  std::string text;
  for (const ExerciseReport& exercise : after.exercises) {
    const ExerciseReport* old = find(before, exercise.name);
    if (old != nullptr) text += change_text(*old, exercise);
  }
  return text.empty() ? "nothing has changed\n" : text;
}

void add_watch_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<GradingOptions>();
  CLI::App* command = app.add_subcommand("watch", "Check again whenever a file is saved");
  add_grading_options(*command, *options);
  command->footer(
      "Says what has changed since the last save, then shows the first failure. Ctrl-C ends.\n"
      "Examples:\n"
      "  meshgrade watch my_homework\n"
      "  meshgrade watch my_homework edge_flip\n"
      "Exit code: 0 when ended by Ctrl-C, 2 bad usage or nothing to watch, 3 an error of the\n"
      "grader.");
  command->callback([options, &exit_code] { exit_code = Watch(*options).run(); });
}

}  // namespace meshgrade
