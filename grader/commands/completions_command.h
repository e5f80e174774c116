#pragma once

#include <string>

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade completions SHELL`: what a shell, or man, reads about all other commands.
void add_completions_command(CLI::App& app, const std::string& version, int& exit_code);

}  // namespace meshgrade
