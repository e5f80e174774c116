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

constexpr const char* kTooEarly =
    "what is changed before the last face was asked for its degree()";
constexpr UnchangedWords kRefuses{"a function that refuses leaves the mesh as it was",
                                  kTooEarly, kTooEarly};

/// Judges a call on a mesh that must be refused.
void judge_refusal(const WholeMeshInput& input, const OddFace& odd, const RefusableStep& step,
                   CaseJudgement& judgement) {
  const MeshDump before = built_mesh(input.mesh, input.anchor_turns);
  const auto change = find_change(before, step.after, "", kRefuses);
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
    judgement.findings.push_back(make_finding("refused-unchanged", change->meaning, "",
                                              change->element, change->expected, change->actual,
                                              kTooEarly));
  }
}

/// Judges the levels that were done, as in the first assignment.
void judge_done(const JudgeTask& task, const WholeMeshInput& input, const Outcome& done,
                Conventions& conventions, CaseJudgement& judgement) {
  const Anchoring anchoring =
      input.anchor_turns == 0 ? Anchoring::kAsBuilt : Anchoring::kElsewhere;
  Case asked = task.asked;
  asked.input = to_wire(SubdivisionInput{input.mesh_name, input.mesh, input.times, anchoring});
  const JudgeTask levels{asked, done, task.rubric, task.tolerance, task.explain, task.measure};
  loop_subdivision_judge(task.rubric).judge_steps(levels, conventions, judgement);
}

void judge_levels_of_triangles(const JudgeTask& task, const WholeMeshInput& input,
                               Conventions& conventions, CaseJudgement& judgement) {
  Outcome done = task.outcome;
  done.steps.clear();
  bool refused = false;
  for (const std::string& bytes : task.outcome.steps) {
    const auto step = from_wire<RefusableStep>(bytes);
    refused = step.done == 0;
    if (refused) break;
    done.steps.push_back(to_wire(step.after));
  }
  if (refused) done.ending = Ending::kExit;  // that steps are missing is told below
  judge_done(task, input, done, conventions, judgement);
  // What went wrong before may be why it was refused.
  if (!refused || !judgement.findings.empty()) return;
  judgement.verdict = Verdict::kFailed;
  judgement.findings.push_back(make_finding(
      "refused", "only a mesh with a face that is no triangle is refused",
      input.times == 1 ? "" : "at level " + std::to_string(done.steps.size() + 1), "the mesh",
      "all faces are triangles: subdivide it, and return true", "false was returned",
      "the test at the start. Boundary loops are no faces, and may have any number of "
      "corners"));
}

void judge_loop_refinements(const JudgeTask& task, Conventions& conventions,
                            CaseJudgement& judgement) {
  const auto input = from_wire<WholeMeshInput>(task.asked.input);
  if (task.outcome.steps.size() > input.times) throw WireError("too many steps");
  const OddFace odd = find_odd_face(input.mesh);
  if (odd.corners == 3) return judge_levels_of_triangles(task, input, conventions, judgement);
  require_all_steps(task.outcome, input.times);
  for (const std::string& bytes : task.outcome.steps)
    judge_refusal(input, odd, from_wire<RefusableStep>(bytes), judgement);
  if (!judgement.findings.empty()) judgement.verdict = Verdict::kFailed;
}

}  // namespace

ExerciseJudge loop_refinement_judge(const ExerciseRubric& rubric) {
  ExerciseJudge judge = loop_subdivision_judge(rubric);
  judge.functions = {"PolyMesh::loopSubdivide"};
  judge.judge_steps = judge_loop_refinements;
  return judge;
}

}  // namespace meshgrade
