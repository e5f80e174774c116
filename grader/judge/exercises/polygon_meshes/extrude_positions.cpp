#include "grader/judge/options.h"
#include "grader/judge/placement_judge.h"

namespace meshgrade {
namespace {

/// start + shrink (centre - start) + move. The corners begin at the places of the outer ones.
Point3 extruded(const PlacedCorner& corner, const Point3& centre, double shrink,
                const Point3& move) {
  Point3 place;
  for (std::size_t i = 0; i < 3; ++i)
    place[i] = corner.start[i] + shrink * (centre[i] - corner.start[i]) + move[i];
  return place;
}

Point3 extruded_place(const PlacedCorner& corner, const Placement& asked) {
  return extruded(corner, corner.mean, asked.amount, asked.vector);
}

Point3 towards_the_origin(const PlacedCorner& corner, const Placement& asked) {
  return extruded(corner, {0.0, 0.0, 0.0}, asked.amount, asked.vector);
}

Point3 as_a_factor(const PlacedCorner& corner, const Placement& asked) {
  return extruded(corner, corner.mean, 1.0 - asked.amount, asked.vector);
}

Point3 extruded_turned_round(const PlacedCorner& corner, const Placement& asked) {
  return extruded(corner, corner.mean, -asked.amount, asked.vector);
}

Point3 without_move(const PlacedCorner& corner, const Placement& asked) {
  return extruded(corner, corner.mean, asked.amount, {0.0, 0.0, 0.0});
}

Point3 with_smaller_move(const PlacedCorner& corner, const Placement& asked) {
  Point3 move = asked.vector;
  for (double& x : move)
    x *= 1.0 - asked.amount;
  return extruded(corner, corner.mean, asked.amount, move);
}

const PlacementRules& extruded_rules() {
  static const PlacementRules rules{
      "PolyMesh::placeExtruded",
      extruded_place,
      {{towards_the_origin,
        {"towards-origin",
         "the corners shrink towards the origin, and not towards the mean of the outer "
         "corners"}},
       {with_smaller_move,
        {"move-shrinks", "the move is made smaller by shrink: it is added last, as a whole"}},
       {as_a_factor,
        {"shrink-as-factor",
         "shrink is taken for what is left of the size: 0 is full size, 1 a point"}},
       {extruded_turned_round,
        {"sign-turned", "a positive shrink makes the face larger: the sign is turned round"}},
       {without_move, {"move-left-out", "the move is left out"}}}};
  return rules;
}

}  // namespace

ExerciseJudge extrude_positions_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  ExerciseJudge judge;
  judge.functions = {extruded_rules().function};
  judge.misconceptions = placement_misconceptions(extruded_rules());
  judge.judge_steps = [](const JudgeTask& task, Conventions& /*conventions*/,
                         CaseJudgement& judgement) {
    judge_placements(task, extruded_rules(), judgement);
  };
  return judge;
}

}  // namespace meshgrade
