#pragma once

// What the mesh exercises ask, as it goes to the worker, and what comes back. C++17.

#include <cstdint>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

enum class OperationKind : std::uint32_t { kFlip = 0, kSplit = 1 };

/// Which half-edges the elements anchor to begin with: all of these are right.
enum class Anchoring : std::uint32_t {
  kAsBuilt = 0,
  kOnEdge = 1,  ///< the first edge its other half-edge; its faces and inner ends the edge's own
  kElsewhere = 2,    ///< every element of the mesh another one than as it is built
  kOnEachEdge = 3,   ///< as each operation's `anchors` say, before it
  kFromEarlier = 4,  ///< the half-edge of each edge starts at that of its ends that comes first
};

/// What a title adds for elements that are anchored in this way, after what is asked.
inline const char* anchoring_text(Anchoring anchoring) {
  switch (anchoring) {
    case Anchoring::kElsewhere:
      return ", each halfedge() another than after build()";
    case Anchoring::kOnEachEdge:
      return ", each edge anchored by its ends and faces";
    case Anchoring::kFromEarlier:
      return ", the half-edge of each edge starting at its earlier end";
    default:
      return "";
  }
}

/// One flip or split. The edge is named by its end points, and these by their place among the
/// live vertices, so that the numbering of a solution's new edges does not matter.
struct Operation {
  OperationKind kind = OperationKind::kFlip;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t anchors = 0;  ///< with kOnEachEdge, one of the kAnchorWays of anchor_on()
};

struct OperationsInput {
  std::string mesh_name;  ///< for titles: "octahedron.off"
  PolygonMesh mesh;
  Anchoring anchoring = Anchoring::kAsBuilt;
  std::vector<Operation> operations;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, anchoring, operations);
  }
};

/// What one operation left behind.
struct OperationStep {
  Ref edge = kUnsetRef;      ///< the edge that was asked for; unset if there was none
  Ref returned = kUnsetRef;  ///< the edge or vertex that the function returned
  MeshDump after;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(edge, returned, after);
  }
};

/// Loop subdivision: the worker sends a MeshDump after each level.
struct SubdivisionInput {
  std::string mesh_name;  ///< for titles
  PolygonMesh mesh;
  std::uint32_t levels = 1;
  Anchoring anchoring = Anchoring::kAsBuilt;  ///< kAsBuilt, kElsewhere or kFromEarlier

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, levels, anchoring);
  }
};

/// Vertex normals: the worker sends a Point3 for each vertex, in order.
struct NormalInput {
  PolygonMesh mesh;
  Anchoring anchoring = Anchoring::kAsBuilt;  ///< kAsBuilt or kElsewhere

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh, anchoring);
  }
};

}  // namespace meshgrade
