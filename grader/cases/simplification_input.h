#pragma once

// What the exercise simplification asks, as it goes to the worker. C++17.

#include <cstdint>
#include <string>

#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// What is compared besides the numbers of elements.
enum class SimplifiedAs : std::uint32_t {
  kCheapest,  ///< each collapse: few of them, whose costs and points can be computed
  kSame,      ///< the shape: it can be kept, so every point must lie where the surface was
  kSimilar,   ///< the distance to the shape before, with that of another program
  kAnything,  ///< nothing: it ends with a mesh
};

struct SimplificationInput {
  std::string mesh_name;           ///< for titles: "icosahedron.obj"
  PolygonMesh mesh;                ///< of triangles
  std::uint32_t anchor_turns = 0;  ///< how often every element gets the next anchor around it
  double ratio = 1.0;
  SimplifiedAs compared = SimplifiedAs::kCheapest;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, anchor_turns, ratio, compared);
  }
};

}  // namespace meshgrade
