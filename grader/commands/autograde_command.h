#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade autograde`: grades one submission for a platform, in the platform's own form.
void add_autograde_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
