#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade check DIR [EXERCISE...]`
void add_check_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
