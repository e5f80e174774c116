#pragma once

// An operation on an element of a mesh, or on two, as data: what it is called, what is picked,
// and the right answer, as lists of faces. Cases and judges of such exercises are made from it.

#include <string>
#include <vector>

#include "grader/operations/face_lists.h"

namespace meshgrade {

/// The element that an operation is about, by its corners.
struct Picked {
  Corners corners;  ///< of a vertex itself, of an edge its ends, of a face all, in its order
  Corners partner = {};  ///< of the second element, where two are picked
};

enum class Demand {
  kMust,    ///< there is one right answer
  kRefuse,  ///< there is none: the mesh stays as it is
  kEither,  ///< the answer is degenerate, or sources disagree: done rightly or refused
  kOpen,    ///< no course says what is right: any mesh that keeps the rules, or refused
};

/// The right answer to an operation on one element.
struct Answer {
  Demand demand = Demand::kMust;
  /// Why it is refused, or why it may be: "both ends lie on a boundary, and the edge does not".
  std::string reason = {};
  FaceLists after = {};  ///< of a refused one: as before
  /// Corners from here on are new or may be: any vertex that the operation need not keep can
  /// stand there. All others are old vertices, which stay what they are.
  Label first_free = 0;
  /// The elements that may be returned, each by its corners, of the kind that the operation
  /// says; a boundary loop by those that it passes, in its order.
  std::vector<Corners> returned = {};
  /// Of a vertex that is returned: where its half-edge may lead; empty if anywhere.
  Corners anchored_to = {};
};

/// The two kinds of answers that need no more than a word.
Answer refuse(const FaceLists& before, std::string reason);
Answer allow(Answer answer, std::string reason);

/// A face goes, and the outside takes its place: each boundary loop that passes one of its old
/// sides may be returned. A vertex that had no other face goes, too.
Answer without_face(const FaceLists& before, std::size_t face);

struct LocalOperation {
  std::string exercise;  ///< "edge_collapse"
  std::string function;  ///< "PolyMesh::collapseEdge"
  std::string verb;      ///< "collapse"
  ElementKind picks = ElementKind::kEdge;
  ElementKind returns = ElementKind::kVertex;
  Answer (*answer)(const FaceLists& before, const Picked& picked) = nullptr;
  /// What a mesh of the wrong numbers of elements most likely lacks: what to look at.
  std::string advice;
  bool picks_two = false;  ///< two elements, one after the other, that may be the same
};

/// The same answer, but kEither if what would be left is degenerate, or no surface as far as
/// lists of faces tell.
Answer settle(Answer answer);

/// The middle of two corners, and of some.
Point3 middle(const FaceLists& lists, const Corners& corners);

}  // namespace meshgrade
