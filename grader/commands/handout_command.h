#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade handout`: the students' package.
void add_handout_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
