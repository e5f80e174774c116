#pragma once

// The way back from half-edges to lists of corners. C++17: used by the worker and by the
// viewer, which must number vertices alike.

#include <cstdint>
#include <optional>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// The number that build() gives each vertex: it counts them as the polygons first name them.
/// @param polygons  name each vertex
inline std::vector<std::uint32_t> built_numbers(const PolygonMesh& polygons) {
  std::vector<std::uint32_t> numbers(polygons.positions.size(), kUnsetRef);
  std::uint32_t next = 0;
  for (const auto& polygon : polygons.polygons) {
    for (const std::uint32_t corner : polygon) {
      if (numbers[corner] == kUnsetRef) numbers[corner] = next++;
    }
  }
  return numbers;
}

/// The live faces of a mesh, in order. Vertices are counted as build() does it, so that they
/// keep these numbers.
/// @return nothing if a face does not close within its half-edges: the mesh is broken
inline std::optional<PolygonMesh> polygons_of(const MeshDump& mesh) {
  std::vector<std::size_t> most(mesh.faces.size(), 0);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0 && h.face < most.size()) ++most[h.face];
  }
  PolygonMesh polygons;
  std::vector<std::uint32_t> place(mesh.vertices.size(), kUnsetRef);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[f].live == 0) continue;
    std::vector<std::uint32_t> corners;
    Ref h = mesh.faces[f].halfedge;
    do {
      if (h >= mesh.halfedges.size() || corners.size() == most[f]) return {};
      const HalfedgeRecord& side = mesh.halfedges[h];
      if (side.live == 0 || side.vertex >= place.size()) return {};
      if (place[side.vertex] == kUnsetRef) {
        place[side.vertex] = static_cast<std::uint32_t>(polygons.positions.size());
        polygons.positions.push_back(mesh.vertices[side.vertex].position);
      }
      corners.push_back(place[side.vertex]);
      h = side.next;
    } while (h != mesh.faces[f].halfedge);
    polygons.polygons.push_back(std::move(corners));
  }
  return polygons;
}

}  // namespace meshgrade
