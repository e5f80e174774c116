#pragma once

#include <set>
#include <string>

#include "grader/mutants/mutant.h"

namespace meshgrade {

/// A pointer named by what its element is after the operation: "half-edge bm.next",
/// "edge bm.halfedge" (the same as of mb), "face abm.halfedge" (the same as bma).
using PointerName = std::string;

/// The pointers that a mutant of the textbook's flip or split gets wrong: those that the
/// changed line sets differently. Empty if the mistake is not in a line that only sets
/// pointers, or the names of the solution tell nothing.
std::set<PointerName> wrong_pointers(const Mutant& mutant);

/// The pointer that Finding::element names: "h12.next, of bm" is "half-edge bm.next". Empty if
/// it names none.
PointerName named_pointer(const std::string& element);

}  // namespace meshgrade
