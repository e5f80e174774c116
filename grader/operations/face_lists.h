#pragma once

// A surface as what files have: for each face the list of its corners. An operation on a mesh
// is easily right there, and there is no half-edge that could be wrong.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// A corner. Old vertices have the number of their record in the dump.
using Label = std::uint32_t;

/// Corners of a face, counter-clockwise; it matters not where the list begins.
using Corners = std::vector<Label>;

struct FaceLists {
  std::vector<Point3> positions;  ///< by label; not all labels need to be in use
  std::vector<Corners> faces;     ///< those of the surface; what lies outside follows from them

  /// A new corner. @return its label
  Label add(const Point3& position);

  /// Puts others in the place of the face with these corners, which must be there.
  void replace(const Corners& face, const std::vector<Corners>& others);
};

/// The faces of a mesh that keeps all rules, in the order of its live faces.
FaceLists face_lists_of(const MeshDump& mesh);

/// The list with its least label first: equal for equal faces.
Corners canonical(Corners corners);

/// The place of a label in a list; nothing if it is not there.
std::optional<std::size_t> place_of(const Corners& corners, Label label);

/// The list, beginning with this corner, which must be there.
Corners beginning_with(const Corners& corners, Label first);

/// Makes one of some corners: each of them becomes `left`. Where that stands twice in a row it
/// stands once then, and what has fewer than three corners goes.
FaceLists merged(const FaceLists& before, const Corners& corners, Label left);

/// The corners of a face, from the steps between them.
/// @return in order; fewer than there are steps if these are no single round
Corners round_of(const std::map<Label, Label>& next);

/// Questions about a surface that does not change meanwhile.
class Surface {
 public:
  explicit Surface(const FaceLists& lists);

  /// The face that has the side from `a` to `b`; nothing outside.
  std::optional<std::size_t> face_with_side(Label a, Label b) const;
  bool is_edge(Label a, Label b) const;
  bool is_boundary_edge(Label a, Label b) const;
  bool is_boundary(Label vertex) const;
  /// By edges, in ascending order, each once.
  /// @throws std::out_of_range if no face has this corner
  std::span<const Label> neighbours(Label vertex) const;
  bool are_neighbours(Label a, Label b) const;
  /// The faces that have this corner, in ascending order.
  /// @throws std::out_of_range if no face has this corner
  std::span<const std::size_t> faces_at(Label vertex) const;
  /// The corners of the boundary loop that has the side from `a` to `b`, outside, in its order.
  Corners loop_of(Label a, Label b) const;
  /// Whether no face has the side from `a` to `b`, but one has that from `b` to `a`.
  bool is_outside(Label a, Label b) const;

 private:
  /// Where what belongs to each label begins in a list of all, and where the last one ends.
  using Begins = std::vector<std::size_t>;

  template <typename T>
  static std::span<const T> row_of(const Begins& begins, const std::vector<T>& all,
                                   Label label);

  void find_sides(const FaceLists& lists);
  void find_neighbours(const FaceLists& lists);
  void find_boundary();

  std::size_t n_labels_ = 0;
  Begins sides_begin_;              ///< of the sides that start at a label
  std::vector<Label> ends_;         ///< of each side
  std::vector<std::size_t> faces_;  ///< of each side
  Begins neighbours_begin_;
  std::vector<Label> neighbours_;
  std::vector<bool> is_boundary_;    ///< by label
  std::vector<Label> next_outside_;  ///< by label; of no use inside
};

/// What keeps these lists from being a surface without two edges between the same vertices and
/// without two faces of the same corners; empty if nothing does.
std::string trouble_of(const FaceLists& lists);

/// The same as a mesh whose vertices have the numbers of their labels. Those of labels that are
/// not in use are not live.
/// @throws meshedit::MeshError if it is no surface
MeshDump mesh_of(const FaceLists& lists);

}  // namespace meshgrade
