#include "grader/files/weld.h"

#include <functional>
#include <limits>
#include <unordered_map>

namespace meshgrade {
namespace {

struct PointHash {
  std::size_t operator()(const Point3& point) const {
    std::size_t hash = 0;
    for (const double coordinate : point) {
      hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<double>{}(coordinate);
    }
    return hash ^ (hash >> 32U);
  }
};

}  // namespace

std::string weld(PolygonMesh& mesh) {
  constexpr auto kUnseen = std::numeric_limits<std::uint32_t>::max();
  std::unordered_map<Point3, std::uint32_t, PointHash> vertex_at;
  std::vector<std::uint32_t> new_index(mesh.positions.size(), kUnseen);
  std::vector<Point3> positions;
  std::size_t n_corners = 0;
  std::size_t n_used = 0;
  for (auto& polygon : mesh.polygons) {
    for (std::uint32_t& corner : polygon) {
      std::uint32_t& index = new_index[corner];
      if (index == kUnseen) {
        const Point3& point = mesh.positions[corner];
        const auto next = static_cast<std::uint32_t>(positions.size());
        const auto [entry, is_new] = vertex_at.try_emplace(point, next);
        if (is_new) positions.push_back(point);
        index = entry->second;
        ++n_used;
      }
      corner = index;
      ++n_corners;
    }
  }
  const bool merged = positions.size() < n_used;
  mesh.positions = std::move(positions);
  return merged ? weld_note(n_corners, mesh.positions.size()) : "";
}

std::string weld_note(std::size_t n_corners, std::size_t n_vertices) {
  return "welded " + std::to_string(n_corners) + " corners into " + std::to_string(n_vertices) +
         " vertices";
}

}  // namespace meshgrade
