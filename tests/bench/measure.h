#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tests/bench/contestant.h"

namespace meshgrade::bench {

/// One value per round.
using Samples = std::vector<double>;

double median(Samples samples);

/// The median of the ratios within each round: what slows a whole round down cancels out.
double median_ratio(const Samples& a, const Samples& b);

/// Calls each run once per round, and begins every round with another one. Entry i of the
/// result has what run i returned. One round more comes first and is dropped.
template <class Result>
std::vector<std::vector<Result>> interleave(std::size_t rounds,
                                            const std::vector<std::function<Result()>>& runs) {
  std::vector<std::vector<Result>> results(runs.size());
  for (std::size_t round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const std::size_t turn = (round + i) % runs.size();
      const Result result = runs[turn]();
      if (round > 0) results[turn].push_back(result);
    }
  }
  return results;
}

/// Processor time is steadier on a busy machine; with several threads only real time tells.
enum class Clock { kProcessor, kReal };

double seconds(Clock clock);

using Factory = std::function<std::unique_ptr<Contestant>()>;

/// Seconds that `task` takes on this workload. Short tasks are repeated, each time with a new
/// contestant. Throws GraderError if the mesh has not the right number of triangles afterwards.
double time_task(const Factory& make, Task task, const Workload& workload, Clock clock);

/// The number of triangles of the mesh after the task.
std::size_t n_triangles_after(Task task, const Workload& workload);

/// Bytes on the heap.
struct Memory {
  std::size_t built = 0;       ///< for the mesh after build()
  std::size_t subdivided = 0;  ///< and after one level of Loop subdivision
};
Memory measure_memory(const Factory& make, const Workload& workload);

/// Lets freed memory stay with the program, so that no contestant pays for fresh pages.
void keep_heap_warm();

}  // namespace meshgrade::bench
