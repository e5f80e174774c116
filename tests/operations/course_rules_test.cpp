// Where a course had no rule, whoever refuses is right as well; all else stays what it is.

#include "grader/operations/course_rules.h"

#include <gtest/gtest.h>

#include "grader/operations/local_operation_list.h"

namespace meshgrade {
namespace {

/// Two squares side by side, and a triangle on each short end.
FaceLists strip() {
  FaceLists lists;
  for (double y : {0.0, 1.0}) {
    for (double x : {0.0, 1.0, 2.0})
      lists.add({x, y, 0.0});
  }
  lists.add({-1.0, 0.5, 0.0});
  lists.add({3.0, 0.5, 0.0});
  lists.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 6}, {2, 7, 5}};
  return lists;
}

Demand demand_of(CourseRules rules, const std::string& exercise, const Corners& corners) {
  const LocalOperation& operation = *find_local_operation(exercise);
  const FaceLists lists = strip();
  const Picked picked{corners};
  return as_asked(rules, operation, lists, picked, operation.answer(lists, picked)).demand;
}

Demand until_2022(const std::string& exercise, const Corners& corners) {
  return demand_of(CourseRules::kScotty3d2020, exercise, corners);
}

TEST(CourseRules, OursAskForEveryElement) {
  EXPECT_EQ(demand_of(CourseRules::kAll, "edge_split_polygon", {0, 1}), Demand::kMust);
  EXPECT_EQ(demand_of(CourseRules::kAll, "edge_dissolve", {1, 4}), Demand::kMust);
  EXPECT_EQ(demand_of(CourseRules::kAll, "vertex_dissolve", {1}), Demand::kMust);
}

TEST(CourseRules, UntilSpring2022SplitsAreAskedOfTrianglesOnly) {
  EXPECT_EQ(until_2022("edge_split_polygon", {0, 6}), Demand::kMust);
  EXPECT_EQ(until_2022("edge_split_polygon", {0, 3}), Demand::kEither);
  EXPECT_EQ(until_2022("edge_split_polygon", {0, 1}), Demand::kEither);
}

TEST(CourseRules, UntilSpring2022WhatChangesABoundaryMayBeRefused) {
  EXPECT_EQ(until_2022("edge_dissolve", {1, 4}), Demand::kEither);
  EXPECT_EQ(until_2022("edge_collapse", {0, 1}), Demand::kEither);
  EXPECT_EQ(until_2022("vertex_bevel", {1}), Demand::kEither);
  EXPECT_EQ(until_2022("vertex_dissolve", {1}), Demand::kOpen);
}

TEST(CourseRules, UntilSpring2022WhatOnlyTouchesABoundaryMustBeDone) {
  EXPECT_EQ(until_2022("face_extrude", {0, 1, 4, 3}), Demand::kMust);
  EXPECT_EQ(until_2022("vertex_inset", {0, 1, 4, 3}), Demand::kMust);
  EXPECT_EQ(until_2022("edge_flip_polygon", {1, 4}), Demand::kMust);
}

TEST(CourseRules, WhatLeavesNoSurfaceIsRefusedInAllYears) {
  EXPECT_EQ(until_2022("edge_flip_polygon", {0, 1}), Demand::kRefuse);
  EXPECT_EQ(until_2022("edge_collapse", {1, 4}), Demand::kRefuse);
}

}  // namespace
}  // namespace meshgrade
