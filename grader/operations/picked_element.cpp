#include "grader/operations/picked_element.h"

#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {
namespace {

template <class Record>
Ref live_with_place(const std::vector<Record>& records, std::uint32_t place) {
  std::vector<Ref> live;
  for (Ref i = 0; i < records.size(); ++i) {
    if (records[i].live != 0) live.push_back(i);
  }
  return live.empty() ? kUnsetRef : live[place % live.size()];
}

}  // namespace

MeshDump built_mesh(const PolygonMesh& polygons, std::uint32_t anchor_turns) {
  meshedit::HalfedgeMesh mesh;
  build_mesh(polygons, mesh);
  for (std::uint32_t i = 0; i < anchor_turns; ++i)
    anchor_elsewhere(mesh);
  return dump_mesh(mesh);
}

std::uint32_t count_elements(const MeshDump& mesh, ElementKind kind) {
  const Counts counts = count(mesh);
  const std::size_t n = kind == ElementKind::kHalfedge ? counts.halfedges
                        : kind == ElementKind::kVertex ? counts.vertices
                        : kind == ElementKind::kEdge   ? counts.edges
                                                       : counts.faces;
  return static_cast<std::uint32_t>(n);
}

Ref find_element(const MeshDump& mesh, ElementKind kind, std::uint32_t place) {
  switch (kind) {
    case ElementKind::kHalfedge:
      return live_with_place(mesh.halfedges, place);
    case ElementKind::kVertex:
      return live_with_place(mesh.vertices, place);
    case ElementKind::kEdge:
      return live_with_place(mesh.edges, place);
    case ElementKind::kFace:
      return live_with_place(mesh.faces, place);
  }
  return kUnsetRef;
}

Picked corners_of(const MeshDump& mesh, ElementKind kind, Ref element) {
  if (kind == ElementKind::kVertex) return {{element}};
  if (kind == ElementKind::kEdge || kind == ElementKind::kHalfedge) {
    const bool is_edge = kind == ElementKind::kEdge;
    const HalfedgeRecord& h = mesh.halfedges[is_edge ? mesh.edges[element].halfedge : element];
    return {{h.vertex, mesh.halfedges[h.twin].vertex}};
  }
  Picked picked;
  const Ref first = find_face(mesh, element)->halfedge;
  Ref h = first;
  do {
    picked.corners.push_back(mesh.halfedges[h].vertex);
    h = mesh.halfedges[h].next;
  } while (h != first);
  return picked;
}

Picked pick(const MeshDump& mesh, ElementKind kind, std::uint32_t place) {
  return corners_of(mesh, kind, find_element(mesh, kind, place));
}

}  // namespace meshgrade
