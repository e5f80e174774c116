#include "grader/commands/file_watch.h"

#include <chrono>
#include <thread>

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kPause{50};

/// Editors put backups and their own notes next to the files.
bool is_source(const fs::path& file) {
  const std::string ending = file.extension().string();
  const std::string name = file.filename().string();
  return name[0] != '.' && (ending == ".cpp" || ending == ".cc" || ending == ".cxx" ||
                            ending == ".h" || ending == ".hpp" || ending == ".hh");
}

}  // namespace

FileWatch::FileWatch(fs::path path) : path_(std::move(path)), seen_(look()) {}

FileWatch::State FileWatch::look() const {
  State state;
  const auto add = [&state](const fs::path& file) {
    std::error_code gone;  // a file may go between two looks at it
    const auto time = fs::last_write_time(file, gone).time_since_epoch().count();
    const auto size = fs::file_size(file, gone);
    if (!gone) state[file.string()] = {static_cast<std::int64_t>(time), size};
  };
  std::error_code error;
  if (!fs::is_directory(path_, error)) add(path_);
  for (fs::directory_iterator it(path_, error), end; !error && it != end; it.increment(error)) {
    if (is_source(it->path())) add(it->path());
  }
  return state;
}

bool FileWatch::wait_for_change(const std::function<bool()>& is_over) {
  State before = seen_;
  while (!is_over()) {
    std::this_thread::sleep_for(kPause);
    State now = look();
    const bool at_rest = now == before;
    before = std::move(now);
    if (!at_rest || before == seen_) continue;
    seen_ = std::move(before);
    return true;
  }
  return false;
}

}  // namespace meshgrade
