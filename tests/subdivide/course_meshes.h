#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "grader/files/mesh_file.h"
#include "grader/mesh/torus_mesh.h"

namespace meshgrade {

struct NamedMesh {
  std::string name;
  PolygonMesh mesh;
};

/// Every triangle mesh of the course, closed and open, and a torus made by code.
inline const std::vector<NamedMesh>& triangle_meshes() {
  static const std::vector<NamedMesh> meshes = [] {
    std::vector<NamedMesh> all;
    for (const std::string name :
         {"single_triangle.obj", "two_triangles.obj", "fan.obj", "umbrella.obj", "grid_4x4.obj",
          "grid_hole.off", "cylinder.dae", "needle.obj", "tetrahedron.obj", "octahedron.off",
          "cube.obj", "cube_crossed.obj", "icosahedron.obj", "torus.ply", "double_torus.obj",
          "valence_zoo.obj", "two_components.obj", "sliver.obj"}) {
      all.push_back({name, read_mesh(MESHGRADE_SOURCE_DIR "/meshes/" + name).mesh});
    }
    all.push_back({"torus 5 x 3", torus_mesh(5, 3)});
    return all;
  }();
  return meshes;
}

inline const PolygonMesh& triangle_mesh(const char* name) {
  for (const NamedMesh& named : triangle_meshes()) {
    if (named.name == name) return named.mesh;
  }
  throw std::out_of_range(std::string("no mesh ") + name);
}

}  // namespace meshgrade
