#pragma once

#include <CLI/CLI.hpp>

namespace meshgrade {

/// `meshgrade subdivide IN -n K -o OUT`: reads a mesh of any known format, subdivides it by
/// Loop's scheme, writes it in any known format and prints one line about what came out. When
/// the command runs, it sets `exit_code` to 0 or throws UserError.
void add_subdivide_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
