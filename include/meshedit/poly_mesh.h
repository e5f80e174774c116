#pragma once

#include <map>
#include <optional>
#include <vector>

#include "halfedge_mesh.h"
#include "vector3d.h"

namespace meshedit {

/// Where the vertices of the next level of a subdivision lie: one position for each vertex,
/// edge and face of the surface. Boundary loops are no faces: they have none.
struct RefinedPositions {
  std::map<VertexIter, Vector3D> vertices;  ///< where each old vertex goes
  std::map<EdgeIter, Vector3D> edges;       ///< the new vertex of each edge
  std::map<FaceIter, Vector3D> faces;       ///< the new vertex within each face
};

/// What isotropicRemesh() is asked for.
struct RemeshParameters {
  Size outerIterations = 3;       ///< rounds of split, collapse, flip and smooth
  double longerFactor = 1.2;      ///< an edge longer than this times the mean length is split
  double shorterFactor = 0.8;     ///< one that is shorter than this times it is collapsed
  Size smoothingIterations = 10;  ///< in each round
  double smoothingStep = 0.2;     ///< which part of the way a vertex goes in each of them
};

/// THE SECOND ASSIGNMENT: editing a surface whose faces are polygons with any number of
/// corners.
///
/// The mesh is that of halfedge_mesh.h. What is new:
///
///   - Faces have 3 corners or more, boundary loops too.
///   - What an operation takes away is deleted: deleteVertex and the others. Deleting changes
///     no pointer: mend those that led to the element first. A handle to a deleted element is
///     of no use any more, and using it is told with the line.
///   - An operation that would leave no surface REFUSES: it returns std::nullopt, and the mesh
///     is as it was. Look first, change afterwards. What would not be one:
///       - a face with fewer than 3 corners, or one that visits a vertex twice;
///       - a vertex where two fans of faces touch in nothing but the vertex;
///       - an edge without a face on either side, or nothing at all.
///     Where the result is a surface but a degenerate one (two edges between the same vertices,
///     two faces with the same corners), both is right: to do it or to refuse.
///   - Which of the old elements go on living is yours, but for vertices: those that an
///     operation does not remove stay, with their position.
///
/// Every operation costs time in proportion to the faces around its element, not to the mesh.
class PolyMesh : public HalfedgeMesh {
 public:
  /// EXERCISE edge_flip_polygon. Turns an edge by one corner, counter-clockwise in both faces:
  /// from a-b to d-c, where c follows b in its face and d follows a in the other.
  ///
  ///      d ---- a ---- y        d ---- a ---- y
  ///      |      |      |        | `-.      f  |
  ///      |  g   |   f  |        |    `-.      |
  ///      |      |      |        |  g    `-.   |
  ///      x ---- b ---- c        x ---- b --`- c
  ///
  /// Refuses a boundary edge, and an edge whose new ends would make a face visit a vertex
  /// twice. Creates and deletes nothing.
  ///
  /// @return `e`, turned
  MESHEDIT_YOURS std::optional<EdgeIter> flipEdge(EdgeIter e);

  /// EXERCISE edge_split_polygon. Puts a new vertex in the middle of an edge a-b. Each face on
  /// its sides is cut in two, from the new vertex to the corner that follows the edge in it;
  /// outside of the surface nothing is cut. Never refuses.
  ///
  /// @return the new vertex, its halfedge() along one half of the old edge
  MESHEDIT_YOURS std::optional<VertexIter> splitEdge(EdgeIter e);

  /// EXERCISE edge_collapse. Shrinks an edge to one vertex in its middle. Both faces beside it
  /// lose a corner; a triangle there vanishes, and its two other edges become one.
  ///
  /// Refuses where no surface would be left: for example if both ends lie on a boundary and the
  /// edge does not, or if another face than those beside the edge has both ends.
  ///
  /// @return the vertex that is left: either of the two, or a new one
  MESHEDIT_YOURS std::optional<VertexIter> collapseEdge(EdgeIter e);

  /// EXERCISE edge_dissolve. Takes an edge away. The two faces beside it become one; on a
  /// boundary, the face goes and the outside takes its place.
  ///
  /// Refuses where no surface would be left: for example if the two faces share more than this
  /// edge, or a face at the boundary touches it elsewhere, too.
  ///
  /// @return the face that is left, a boundary loop if it was a boundary edge
  MESHEDIT_YOURS std::optional<FaceIter> dissolveEdge(EdgeIter e);

  /// EXERCISE vertex_dissolve. Takes a vertex away, with all edges at it. The faces around it
  /// become one. On a boundary, a new edge between its two neighbours there closes the face.
  ///
  /// Refuses where no surface would be left: for example if two of the faces share more than
  /// the vertex and one edge at it.
  ///
  /// @return the face that is left
  MESHEDIT_YOURS std::optional<FaceIter> dissolveVertex(VertexIter v);

  /// EXERCISE vertex_inset. Puts a new vertex into a face, at the mean of its corners, and
  /// joins it to each of them: n corners, n triangles. Never refuses a face of the surface.
  ///
  /// @return the new vertex
  MESHEDIT_YOURS std::optional<VertexIter> insetVertex(FaceIter f);

  /// EXERCISE face_extrude. Makes a smaller copy of a face inside it, to be moved later: each
  /// corner gets a new one AT THE SAME PLACE, and each side a quad between the old corners and
  /// the new ones. Never refuses a face of the surface.
  ///
  /// @return the face in the middle
  MESHEDIT_YOURS std::optional<FaceIter> extrudeFace(FaceIter f);

  /// EXERCISE face_collapse. Shrinks a face to one vertex, at the mean of its corners. The
  /// faces beside it lose a corner for each side that they share with it; a triangle there
  /// vanishes, and its two other edges become one.
  ///
  /// Refuses where no surface would be left: for example if the face touches a boundary in two
  /// places, or if another face has two of its corners and not the side between them.
  ///
  /// @return the vertex that is left: one of the corners, or a new one
  MESHEDIT_YOURS std::optional<VertexIter> collapseFace(FaceIter f);

  /// EXERCISE vertex_bevel. Puts a face in the place of a vertex: each edge there gets an end
  /// of its own, AT THE PLACE OF THE VERTEX, and these are the corners of the face. On a
  /// boundary, one side of the new face lies on it.
  ///
  /// Refuses a vertex with two edges.
  ///
  /// @return the new face
  MESHEDIT_YOURS std::optional<FaceIter> bevelVertex(VertexIter v);

  /// EXERCISE edge_bevel. Puts a face in the place of an edge: each OTHER edge at its two ends
  /// gets an end of its own, at the place of the old one, and these are the corners of the
  /// face.
  ///
  /// Refuses a boundary edge, and an edge whose ends have no third edge.
  ///
  /// @return the new face
  MESHEDIT_YOURS std::optional<FaceIter> bevelEdge(EdgeIter e);

  /// EXERCISE face_remove. Takes a face away, and the outside takes its place: a new boundary
  /// loop, or the loops that the face touches grow into it. What lay on a boundary, and has no
  /// face then, goes: sides of the face, and corners between two of them.
  ///
  /// Refuses where no surface would be left: if the face touches a boundary in a corner and not
  /// in a side there, or if all of its sides lie on a boundary.
  ///
  /// @return a boundary loop that passes an old side of the face
  MESHEDIT_YOURS std::optional<FaceIter> removeFace(FaceIter f);

  /// EXERCISE edge_weld. Makes one edge of two that lie on a boundary, so that their faces lie
  /// side by side: where `e` starts in its face, `f` ends in its own. Of each two ends that
  /// meet, one vertex is left, in the middle between them; an end that both have stays.
  ///
  /// Refuses an edge that is not on a boundary, twice the same, and what leaves no surface: if
  /// two ends that meet are joined by an edge, or are corners of the same face.
  ///
  /// @return the edge that is left: either of the two, or a new one
  MESHEDIT_YOURS std::optional<EdgeIter> weldEdges(EdgeIter e, EdgeIter f);

  // WHERE THE CORNERS of a new face LIE, while somebody drags it. These change no pointer.

  /// EXERCISE extrude_positions. Places the corners of a face that extrudeFace() has made: each
  /// at p + shrink (m - p) + move, where p is the outer corner beside it and m the mean of all
  /// outer corners. Each call begins at the outer corners, so that the same call again changes
  /// nothing.
  ///
  /// @param shrink 0 for full size, 1 for a point, less than 0 for a larger face
  MESHEDIT_YOURS void placeExtruded(FaceIter f, const Vector3D& move, double shrink);

  /// EXERCISE bevel_positions. Places the corners of a face that bevelVertex() or bevelEdge()
  /// has made, each on the edge that leads out of the face there: at start + t u, where u is
  /// the unit vector from the start to the outer vertex, and t = distance / dot(direction, u),
  /// so that all corners go equally far in the direction.
  ///
  /// @param starts where the corners were at first, from the vertex of f->halfedge() on
  /// @param direction of length 1
  MESHEDIT_YOURS void placeBevelled(FaceIter f, const std::vector<Vector3D>& starts,
                                    const Vector3D& direction, double distance);

  // The WHOLE mesh: these cost time in proportion to it.

  /// EXERCISE triangulation. Cuts every face with more than three corners into triangles, by
  /// new edges between its corners. Any pattern is right: n corners, n - 2 triangles. All
  /// vertices and edges stay as they are, boundary loops too. An old face may be one of the
  /// triangles, or be deleted.
  MESHEDIT_YOURS void triangulate();

  /// EXERCISE linear_subdivision. Where the vertices of the next level lie if each face with n
  /// corners is cut into n quads and nothing is smoothed: vertices stay, the new vertex of an
  /// edge lies in its middle, that of a face at the mean of its corners. Cutting is not yours:
  /// the mesh must stay as it is.
  MESHEDIT_YOURS RefinedPositions linearPositions();

  /// EXERCISE catmull_clark. The same with the rules of Catmull and Clark (1978):
  ///
  ///   face    the mean of its corners
  ///   edge    the mean of its two ends and of the new vertices of the two faces beside it;
  ///           on a boundary its middle
  ///   vertex  (Q + 2 R + (n - 3) S) / n, where n is its number of edges, Q the mean of the new
  ///           vertices of the faces around it, R the mean of the middles of its edges, and S
  ///           where it lies; on a boundary 3/4 S + 1/8 (a + b), with its two neighbours a and
  ///           b along the boundary
  MESHEDIT_YOURS RefinedPositions catmullClarkPositions();

  /// EXERCISE loop_refinement. One level of Loop subdivision: each triangle becomes four, and
  /// all vertices move. Old vertices stay; which edges and faces are the old ones is yours.
  ///
  ///   edge    3/8 of each end and 1/8 of each of the two vertices opposite; on a boundary its
  ///           middle
  ///   vertex  (1 - n u) S + u (the sum of its n neighbours), u = 3/16 for n = 3, otherwise
  ///           3 / (8 n); on a boundary 3/4 S + 1/8 (a + b), with its two neighbours a and b
  ///           along the boundary
  ///
  /// @return false if a face is no triangle: the mesh is then as it was
  MESHEDIT_YOURS bool loopSubdivide();

  /// EXERCISE isotropic_remeshing. Makes the triangles of a mesh alike: edges about as long as
  /// the mean, about six edges at each vertex. With your own splitEdge, collapseEdge and
  /// flipEdge. In each round, L being the mean length of all edges:
  ///
  ///   1. split each edge that is longer than longerFactor L
  ///   2. collapse each edge that is shorter than shorterFactor L, unless that is refused
  ///   3. flip each edge where that lowers the sum of |n - 6| over the four vertices of its two
  ///      triangles, n being the number of edges at a vertex
  ///   4. smooth, so many times: each vertex p goes to p + s (u - (u . N) N), where u leads
  ///   from
  ///      p to the mean of its neighbours, N is its normal, weighted by areas, and s the step.
  ///      All of that comes from the positions before the iteration.
  ///
  /// Yours: whether L is taken once or in each round anew; whether a step visits the edges
  /// that there are when it begins, or goes on until there is nothing left to do; in which
  /// order; and what becomes of vertices on a boundary, and of edges at them.
  ///
  /// @param parameters  all faces of the mesh are triangles
  MESHEDIT_YOURS void isotropicRemesh(const RemeshParameters& parameters);

  /// EXERCISE simplification. Makes a mesh of triangles coarser by the quadric errors of
  /// Garland and Heckbert (1997): collapses the edge of the least cost, by collapseEdge(),
  /// again and again, until at most `ratio` times as many faces are left as there were.
  ///
  ///   face    K = p p^T, where p = (n, -n . q) with the unit normal n and a corner q: so
  ///           (v, 1)^T K (v, 1) is the squared distance of v from the plane of the face
  ///   vertex  the sum of K over the faces around it
  ///   edge    the sum of K of its two ends. The new vertex lies at the point v where
  ///           (v, 1)^T K (v, 1) is least, and this value is the cost. Where there is no single
  ///           such point (all is flat, or straight like a crease): at the best point of the
  ///           edge, or at the best of its ends and its middle
  ///
  /// The new vertex gets the K of its edge, and the edges at it get new costs. An edge whose
  /// collapse is refused is passed over; until one of its ends moves it need not be tried
  /// again.
  ///
  /// Time: O(n log n) for n faces. Do not search all edges for each collapse.
  ///
  /// @return false if no collapse is left before the goal is reached
  MESHEDIT_YOURS bool simplify(double ratio);
};

}  // namespace meshedit
