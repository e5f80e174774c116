#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace meshgrade {

/// How one job ended.
struct JobEnd {
  std::size_t job = 0;
  bool ok = false;   ///< the work returned; else it threw, or its process died
  std::string text;  ///< what the work returned, or what went wrong
};

/// What a pool of processes is told, and tells.
struct JobPool {
  unsigned processes = 1;
  /// Does one job. `process` counts from 0 and tells jobs apart that run at the same time.
  std::function<std::string(std::size_t job, unsigned process)> work;
  /// Called in this process when a job has ended.
  std::function<void(const JobEnd&)> ended;
  /// Asked several times a second, in this process; whoever answers true ends it all: jobs
  /// under way are killed, and no others begin. Never, if it is empty.
  std::function<bool()> stop = {};
};

/// Does the jobs 0 .. count - 1 in processes of their own, so that jobs share nothing that can
/// be written, and the death of one is only its own. When this process dies, they die as well.
/// @return false if it was stopped
/// @throws what `ended` throws; GraderError if a process cannot be started
bool do_jobs(std::size_t count, const JobPool& pool);

/// Calls `work(i)` for i = 0 .. count - 1 in `jobs` processes of their own. `finished` is told
/// how many are done, in this process.
/// @return what `work` returned, in order
/// @throws GraderError if a job throws or its process dies
std::vector<std::string> run_jobs(std::size_t count, unsigned jobs,
                                  const std::function<std::string(std::size_t)>& work,
                                  const std::function<void(std::size_t)>& finished);

}  // namespace meshgrade
