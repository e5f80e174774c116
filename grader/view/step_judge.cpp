#include "grader/view/step_judge.h"

#include "grader/cases/mesh_input.h"
#include "grader/judge/operation_judge.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {
namespace {

/// The exercise as a case asks for it, whatever the assignment gives points for.
ExerciseRubric rubric_of(const Assignment& assignment, ViewKind kind) {
  const ExerciseRubric* known = assignment.find(exercise_of(kind));
  if (known != nullptr) return *known;
  ExerciseRubric rubric;
  rubric.name = exercise_of(kind);
  return rubric;
}

Case case_of(ViewKind kind, const PolygonMesh& mesh) {
  Case asked;
  asked.exercise = exercise_of(kind);
  asked.group = kViewTask;
  asked.number = 1;
  if (kind == ViewKind::kSubdivide) {
    asked.input = to_wire(SubdivisionInput{"", mesh, 1});
  } else {
    OperationsInput input;
    input.mesh = mesh;
    input.operations.resize(1);
    asked.input = to_wire(input);
  }
  return asked;
}

CaseJudgement judge_by_exercise(const Assignment& assignment, ViewKind kind,
                                const PolygonMesh& mesh, const Outcome& outcome) {
  const ExerciseRubric rubric = rubric_of(assignment, kind);
  const ExerciseJudge judge = find_exercise_judge(rubric);
  const Case asked = case_of(kind, mesh);
  Conventions conventions = judge.conventions;
  return judge_case(judge, {asked, outcome, rubric, assignment.tolerance, true, true},
                    conventions);
}

CaseJudgement not_judged(const std::string& note) {
  CaseJudgement judgement;
  judgement.verdict = Verdict::kNotJudged;
  judgement.note = note;
  return judgement;
}

CaseJudgement judge_subdivision(const Assignment& assignment, const MeshDump& before,
                                const ViewStep& step) {
  const PolygonMesh mesh = to_polygons(before);
  if (mesh.polygons.empty()) return not_judged("a vertex was deleted before: not compared");
  Outcome outcome;
  outcome.steps.push_back(to_wire(step.after));
  return judge_by_exercise(assignment, ViewKind::kSubdivide, mesh, outcome);
}

}  // namespace

const char* exercise_of(ViewKind kind) {
  switch (kind) {
    case ViewKind::kFlip:
      return "edge_flip";
    case ViewKind::kSplit:
      return "edge_split";
    case ViewKind::kSubdivide:
      break;
  }
  return "loop_subdivision";
}

std::string operation_text(const ViewOperation& operation) {
  if (operation.kind == ViewKind::kSubdivide) return "subdivide";
  const char* verb = operation.kind == ViewKind::kFlip ? "flip " : "split ";
  return verb + edge_name(operation.edge);
}

PolygonMesh to_polygons(const MeshDump& mesh) {
  PolygonMesh polygons;
  for (const VertexRecord& v : mesh.vertices) {
    if (v.live == 0) return {};
    polygons.positions.push_back(v.position);
  }
  for (const FaceRecord& f : mesh.faces) {
    if (f.live == 0) continue;
    polygons.polygons.emplace_back();
    Ref h = f.halfedge;
    do {
      polygons.polygons.back().push_back(mesh.halfedges[h].vertex);
      h = mesh.halfedges[h].next;
    } while (h != f.halfedge);
  }
  return polygons;
}

CaseJudgement judge_view_step(const Assignment& assignment, const MeshDump& before,
                              const ViewOperation& operation, const ViewStep& step) {
  if (!find_broken_rules(before).empty()) {
    return not_judged("the mesh was broken before this step: undo to the step that broke it");
  }
  if (operation.kind == ViewKind::kSubdivide) {
    return judge_subdivision(assignment, before, step);
  }
  const ExerciseRubric rubric = rubric_of(assignment, operation.kind);
  const Case asked = case_of(operation.kind, {});
  const bool flip = operation.kind == ViewKind::kFlip;
  CaseJudgement judgement;
  judge_operation({asked, {}, rubric, assignment.tolerance}, before,
                  flip ? OperationKind::kFlip : OperationKind::kSplit,
                  {operation.edge, step.returned, step.after}, judgement);
  return judgement;
}

CaseJudgement judge_stop(const Assignment& assignment, const PolygonMesh& start,
                         const ViewOperation& operation, const Outcome& outcome) {
  Outcome ending = outcome;
  ending.steps.clear();
  return judge_by_exercise(assignment, operation.kind, start, ending);
}

}  // namespace meshgrade
