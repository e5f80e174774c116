#pragma once

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade bundle`: what an instructor uploads to a platform that runs autograders.
void add_bundle_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
