#pragma once

#include <filesystem>
#include <string>

namespace meshgrade {

/// A pipe or a device: to be written to, and never to be replaced. So is /dev/stdout, also
/// where standard output goes to a file, at whose end the text is added then.
bool is_stream(const std::filesystem::path& file);

/// Writes a whole file, or nothing: to a temporary name of its own first, which is brought to
/// the disk and then renamed. Whoever reads the file, even after a power cut, finds the old or
/// the new text. A file that is there keeps its mode. Links are followed; what is_stream() is
/// just written to.
/// @throws UserError if it cannot be written, or is there and is read-only
void write_file_safely(const std::filesystem::path& file, const std::string& text);

/// A folder and those above it, where they are not there yet.
/// @throws UserError if it cannot be made
void make_folder(const std::filesystem::path& folder);

/// The whole file.
/// @throws UserError if it cannot be read
std::string read_whole_file(const std::filesystem::path& file);

}  // namespace meshgrade
