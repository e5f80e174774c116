#include "grader/cases/whole_mesh_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "grader/cases/whole_mesh_input.h"
#include "grader/operations/face_lists.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

std::size_t corners_of(const PolygonMesh& mesh) {
  std::size_t n = 0;
  for (const auto& polygon : mesh.polygons)
    n += polygon.size();
  return n;
}

class WholeMeshExercises : public testing::TestWithParam<std::string> {};

TEST_P(WholeMeshExercises, HaveFacesAndInnerVerticesOfEverySizeAndAllAnchors) {
  std::set<std::size_t> sides;
  std::set<std::size_t> valences;
  std::set<std::uint32_t> turns;
  bool has_fresh_repetition = false;
  for (const Case& c : standard_cases(GetParam())) {
    const auto input = from_wire<WholeMeshInput>(c.input);
    turns.insert(input.anchor_turns);
    has_fresh_repetition = has_fresh_repetition || (c.fresh && input.times >= 2);
    if (c.input.size() > 50'000) continue;
    const FaceLists lists{input.mesh.positions,
                          {input.mesh.polygons.begin(), input.mesh.polygons.end()}};
    const Surface surface(lists);
    for (const Corners& face : lists.faces) {
      sides.insert(face.size());
      for (const Label v : face) {
        if (!surface.is_boundary(v)) valences.insert(surface.neighbours(v).size());
      }
    }
  }
  for (std::size_t n = 3; n <= 24; ++n) {
    EXPECT_EQ(sides.count(n), 1U) << n << " corners";
    EXPECT_EQ(valences.count(n), 1U) << n << " edges";
  }
  EXPECT_EQ(turns, (std::set<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(has_fresh_repetition);
}

TEST_P(WholeMeshExercises, AreShrunkToFewerCallsOrCorners) {
  const ExerciseRubric& rubric = rubric_of(GetParam());
  std::size_t shrunk = 0;
  for (const Case& c : standard_cases(GetParam())) {
    const auto input = from_wire<WholeMeshInput>(c.input);
    for (const Case& smaller : make_smaller_cases(assignment_with(GetParam()), rubric,
                                                  MESHGRADE_SOURCE_DIR "/meshes", c)) {
      ++shrunk;
      EXPECT_EQ(smaller.group, c.group);
      const auto less = from_wire<WholeMeshInput>(smaller.input);
      EXPECT_TRUE(less.times < input.times || corners_of(less.mesh) < corners_of(input.mesh))
          << c.title << " -> " << smaller.title;
    }
  }
  EXPECT_GT(shrunk, 0U);
}

INSTANTIATE_TEST_SUITE_P(, WholeMeshExercises,
                         testing::Values("triangulation", "linear_subdivision", "catmull_clark",
                                         "loop_refinement"),
                         [](const auto& parameter) { return parameter.param; });

TEST(LoopRefinement, RefusesExactlyWhatHasOtherFacesThanTriangles) {
  std::map<bool, int> asked;
  for (const Case& c : standard_cases("loop_refinement")) {
    const auto input = from_wire<WholeMeshInput>(c.input);
    const auto& polygons = input.mesh.polygons;
    const bool triangles = std::all_of(polygons.begin(), polygons.end(),
                                       [](const auto& p) { return p.size() == 3; });
    EXPECT_EQ(c.group == "refused", !triangles) << c.title;
    ++asked[triangles];
  }
  EXPECT_GT(asked[true], 40);
  EXPECT_GT(asked[false], 20);
}

}  // namespace
}  // namespace meshgrade
