#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace meshgrade {

/// Notices when source files of a folder change: are saved, come, go, or are replaced. Asks for
/// their times and sizes twenty times a second, which works on every system and file system.
class FileWatch {
 public:
  /// A folder, or a single file.
  explicit FileWatch(std::filesystem::path path);

  /// Waits until something has changed since the last call and then stays as it is for a
  /// moment, so that a file that is being written is not taken half-written.
  /// @return false if `is_over` has become true
  bool wait_for_change(const std::function<bool()>& is_over);

 private:
  /// Modification time and size of each file.
  using State = std::map<std::string, std::pair<std::int64_t, std::uintmax_t>>;

  State look() const;

  std::filesystem::path path_;
  State seen_;
};

}  // namespace meshgrade
