#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade dev-check [--write]`: for those who change the reference or add an exercise.
void add_dev_check_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
