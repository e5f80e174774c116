#pragma once

// What the viewer asks of a student's mesh functions, as it goes to the worker. C++17.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The names of the viewer's tasks, for meshes of triangles and of polygons: no exercise has
/// one of them.
constexpr const char* kViewTask = "view";
constexpr const char* kPolygonViewTask = "view_polygons";

struct ViewOperation {
  std::string exercise;  ///< whose function is called: "edge_flip"
  ElementKind picks = ElementKind::kEdge;
  std::vector<Ref> picked;  ///< by their numbers, a face as a plain one; none: the whole mesh

  template <class Wire>
  void transfer(Wire& wire) {
    wire(exercise, picks, picked);
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

/// What one operation on a mesh of polygons left behind.
struct PolygonViewStep {
  std::string step;  ///< as the exercise writes it down
  MeshDump after;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(step, after);
  }
};

/// Whether a function of the whole mesh gets one that is built anew, as in its exercise. Loop
/// subdivision goes on with triangles as they are: what one level leaves marked, the next
/// finds.
inline bool is_built_anew(const ViewOperation& operation, const MeshDump& mesh) {
  if (!operation.picked.empty()) return false;
  const auto is_live = [](const VertexRecord& v) { return v.live != 0; };
  std::vector<std::uint32_t> corners(mesh.faces.size(), 0);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0 && h.face < corners.size()) ++corners[h.face];
  }
  for (Ref f = 0; f < corners.size(); ++f) {
    if (mesh.faces[f].live != 0 && corners[f] != 3) return true;
  }
  return operation.exercise != "loop_refinement" ||
         !std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_live);
}

}  // namespace meshgrade
