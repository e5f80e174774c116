#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade similarity SUBMISSIONS`
void add_similarity_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
