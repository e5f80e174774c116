#pragma once

#include <string>

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade replay CASE [SUBMISSION] [--debug | --sanitize]`
void add_replay_command(CLI::App& app, int& exit_code);

/// The command that runs this case again: "./meshgrade replay edge_flip:basic/1 my_homework".
/// `assignment` is empty for the standard one.
std::string replay_command_line(const std::string& case_id, const std::string& submission,
                                const std::string& assignment);

}  // namespace meshgrade
