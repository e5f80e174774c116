#pragma once

// What exercises ask that place the corners of a face, as somebody drags it. C++17.

#include <cstdint>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// One call: where the mouse is.
struct Placement {
  Point3 vector{};      ///< a move, or a direction
  double amount = 0.0;  ///< how much the face shrinks, or a distance

  template <class Wire>
  void transfer(Wire& wire) {
    wire(vector, amount);
  }
};

struct PlacementInput {
  std::string mesh_name;           ///< for titles: "v3 of prism_5.obj, bevelled"
  PolygonMesh mesh;                ///< with the face, and a ring of faces around it
  std::uint32_t anchor_turns = 0;  ///< how often every element gets the next anchor around it
  std::uint32_t face = 0;          ///< which polygon
  std::vector<Placement> calls;    ///< one after the other, without anything between

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, anchor_turns, face, calls);
  }
};

}  // namespace meshgrade
