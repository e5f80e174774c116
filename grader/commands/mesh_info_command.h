#pragma once

#include <CLI/CLI.hpp>

namespace meshgrade {

/// `meshgrade mesh-info FILE`: prints what a mesh or Bezier file holds: counts, topology,
/// valences, bounding box. When the command runs, it sets `exit_code` to 0, or to 2 after
/// printing what is wrong if the polygons are no surface; it throws UserError if the file
/// cannot be read.
void add_mesh_info_command(CLI::App& app, int& exit_code);

}  // namespace meshgrade
