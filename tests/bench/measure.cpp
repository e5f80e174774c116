#include "tests/bench/measure.h"

#include <malloc.h>

#include <algorithm>
#include <climits>
#include <ctime>
#include <numeric>
#include <string>

#include "grader/base/errors.h"

namespace meshgrade::bench {
namespace {

/// Shorter than this, the clock and the caches of the moment count too much.
constexpr double kShortestRun = 0.004;

void perform(Contestant& contestant, Task task) {
  switch (task) {
    case Task::kBuild:
      return contestant.build();
    case Task::kNormals:
      return contestant.compute_normals();
    case Task::kFlips:
      return contestant.flip_edges();
    case Task::kSplits:
      return contestant.split_edges();
    case Task::kLoop:
    case Task::kCatmullClark:
      return contestant.subdivide();
  }
}

double time_once(const Factory& make, Task task, const Workload& workload, Clock clock) {
  const std::unique_ptr<Contestant> contestant = make();
  contestant->prepare(workload);
  if (task != Task::kBuild) {
    contestant->build();
    contestant->find_edges();
  }
  const double start = seconds(clock);
  perform(*contestant, task);
  const double taken = seconds(clock) - start;
  const std::size_t expected = n_triangles_after(task, workload);
  if (contestant->n_triangles() != expected) {
    throw GraderError("the benchmark's result has " +
                      std::to_string(contestant->n_triangles()) + " faces, not " +
                      std::to_string(expected));
  }
  return taken;
}

std::size_t bytes_on_heap() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace

double seconds(Clock clock) {
  timespec now{};
  clock_gettime(clock == Clock::kReal ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(Samples samples) {
  const std::size_t middle = samples.size() / 2;
  std::sort(samples.begin(), samples.end());
  return samples.size() % 2 == 1 ? samples[middle]
                                 : (samples[middle - 1] + samples[middle]) / 2.0;
}

double median_ratio(const Samples& a, const Samples& b) {
  Samples ratios;
  for (std::size_t i = 0; i < a.size(); ++i)
    ratios.push_back(a[i] / b[i]);
  return median(std::move(ratios));
}

double time_task(const Factory& make, Task task, const Workload& workload, Clock clock) {
  double total = 0.0;
  std::size_t runs = 0;
  for (; total < kShortestRun; ++runs)
    total += time_once(make, task, workload, clock);
  return total / static_cast<double>(runs);
}

std::size_t n_triangles_after(Task task, const Workload& workload) {
  const std::size_t before = workload.mesh.polygons.size();
  if (task == Task::kLoop || task == Task::kCatmullClark) return 4 * before;
  return task == Task::kSplits ? before + 2 * workload.edges.size() : before;
}

Memory measure_memory(const Factory& make, const Workload& workload) {
  const std::unique_ptr<Contestant> contestant = make();
  contestant->prepare(workload);
  const std::size_t before = bytes_on_heap();
  contestant->build();
  Memory memory;
  memory.built = bytes_on_heap() - before;
  contestant->subdivide();
  memory.subdivided = bytes_on_heap() - before;
  return memory;
}

void keep_heap_warm() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
}

}  // namespace meshgrade::bench
