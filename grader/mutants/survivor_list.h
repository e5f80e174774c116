#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace meshgrade {

/// Mutants that were looked at and found to be right solutions: Mutant::id() -> the reason.
using SurvivorList = std::map<std::string, std::string>;

/// Reads a list (TOML): an array `group` of tables with a `reason` and the ids in `mutants`.
/// @throws UserError that names the file and the line
SurvivorList read_survivor_list(const std::filesystem::path& file);

}  // namespace meshgrade
