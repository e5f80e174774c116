#pragma once

// The course's meshes as polygons and as dumps of half-edge meshes.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/cases/mesh_shapes.h"
#include "grader/files/mesh_file.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {

inline MeshDump dump_polygons(const PolygonMesh& polygons) {
  meshedit::HalfedgeMesh mesh;
  build_mesh(polygons, mesh);
  return dump_mesh(mesh);
}

inline PolygonMesh sample_polygons(const std::string& file) {
  return in_build_order(read_mesh(MESHGRADE_SOURCE_DIR "/meshes/" + file).mesh);
}

inline MeshDump sample_dump(const std::string& file) {
  return dump_polygons(sample_polygons(file));
}

inline bool is_triangle_mesh(const PolygonMesh& mesh) {
  for (const auto& polygon : mesh.polygons) {
    if (polygon.size() != 3) return false;
  }
  return true;
}

/// Every valid mesh file made of triangles.
inline const std::vector<std::string>& triangle_mesh_files() {
  static const std::vector<std::string> files = [] {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(MESHGRADE_SOURCE_DIR "/meshes")) {
      const std::string ending = entry.path().extension().string();
      const bool mesh =
          entry.is_regular_file() && ending != ".md" && ending != ".bzc" && ending != ".bez";
      const std::string name = entry.path().filename().string();
      if (mesh && is_triangle_mesh(sample_polygons(name))) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }();
  return files;
}

}  // namespace meshgrade
