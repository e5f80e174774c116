#include "grader/judge/placement_judge.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/placement_cases.h"
#include "grader/judge/findings.h"
#include "grader/judge/point_compare.h"
#include "grader/judge/unchanged_mesh.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {
namespace {

constexpr UnchangedWords kPlaces{
    "only the corners of the face move, and nothing else changes",
    "calls of new... and delete...: all elements are there already",
    "assignments to .position: the corners of the face move, and no other vertex"};

const Misconception& drifting() {
  static const Misconception drifting{
      "begins-where-it-is",
      "the corners are moved on from where the last call left them, and not placed from where "
      "they began: with the mouse held still they would drift away"};
  return drifting;
}

class PlacementJudge {
 public:
  PlacementJudge(const JudgeTask& task, const PlacementRules& rules,
                 const PlacementInput& input, CaseJudgement& judgement)
      : rules_(rules),
        input_(input),
        start_(built_mesh(input.mesh, input.anchor_turns)),
        ring_(ring_of(input.mesh, input.face)),
        judgement_(judgement) {
    double size = 0.0;
    for (const RingCorner& corner : ring_)
      size = std::max(size, distance(start_.vertices[corner.outer].position,
                                     start_.vertices[ring_[0].outer].position));
    allowed_ = task.tolerance * size;
  }

  /// @return whether the step is right
  bool judge(std::size_t step, const MeshDump& before, const MeshDump& after) {
    where_ = input_.calls.size() == 1 ? ""
                                      : "after call " + std::to_string(step + 1) + " of " +
                                            std::to_string(input_.calls.size());
    if (const auto change = find_change(start_, with_old_corners(after), where_, kPlaces)) {
      judgement_.findings.push_back(*change);
    } else {
      judge_places(step, before, after);
    }
    return judgement_.findings.empty();
  }

 private:
  /// The mesh as if no corner of the face had moved.
  MeshDump with_old_corners(MeshDump mesh) const {
    for (const RingCorner& corner : ring_) {
      const Ref v = corner.corner;
      if (v < mesh.vertices.size()) mesh.vertices[v].position = start_.vertices[v].position;
    }
    return mesh;
  }

  /// @param begin  where the corners begin
  /// @param around where the mean is taken of all of them
  PlacedCorner corner(std::size_t i, const MeshDump& begin, const MeshDump& around) const {
    Point3 mean{};
    for (const RingCorner& corner : ring_) {
      const Point3& at = around.vertices[corner.corner].position;
      for (std::size_t k = 0; k < 3; ++k)
        mean[k] += at[k] / static_cast<double>(ring_.size());
    }
    return {begin.vertices[ring_[i].corner].position, mean,
            start_.vertices[ring_[i].outer].position};
  }

  bool fits(PlacementFormula place, std::size_t step, const MeshDump& begin,
            const MeshDump& around, const MeshDump& after) const {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Point3 expected = place(corner(i, begin, around), input_.calls[step]);
      if (distance(expected, after.vertices[ring_[i].corner].position) > allowed_) return false;
    }
    return true;
  }

  void judge_places(std::size_t step, const MeshDump& before, const MeshDump& after) {
    if (fits(rules_.right, step, start_, start_, after)) return;
    std::size_t i = 0;
    Point3 expected{};
    Point3 actual{};
    for (; i < ring_.size(); ++i) {
      expected = rules_.right(corner(i, start_, start_), input_.calls[step]);
      actual = after.vertices[ring_[i].corner].position;
      if (distance(expected, actual) > allowed_) break;
    }
    const std::string name = vertex_name(ring_[i].corner);
    Finding finding = make_finding(
        "new-position", "each corner lies where the call says, whatever was called before",
        where_, name, point_text(expected),
        point_text(actual) + ", off by " + number_text(distance(expected, actual)),
        name + ".position, as " + rules_.function + " sets it");
    finding.likely = likely(step, before, after);
    judgement_.findings.push_back(std::move(finding));
  }

  /// What was done in place of the right thing; none if that cannot be told.
  Misconceptions likely(std::size_t step, const MeshDump& before, const MeshDump& after) const {
    const bool drifts = fits(rules_.right, step, before, before, after) ||
                        fits(rules_.right, step, before, start_, after);
    if (step > 0 && drifts) return {drifting()};
    Misconceptions likely;
    for (const PlacementMistake& mistake : rules_.mistakes) {
      if (fits(mistake.place, step, start_, start_, after))
        likely.push_back(mistake.misconception);
    }
    return likely;
  }

  const PlacementRules& rules_;
  const PlacementInput& input_;
  MeshDump start_;
  std::vector<RingCorner> ring_;
  double allowed_;  ///< how far a corner may be off
  std::string where_;
  CaseJudgement& judgement_;
};

}  // namespace

Misconceptions placement_misconceptions(const PlacementRules& rules) {
  Misconceptions all{drifting()};
  for (const PlacementMistake& mistake : rules.mistakes)
    all.push_back(mistake.misconception);
  return all;
}

void judge_placements(const JudgeTask& task, const PlacementRules& rules,
                      CaseJudgement& judgement) {
  const auto input = from_wire<PlacementInput>(task.asked.input);
  if (task.outcome.steps.size() > input.calls.size()) throw WireError("too many steps");
  PlacementJudge judge(task, rules, input, judgement);
  MeshDump before = built_mesh(input.mesh, input.anchor_turns);
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    auto after = from_wire<MeshDump>(task.outcome.steps[i]);
    if (!judge.judge(i, before, after)) {
      judgement.verdict = Verdict::kFailed;
      mention_turned_anchors(input.anchor_turns, judgement);
      return;
    }
    before = std::move(after);
  }
  require_all_steps(task.outcome, input.calls.size());
}

}  // namespace meshgrade
