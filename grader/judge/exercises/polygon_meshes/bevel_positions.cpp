#include <cmath>

#include "grader/judge/options.h"
#include "grader/judge/placement_judge.h"
#include "grader/mesh/point_products.h"

namespace meshgrade {
namespace {

/// From the start to the outer vertex, and how long that is.
struct Way {
  Point3 unit;
  double length;
};

Way way_out(const PlacedCorner& corner) {
  Point3 way;
  for (std::size_t i = 0; i < 3; ++i)
    way[i] = corner.outer[i] - corner.start[i];
  const double length = std::hypot(way[0], way[1], way[2]);
  for (double& x : way)
    x /= length;
  return {way, length};
}

Point3 along(const PlacedCorner& corner, const Point3& direction, double t) {
  Point3 place = corner.start;
  for (std::size_t i = 0; i < 3; ++i)
    place[i] += t * direction[i];
  return place;
}

Point3 bevelled_place(const PlacedCorner& corner, const Placement& asked) {
  const Point3 unit = way_out(corner).unit;
  return along(corner, unit, asked.amount / dot(asked.vector, unit));
}

Point3 by_the_distance(const PlacedCorner& corner, const Placement& asked) {
  return along(corner, way_out(corner).unit, asked.amount);
}

Point3 by_the_projection(const PlacedCorner& corner, const Placement& asked) {
  const Point3 unit = way_out(corner).unit;
  return along(corner, unit, asked.amount * dot(asked.vector, unit));
}

Point3 in_the_direction(const PlacedCorner& corner, const Placement& asked) {
  return along(corner, asked.vector, asked.amount);
}

Point3 by_the_length(const PlacedCorner& corner, const Placement& asked) {
  const Way way = way_out(corner);
  return along(corner, way.unit, way.length * asked.amount / dot(asked.vector, way.unit));
}

Point3 bevelled_turned_round(const PlacedCorner& corner, const Placement& asked) {
  const Point3 unit = way_out(corner).unit;
  return along(corner, unit, -asked.amount / dot(asked.vector, unit));
}

const PlacementRules& bevelled_rules() {
  static const PlacementRules rules{
      "PolyMesh::placeBevelled",
      bevelled_place,
      {{by_the_distance,
        {"distance-along-edge",
         "each corner goes the distance along its edge, and not so far that it has gone the "
         "distance in the direction: divide by the dot product of the two"}},
       {by_the_projection,
        {"times-dot-product",
         "the distance is multiplied by the dot product of edge and direction: divide by it"}},
       {in_the_direction,
        {"off-the-edge", "the corners leave their edges and go in the direction itself"}},
       {by_the_length,
        {"edge-not-unit", "the edge is not brought to length 1 before it is multiplied"}},
       {bevelled_turned_round,
        {"sign-turned", "the corners go the other way: the sign is turned round"}}}};
  return rules;
}

}  // namespace

ExerciseJudge bevel_positions_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  ExerciseJudge judge;
  judge.functions = {bevelled_rules().function};
  judge.misconceptions = placement_misconceptions(bevelled_rules());
  judge.judge_steps = [](const JudgeTask& task, Conventions& /*conventions*/,
                         CaseJudgement& judgement) {
    judge_placements(task, bevelled_rules(), judgement);
  };
  return judge;
}

}  // namespace meshgrade
