// Functions that place the corners of a face, from source to report: wrong solutions that are
// the reference but for a line, and what is said of them.

#include <gtest/gtest.h>

#include <set>

#include "grader/judge/judge.h"
#include "tests/grade/graded_change.h"

namespace meshgrade {
namespace {

/// `rule` is the name of the misconception here.
const Change kMisplaced[] = {
    {"Drifts", "extrude_positions", "const Vector3D p = outerCornerOf(side)->position;",
     "const Vector3D p = side->vertex()->position;", "begins-where-it-is"},
    {"ShrinksTowardsTheOrigin", "extrude_positions", "shrink * (mean - p)", "shrink * (-p)",
     "towards-origin"},
    {"ShrinksTheMove", "extrude_positions", "p + shrink * (mean - p) + move",
     "p + move + shrink * (mean - p - move)", "move-shrinks"},
    {"TakesAFactor", "extrude_positions", "p + shrink * (mean - p) + move",
     "mean + shrink * (p - mean) + move", "shrink-as-factor"},
    {"Grows", "extrude_positions", "shrink * (mean - p)", "shrink * (p - mean)", "sign-turned"},
    {"DoesNotMove", "extrude_positions", "shrink * (mean - p) + move", "shrink * (mean - p)",
     "move-left-out"},
    {"GoesTheDistance", "bevel_positions", "distance / dot(direction, u) * u", "distance * u",
     "distance-along-edge"},
    {"Multiplies", "bevel_positions", "distance / dot(direction, u)",
     "distance * dot(direction, u)", "times-dot-product"},
    {"LeavesTheEdge", "bevel_positions", "distance / dot(direction, u) * u",
     "distance * direction", "off-the-edge"},
    {"UsesTheWholeEdge", "bevel_positions", "distance / dot(direction, u) * u",
     "distance / dot(direction, u) * (outer->position - start)", "edge-not-unit"},
    {"GoesBack", "bevel_positions", "start + distance / dot", "start - distance / dot",
     "sign-turned"},
    {"GoesOn", "bevel_positions", "h->vertex()->position = start + ",
     "h->vertex()->position = h->vertex()->position + ", "begins-where-it-is"},
};

class Misplaced : public testing::TestWithParam<Change> {};

TEST_P(Misplaced, LosesPointsAndIsToldWhy) {
  const Change& change = GetParam();
  const ExerciseReport report =
      grade_one(change.exercise, altered(path_of(change.exercise), change.was, change.becomes));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_LT(report.points, report.max_points);
  EXPECT_EQ(first_finding(report).rule, "new-position");
  EXPECT_EQ(causes_of(report), std::set<std::string>{change.rule});
}

INSTANTIATE_TEST_SUITE_P(Placements, Misplaced, testing::ValuesIn(kMisplaced),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// From the corners themselves, as most students do who drift.
TEST(Misplaced, FromItsOwnCornersDrifts) {
  const ExerciseReport report =
      grade_one("extrude_positions", altered(path_of("extrude_positions"),
                                             "return side->twin()->next()->twin()->vertex();",
                                             "return side->vertex();"));
  EXPECT_EQ(causes_of(report), std::set<std::string>{"begins-where-it-is"});
  for (const GroupReport& group : report.groups) {
    if (group.name == "basic") {
      EXPECT_EQ(group.points, group.max_points);
    } else {
      EXPECT_EQ(group.points, 0.0) << group.name;
    }
  }
}

TEST(Misplaced, MovingAnotherVertexIsSeen) {
  const ExerciseReport report = grade_one(
      "bevel_positions",
      altered(path_of("bevel_positions"), "h->vertex()->position = start",
              "outer->position += Vector3D(0, 0, 0.01);\n    h->vertex()->position = start"));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(first_finding(report).rule, "mesh-changed");
  EXPECT_NE(first_finding(report).look_at.find("no other vertex"), std::string::npos);
}

TEST(Misplaced, EveryNameHasItsMistake) {
  std::set<std::string> tested;
  for (const Change& change : kMisplaced)
    tested.insert(std::string(change.exercise) + " " + change.rule);
  const Assignment assignment = load_assignment("polygon_meshes");
  for (const char* exercise : {"extrude_positions", "bevel_positions"}) {
    for (const Misconception& m :
         find_exercise_judge(*assignment.find(exercise)).misconceptions)
      EXPECT_EQ(tested.count(std::string(exercise) + " " + m.name), 1U) << m.name;
  }
}

}  // namespace
}  // namespace meshgrade
