#pragma once

#include <string>

#include "grader/base/random.h"

namespace meshgrade {

/// Another right solution, drawn from all that differ in: which new element is created first
/// and which plays which part; which part the old face, edge and half-edges play; the order of
/// pointer assignments; setNeighbors or single assignments; which half-edge a vertex, an edge
/// and a face anchor; the order of sums; float or double; all names.
///
/// Right by construction: each change is one that the contract leaves open. It relies on how
/// the textbook solutions are laid out: lines that follow each other without a blank line may
/// change places if all of them only set pointers to variables, and declarations of handles
/// that follow each other may exchange what they are given.
std::string make_variant(const std::string& solution, Random& random);

}  // namespace meshgrade
