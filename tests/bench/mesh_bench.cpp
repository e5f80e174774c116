#include "tests/bench/mesh_bench.h"

#include <iostream>

#include "tests/bench/workload.h"

namespace meshgrade::bench {
namespace {

// The rows of the tables.
constexpr const char* kTeaching = "teaching mesh";
constexpr const char* kUnchecked = "teaching mesh, unchecked";
constexpr const char* kList = "std::list mesh";
constexpr const char* kOpenMesh = "OpenMesh";
constexpr const char* kOpenSubdiv = "OpenSubdiv";
constexpr const char* kCgal = "CGAL";
constexpr const char* kDirect = "meshgrade subdivide";
constexpr const char* kTwoThreads = "meshgrade subdivide, 2 threads";
constexpr const char* kCopying = "copying limit";

struct Entrant {
  const char* name;
  Factory make;
};

std::vector<Entrant> entrants() {
  return {{kTeaching, make_teaching_mesh},
          {kUnchecked, make_unchecked_teaching_mesh},
          {kList, make_list_mesh},
          {kOpenMesh, make_openmesh},
          {kOpenSubdiv, make_opensubdiv},
          {kCgal, make_cgal},
          {kDirect, [] { return make_direct_loop(1); }},
          {kCopying, make_copying_limit}};
}

struct Size {
  const char* name;
  unsigned levels;
  std::size_t rounds;
  bool shuffled = false;
};

/// Loop begins one level lower, so that its result has the size of the column.
Workload make_workload(const Size& size, Task task) {
  const unsigned levels = task == Task::kLoop ? size.levels - 1 : size.levels;
  return size.shuffled ? shuffled_icosphere(levels) : icosphere(levels);
}

/// Nanoseconds per triangle, vertex or edge.
double operations(Task task, const Workload& workload) {
  switch (task) {
    case Task::kBuild:
      return static_cast<double>(workload.mesh.polygons.size());
    case Task::kNormals:
      return static_cast<double>(workload.mesh.positions.size());
    case Task::kFlips:
    case Task::kSplits:
      return static_cast<double>(workload.edges.size());
    case Task::kLoop:
      return static_cast<double>(n_triangles_after(task, workload));
  }
  return 1.0;
}

/// Fills one column of a table.
void measure_column(Table& table, Task task, const Size& size,
                    const std::vector<Entrant>& field, Clock clock) {
  std::cerr << "measuring: " << table.name << ", " << size.name << "\n";
  const Workload workload = make_workload(size, task);
  const double scale = 1e9 / operations(task, workload);
  std::vector<std::function<double()>> runs;
  for (const Entrant& entrant : field) {
    runs.emplace_back([&workload, &entrant, task, clock, scale] {
      return scale * time_task(entrant.make, task, workload, clock);
    });
  }
  const std::vector<Samples> samples = interleave(size.rounds, runs);
  table.columns.emplace_back(size.name);
  for (std::size_t i = 0; i < field.size(); ++i)
    table.row(field[i].name).cells.push_back(samples[i]);
}

Table measure_task(Task task, const std::string& name, const std::string& title,
                   const std::vector<Size>& sizes) {
  Table table{name, title, kOpenMesh, {}, {}};
  std::vector<Entrant> field;
  for (const Entrant& entrant : entrants()) {
    if (entrant.make()->takes_part(task)) field.push_back(entrant);
  }
  for (const Size& size : sizes)
    measure_column(table, task, size, field, Clock::kProcessor);
  return table;
}

Table measure_threads(const Size& size) {
  Table table{
      "threads", "Loop with threads: ns of real time per output triangle", kDirect, {}, {}};
  measure_column(table, Task::kLoop, size,
                 {{kDirect, [] { return make_direct_loop(1); }},
                  {kTwoThreads, [] { return make_direct_loop(2); }}},
                 Clock::kReal);
  return table;
}

/// Bytes need no rounds: each cell has one sample.
Table measure_memories(const std::vector<Size>& sizes) {
  Table table{
      "memory", "memory: bytes per triangle, after build and after Loop", kOpenMesh, {}, {}};
  for (const Size& size : sizes) {
    const Workload workload = make_workload(size, Task::kLoop);
    const auto n_built = static_cast<double>(workload.mesh.polygons.size());
    const double n_subdivided = operations(Task::kLoop, workload);
    table.columns.emplace_back(std::string("built, ") + size.name + " / 4");
    table.columns.emplace_back(std::string("Loop, ") + size.name);
    for (const Entrant& entrant : entrants()) {
      if (entrant.name == kCopying) continue;
      const Memory memory = measure_memory(entrant.make, workload);
      std::vector<Samples>& cells = table.row(entrant.name).cells;
      cells.push_back({static_cast<double>(memory.built) / n_built});
      cells.push_back({static_cast<double>(memory.subdivided) / n_subdivided});
    }
  }
  return table;
}

}  // namespace

std::vector<Table> run_mesh_bench(bool quick) {
  std::vector<Size> sizes{{"1k", 3, 15}, {"20k", 5, 9}, {"330k", 7, 7}};
  std::vector<Size> loop_sizes = sizes;
  loop_sizes.push_back({"1.3M", 8, 5});
  loop_sizes.push_back({"330k shuffled", 7, 5, true});
  sizes.push_back(loop_sizes.back());
  if (quick) sizes = loop_sizes = {{"1k", 3, 5}, {"20k", 5, 5}};

  std::vector<Table> tables;
  tables.push_back(measure_task(Task::kBuild, "build", "build: ns per triangle", sizes));
  tables.push_back(measure_task(Task::kNormals, "normals", "normals: ns per vertex", sizes));
  tables.push_back(measure_task(Task::kFlips, "flips", "flips: ns per flip", sizes));
  tables.push_back(measure_task(Task::kSplits, "splits", "splits: ns per split", sizes));
  tables.push_back(
      measure_task(Task::kLoop, "loop", "Loop: ns per output triangle", loop_sizes));
  tables.push_back(measure_threads(quick ? Size{"330k", 7, 5} : Size{"1.3M", 8, 9}));
  tables.push_back(measure_memories({sizes[1], sizes[quick ? 1 : 2]}));
  return tables;
}

std::vector<Goal> mesh_goals() {
  std::vector<Goal> goals;
  for (const char* size : {"20k", "330k"}) {
    goals.push_back({"build", kTeaching, kOpenMesh, size, 0.6});
    goals.push_back({"loop", kTeaching, kOpenMesh, size, 1.5});
    goals.push_back({"loop", kUnchecked, kOpenMesh, size, 1.0});
    goals.push_back({"loop", kTeaching, kList, size, 5.0, Goal::kAtLeast});
    goals.push_back({"loop", kDirect, kCgal, size, 3.0, Goal::kAtLeast});
    goals.push_back({"loop", kDirect, kCopying, size, 4.0});
  }
  for (const char* size : {"330k", "1.3M"})
    goals.push_back({"threads", kTwoThreads, kDirect, size, 1.6, Goal::kAtLeast});
  // Linear growth: a triangle costs about the same in a mesh four times as large.
  goals.push_back({"loop", kTeaching, kTeaching, "1.3M", 1.25, Goal::kAtMost, "330k"});
  return goals;
}

}  // namespace meshgrade::bench
