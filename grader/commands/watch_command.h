#pragma once

#include <string>

#include "grader/report/report.h"

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade watch DIR [EXERCISE...]`
void add_watch_command(CLI::App& app, int& exit_code);

/// What differs between two reports of the same submission, a line for each exercise:
/// "edge_flip: failed -> passed (+20)". "nothing has changed" if nothing does.
std::string changes_text(const Report& before, const Report& after);

}  // namespace meshgrade
