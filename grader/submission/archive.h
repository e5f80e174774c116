#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace meshgrade {

/// Whether a file of this name is an archive that can be unpacked: .zip, .tar, .7z, and .gz,
/// .bz2, .xz, .zst of a tar or of a single file.
bool is_archive_name(const std::filesystem::path& file);

/// Which archives can be unpacked, for messages.
constexpr const char* kArchiveKinds = "zip, tar, gz, bz2, xz, zst and 7z";

/// The most that is taken out of an archive, however small it is itself.
struct ArchiveLimits {
  std::uint64_t bytes = std::uint64_t{1} << 30U;       ///< of all files together, unpacked
  std::uint64_t file_bytes = std::uint64_t{1} << 30U;  ///< of one file; the rest is cut off
  std::size_t entries = 50'000;
  std::size_t depth = 32;  ///< folders in folders
};

/// How much of a file is unpacked.
enum class Take {
  kWhole,
  kNameOnly,  ///< as an empty file
  kNothing,
};

/// Unpacks the folders and regular files of an archive into an empty folder. Links, devices,
/// and names that lead out of the folder are left out. Nothing is executed and no other program
/// is called. `choose` says how much of a file is wanted; empty: all of everything.
/// @return a note on each kind of thing that was left out
/// @throws UserError "<name>: ..." if the archive is damaged, encrypted, or beyond the limits
std::vector<std::string> unpack_archive(
    const std::filesystem::path& archive, const std::filesystem::path& folder,
    const ArchiveLimits& limits,
    const std::function<Take(const std::filesystem::path& name)>& choose = {});

}  // namespace meshgrade
