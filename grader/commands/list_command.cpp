#include "grader/commands/list_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <iostream>
#include <memory>

#include "grader/base/text.h"
#include "grader/commands/context.h"

namespace meshgrade {
namespace {

struct ListOptions {
  std::string submission;
  std::string assignment;
};

std::string pad(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

/// "5 minutes ago"
std::string ago(std::int64_t seconds) {
  const auto some = [](std::int64_t count, const char* noun) {
    return plural(static_cast<std::size_t>(count), noun) + " ago";
  };
  if (seconds < 60) return "just now";
  if (seconds < 3600) return some(seconds / 60, "minute");
  if (seconds < 86400) return some(seconds / 3600, "hour");
  return some(seconds / 86400, "day");
}

std::string row(const std::string& name, const std::string& verdict, const std::string& points,
                const std::string& extra, const std::string& hints, const std::string& when) {
  std::string line = "  " + pad(name, 20) + pad(verdict, 18) + pad(points, 12) +
                     pad(extra, 10) + pad(hints, 8) + when;
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string points_text(double points, double max_points) {
  return max_points > 0.0 ? number_text(points) + " / " + number_text(max_points) : "";
}

int list(const ListOptions& options) {
  const ProgressStore store = personal_store();
  const std::filesystem::path submission = given_or_last(options.submission, store);
  const Assignment assignment = load_assignment_of(options.assignment, submission);
  const SubmissionProgress progress = store.load(submission);
  std::cout << progress.submission.string() << "\n\n"
            << progress_table(assignment, progress, std::time(nullptr));
  return 0;
}

}  // namespace

std::string progress_table(const Assignment& assignment, const SubmissionProgress& progress,
                           std::int64_t now) {
  std::string table = row("exercise", "verdict", "points", "extra", "hints", "checked");
  ExerciseProgress total;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    const auto found = progress.exercises.find(rubric.name);
    const ExerciseProgress kept =
        found == progress.exercises.end() ? ExerciseProgress() : found->second;
    table += row(rubric.name, kept.verdict.empty() ? "-" : kept.verdict,
                 points_text(kept.points, rubric.points()),
                 points_text(kept.extra_points, rubric.extra_points()),
                 kept.hints == 0 ? "" : std::to_string(kept.hints),
                 kept.verdict.empty() ? "never" : ago(now - kept.checked_at));
    total.points += kept.points;
    total.max_points += rubric.points();
    total.extra_points += kept.extra_points;
    total.max_extra_points += rubric.extra_points();
  }
  return table + row("total", "", points_text(total.points, total.max_points),
                     points_text(total.extra_points, total.max_extra_points), "", "");
}

void add_list_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* command = app.add_subcommand("list", "Show how far a submission has come");
  command->add_option("submission", options->submission,
                      "The folder with the C++ files; the one checked last if not given");
  command->add_option("--assignment", options->assignment,
                      "The assignment (TOML); the standard one if not given");
  command->footer(
      "Shows what the last check of each exercise gave: it checks nothing itself.\n"
      "Examples:\n"
      "  meshgrade list\n"
      "  meshgrade list my_homework\n"
      "Exit code: 0, or 2 if nothing was checked yet.");
  command->callback([options, &exit_code] { exit_code = list(*options); });
}

}  // namespace meshgrade
