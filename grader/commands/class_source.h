#pragma once

#include <filesystem>
#include <optional>

#include "grader/base/process.h"
#include "grader/roster/roster.h"

namespace CLI {
class App;
}

namespace meshgrade {

/// What a class handed in. An archive of it is unpacked for as long as this value lives.
struct ClassSource {
  std::optional<ScratchFolder> unpacked;
  Roster roster;
};

/// @throws UserError if there is nothing, or an archive cannot be opened
ClassSource open_class(const std::filesystem::path& submissions, const RosterOptions& options);

/// Adds --layout and --part.
void add_roster_options(CLI::App& command, RosterOptions& options);

}  // namespace meshgrade
