#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade batch SUBMISSIONS -o RESULTS`
void add_batch_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
