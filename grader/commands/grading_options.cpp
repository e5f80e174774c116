#include "grader/commands/grading_options.h"

#include <CLI/CLI.hpp>

namespace meshgrade {

void add_grading_options(CLI::App& command, GradingOptions& options) {
  command
      .add_option("submission", options.submission,
                  "The folder with the C++ files, or one file")
      ->required();
  command.add_option("exercises", options.exercises,
                     "Only these exercises, for example edge_flip; all if none is named");
  command.add_option(
      "--assignment", options.assignment,
      "What is asked and what it is worth (TOML); the standard one if not given");
  command.add_option("--color", options.color, "When to use color")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  add_cache_option(command, options.no_cache);
}

void add_cache_option(CLI::App& command, bool& no_cache) {
  command.add_flag("--no-cache", no_cache,
                   "Compile and run everything again, also what has not changed since it was "
                   "done last; keep nothing");
}

}  // namespace meshgrade
