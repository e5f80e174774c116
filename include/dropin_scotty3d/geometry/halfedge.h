#pragma once

// The half-edge mesh of Scotty3D's homework A2 (since Fall 2022), by the names of the course,
// so that a homework file written for it compiles as it is. docs/scotty3d.md says what works.
//
// A mesh is four lists of elements, whose members are open to all. Boundary faces are in
// `faces` as well, and marked. Every element has a number of its own, from one counter for all
// kinds.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "../detail/element_list.h"
#include "../lib/log.h"
#include "../lib/mathlib.h"

class Halfedge_Mesh {
 public:
  class Vertex;
  class Edge;
  class Face;
  class Halfedge;

  using Index = std::uint32_t;
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

  /// How much a bone moves a vertex.
  struct Bone_Weight {
    std::uint32_t bone = 0;
    float weight = 0.0f;
  };

  class Vertex {
   public:
    static constexpr const char* kReferenceName = "vertex reference (VertexRef)";
    static constexpr bool kStaysWhenErased = true;
    using Bone_Weight = Halfedge_Mesh::Bone_Weight;

    HalfedgeRef halfedge;  ///< one that leaves the vertex
    Index id = 0;
    Vec3 position;
    std::vector<Bone_Weight> bone_weights;

    bool on_boundary() const;
    /// The number of edges here.
    std::uint32_t degree() const;
    /// The sum of the normals of the faces around, weighted by area, of length 1.
    Vec3 normal() const;
    /// The mean of the neighbours.
    Vec3 neighborhood_center() const;
    /// 2 pi without the angles of the faces here.
    float angle_defect() const;
    float gaussian_curvature() const;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_vertex.h"
#endif
  };

  class Edge {
   public:
    static constexpr const char* kReferenceName = "edge reference (EdgeRef)";
    static constexpr bool kStaysWhenErased = true;

    HalfedgeRef halfedge;  ///< one of the two
    Index id = 0;
    bool sharp = false;

    bool on_boundary() const;
    Vec3 center() const;
    /// The mean of the normals of its faces, of length 1.
    Vec3 normal() const;
    float length() const;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_edge.h"
#endif
  };

  class Face {
   public:
    static constexpr const char* kReferenceName = "face reference (FaceRef)";
    static constexpr bool kStaysWhenErased = true;

    HalfedgeRef halfedge;  ///< one of those around the face
    Index id = 0;
    bool boundary = false;  ///< whether this is no face of the surface

    /// The mean of its corners.
    Vec3 center() const;
    Vec3 normal() const;
    /// The number of its corners.
    std::uint32_t degree() const;
    float area() const;

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_face.h"
#endif
  };

  class Halfedge {
   public:
    static constexpr const char* kReferenceName = "half-edge reference (HalfedgeRef)";
    static constexpr bool kStaysWhenErased = true;

    HalfedgeRef twin;
    HalfedgeRef next;
    VertexRef vertex;  ///< where it starts
    EdgeRef edge;
    FaceRef face;
    Index id = 0;
    Vec2 corner_uv;
    Vec3 corner_normal;

    void set_tnvef(HalfedgeRef twin_, HalfedgeRef next_, VertexRef vertex_, EdgeRef edge_,
                   FaceRef face_) {
      twin = twin_;
      next = next_;
      vertex = vertex_;
      edge = edge_;
      face = face_;
    }

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_halfedge.h"
#endif
  };

  meshedit::detail::scotty3d::ElementList<Vertex> vertices;
  meshedit::detail::scotty3d::ElementList<Edge> edges;
  meshedit::detail::scotty3d::ElementList<Face> faces;
  meshedit::detail::scotty3d::ElementList<Halfedge> halfedges;

  Halfedge_Mesh() = default;
  Halfedge_Mesh(const Halfedge_Mesh& mesh);
  Halfedge_Mesh(Halfedge_Mesh&& mesh) noexcept {
    swap(mesh);
  }
  Halfedge_Mesh& operator=(const Halfedge_Mesh& mesh);
  Halfedge_Mesh& operator=(Halfedge_Mesh&& mesh) noexcept {
    swap(mesh);
    return *this;
  }
  ~Halfedge_Mesh() = default;
  /// A deep copy: same elements with the same numbers, none shared.
  Halfedge_Mesh copy() const {
    return *this;
  }
  void swap(Halfedge_Mesh& mesh) noexcept;

  /// A new last element of a list: all pointers are the end of their list, positions 0. It
  /// takes the place in memory of what was erased first, if anything was.
  VertexRef emplace_vertex();
  EdgeRef emplace_edge(bool sharp = false);
  FaceRef emplace_face(bool boundary = false);
  HalfedgeRef emplace_halfedge();

  /// Takes an element out of its list at once and changes no pointer to it. The element stays
  /// readable: its number has bit 31 set, its pointers are the ends of their lists, and its
  /// numbers are not numbers.
  void erase_vertex(VertexRef v);
  void erase_edge(EdgeRef e);
  void erase_face(FaceRef f);
  void erase_halfedge(HalfedgeRef h);

  /// Gives the mean of what others hold beside their position: the weights of bones.
  static void interpolate_data(const std::vector<VertexCRef>& from, VertexRef to);
  /// The same of corners: their texture coordinates and normals.
  static void interpolate_data(const std::vector<HalfedgeCRef>& from, HalfedgeRef to);

// The graded functions.
#define SCOTTY3D_FUNCTION(exercise, ours, theirs, Result, Argument) \
  std::optional<Result##Ref> theirs(Argument##Ref);
#define SCOTTY3D_FUNCTION_OF_TWO(exercise, ours, theirs, Result, Argument) \
  std::optional<Result##Ref> theirs(Argument##Ref, Argument##Ref);
#define SCOTTY3D_MESH_FUNCTION(exercise, ours, theirs, Result) Result theirs();
#define SCOTTY3D_MESH_FUNCTION_OF(exercise, ours, theirs, Result, OurArgument, Argument) \
  Result theirs(Argument);
#define SCOTTY3D_REFINEMENT(exercise, ours, theirs) void theirs();
#include "../functions.inc"
  void extrude_positions(FaceRef face, Vec3 move, float shrink);
  void bevel_positions(FaceRef face, const std::vector<Vec3>& start_positions, Vec3 direction,
                       float distance);

  /// In the course it makes the mesh of the next level, with these positions. Here it takes
  /// down the positions, which are all that students write, and leaves the mesh as it is.
  void catmark_subdivide_helper(
      const std::unordered_map<VertexCRef, Vec3>& vertex_positions,
      const std::unordered_map<EdgeCRef, Vec3>& edge_vertex_positions,
      const std::unordered_map<FaceCRef, Vec3>& face_vertex_positions);

  struct Isotropic_Remesh_Parameters {
    std::uint32_t outer_iterations = 3;
    float longer_factor = 1.2f;
    float shorter_factor = 0.8f;
    std::uint32_t smoothing_iterations = 10;
    float smoothing_step = 0.2f;
  };
  void isotropic_remesh(const Isotropic_Remesh_Parameters& params);

  /// The number of boundary faces.
  std::size_t n_boundaries() const;
  /// The largest distance of a vertex from the origin.
  float radius() const;
  static Index id_of(const ElementCRef& element);
  static Vec3 center_of(const ElementCRef& element);
  static Vec3 normal_of(const ElementCRef& element);
  /// All elements with what they point to, a line for each.
  std::string describe() const;
  /// The first element that breaks a rule of meshes, and which rule; nothing if all is well.
  std::optional<std::pair<ElementCRef, std::string>> validate() const;

  /// A mesh of these faces, counter-clockwise lists of corners.
  /// @throws std::runtime_error if they are no surface
  static Halfedge_Mesh from_indexed_faces(const std::vector<Vec3>& positions,
                                          const std::vector<std::vector<Index>>& corners);
  /// Six quads around the origin, whose corners are `radius` away in each coordinate.
  static Halfedge_Mesh cube(float radius);

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_mesh.h"
#endif

 private:
  Index next_id_ = 0;
};

#include "../detail/std_lists.h"

#ifdef SCOTTY3D_ADDED
#include "scotty3d_added_after.h"
#endif
