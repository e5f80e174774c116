#pragma once

#include "grader/assignment/assignment.h"
#include "grader/cases/view_input.h"
#include "grader/judge/finding.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// The exercise whose function an operation calls.
const char* exercise_of(ViewKind kind);

/// "flip e5", "subdivide"
std::string operation_text(const ViewOperation& operation);

/// What the judge says of one step of the viewer. From a mesh that breaks rules already,
/// nothing is expected of the step: the judgement is kNotJudged.
CaseJudgement judge_view_step(const Assignment& assignment, const MeshDump& before,
                              const ViewOperation& operation, const ViewStep& step);

/// What the judge says of an operation that did not come to its end.
CaseJudgement judge_stop(const Assignment& assignment, const PolygonMesh& start,
                         const ViewOperation& operation, const Outcome& outcome);

/// The faces of a mesh that keeps all rules, vertex i for vertex i. Empty if a vertex was
/// deleted.
PolygonMesh to_polygons(const MeshDump& mesh);

}  // namespace meshgrade
