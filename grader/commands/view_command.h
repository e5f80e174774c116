#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade view [MESH] --submission DIR`
void add_view_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
