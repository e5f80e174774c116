#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade::bench {

/// The programs of which `check` and `batch` are timed.
struct Programs {
  std::filesystem::path now;
  std::filesystem::path before;  ///< of an older revision; may be empty
};

/// @throws GraderError if it dies or ends with a status above `most_status`
void run_or_throw(std::vector<std::string> arguments, int most_status = 0);

/// The bare compile, with the flags of student code and no precompiled header: each file goes
/// to the next free one of `n_cores` threads.
void compile_all(const std::vector<std::filesystem::path>& files, unsigned n_cores);

}  // namespace meshgrade::bench
