#include "tests/bench/mesh_bench.h"

#include <algorithm>
#include <iostream>

#include "grader/base/contains.h"
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
          {kOpenSubdiv, make_opensubdiv_catmull_clark},
          {kCgal, make_cgal_catmull_clark},
          {kDirect, make_direct_catmull_clark},
          {kCopying, make_copying_limit}};
}

struct Size {
  std::string name;
  unsigned levels;
  std::size_t rounds;
  bool shuffled = false;
  bool loop_only = false;
};

std::vector<Size> choose_sizes(const Selection& selection) {
  std::vector<Size> all{{"1k", 3, 15}, {"20k", 5, 9}, {"330k", 7, 7}};
  if (selection.quick) {
    all = {{"1k", 3, 5}, {"20k", 5, 5}};
  } else {
    all.push_back({"330k shuffled", 7, 5, true});
    all.push_back({"1.3M", 8, 5, false, true});
  }
  const std::vector<std::string>& names = selection.meshes;
  std::vector<Size> chosen;
  for (const Size& size : all) {
    const bool named = std::find(names.begin(), names.end(), size.name) != names.end();
    if (names.empty() || named) chosen.push_back(size);
  }
  return chosen;
}

/// Subdivision begins one level lower, so that its result has the size of the column; a cube
/// has about as many faces as an icosphere of one level less.
Workload make_workload(const Size& size, Task task) {
  if (task == Task::kCatmullClark)
    return size.shuffled ? shuffled_cube_sphere(size.levels) : cube_sphere(size.levels);
  const unsigned levels = task == Task::kLoop ? size.levels - 1 : size.levels;
  return size.shuffled ? shuffled_icosphere(levels) : icosphere(levels);
}

/// What a task's time is divided by: triangles, vertices or edges.
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
    case Task::kCatmullClark:
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
  table.columns.push_back(size.name);
  for (std::size_t i = 0; i < field.size(); ++i)
    table.row(field[i].name).cells.push_back(samples[i]);
}

Table measure_task(Task task, const std::string& name, const std::string& unit,
                   const std::vector<Size>& sizes) {
  const bool is_subdivision = task == Task::kLoop || task == Task::kCatmullClark;
  const char* base = task == Task::kCatmullClark ? kOpenSubdiv : kOpenMesh;
  Table table{name, name + ": ns per " + unit, base, {}, {}};
  std::vector<Entrant> field;
  for (const Entrant& entrant : entrants()) {
    if (entrant.make()->takes_part(task)) field.push_back(entrant);
  }
  for (const Size& size : sizes) {
    if (is_subdivision || !size.loop_only) {
      measure_column(table, task, size, field, Clock::kProcessor);
    }
  }
  return table;
}

Table measure_threads(const std::vector<Size>& sizes) {
  Table table{
      "threads", "threads: ns of real time per triangle that Loop makes", kDirect, {}, {}};
  const std::vector<Entrant> field{{kDirect, [] { return make_direct_loop(1); }},
                                   {kTwoThreads, [] { return make_direct_loop(2); }}};
  for (const Size& size : sizes)
    measure_column(table, Task::kLoop, size, field, Clock::kReal);
  return table;
}

/// Bytes need no rounds: each cell has one sample.
void measure_memory_column(Table& table, const Size& size) {
  const Workload workload = make_workload(size, Task::kLoop);
  const auto n_built = static_cast<double>(workload.mesh.polygons.size());
  const double n_subdivided = operations(Task::kLoop, workload);
  table.columns.push_back("input of " + size.name);
  table.columns.push_back(size.name);
  for (const Entrant& entrant : entrants()) {
    if (entrant.name == kCopying || !entrant.make()->takes_part(Task::kLoop)) continue;
    const Memory memory = measure_memory(entrant.make, workload);
    std::vector<Samples>& cells = table.row(entrant.name).cells;
    cells.push_back({static_cast<double>(memory.built) / n_built});
    cells.push_back({static_cast<double>(memory.subdivided) / n_subdivided});
  }
}

Table measure_memories(const std::vector<Size>& sizes) {
  Table table{"memory", "memory: bytes per triangle, before and after Loop", kOpenMesh, {}, {}};
  for (const Size& size : sizes) {
    if (!size.shuffled) measure_memory_column(table, size);
  }
  return table;
}

}  // namespace

bool Selection::has_table(const std::string& name) const {
  return tables.empty() || names(name);
}

bool Selection::names(const std::string& name) const {
  return contains(tables, name);
}

std::vector<Table> run_mesh_bench(const Selection& selection) {
  const std::vector<Size> sizes = choose_sizes(selection);
  std::vector<Table> tables;
  const auto add_task = [&](Task task, const char* name, const char* unit) {
    if (selection.has_table(name)) tables.push_back(measure_task(task, name, unit, sizes));
  };
  add_task(Task::kBuild, "build", "triangle");
  add_task(Task::kNormals, "normals", "vertex");
  add_task(Task::kFlips, "flips", "flip");
  add_task(Task::kSplits, "splits", "split");
  add_task(Task::kLoop, "loop", "output triangle");
  add_task(Task::kCatmullClark, "catmull-clark", "output quadrilateral");
  if (selection.has_table("threads")) tables.push_back(measure_threads(sizes));
  if (selection.has_table("memory")) tables.push_back(measure_memories(sizes));
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
    for (const char* peer : {kOpenSubdiv, kCgal})
      goals.push_back({"catmull-clark", kDirect, peer, size, 3.0, Goal::kAtLeast});
  }
  for (const char* size : {"330k", "1.3M"})
    goals.push_back({"threads", kTwoThreads, kDirect, size, 1.6, Goal::kAtLeast});
  // Linear growth: a triangle costs about the same in a mesh four times as large.
  goals.push_back({"loop", kTeaching, kTeaching, "1.3M", 1.25, Goal::kAtMost, "330k"});
  return goals;
}

}  // namespace meshgrade::bench
