#include "grader/mutants/single_pointers.h"

#include <algorithm>
#include <chrono>

#include "grader/base/random.h"
#include "grader/base/wire.h"
#include "grader/cases/mesh_input.h"
#include "grader/judge/judge.h"
#include "grader/judge/operations_judge.h"
#include "grader/mesh/mesh_dump.h"

namespace meshgrade {
namespace {

constexpr int kChangesOfACase = 8;

/// A pointer, and how a finding calls it.
struct Pointer {
  Ref* target;
  std::size_t choices;  ///< how many elements there are of the kind that it leads to
  std::string name;
};

bool is_same(const HalfedgeRecord& a, const HalfedgeRecord& b) {
  return a.next == b.next && a.twin == b.twin && a.vertex == b.vertex && a.edge == b.edge &&
         a.face == b.face;
}

/// The pointers of elements that are new, or not as they were.
std::vector<Pointer> changed_pointers(const MeshDump& before, MeshDump& after) {
  std::vector<Pointer> pointers;
  const std::size_t halfedges = after.halfedges.size();
  for (Ref h = 0; h < halfedges; ++h) {
    HalfedgeRecord& record = after.halfedges[h];
    if (h < before.halfedges.size() && is_same(before.halfedges[h], record)) continue;
    const std::string name = halfedge_name(h);
    pointers.push_back({&record.next, halfedges, name + ".next"});
    pointers.push_back({&record.twin, halfedges, name + ".twin"});
    pointers.push_back({&record.vertex, after.vertices.size(), name + ".vertex"});
    pointers.push_back({&record.edge, after.edges.size(), name + ".edge"});
    if ((record.face & kBoundaryBit) == 0)
      pointers.push_back({&record.face, after.faces.size(), name + ".face"});
  }
  const auto add_anchors = [&](const auto& old, auto& now, const auto& name_of) {
    for (Ref i = 0; i < now.size(); ++i) {
      if (i >= old.size() || old[i].halfedge != now[i].halfedge)
        pointers.push_back({&now[i].halfedge, halfedges, name_of(i) + ".halfedge"});
    }
  };
  add_anchors(before.vertices, after.vertices, vertex_name);
  add_anchors(before.edges, after.edges, edge_name);
  add_anchors(before.faces, after.faces, [](Ref f) { return face_name(f); });
  return pointers;
}

class Trial {
 public:
  Trial(const ExerciseRubric& rubric, double tolerance, std::uint64_t seed)
      : rubric_(rubric),
        judge_(find_exercise_judge(rubric)),
        tolerance_(tolerance),
        random_(seed, "single pointers") {
    sums_.exercise = rubric.name;
  }

  void spoil(const Case& asked, const Outcome& right) {
    const auto input = from_wire<OperationsInput>(asked.input);
    if (input.operations.size() != 1 || right.steps.size() != 1) return;
    const MeshDump before = first_mesh(input);
    for (int i = 0; i < kChangesOfACase; ++i) {
      auto step = from_wire<OperationStep>(right.steps[0]);
      const std::vector<Pointer> pointers = changed_pointers(before, step.after);
      if (pointers.empty()) return;
      const Pointer& pointer =
          pointers[random_.below(static_cast<std::uint32_t>(pointers.size()))];
      const Ref was = *pointer.target;
      *pointer.target = random_.below(4) == 0
                            ? kUnsetRef
                            : random_.below(static_cast<std::uint32_t>(pointer.choices));
      if (*pointer.target != was) judge(asked, right, step, pointer.name);
    }
  }

  SinglePointers sums(const std::string& solution) {
    sums_.solution = solution;
    std::sort(times_.begin(), times_.end());
    if (!times_.empty()) sums_.milliseconds = times_[(times_.size() - 1) * 99 / 100];
    return sums_;
  }

 private:
  void judge(const Case& asked, Outcome outcome, const OperationStep& step,
             const std::string& name) {
    outcome.steps = {to_wire(step)};
    Conventions conventions = judge_.conventions;
    const auto began = std::chrono::steady_clock::now();
    const CaseJudgement judgement =
        judge_case(judge_, {asked, outcome, rubric_, tolerance_}, conventions);
    const std::chrono::duration<double, std::milli> took =
        std::chrono::steady_clock::now() - began;
    if (judgement.verdict == Verdict::kPassed || judgement.findings.empty()) return;
    times_.push_back(took.count());
    const PointerDiff& diff = judgement.findings[0].pointers;
    ++sums_.tried;
    if (diff.wrong.size() == 1) ++sums_.alone;
    if (!diff.wrong.empty() && diff.wrong[0].name == name) ++sums_.first;
  }

  const ExerciseRubric& rubric_;
  ExerciseJudge judge_;
  double tolerance_;
  Random random_;
  SinglePointers sums_;
  std::vector<double> times_;
};

}  // namespace

SinglePointers judge_single_pointers(const ExerciseRubric& rubric, const RightRun& run,
                                     double tolerance, std::uint64_t seed) {
  Trial trial(rubric, tolerance, seed);
  for (std::size_t i = 0; i < run.cases.size(); ++i)
    trial.spoil(run.cases[i], run.outcomes[i]);
  return trial.sums(run.solution);
}

}  // namespace meshgrade
