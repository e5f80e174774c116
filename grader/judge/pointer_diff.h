#pragma once

// What exactly is wrong after a flip or a split: every pointer of the neighbourhood, before, as
// the student left it, and as it must be.
//
// A right answer is free in many ways: which new half-edge goes where, which half of a split
// edge keeps the old Edge, which face is reused, which half-edge a vertex anchors. So the
// student's free elements are first matched to those of a right answer such that the number of
// wrong pointers is the smallest possible.

#include <string>
#include <vector>

#include "grader/judge/neighbourhood_figure.h"
#include "grader/judge/operation_model.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

struct PointerCell {
  std::string before;
  std::string yours;
  std::string expected;
  bool wrong = false;
};

/// One element: a name for each of its pointers, in the order of the table's columns.
struct PointerRow {
  std::string element;  ///< "h12"; empty if the student has not created it
  std::string role;     ///< "mc", "face a b m"
  std::vector<PointerCell> cells;
};

/// All elements of one kind around the edge.
struct PointerTable {
  std::string kind;                  ///< "half-edges"
  std::vector<std::string> columns;  ///< "next", "twin", ...
  std::vector<PointerRow> rows;
};

/// One pointer that is wrong.
struct WrongPointer {
  std::string name;      ///< "h12.next"
  std::string role;      ///< of its element
  std::string expected;  ///< "h5 (ca)"
  std::string actual;
  bool was_set = false;  ///< it is not what it was before, but not what it must be either
  bool is_new = false;   ///< its element did not exist before
};

/// "h12.next was set to h5", "h12.next is still h5, as before", "h12.next is still unset"
std::string as_left(const WrongPointer& pointer);

struct PointerDiff {
  std::string corners;  ///< which vertex is a, b, c, d, m
  std::vector<PointerTable> tables;
  std::vector<WrongPointer> wrong;
  std::size_t to_change = 0;  ///< pointers that a right answer sets, with those of new elements
  Ref new_vertex = kUnsetRef;  ///< the student's, where one is to be made and is there
  std::size_t missing = 0;     ///< elements that must be created and are not
  std::size_t surplus = 0;     ///< elements that are created but not needed
  NeighbourhoodFigure figure;
};

/// "must be h5 (ca), you set h4 (bd)"
std::string must_be_text(const WrongPointer& pointer);

/// Compares the neighbourhood of `edge`. `before` and `expected` keep all mesh rules; `after`
/// may be broken in any way. Old elements keep their numbers in all three. `split_vertex` is
/// the new vertex of `expected`, unset after a flip.
PointerDiff diff_pointers(const MeshDump& before, const MeshDump& after,
                          const MeshDump& expected, Ref edge, Ref split_vertex);

}  // namespace meshgrade
