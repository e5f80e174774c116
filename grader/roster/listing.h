#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade {

/// What systems and tools leave lying about: .DS_Store, __MACOSX, Thumbs.db, names with a dot.
bool is_noise(const std::filesystem::path& path);

/// The entries of a folder, sorted, without noise and without links.
/// @throws UserError if it cannot be read
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

bool is_real_folder(const std::filesystem::path& path);
bool is_real_file(const std::filesystem::path& path);

}  // namespace meshgrade
