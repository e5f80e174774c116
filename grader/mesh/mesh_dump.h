#pragma once

// A half-edge mesh as plain numbers: what the worker writes down and the judge reads. Elements
// are numbered in the order of their creation and keep their number for life. Written for
// C++17.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace meshgrade {

using Point3 = std::array<double, 3>;

/// A pointer of a mesh, as a number: that of the element it leads to, or one of the values
/// below.
using Ref = std::uint32_t;

constexpr Ref kUnsetRef = 0xFFFFFFFFU;
constexpr Ref kPastEndRef = 0xFFFFFFFEU;
/// The pointer leads to no element of this mesh and is not unset.
constexpr Ref kForeignRef = 0xFFFFFFFDU;
/// Added to the number of an element that was deleted.
constexpr Ref kDeletedBit = 0x80000000U;
/// Added to the number of a boundary loop, where a face is meant.
constexpr Ref kBoundaryBit = 0x40000000U;

struct HalfedgeRecord {
  Ref next;
  Ref twin;
  Ref vertex;
  Ref edge;
  Ref face;
  std::uint32_t live;
};

struct VertexRecord {
  Ref halfedge;
  std::uint32_t live;
  Point3 position;
};

struct EdgeRecord {
  Ref halfedge;
  std::uint32_t live;
};

struct FaceRecord {
  Ref halfedge;
  std::uint32_t live;
  std::uint32_t is_boundary;  ///< what Face::isBoundary() says
};

struct MeshDump {
  std::vector<HalfedgeRecord> halfedges;
  std::vector<VertexRecord> vertices;
  std::vector<EdgeRecord> edges;
  std::vector<FaceRecord> faces;
  std::vector<FaceRecord> boundaries;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(halfedges, vertices, edges, faces, boundaries);
  }
};

/// "h12", "v3", "e5", "f2", "b0"; or in words what the pointer leads to instead.
std::string halfedge_name(Ref ref);
std::string vertex_name(Ref ref);
std::string edge_name(Ref ref);
std::string face_name(Ref ref);

enum class ElementKind { kHalfedge, kVertex, kEdge, kFace };

/// The same for an element of any kind; a boundary loop is a face.
std::string element_name(ElementKind kind, Ref ref);

/// "half-edge", "vertex", "edge", "face"
const char* kind_name(ElementKind kind);

/// True if the number stands for an element and not for one of the special values. The element
/// need not exist.
constexpr bool is_plain(Ref ref) {
  return (ref & kDeletedBit) == 0;
}

/// The face or boundary loop that a plain face reference names; nullptr if there is none.
const FaceRecord* find_face(const MeshDump& mesh, Ref ref);

/// Numbers of live elements.
struct Counts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t halfedges = 0;
  std::size_t boundaries = 0;

  friend bool operator==(const Counts& a, const Counts& b) {
    return a.vertices == b.vertices && a.edges == b.edges && a.faces == b.faces &&
           a.halfedges == b.halfedges && a.boundaries == b.boundaries;
  }
};
Counts count(const MeshDump& mesh);

/// The length of the diagonal of the bounding box of all live vertices; 0 if there is none.
double diagonal(const MeshDump& mesh);

}  // namespace meshgrade
