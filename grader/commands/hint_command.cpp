#include "grader/commands/hint_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/commands/console.h"
#include "grader/commands/context.h"
#include "grader/commands/progress_store.h"
#include "grader/grade/grading.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

struct HintOptions {
  std::string exercise;
  std::string submission;
  bool all = false;
  bool again = false;
  bool reset = false;
};

/// "12. Text" -> where "Text" begins; 0 for lines that begin no item.
std::size_t item_text(const std::string& line) {
  std::size_t at = 0;
  while (at < line.size() && std::isdigit(static_cast<unsigned char>(line[at])) != 0)
    ++at;
  const bool is_item = at > 0 && line.compare(at, 2, ". ") == 0;
  return is_item ? at + 2 : 0;
}

std::string without_indent(const std::string& line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// The assignment that has the exercise; the standard one if none has.
Assignment assignment_with(const std::string& exercise) {
  Assignment standard = read_assignment(standard_assignment());
  if (standard.find(exercise) != nullptr) return standard;
  for (const std::string& name : named_assignments()) {
    Assignment other = load_assignment(name);
    if (other.find(exercise) != nullptr) return other;
  }
  return standard;
}

std::vector<std::string> read_hints(const Assignment& assignment, const std::string& exercise) {
  const fs::path page = find_home().docs / "exercises" / assignment.folder / (exercise + ".md");
  std::ifstream stream(page);
  std::ostringstream text;
  text << stream.rdbuf();
  std::vector<std::string> hints = find_hints(text.str());
  if (hints.empty()) throw GraderError(page.string() + ": no hints under \"## Hints\"");
  return hints;
}

/// Hints are also for those who have not checked anything yet.
fs::path choose_submission(const std::string& given, const ProgressStore& store) {
  if (given.empty() && !store.last_submission()) return source_folder() / "student_skeleton";
  return given_or_last(given, store);
}

void print_hint(const HintOptions& options, const std::vector<std::string>& hints,
                std::size_t number) {
  std::cout << options.exercise << ", hint " << number << " of " << hints.size() << ":\n";
  for (const std::string& line : split_lines(hints[number - 1]))
    std::cout << "  " << line << "\n";
}

void print_all(const HintOptions& options, const std::vector<std::string>& hints) {
  for (std::size_t number = 1; number <= hints.size(); ++number)
    print_hint(options, hints, number);
}

/// Prints the hint after the `shown` ones. @return how many are shown then
std::size_t print_next(const HintOptions& options, const std::vector<std::string>& hints,
                       std::size_t shown) {
  if (shown == hints.size()) {
    std::cout << "there are no more hints for " << options.exercise
              << ": --again shows the last one, --all shows all of them, and "
              << "its page in docs/exercises explains more\n";
    return shown;
  }
  print_hint(options, hints, shown + 1);
  return shown + 1;
}

int hint(const HintOptions& options) {
  const Assignment assignment = assignment_with(options.exercise);
  choose_exercises(assignment, {options.exercise});
  const std::vector<std::string> hints = read_hints(assignment, options.exercise);
  const ProgressStore store = personal_store();
  SubmissionProgress progress = store.load(choose_submission(options.submission, store));
  std::uint32_t& kept = progress.exercises[options.exercise].hints;
  std::size_t shown = std::min<std::size_t>(kept, hints.size());
  if (options.reset) {
    shown = 0;
    std::cout << options.exercise << " begins with its first hint again\n";
  } else if (options.all) {
    shown = hints.size();
    print_all(options, hints);
  } else if (options.again && shown > 0) {
    print_hint(options, hints, shown);
  } else {
    shown = print_next(options, hints, shown);
  }
  kept = static_cast<std::uint32_t>(shown);
  store.save(progress);
  return 0;
}

}  // namespace

std::vector<std::string> find_hints(const std::string& page) {
  std::vector<std::string> hints;
  bool inside = false;
  for (const std::string& line : split_lines(page)) {
    if (line.rfind("## ", 0) == 0) {
      inside = line == "## Hints";
    } else if (inside && item_text(line) > 0) {
      hints.push_back(line.substr(item_text(line)));
    } else if (inside && !hints.empty() && !line.empty()) {
      hints.back() += "\n" + without_indent(line);
    }
  }
  return hints;
}

void add_hint_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<HintOptions>();
  CLI::App* command = app.add_subcommand("hint", "Give the next hint for an exercise");
  command->add_option("exercise", options->exercise, "For example edge_flip")->required();
  command->add_option("submission", options->submission,
                      "Whose hints are counted: the one checked last if not given");
  auto* all = command->add_flag("--all", options->all, "Show all hints");
  auto* again = command->add_flag("--again", options->again, "Show the last hint once more");
  auto* reset = command->add_flag("--reset", options->reset, "Begin with the first hint again");
  all->excludes(again)->excludes(reset);
  again->excludes(reset);
  command->footer(
      "Each call gives one hint more; they get more and more concrete, and cost no points.\n"
      "Examples:\n"
      "  meshgrade hint edge_flip\n"
      "  meshgrade hint edge_flip --again\n"
      "  meshgrade hint edge_flip --reset\n"
      "Exit code: 0, or 2 for an exercise that does not exist.");
  command->callback([options, &exit_code] { exit_code = hint(*options); });
}

}  // namespace meshgrade
