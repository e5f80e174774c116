#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meshgrade {

/// What every command that grades a submission can be told.
struct GradingOptions {
  std::string submission;
  std::vector<std::string> exercises;  ///< all if empty
  std::string assignment;              ///< the standard one if empty
  std::string color = "auto";
  bool no_cache = false;
};

/// Adds them to a command; `options` must live as long as it.
void add_grading_options(CLI::App& command, GradingOptions& options);

/// Adds --no-cache to a command that keeps what it compiles and runs.
void add_cache_option(CLI::App& command, bool& no_cache);

}  // namespace meshgrade
