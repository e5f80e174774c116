#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade doctor`
void add_doctor_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
