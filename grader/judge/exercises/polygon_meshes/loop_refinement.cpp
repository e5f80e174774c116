#include <algorithm>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/mesh_input.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/unchanged_mesh.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {

// The exercise of the first assignment with the same rules: it judges what is not refused.
ExerciseJudge loop_subdivision_judge(const ExerciseRubric& rubric);

namespace {

/// The first face that is no triangle; its number of corners is 3 if there is none.
struct OddFace {
  std::size_t face = 0;
  std::size_t corners = 3;
};

OddFace find_odd_face(const PolygonMesh& mesh) {
  const auto odd = std::find_if(mesh.polygons.begin(), mesh.polygons.end(),
                                [](const auto& corners) { return corners.size() != 3; });
  if (odd == mesh.polygons.end()) return {};
  return {static_cast<std::size_t>(odd - mesh.polygons.begin()), odd->size()};
}

/// Judges a call on a mesh that must be refused.
void judge_refusal(const WholeMeshInput& input, const OddFace& odd, const RefusableStep& step,
                   CaseJudgement& judgement) {
  const MeshDump before = built_mesh(input.mesh, input.anchor_turns);
  const auto change = find_change(before, step.after, "");
  const std::string face = face_name(static_cast<Ref>(odd.face));
  const std::string reason = face + " has " + plural(odd.corners, "corner");
  if (step.done != 0) {
    judgement.findings.push_back(make_finding(
        "not-refused", "a mesh is refused, and stays as it was, unless all faces are triangles",
        "", face, "false is returned: " + reason,
        change ? "true was returned, and the mesh was changed"
               : "true was returned, and the mesh is as it was",
        "a loop over all faces at the start, that asks degree()"));
  } else if (change) {
    judgement.findings.push_back(
        make_finding("refused-unchanged", "a function that refuses leaves the mesh as it was",
                     "", change->element, change->expected, change->actual,
                     "what is changed before the last face was asked for its degree()"));
  }
}

void judge_loop_refinements(const JudgeTask& task, Conventions& conventions,
                            CaseJudgement& judgement) {
  const auto input = from_wire<WholeMeshInput>(task.asked.input);
  if (task.outcome.steps.size() > input.times) throw WireError("too many steps");
  const OddFace odd = find_odd_face(input.mesh);
  Outcome outcome = task.outcome;
  for (std::string& bytes : outcome.steps) {
    const auto step = from_wire<RefusableStep>(bytes);
    if (odd.corners != 3) {
      judge_refusal(input, odd, step, judgement);
    } else if (step.done == 0) {
      judgement.findings.push_back(make_finding(
          "refused", "only a mesh with a face that is no triangle is refused", "", "the mesh",
          "all faces are triangles: subdivide it, and return true", "false was returned",
          "the test at the start. Boundary loops are no faces, and may have any number of "
          "corners"));
    }
    if (!judgement.findings.empty()) break;
    bytes = to_wire(step.after);
  }
  if (!judgement.findings.empty()) {
    judgement.verdict = Verdict::kFailed;
  } else if (odd.corners != 3) {
    require_all_steps(task.outcome, input.times);
  } else {
    const Anchoring anchoring =
        input.anchor_turns == 0 ? Anchoring::kAsBuilt : Anchoring::kElsewhere;
    Case asked = task.asked;
    asked.input =
        to_wire(SubdivisionInput{input.mesh_name, input.mesh, input.times, anchoring});
    const JudgeTask levels{asked,          outcome,      task.rubric,
                           task.tolerance, task.explain, task.measure};
    loop_subdivision_judge(task.rubric).judge_steps(levels, conventions, judgement);
  }
}

}  // namespace

ExerciseJudge loop_refinement_judge(const ExerciseRubric& rubric) {
  ExerciseJudge judge = loop_subdivision_judge(rubric);
  judge.functions = {"PolyMesh::loopSubdivide"};
  judge.judge_steps = judge_loop_refinements;
  return judge;
}

}  // namespace meshgrade
