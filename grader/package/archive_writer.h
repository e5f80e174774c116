#pragma once

#include <filesystem>

namespace meshgrade {

/// Packs all files of a folder, in the order of their names and without times, so that the same
/// files give the same bytes. The kind is that of the file's name: ".zip", ".tar", ".tar.gz".
/// @throws UserError if the kind is unknown or the file cannot be written
void write_archive(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace meshgrade
