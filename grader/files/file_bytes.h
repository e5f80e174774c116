#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

/// Throws UserError "<file>:<place>: <what>", or "<file>: <what>" for an empty place. `what`
/// says what is wrong and what to do about it.
[[noreturn]] void refuse_file(const std::filesystem::path& file, const std::string& place,
                              const std::string& what);

/// The whole content of a file. Throws UserError if it is missing, a folder, empty, not
/// readable or larger than 2 GiB.
std::string read_bytes(const std::filesystem::path& file);

/// The extension in lower case, with its dot: ".obj".
std::string lower_extension(const std::filesystem::path& file);

/// Words from a file as they may stand in a one-line message: quoted, at most `longest`
/// characters, anything unprintable replaced by '?'.
std::string in_quotes(std::string_view words, std::size_t longest = 24);

/// Throws UserError unless `vertex`, counted from 0, is below `n_vertices`. `first_number` is
/// the number that the format gives to its first vertex.
void check_corner(const std::filesystem::path& file, const std::string& place, std::size_t face,
                  std::uint32_t vertex, std::size_t n_vertices, unsigned first_number);

/// Throws UserError unless the polygon has at least 3 corners, all different and all below
/// `n_vertices`.
void check_polygon(const std::filesystem::path& file, std::size_t face,
                   const std::vector<std::uint32_t>& corners, std::size_t n_vertices);

}  // namespace meshgrade
