#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meshgrade::bench {

/// @throws GraderError if it dies or ends with a status above `most_status`
void run_or_throw(std::vector<std::string> arguments, int most_status = 0);

/// The bare compile, with the flags of student code and no precompiled header: each file goes
/// to the next free one of `n_cores` threads.
void compile_all(const std::vector<std::filesystem::path>& files, unsigned n_cores);

}  // namespace meshgrade::bench
