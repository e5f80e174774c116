#include "grader/commands/diff_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/base/text.h"
#include "grader/batch/class_diff.h"

namespace meshgrade {
namespace {

struct DiffOptions {
  std::string before;
  std::string after;
  std::size_t cases = 5;
};

int diff(const DiffOptions& options) {
  const ClassResults before = load_class_results(options.before);
  const ClassResults after = load_class_results(options.after);
  const std::vector<RowChange> changes =
      compare_classes(before, result_store(options.before), after, result_store(options.after));
  std::cout << to_text(changes, options.cases) << plural(changes.size(), "hand-in")
            << " changed of " << after.rows.size() << "\n";
  return changes.empty() ? 0 : 1;
}

}  // namespace

void add_diff_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command =
      app.add_subcommand("diff", "Show whose points changed after a class was graded again");
  command->add_option("old", options->before, "The results before")->required();
  command->add_option("new", options->after, "The results after")->required();
  command->add_option("--cases", options->cases, "The most cases to name for each hand-in");
  command->footer(
      "Keep the old results to compare with, and grade into another folder:\n"
      "  meshgrade batch submissions -o results_2 --assignment mended.toml\n"
      "  meshgrade diff results results_2\n"
      "Exit code: 0 nothing changed, 1 something did, 2 bad usage or unreadable results.");
  command->callback([options, &exit_code] { exit_code = diff(*options); });
}

}  // namespace meshgrade
