#pragma once

// What the viewer asks of a student's mesh functions, as it goes to the worker. C++17.

#include <cstdint>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The name of the viewer's task: no exercise has it.
constexpr const char* kViewTask = "view";

enum class ViewKind : std::uint32_t { kFlip = 0, kSplit = 1, kSubdivide = 2 };

struct ViewOperation {
  ViewKind kind = ViewKind::kFlip;
  Ref edge = kUnsetRef;  ///< by its number; unset for a subdivision

  template <class Wire>
  void transfer(Wire& wire) {
    wire(kind, edge);
  }
};

/// Operations on one mesh, one after the other, also when one has broken it.
struct ViewInput {
  PolygonMesh mesh;
  std::vector<ViewOperation> operations;
  std::uint32_t first_told = 0;  ///< steps before this one are not written down
  bool normals = false;          ///< ask in the end for the normal of each live vertex

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh, operations, first_told, normals);
  }
};

/// What one operation left behind. After the last, if normals are asked for, comes a Point3 for
/// each live vertex, in order.
struct ViewStep {
  Ref returned = kUnsetRef;  ///< the edge or vertex that the function returned
  MeshDump after;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(returned, after);
  }
};

}  // namespace meshgrade
