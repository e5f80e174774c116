#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade export RESULTS FORMAT`
void add_export_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
