#pragma once

// Writes a half-edge mesh down as numbers. Pointers are looked up in the tables of elements and
// never followed, so that a broken mesh can be written down as well. Written for C++17; used by
// the worker and, on meshes of its own, by the judge.

#include <cstddef>

#include "grader/mesh/mesh_dump.h"
#include "meshedit/detail/inspector.h"
#include "meshedit/halfedge_mesh.h"

namespace meshgrade {
namespace dump_detail {

template <class T>
Ref look_up(const meshedit::detail::Pool<T>& pool, const T* address) {
  if (address == nullptr) return kUnsetRef;
  if (pool.is_end(address)) return kPastEndRef;
  const std::ptrdiff_t index = pool.find(address);
  if (index < 0) return kForeignRef;
  const Ref ref = static_cast<Ref>(index);
  const bool live =
      meshedit::detail::Inspector::is_live(*pool.at(static_cast<std::size_t>(index)));
  return live ? ref : ref | kDeletedBit;
}

inline Ref look_up_face(const meshedit::HalfedgeMesh& mesh, const meshedit::Face* address) {
  const auto& boundaries = meshedit::detail::Inspector::boundaries(mesh);
  const Ref inside = look_up(meshedit::detail::Inspector::faces(mesh), address);
  if (inside != kForeignRef) return inside;
  const Ref outside = look_up(boundaries, address);
  return outside >= kForeignRef ? outside : outside | kBoundaryBit;
}

inline Point3 to_point(const meshedit::Vector3D& v) {
  return {v.x, v.y, v.z};
}

}  // namespace dump_detail

/// The number of the element that a handle leads to, or a special value.
inline Ref dump_handle(const meshedit::HalfedgeMesh& mesh, const meshedit::EdgeIter& e) {
  using meshedit::detail::Inspector;
  return dump_detail::look_up<meshedit::Edge>(Inspector::edges(mesh), Inspector::address(e));
}
inline Ref dump_handle(const meshedit::HalfedgeMesh& mesh, const meshedit::VertexIter& v) {
  using meshedit::detail::Inspector;
  return dump_detail::look_up<meshedit::Vertex>(Inspector::vertices(mesh),
                                                Inspector::address(v));
}

inline Ref dump_handle(const meshedit::HalfedgeMesh& mesh, const meshedit::FaceIter& f) {
  return dump_detail::look_up_face(mesh, meshedit::detail::Inspector::address(f));
}

inline std::vector<FaceRecord> dump_faces(
    const meshedit::detail::Pool<meshedit::Face>& pool,
    const meshedit::detail::Pool<meshedit::Halfedge>& halfedges) {
  using meshedit::detail::Inspector;
  std::vector<FaceRecord> records;
  for (std::size_t i = 0; i < pool.slots(); ++i) {
    const meshedit::Face& f = *pool.at(i);
    records.push_back({dump_detail::look_up(halfedges, Inspector::halfedge(f)),
                       Inspector::is_live(f), f.isBoundary()});
  }
  return records;
}

inline MeshDump dump_mesh(const meshedit::HalfedgeMesh& mesh) {
  using dump_detail::look_up;
  using meshedit::detail::Inspector;
  const auto& halfedges = Inspector::halfedges(mesh);
  const auto& vertices = Inspector::vertices(mesh);
  const auto& edges = Inspector::edges(mesh);
  MeshDump dump;
  dump.halfedges.reserve(halfedges.slots());
  for (std::size_t i = 0; i < halfedges.slots(); ++i) {
    const meshedit::Halfedge& h = *halfedges.at(i);
    dump.halfedges.push_back(
        {look_up(halfedges, Inspector::next(h)), look_up(halfedges, Inspector::twin(h)),
         look_up(vertices, Inspector::vertex(h)), look_up(edges, Inspector::edge(h)),
         dump_detail::look_up_face(mesh, Inspector::face(h)), Inspector::is_live(h)});
  }
  for (std::size_t i = 0; i < vertices.slots(); ++i) {
    const meshedit::Vertex& v = *vertices.at(i);
    dump.vertices.push_back({look_up(halfedges, Inspector::halfedge(v)), Inspector::is_live(v),
                             dump_detail::to_point(v.position)});
  }
  for (std::size_t i = 0; i < edges.slots(); ++i) {
    const meshedit::Edge& e = *edges.at(i);
    dump.edges.push_back({look_up(halfedges, Inspector::halfedge(e)), Inspector::is_live(e)});
  }
  dump.faces = dump_faces(Inspector::faces(mesh), halfedges);
  dump.boundaries = dump_faces(Inspector::boundaries(mesh), halfedges);
  return dump;
}

}  // namespace meshgrade
