#include "grader/judge/operations_judge.h"

#include <algorithm>

#include "grader/judge/operation_judge.h"
#include "grader/judge/operation_model.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {
namespace {

Ref live_vertex(const MeshDump& mesh, std::uint32_t place) {
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].live != 0 && place-- == 0) return v;
  }
  return kUnsetRef;
}

const char* verb(const Operation& operation) {
  return operation.kind == OperationKind::kFlip ? "flip" : "split";
}

const char* exercise_of(const Operation& operation) {
  return operation.kind == OperationKind::kFlip ? "edge_flip" : "edge_split";
}

std::string step_text(const OperationsInput& input, std::size_t i, Ref a, Ref b) {
  if (input.operations.size() == 1) return {};
  return "after operation " + std::to_string(i + 1) + " of " +
         std::to_string(input.operations.size()) + ": " + verb(input.operations[i]) + " " +
         vertex_name(a) + "-" + vertex_name(b);
}

/// In a sequence of splits and flips, an operation of the other kind that goes wrong says
/// nothing about this exercise.
void leave_to_other_exercise(const JudgeTask& task, const OperationsInput& input,
                             std::size_t done, CaseJudgement& judgement) {
  if (done == input.operations.size()) return;
  const auto is_other = [&](const Operation& operation) {
    return exercise_of(operation) != task.asked.exercise;
  };
  // Nobody knows which operation spoiled the run: the other exercise's own cases tell.
  const auto& operations = input.operations;
  const auto blamed = task.outcome.lost
                          ? std::find_if(operations.begin(), operations.end(), is_other)
                          : operations.begin() + static_cast<std::ptrdiff_t>(done);
  if (blamed == operations.end()) return;
  const std::string other = exercise_of(*blamed);
  const bool stopped = task.outcome.ending != Ending::kDone || !judgement.findings.empty();
  if (other == task.asked.exercise || !stopped) return;
  judgement.findings.clear();
  judgement.verdict = Verdict::kNotJudged;
  judgement.excused = true;
  judgement.note = "operation " + std::to_string(blamed - operations.begin() + 1) + ", a " +
                   verb(*blamed) + ", goes wrong: see " + other;
}

}  // namespace

MeshDump first_mesh(const OperationsInput& input) {
  meshedit::HalfedgeMesh mesh;
  build_mesh(input.mesh, mesh);
  MeshDump built = dump_mesh(mesh);
  if (input.anchoring == Anchoring::kAsBuilt || input.anchoring == Anchoring::kOnEachEdge) {
    return built;
  }
  if (input.anchoring == Anchoring::kElsewhere) {
    anchor_elsewhere(mesh);
    return dump_mesh(mesh);
  }
  const Operation& first = input.operations.at(0);
  const Ref e = find_edge(built, live_vertex(built, first.a), live_vertex(built, first.b));
  anchor_on(std::next(mesh.edgesBegin(), e));
  return dump_mesh(mesh);
}

void judge_operations(const JudgeTask& task, CaseJudgement& judgement) {
  const auto input = from_wire<OperationsInput>(task.asked.input);
  if (task.outcome.steps.size() > input.operations.size()) throw WireError("too many steps");
  MeshDump before = first_mesh(input);
  std::size_t done = 0;  // operations that were judged to be right
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    const auto step = from_wire<OperationStep>(task.outcome.steps[i]);
    const Ref a = live_vertex(before, input.operations[i].a);
    const Ref b = live_vertex(before, input.operations[i].b);
    const Ref edge = find_edge(before, a, b);
    if (edge == kUnsetRef || step.edge != edge) throw WireError("another edge");
    if (input.anchoring == Anchoring::kOnEachEdge)
      model_anchor_on(before, edge, input.operations[i].anchors);
    judge_step(task, before, input.operations[i], step, step_text(input, i, a, b), judgement);
    if (!judgement.findings.empty() || judgement.verdict != Verdict::kPassed) break;
    before = step.after;
    ++done;
  }
  if (judgement.findings.empty() && judgement.verdict == Verdict::kPassed) {
    require_all_steps(task.outcome, input.operations.size());
  }
  if (!judgement.findings.empty()) {
    judgement.verdict = Verdict::kFailed;
    judgement.note.clear();  // of a step before that is right
    judgement.right_share = (static_cast<double>(done) + judgement.right_share) /
                            static_cast<double>(input.operations.size());
  }
  leave_to_other_exercise(task, input, done, judgement);
}

std::string corner_letters(const OperationsInput& input) {
  const MeshDump mesh = first_mesh(input);
  const Operation& first = input.operations.at(0);
  const Ref edge = find_edge(mesh, live_vertex(mesh, first.a), live_vertex(mesh, first.b));
  if (edge == kUnsetRef) return {};
  const Diamond corners = diamond_of(mesh, edge);
  std::string text;
  const auto add = [&](const char* letter, Ref vertex) {
    if (vertex != kUnsetRef) text += std::string(letter) + "=" + std::to_string(vertex) + " ";
  };
  add("a", corners.a);
  add("b", corners.b);
  add("c", corners.c);
  add("d", corners.d);
  if (first.kind == OperationKind::kSplit) add("m", static_cast<Ref>(mesh.vertices.size()));
  return text;
}

void show_stopped_operation(const JudgeTask& task, Finding& finding) {
  const auto input = from_wire<OperationsInput>(task.asked.input);
  const std::vector<std::string>& steps = task.outcome.steps;
  if (steps.size() >= input.operations.size()) return;
  MeshDump before =
      steps.empty() ? first_mesh(input) : from_wire<OperationStep>(steps.back()).after;
  const Operation& operation = input.operations[steps.size()];
  const auto stopped = from_wire<OperationStep>(task.outcome.interrupted);
  const Ref edge =
      find_edge(before, live_vertex(before, operation.a), live_vertex(before, operation.b));
  if (edge == kUnsetRef || stopped.edge != edge) throw WireError("another edge");
  if (input.anchoring == Anchoring::kOnEachEdge)
    model_anchor_on(before, edge, operation.anchors);
  finding.pointers.figure = figure_of_stop(before, operation.kind, edge, stopped.after);
}

}  // namespace meshgrade
