#pragma once

// What a student can do about a flip or a split that went wrong.

#include <string>
#include <vector>

#include "grader/judge/misconception.h"
#include "grader/judge/operation_model.h"
#include "grader/judge/pointer_diff.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// What to look at if a mesh has too many or too few elements: which calls, and what to do with
/// what is left over.
std::string count_advice(const Counts& expected, const Counts& actual);

/// Whether a wrong pointer, such as "h12.next" or "v3.halfedge", can break a rule.
bool is_about(const std::string& rule, const std::string& pointer);

/// What to say if the wrong pointers are just next and twin of one half-edge, each with what
/// the other must be; empty if they are not.
std::string exchange_advice(const std::vector<WrongPointer>& wrong);

/// The misconceptions about the new vertex of a split.
const Misconceptions& split_misconceptions();

/// Those that explain where the new vertex was put. `before` is the mesh before the split,
/// `allowed` a length.
Misconceptions recognize_midpoint(const MeshDump& before, const Diamond& diamond,
                                  const Point3& actual, double allowed);

}  // namespace meshgrade
