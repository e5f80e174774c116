#pragma once

// The mesh of polygons that a student's function works on. C++17.

#include <memory>

#include "grader/mesh/build_mesh.h"
#include "meshedit/poly_mesh.h"

namespace meshgrade {

/// Where the viewer keeps its mesh from one function to the next.
struct Bench {
  std::unique_ptr<meshedit::PolyMesh> mesh;

  /// @throws meshedit::MeshError if the polygons are no surface
  void put(const PolygonMesh& polygons) {
    auto built = std::make_unique<meshedit::PolyMesh>();
    build_mesh(polygons, *built);
    mesh = std::move(built);
  }
};

/// The viewer's, while its task runs. An exercise that is graded builds a mesh of its own.
inline Bench* viewers_bench = nullptr;

/// Calls back with the mesh to work on: that of the viewer, or one that is built of these
/// polygons, each element with the next anchor around it so many times.
template <class Work>
void with_mesh(const PolygonMesh& polygons, std::uint32_t anchor_turns, Work work) {
  if (viewers_bench != nullptr) return work(*viewers_bench->mesh);
  meshedit::PolyMesh mesh;
  build_mesh(polygons, mesh);
  for (std::uint32_t i = 0; i < anchor_turns; ++i)
    anchor_elsewhere(mesh);
  work(mesh);
}

}  // namespace meshgrade
