#include "grader/mesh/mesh_dump.h"

#include <algorithm>
#include <cmath>

namespace meshgrade {
namespace {

std::string name(const char* letter, Ref ref) {
  if (ref == kUnsetRef) return "unset";
  if (ref == kPastEndRef) return "past the end";
  if (ref == kForeignRef) return "no element of this mesh";
  if ((ref & kDeletedBit) != 0)
    return letter + std::to_string(ref & ~kDeletedBit) + " (deleted)";
  return letter + std::to_string(ref);
}

template <class Records>
std::size_t count_live(const Records& records) {
  return static_cast<std::size_t>(
      std::count_if(records.begin(), records.end(), [](const auto& r) { return r.live != 0; }));
}

}  // namespace

std::string halfedge_name(Ref ref) {
  return name("h", ref);
}
std::string vertex_name(Ref ref) {
  return name("v", ref);
}
std::string edge_name(Ref ref) {
  return name("e", ref);
}

std::string face_name(Ref ref) {
  if (ref >= kForeignRef || (ref & kBoundaryBit) == 0) return name("f", ref);
  return name("b", ref & ~kBoundaryBit);
}

std::string element_name(ElementKind kind, Ref ref) {
  switch (kind) {
    case ElementKind::kHalfedge:
      return halfedge_name(ref);
    case ElementKind::kVertex:
      return vertex_name(ref);
    case ElementKind::kEdge:
      return edge_name(ref);
    case ElementKind::kFace:
      return face_name(ref);
  }
  return {};
}

const char* kind_name(ElementKind kind) {
  switch (kind) {
    case ElementKind::kHalfedge:
      return "half-edge";
    case ElementKind::kVertex:
      return "vertex";
    case ElementKind::kEdge:
      return "edge";
    case ElementKind::kFace:
      return "face";
  }
  return "element";
}

const FaceRecord* find_face(const MeshDump& mesh, Ref ref) {
  if (!is_plain(ref)) return nullptr;
  const bool outside = (ref & kBoundaryBit) != 0;
  const auto& list = outside ? mesh.boundaries : mesh.faces;
  const Ref index = ref & ~kBoundaryBit;
  return index < list.size() ? &list[index] : nullptr;
}

Counts count(const MeshDump& mesh) {
  return {count_live(mesh.vertices), count_live(mesh.edges), count_live(mesh.faces),
          count_live(mesh.halfedges), count_live(mesh.boundaries)};
}

double diagonal(const MeshDump& mesh) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const VertexRecord& v : mesh.vertices) {
      if (v.live == 0) continue;
      low = std::min(low, v.position[axis]);
      high = std::max(high, v.position[axis]);
    }
    if (high > low) sum += (high - low) * (high - low);
  }
  return std::sqrt(sum);
}

}  // namespace meshgrade
