#pragma once

// Compares half-edge meshes as surfaces, whatever the numbering of their elements. One matched
// half-edge fixes the map of a whole connected component, since next and twin lead everywhere.

#include <functional>
#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// A map from the elements of one mesh to those of another; kUnsetRef where there is none.
struct SurfaceMatch {
  std::vector<Ref> halfedge;
  std::vector<Ref> vertex;
  std::vector<Ref> edge;

  explicit SurfaceMatch(const MeshDump& expected)
      : halfedge(expected.halfedges.size(), kUnsetRef),
        vertex(expected.vertices.size(), kUnsetRef),
        edge(expected.edges.size(), kUnsetRef) {}
};

/// Maps the component of half-edge `from` of `expected` to that of half-edge `to` of `actual`,
/// keeping next, twin, vertices, edges, and which side lies outside. Both meshes must keep all
/// mesh rules. @return false, with `match` as it was before, if there is no such map
bool match_component(const MeshDump& expected, const MeshDump& actual, Ref from, Ref to,
                     SurfaceMatch& match);

/// Matches every component. `starts` are half-edges of `expected`, the best to start from
/// first; they must hit every component. For each, `candidates` lists the half-edges of
/// `actual` that it may be mapped to; the first that works is taken.
/// @return false if some component cannot be matched, or the numbers of elements differ
bool match_surfaces(const MeshDump& expected, const MeshDump& actual,
                    const std::vector<Ref>& starts,
                    const std::function<std::vector<Ref>(Ref)>& candidates,
                    SurfaceMatch& match);

}  // namespace meshgrade
