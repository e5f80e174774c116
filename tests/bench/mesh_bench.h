#pragma once

#include "tests/bench/results.h"

namespace meshgrade::bench {

/// Build, normals, flips, splits and Loop on all meshes, then threads and memory. `quick`
/// leaves out the large meshes and takes fewer rounds.
std::vector<Table> run_mesh_bench(bool quick);

/// What is asked of these tables.
std::vector<Goal> mesh_goals();

}  // namespace meshgrade::bench
