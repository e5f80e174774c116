#pragma once

#include "grader/assignment/assignment.h"
#include "grader/cases/view_input.h"
#include "grader/judge/finding.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// What the judge says of one step of the viewer. From a mesh that breaks rules already,
/// nothing is expected of the step: the judgement is kNotJudged.
CaseJudgement judge_view_step(const Assignment& assignment, const MeshDump& before,
                              const ViewOperation& operation, const ViewStep& step);

/// The same for a mesh of polygons. Nothing is expected from a degenerate mesh either.
/// @throws WireError if what the exercise has written down is malformed
CaseJudgement judge_polygon_step(const Assignment& assignment, const MeshDump& before,
                                 const ViewOperation& operation, const PolygonViewStep& step);

/// The mesh that an operation of a mesh of polygons began with: the one before, or the same
/// built anew.
MeshDump mesh_begun_with(const MeshDump& before, const ViewOperation& operation);

/// Why a function of the whole mesh has nothing to begin with; empty if it has.
std::string trouble_before(const MeshDump& before, const ViewOperation& operation);

/// What the judge says of an operation that did not come to its end.
CaseJudgement judge_stop(const Assignment& assignment, const PolygonMesh& start,
                         const ViewOperation& operation, const Outcome& outcome);

/// The faces of a mesh that keeps all rules, vertex i for vertex i. Empty if a vertex was
/// deleted.
PolygonMesh to_polygons(const MeshDump& mesh);

}  // namespace meshgrade
