#pragma once

#include <CLI/CLI.hpp>

namespace meshgrade {

/// `meshgrade simplify IN --faces N -o OUT`: reads a mesh of triangles of any known format,
/// collapses edges by OpenMesh's decimater with quadric errors, writes the mesh in any known
/// format and prints one line about what came out. When the command runs, it sets `exit_code`
/// to 0 or throws UserError.
void add_simplify_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
