#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade diff OLD NEW`
void add_diff_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
