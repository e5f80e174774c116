#pragma once

// The triangles around a flipped or split edge, as a picture shows them: before, as the student
// left them, and as they must be. Data only: how it is drawn is the report's business.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "grader/judge/correspondence.h"

namespace meshgrade {

/// In place of an index: not in the picture.
constexpr std::size_t kNotPictured = SIZE_MAX;

/// Where a pointer leads.
struct FigurePointer {
  std::size_t place = kNotPictured;  ///< in the panel's list of the kind that it leads to
  std::string text;                  ///< "h12", "unset"; empty: to what is not created yet
};

struct FigureElement {
  std::string name;  ///< "h12"; empty if the student has not created it
  /// The letters of the corners that it belongs to: "m" for a vertex, "bm" for an edge, "mc"
  /// for a half-edge from m to c, "bma" for a face. A "-" is a corner beyond the picture; a
  /// boundary loop has no letters.
  std::string corners;
  bool outside = false;  ///< beyond the outer edges of the picture, or in a boundary loop
  /// Of a half-edge: next, twin, vertex, edge, face; of others: halfedge. None if the element
  /// does not exist: it was not created, or deleted.
  std::vector<FigurePointer> pointers;
};

struct FigurePanel {
  std::array<std::vector<FigureElement>, 4> elements;  ///< by kind

  const std::vector<FigureElement>& of(ElementKind kind) const {
    return elements[static_cast<std::size_t>(kind)];
  }
};

/// A pointer that is wrong.
struct FigureFault {
  ElementKind kind = ElementKind::kHalfedge;
  std::size_t place = kNotPictured;  ///< of its element, in `yours` and in `expected`
  std::size_t pointer = 0;           ///< index into FigureElement::pointers
  bool was_set = false;              ///< the student's code set it, but to something wrong
  std::string text;                  ///< "h12.next must be h5 (ca), still h4 (bd)"
};

/// Empty panels: there is no picture.
struct NeighbourhoodFigure {
  FigurePanel before;
  FigurePanel yours;     ///< the elements that stand for the expected ones, in the same places
  FigurePanel expected;  ///< with the student's names
  std::vector<FigureFault> faults;   ///< what was set wrongly first
  std::vector<std::string> surplus;  ///< names of elements that are created but not needed
  std::vector<std::string> deleted;  ///< names of old elements that must stay, but are gone

  bool is_stopped = false;  ///< within the operation: much of `yours` was still to be done

  bool empty() const { return before.of(ElementKind::kVertex).empty(); }
};

/// The kind of element that the pointer with this index leads to.
ElementKind target_kind(ElementKind kind, std::size_t pointer);

/// "next", "halfedge", ...
const char* pointer_name(ElementKind kind, std::size_t pointer);

/// A wrong pointer, before it has found its place in a picture.
struct WrongCell {
  ElementKind kind;
  Ref element;  ///< by the numbers of the expected mesh
  std::size_t pointer;
  bool was_set;
  std::string text;
};

/// The meshes are those of diff_pointers(), and `match` leads from the expected elements to the
/// student's. Empty if two corners are the same vertex, since corners are told by their
/// letters.
NeighbourhoodFigure figure_of_neighbourhood(const MeshDump& before, const MeshDump& after,
                                            const MeshDump& expected,
                                            const Correspondence& match, Ref edge,
                                            Ref split_vertex,
                                            const std::vector<WrongCell>& wrong);

/// The same where the student's code has left the mesh as it was.
NeighbourhoodFigure figure_of_nothing_done(const MeshDump& before, const MeshDump& expected,
                                           Ref edge, Ref split_vertex);

}  // namespace meshgrade
