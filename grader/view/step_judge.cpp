#include "grader/view/step_judge.h"

#include "grader/cases/local_operation_input.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/judge/local_operation_judge.h"
#include "grader/judge/operation_judge.h"
#include "grader/mesh/mesh_rules.h"
#include "grader/mesh/polygons_of.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "grader/view/view_verbs.h"

namespace meshgrade {
namespace {

/// The exercise as a case asks for it, whatever the assignment gives points for.
ExerciseRubric rubric_of(const Assignment& assignment, const std::string& exercise) {
  const ExerciseRubric* known = assignment.find(exercise);
  if (known != nullptr) return *known;
  ExerciseRubric rubric;
  rubric.name = exercise;
  return rubric;
}

std::string input_of(const ViewOperation& operation, const PolygonMesh& mesh) {
  if (operation.exercise == "loop_subdivision") return to_wire(SubdivisionInput{"", mesh, 1});
  if (operation.picked.empty()) return to_wire(WholeMeshInput{"", mesh, 0, 1});
  if (!is_for_triangles(operation)) {
    const std::vector<std::uint32_t> places(operation.picked.size(), 0);
    return to_wire(LocalOperationInput{"", mesh, 0, places});
  }
  OperationsInput input;
  input.mesh = mesh;
  input.operations.resize(1);
  return to_wire(input);
}

Case case_of(const ViewOperation& operation, const PolygonMesh& mesh) {
  Case asked;
  asked.exercise = operation.exercise;
  asked.group = kViewTask;
  asked.number = 1;
  asked.input = input_of(operation, mesh);
  return asked;
}

CaseJudgement judge_by_exercise(const Assignment& assignment, const ViewOperation& operation,
                                const PolygonMesh& mesh, const Outcome& outcome) {
  const ExerciseRubric rubric = rubric_of(assignment, operation.exercise);
  const ExerciseJudge judge = find_exercise_judge(rubric);
  const Case asked = case_of(operation, mesh);
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

constexpr const char* kBrokenBefore =
    "the mesh was broken before this step: undo to the step that broke it";

CaseJudgement judge_subdivision(const Assignment& assignment, const ViewOperation& operation,
                                const MeshDump& before, const ViewStep& step) {
  const PolygonMesh mesh = to_polygons(before);
  if (mesh.polygons.empty()) return not_judged("a vertex was deleted before: not compared");
  Outcome outcome;
  outcome.steps.push_back(to_wire(step.after));
  return judge_by_exercise(assignment, operation, mesh, outcome);
}

/// Why a mesh of polygons says nothing of the next step; empty if it does.
std::string trouble_of_mesh(const MeshDump& mesh) {
  if (!find_broken_rules(mesh, FaceShape::kDegeneratePolygons).empty()) return kBrokenBefore;
  const std::string trouble = trouble_of(face_lists_of(mesh));
  return trouble.empty() ? "" : "the mesh is degenerate before this step: " + trouble;
}

/// What is said of a refusal that is right.
std::string refusal_note(const LocalOperation& operation, const MeshDump& before,
                         const ViewOperation& asked) {
  Picked picked = corners_of(before, asked.picks, asked.picked[0]);
  if (asked.picked.size() == 2)
    picked.partner = corners_of(before, asked.picks, asked.picked[1]).corners;
  const Answer answer = operation.answer(face_lists_of(before), picked);
  const char* how = answer.demand == Demand::kRefuse ? "as it must be" : "as it may be";
  return std::string("refused, ") + how + ": " + answer.reason;
}

CaseJudgement judge_local(const Assignment& assignment, const LocalOperation& operation,
                          const MeshDump& before, const ViewOperation& asked,
                          const PolygonViewStep& told) {
  auto step = from_wire<LocalStep>(told.step);
  step.picked = asked.picked[0];
  step.partner = asked.picked.size() == 2 ? asked.picked[1] : kUnsetRef;
  const ExerciseRubric rubric = rubric_of(assignment, asked.exercise);
  const Case as_case = case_of(asked, {});
  CaseJudgement judgement;
  judge_local_step({as_case, {}, rubric, assignment.tolerance}, operation, before, step, "",
                   judgement);
  if (judgement.findings.empty() && step.refused != 0)
    judgement.note = refusal_note(operation, before, asked);
  return judgement;
}

/// The polygons that a function of the whole mesh has begun with.
PolygonMesh polygons_begun_with(const MeshDump& before, const ViewOperation& operation) {
  if (!is_built_anew(operation, before)) return to_polygons(before);
  return polygons_of(before).value_or(PolygonMesh());
}

}  // namespace

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
  if (!find_broken_rules(before).empty()) return not_judged(kBrokenBefore);
  if (operation.picked.empty()) return judge_subdivision(assignment, operation, before, step);
  const ExerciseRubric rubric = rubric_of(assignment, operation.exercise);
  const Case asked = case_of(operation, {});
  const bool flip = operation.exercise == "edge_flip";
  CaseJudgement judgement;
  judge_operation({asked, {}, rubric, assignment.tolerance}, before,
                  flip ? OperationKind::kFlip : OperationKind::kSplit,
                  {operation.picked[0], step.returned, step.after}, judgement);
  return judgement;
}

CaseJudgement judge_polygon_step(const Assignment& assignment, const MeshDump& before,
                                 const ViewOperation& operation, const PolygonViewStep& step) {
  const std::string trouble = trouble_of_mesh(before);
  if (!trouble.empty()) return not_judged(trouble);
  if (const LocalOperation* local = find_local_operation(operation.exercise))
    return judge_local(assignment, *local, before, operation, step);
  Outcome outcome;
  outcome.steps.push_back(step.step);
  CaseJudgement judgement =
      judge_by_exercise(assignment, operation, polygons_begun_with(before, operation), outcome);
  const bool is_same = to_wire(mesh_begun_with(before, operation)) == to_wire(step.after);
  if (judgement.verdict == Verdict::kPassed && is_same)
    judgement.note = "the mesh is as it was, as it must be";
  return judgement;
}

MeshDump mesh_begun_with(const MeshDump& before, const ViewOperation& operation) {
  if (!is_built_anew(operation, before)) return before;
  return built_mesh(polygons_begun_with(before, operation));
}

std::string trouble_before(const MeshDump& before, const ViewOperation& operation) {
  return operation.picked.empty() ? trouble_of_mesh(before) : "";
}

CaseJudgement judge_stop(const Assignment& assignment, const PolygonMesh& start,
                         const ViewOperation& operation, const Outcome& outcome) {
  Outcome ending = outcome;
  ending.steps.clear();
  return judge_by_exercise(assignment, operation, start, ending);
}

}  // namespace meshgrade
