#pragma once

// What exercises about one operation ask, as it goes to the worker, and what comes back. C++17.

#include <cstdint>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

struct LocalOperationInput {
  std::string mesh_name;  ///< for titles: "prism_5.obj"
  PolygonMesh mesh;
  std::uint32_t anchor_turns = 0;  ///< how often every element gets the next anchor around it
  /// One operation after the other: each on the element with this place among the live ones of
  /// its kind then, counted on from the beginning if there are fewer. Two for each operation
  /// that picks two.
  std::vector<std::uint32_t> places;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, anchor_turns, places);
  }
};

/// What one operation left behind.
struct LocalStep {
  Ref picked = kUnsetRef;     ///< the element that was asked for
  Ref partner = kUnsetRef;    ///< the second one, of operations that pick two
  std::uint32_t refused = 0;  ///< std::nullopt was returned
  Ref returned = kUnsetRef;   ///< the element that was returned, if it did not refuse
  MeshDump after;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(picked, partner, refused, returned, after);
  }
};

}  // namespace meshgrade
