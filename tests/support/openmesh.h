#pragma once

// OpenMesh's meshes. Its headers are not clean under our warnings.

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#pragma GCC diagnostic pop

namespace meshgrade {

/// A mesh without faces whose vertices lie at these positions, ready for changes.
template <class Mesh, class Positions>
Mesh openmesh_with_vertices(const Positions& positions) {
  Mesh mesh;
  mesh.request_face_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_vertex_status();
  for (const auto& p : positions) {
    mesh.add_vertex(typename Mesh::Point(static_cast<float>(p[0]), static_cast<float>(p[1]),
                                         static_cast<float>(p[2])));
  }
  return mesh;
}

}  // namespace meshgrade
