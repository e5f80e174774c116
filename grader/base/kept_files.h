#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace meshgrade {

/// Whether only the user who runs this can write to a folder, which is none but a link.
bool is_only_mine(const std::filesystem::path& folder);

/// Makes a folder unless it is there. @return whether it is_only_mine and can be written to
bool make_own_folder(const std::filesystem::path& folder);

/// Results that need not be computed twice, each in a file named by the digest of everything
/// that it comes from. It is a convenience and never fails: what is damaged, cut off or not
/// readable is as if it had never been kept, and what cannot be written is not kept. The files
/// that were not used for the longest time go when they become too large together.
class KeptFiles {
 public:
  /// @param folder  made if it is not there, and closed to others; nothing is kept in it unless
  ///                it belongs to this user, and nobody else could write to it
  /// @param most    bytes of all files together
  KeptFiles(std::filesystem::path folder, std::uint64_t most);

  std::optional<std::string> find(const std::string& key) const;
  void keep(const std::string& key, const std::string& bytes) const;

  const std::filesystem::path& folder() const { return folder_; }
  /// Whether anything can be kept.
  bool works() const { return works_; }

  struct Usage {
    std::size_t files = 0;
    std::uint64_t bytes = 0;
  };
  Usage usage() const;

 private:
  void remove_oldest() const;

  std::filesystem::path folder_;
  std::uint64_t most_;
  bool works_;
  mutable std::atomic<std::uint64_t> written_;  ///< bytes, since files were last removed
};

}  // namespace meshgrade
