#pragma once

// The half-edge mesh of Scotty3D's homework A2 of Fall 2020 to Spring 2022, and of Stanford's
// Cardinal3D, by the names of the course, so that a homework file written for it compiles as it
// is. docs/scotty3d.md says what works.
//
// What differs from later years: pointers are functions that return references; new elements
// have pointers that were never set; and what is erased is only marked. It goes when do_erase()
// is called, which validate() does, and the grader when a function has returned.

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <sstream>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "dropin_scotty3d/detail/element_list.h"
#include "dropin_scotty3d/lib/log.h"
#include "dropin_scotty3d/lib/mathlib.h"

/// The kinds of subdivision. Nothing that is graded uses them.
enum class SubD { linear, catmullclark, loop };

class Halfedge_Mesh {
 public:
  class Vertex;
  class Edge;
  class Face;
  class Halfedge;

  using Index = std::size_t;
  using Size = std::size_t;
  using VertexRef = meshedit::detail::scotty3d::Reference<Vertex>;
  using VertexCRef = meshedit::detail::scotty3d::Reference<const Vertex>;
  using EdgeRef = meshedit::detail::scotty3d::Reference<Edge>;
  using EdgeCRef = meshedit::detail::scotty3d::Reference<const Edge>;
  using FaceRef = meshedit::detail::scotty3d::Reference<Face>;
  using FaceCRef = meshedit::detail::scotty3d::Reference<const Face>;
  using HalfedgeRef = meshedit::detail::scotty3d::Reference<Halfedge>;
  using HalfedgeCRef = meshedit::detail::scotty3d::Reference<const Halfedge>;
  using ElementRef = std::variant<VertexRef, EdgeRef, HalfedgeRef, FaceRef>;
  using ElementCRef = std::variant<VertexCRef, EdgeCRef, HalfedgeCRef, FaceCRef>;

  // Data that the course hides from other classes is open here: functions of Halfedge_Mesh,
  // which is all that students write, may use it there as well.

  class Vertex {
   public:
    static constexpr const char* kReferenceName = "vertex reference (VertexRef)";
    static constexpr bool kStaysWhenErased = false;

    HalfedgeRef& halfedge() { return _halfedge; }
    HalfedgeCRef halfedge() const { return _halfedge; }

    bool on_boundary() const;
    /// The number of faces here, without boundaries: one less than that of edges, if there are
    /// any.
    unsigned int degree() const;
    /// The sum of the normals of the faces around, weighted by area, of length 1.
    Vec3 normal() const;
    Vec3 center() const { return pos; }
    /// The mean of the neighbours.
    Vec3 neighborhood_center() const;
    unsigned int id() const { return _id; }

    Vec3 pos;
    Vec3 new_pos;  ///< at the next level of a subdivision
    bool is_new = false;
    unsigned int _id = 0;
    HalfedgeRef _halfedge;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_vertex.h"
#endif
  };

  class Edge {
   public:
    static constexpr const char* kReferenceName = "edge reference (EdgeRef)";
    static constexpr bool kStaysWhenErased = false;

    HalfedgeRef& halfedge() { return _halfedge; }
    HalfedgeCRef halfedge() const { return _halfedge; }

    bool on_boundary() const;
    Vec3 center() const;
    /// The mean of the normals of its faces, of length 1.
    Vec3 normal() const;
    float length() const;
    unsigned int id() const { return _id; }

    Vec3 new_pos;  ///< of its new vertex at the next level of a subdivision
    bool is_new = false;
    unsigned int _id = 0;
    HalfedgeRef _halfedge;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_edge.h"
#endif
  };

  class Face {
   public:
    static constexpr const char* kReferenceName = "face reference (FaceRef)";
    static constexpr bool kStaysWhenErased = false;

    HalfedgeRef& halfedge() { return _halfedge; }
    HalfedgeCRef halfedge() const { return _halfedge; }

    bool is_boundary() const { return boundary; }
    /// The mean of its corners.
    Vec3 center() const;
    /// Of length 1.
    Vec3 normal() const;
    /// The number of its corners.
    unsigned int degree() const;
    unsigned int id() const { return _id; }

    Vec3 new_pos;  ///< of its new vertex at the next level of a subdivision
    unsigned int _id = 0;
    HalfedgeRef _halfedge;
    bool boundary = false;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_face.h"
#endif
  };

  class Halfedge {
   public:
    static constexpr const char* kReferenceName = "half-edge reference (HalfedgeRef)";
    static constexpr bool kStaysWhenErased = false;

    HalfedgeRef& twin() { return _twin; }
    HalfedgeCRef twin() const { return _twin; }
    HalfedgeRef& next() { return _next; }
    HalfedgeCRef next() const { return _next; }
    /// Where it starts.
    VertexRef& vertex() { return _vertex; }
    VertexCRef vertex() const { return _vertex; }
    EdgeRef& edge() { return _edge; }
    EdgeCRef edge() const { return _edge; }
    FaceRef& face() { return _face; }
    FaceCRef face() const { return _face; }
    unsigned int id() const { return _id; }

    bool is_boundary() const { return _face->is_boundary(); }

    void set_neighbors(HalfedgeRef next, HalfedgeRef twin, VertexRef vertex, EdgeRef edge,
                       FaceRef face) {
      _next = next;
      _twin = twin;
      _vertex = vertex;
      _edge = edge;
      _face = face;
    }

    unsigned int _id = 0;
    HalfedgeRef _twin, _next;
    VertexRef _vertex;
    EdgeRef _edge;
    FaceRef _face;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_halfedge.h"
#endif
  };

  Halfedge_Mesh() = default;
  Halfedge_Mesh(const Halfedge_Mesh&) = delete;
  Halfedge_Mesh& operator=(const Halfedge_Mesh&) = delete;
  ~Halfedge_Mesh() = default;

  /// A new last element of a list. Its pointers were never set, its position is 0.
  VertexRef new_vertex();
  EdgeRef new_edge();
  FaceRef new_face(bool boundary = false);
  HalfedgeRef new_halfedge();

  /// Marks an element. It stays in its list, with all that it holds, until do_erase().
  void erase(VertexRef v);
  void erase(EdgeRef e);
  void erase(FaceRef f);
  void erase(HalfedgeRef h);

  /// Takes what is marked out of the lists. Using a reference to it is a fault from then on.
  void do_erase();

  VertexRef vertices_begin() {
    return vertices.begin();
  }
  VertexCRef vertices_begin() const {
    return vertices.begin();
  }
  VertexRef vertices_end() {
    return vertices.end();
  }
  VertexCRef vertices_end() const {
    return vertices.end();
  }
  EdgeRef edges_begin() {
    return edges.begin();
  }
  EdgeCRef edges_begin() const {
    return edges.begin();
  }
  EdgeRef edges_end() {
    return edges.end();
  }
  EdgeCRef edges_end() const {
    return edges.end();
  }
  FaceRef faces_begin() {
    return faces.begin();
  }
  FaceCRef faces_begin() const {
    return faces.begin();
  }
  FaceRef faces_end() {
    return faces.end();
  }
  FaceCRef faces_end() const {
    return faces.end();
  }
  HalfedgeRef halfedges_begin() {
    return halfedges.begin();
  }
  HalfedgeCRef halfedges_begin() const {
    return halfedges.begin();
  }
  HalfedgeRef halfedges_end() {
    return halfedges.end();
  }
  HalfedgeCRef halfedges_end() const {
    return halfedges.end();
  }

  // With what is marked.
  Size n_vertices() const {
    return vertices.size();
  }
  Size n_edges() const {
    return edges.size();
  }
  Size n_faces() const {
    return faces.size();
  }
  Size n_halfedges() const {
    return halfedges.size();
  }

  bool has_boundary() const {
    return n_boundaries() > 0;
  }
  /// The number of boundary faces.
  Size n_boundaries() const;

  // The graded functions.
#define SCOTTY3D_FUNCTION(exercise, ours, theirs, Result, Argument) \
  std::optional<Result##Ref> theirs(Argument##Ref);
#define SCOTTY3D_REFINEMENT(exercise, ours, theirs) void theirs();
#include "../functions.inc"
  void triangulate();
  void loop_subdivide();

  // These may be written, and are not graded.
  void bevel_vertex_positions(const std::vector<Vec3>& start_positions, FaceRef face,
                              float tangent_offset);
  void bevel_edge_positions(const std::vector<Vec3>& start_positions, FaceRef face,
                            float tangent_offset);
  void bevel_face_positions(const std::vector<Vec3>& start_positions, FaceRef face,
                            float tangent_offset, float normal_offset);
  std::optional<VertexRef> bisect_edge(EdgeRef e);
  std::optional<FaceRef> inset_face(FaceRef f);
  std::optional<VertexRef> extrude_vertex(VertexRef v);
  bool isotropic_remesh();
  bool simplify();

  /// collapse_edge(), and what it marked goes at once.
  std::optional<VertexRef> collapse_edge_erase(EdgeRef e) {
    std::optional<VertexRef> left = collapse_edge(e);
    do_erase();
    return left;
  }

  /// The first element that breaks a rule of meshes, and which rule. If none does, what is
  /// marked goes.
  std::optional<std::pair<ElementRef, std::string>> validate();
  /// An element that is degenerate; none is looked for here.
  std::optional<std::pair<ElementRef, std::string>> warnings() {
    return std::nullopt;
  }

  /// Whether the program shows the surface inside out. It does not here.
  bool flipped() const {
    return flip_orientation;
  }
  void flip() {
    flip_orientation = !flip_orientation;
  }
  void mark_dirty() {
    render_dirty_flag = true;
  }

  Vec3 normal_of(ElementRef element);
  static Vec3 center_of(ElementRef element);
  static unsigned int id_of(ElementRef element);

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_mesh.h"
#endif

  meshedit::detail::scotty3d::ElementList<Vertex> vertices;
  meshedit::detail::scotty3d::ElementList<Edge> edges;
  meshedit::detail::scotty3d::ElementList<Face> faces;
  meshedit::detail::scotty3d::ElementList<Halfedge> halfedges;

  unsigned int next_id = 1;
  bool flip_orientation = false;
  bool render_dirty_flag = false;

  // What is marked.
  std::set<VertexRef> verased;
  std::set<EdgeRef> eerased;
  std::set<FaceRef> ferased;
  std::set<HalfedgeRef> herased;
};

#include "dropin_scotty3d/detail/std_lists.h"

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_after.h"
#endif
