#pragma once

#include "tests/bench/results.h"

namespace meshgrade::bench {

/// What to measure. Tables and meshes by name; where none is named: all.
struct Selection {
  bool quick = false;  ///< leaves out the large meshes and takes fewer rounds
  std::vector<std::string> tables;
  std::vector<std::string> meshes;

  bool has_table(const std::string& name) const;
  /// Whether the table is asked for by its name, and not just as one of all.
  bool names(const std::string& name) const;
};

/// The tables build, normals, flips, splits, loop, catmull-clark, threads and memory.
std::vector<Table> run_mesh_bench(const Selection& selection);

/// What is asked of these tables.
std::vector<Goal> mesh_goals();

}  // namespace meshgrade::bench
