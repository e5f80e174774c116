#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade hint EXERCISE [SUBMISSION] [--all | --again | --reset]`
void add_hint_command(CLI::App& app, int& exit_code);

/// The hints of an exercise's page: the items of the numbered list under "## Hints", without
/// their numbers, each with its lines as they are.
std::vector<std::string> find_hints(const std::string& page);

}  // namespace meshgrade
