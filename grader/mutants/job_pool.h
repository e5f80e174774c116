#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace meshgrade {

/// Calls `work(i)` for i = 0 .. count - 1 in `jobs` processes of their own, so that jobs share
/// nothing that can be written. `finished` is told how many are done, in this process.
/// @return what `work` returned, in order
/// @throws GraderError if a job throws or its process dies
std::vector<std::string> run_jobs(std::size_t count, unsigned jobs,
                                  const std::function<std::string(std::size_t)>& work,
                                  const std::function<void(std::size_t)>& finished);

}  // namespace meshgrade
