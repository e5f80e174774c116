#pragma once

// What exercises about a whole mesh ask, as it goes to the worker, and what comes back. C++17.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/mesh/mesh_dump.h"
#include "grader/mesh/polygon_mesh.h"
#include "grader/mesh/refined_mesh.h"

namespace meshgrade {

struct WholeMeshInput {
  std::string mesh_name;  ///< for titles: "prism_5.obj"
  PolygonMesh mesh;
  std::uint32_t anchor_turns = 0;  ///< how often every element gets the next anchor around it
  std::uint32_t times = 1;         ///< calls, each on what came of the one before

  template <class Wire>
  void transfer(Wire& wire) {
    wire(mesh_name, mesh, anchor_turns, times);
  }
};

/// What a function left behind that may refuse the mesh.
struct RefusableStep {
  std::uint32_t done = 0;  ///< true was returned
  MeshDump after;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(done, after);
  }
};

/// One entry of a map from elements to positions.
struct PlacedElement {
  Ref element = kUnsetRef;
  Point3 at{};
};

/// What a function returned that computes the positions of the next level.
struct RefinementStep {
  MeshDump after;  ///< the mesh, which must be as it was
  std::vector<PlacedElement> vertices;
  std::vector<PlacedElement> edges;
  std::vector<PlacedElement> faces;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(after, vertices, edges, faces);
  }
};

namespace whole_mesh_detail {

/// One position for each of n elements; nothing if one has none, or one that is not finite.
inline std::optional<std::vector<Point3>> complete(const std::vector<PlacedElement>& placed,
                                                   std::size_t n) {
  std::vector<Point3> points(n, Point3{NAN, NAN, NAN});
  for (const PlacedElement& entry : placed) {
    if (entry.element < n) points[entry.element] = entry.at;
  }
  for (const Point3& p : points) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return {};
  }
  return points;
}

}  // namespace whole_mesh_detail

/// The positions of the next level of a mesh all of whose elements are live.
/// @return nothing if an element has none, or one that is not finite: there is no next level
inline std::optional<RefinedPoints> complete_points(const MeshDump& mesh,
                                                    const RefinementStep& step) {
  using whole_mesh_detail::complete;
  auto vertices = complete(step.vertices, mesh.vertices.size());
  auto edges = complete(step.edges, mesh.edges.size());
  auto faces = complete(step.faces, mesh.faces.size());
  if (!vertices || !edges || !faces) return {};
  return RefinedPoints{std::move(*vertices), std::move(*edges), std::move(*faces)};
}

}  // namespace meshgrade
