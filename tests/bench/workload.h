#pragma once

#include "tests/bench/contestant.h"

namespace meshgrade::bench {

/// A sphere of 20 * 4^levels triangles, made from an icosahedron. An edge on about every eighth
/// face is chosen, and the chosen ones are in random order.
Workload icosphere(unsigned levels);

/// The same surface with faces and vertices in random order: neighbours are far apart in
/// memory.
Workload shuffled_icosphere(unsigned levels);

/// The same two with 6 * 4^levels quadrilaterals, made from a cube.
Workload cube_sphere(unsigned levels);
Workload shuffled_cube_sphere(unsigned levels);

}  // namespace meshgrade::bench
