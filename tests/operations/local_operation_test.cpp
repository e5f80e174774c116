// The right answers, on every element of every mesh of polygons: numbers of elements by closed
// forms, and what must hold of any surface.

#include "grader/operations/local_operation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

const char* const kMeshes[] = {"quad_cube.dae",    "prism_5.obj",       "pyramid_4.obj",
                               "dodecahedron.obj", "octahedron.off",    "quad_torus.obj",
                               "bipyramid_3.obj",  "pouch.obj",         "lens.obj",
                               "mixed_strip.obj",  "quad_grid_3x3.obj", "tube_6.obj",
                               "ring_5.obj",       "fan.obj",           "single_triangle.obj",
                               "single_quad.obj",  "tetrahedron.obj",   "two_triangles.obj",
                               "valence_zoo.obj",  "two_patches.obj",   "octagon.obj"};

const char* const kOperations[] = {"edge_flip_polygon", "edge_split_polygon", "edge_collapse",
                                   "edge_dissolve",     "vertex_dissolve",    "vertex_inset",
                                   "face_extrude",      "face_collapse",      "vertex_bevel",
                                   "edge_bevel",        "face_remove",        "edge_weld"};

/// One operation on one element.
struct Try {
  const LocalOperation& operation;
  const FaceLists& lists;
  const Surface& surface;
  Picked picked;
  Answer answer;
  std::string name;  ///< for messages

  bool at_boundary() const {
    return std::any_of(picked.corners.begin(), picked.corners.end(),
                       [&](Label corner) { return surface.is_boundary(corner); });
  }
};

template <class Visit>
void for_every_element(const std::string& exercise, Visit visit) {
  const LocalOperation* operation = find_local_operation(exercise);
  ASSERT_NE(operation, nullptr) << exercise;
  for (const char* file : kMeshes) {
    const MeshDump mesh = sample_dump(file);
    const FaceLists lists = face_lists_of(mesh);
    const Surface surface(lists);
    const std::uint32_t n = count_elements(mesh, operation->picks);
    for (std::uint32_t i = 0; i < n; ++i) {
      Picked picked = pick(mesh, operation->picks, i);
      for (std::uint32_t j = 0; j < (operation->picks_two ? n : 1); ++j) {
        if (operation->picks_two) picked.partner = pick(mesh, operation->picks, j).corners;
        visit(
            Try{*operation, lists, surface, picked, operation->answer(lists, picked),
                exercise + " " + std::to_string(i) + ", " + std::to_string(j) + " of " + file});
      }
    }
  }
}

struct Change {
  std::ptrdiff_t vertices;
  std::ptrdiff_t edges;
  std::ptrdiff_t faces;
};

Change change(const Try& tried) {
  const Counts before = count(mesh_of(tried.lists));
  const Counts after = count(mesh_of(tried.answer.after));
  const auto less = [](std::size_t a, std::size_t b) {
    return static_cast<std::ptrdiff_t>(a) - static_cast<std::ptrdiff_t>(b);
  };
  return {less(after.vertices, before.vertices), less(after.edges, before.edges),
          less(after.faces, before.faces)};
}

/// Triangles beside the edge that was picked.
std::ptrdiff_t triangles(const Try& tried) {
  const Label a = tried.picked.corners[0];
  const Label b = tried.picked.corners[1];
  std::ptrdiff_t n = 0;
  for (const auto& face :
       {tried.surface.face_with_side(a, b), tried.surface.face_with_side(b, a)})
    n += face && tried.lists.faces[*face].size() == 3 ? 1 : 0;
  return n;
}

/// Faces of which one corner only does not belong to the face that was picked.
std::ptrdiff_t vanishing(const Try& tried) {
  return std::count_if(tried.lists.faces.begin(), tried.lists.faces.end(),
                       [&](const Corners& face) {
                         return std::count_if(face.begin(), face.end(), [&](Label corner) {
                                  return !place_of(tried.picked.corners, corner);
                                }) == 1;
                       });
}

/// A side on a boundary goes, and so does a corner with no other face.
Change without_the_face(const Try& tried) {
  Change change{0, 0, -1};
  const Corners& face = tried.picked.corners;
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (tried.surface.is_boundary_edge(face[i], face[(i + 1) % face.size()])) --change.edges;
    if (tried.surface.faces_at(face[i]).size() == 1) --change.vertices;
  }
  return change;
}

std::ptrdiff_t edges_at(const Try& tried, std::size_t corner) {
  return static_cast<std::ptrdiff_t>(
      tried.surface.neighbours(tried.picked.corners[corner]).size());
}

/// By the closed forms of each operation.
Change expected_change(const Try& tried) {
  const std::string& exercise = tried.operation.exercise;
  const Corners& corners = tried.picked.corners;
  const auto d = static_cast<std::ptrdiff_t>(exercise == "vertex_dissolve"
                                                 ? tried.surface.neighbours(corners[0]).size()
                                                 : corners.size());
  const bool boundary_edge =
      corners.size() == 2 && tried.surface.is_boundary_edge(corners[0], corners[1]);
  if (exercise == "edge_flip_polygon") return {0, 0, 0};
  if (exercise == "edge_split_polygon")
    return boundary_edge ? Change{1, 2, 1} : Change{1, 3, 2};
  if (exercise == "edge_collapse") return {-1, -1 - triangles(tried), -triangles(tried)};
  if (exercise == "edge_dissolve") return {0, -1, -1};
  if (exercise == "vertex_dissolve")
    return tried.at_boundary() ? Change{-1, 1 - d, 2 - d} : Change{-1, -d, 1 - d};
  if (exercise == "vertex_inset") return {1, d, d - 1};
  if (exercise == "face_collapse") return {1 - d, -d - vanishing(tried), -1 - vanishing(tried)};
  if (exercise == "vertex_bevel") return {edges_at(tried, 0) - 1, edges_at(tried, 0), 1};
  if (exercise == "edge_bevel") {
    const std::ptrdiff_t others = edges_at(tried, 0) + edges_at(tried, 1) - 2;
    return {others - 2, others - 1, 1};
  }
  if (exercise == "face_remove") return without_the_face(tried);
  if (exercise == "edge_weld") {
    const auto shared = std::count_if(corners.begin(), corners.end(), [&](Label corner) {
      return place_of(tried.picked.partner, corner).has_value();
    });
    return {shared - 2, -1, 0};
  }
  return {d, 2 * d, d};
}

class RightAnswer : public testing::TestWithParam<const char*> {};

TEST_P(RightAnswer, IsASurfaceWithTheNumbersOfItsClosedForm) {
  std::size_t tried_ones = 0;
  for_every_element(GetParam(), [&](const Try& tried) {
    if (tried.answer.demand != Demand::kMust) return;
    ++tried_ones;
    ASSERT_EQ(trouble_of(tried.answer.after), "") << tried.name;
    const Change is = change(tried);
    const Change must = expected_change(tried);
    EXPECT_EQ(is.vertices, must.vertices) << tried.name;
    EXPECT_EQ(is.edges, must.edges) << tried.name;
    EXPECT_EQ(is.faces, must.faces) << tried.name;
  });
  EXPECT_GT(tried_ones, 50U);
}

TEST_P(RightAnswer, ChangesNoFaceThatHasNothingToDoWithTheElement) {
  for_every_element(GetParam(), [&](const Try& tried) {
    if (tried.answer.demand == Demand::kRefuse) return;
    for (const Corners& corners : tried.lists.faces) {
      const bool touches = std::any_of(corners.begin(), corners.end(), [&](Label corner) {
        return place_of(tried.picked.corners, corner) || place_of(tried.picked.partner, corner);
      });
      const auto is_it = [&](const Corners& other) {
        return canonical(other) == canonical(corners);
      };
      const auto& after = tried.answer.after.faces;
      EXPECT_TRUE(touches || std::any_of(after.begin(), after.end(), is_it)) << tried.name;
    }
  });
}

TEST_P(RightAnswer, ThatIsRefusedOrFreeSaysWhy) {
  for_every_element(GetParam(), [&](const Try& tried) {
    EXPECT_EQ(tried.answer.reason.empty(), tried.answer.demand == Demand::kMust) << tried.name;
  });
}

INSTANTIATE_TEST_SUITE_P(Operations, RightAnswer, testing::ValuesIn(kOperations),
                         [](const auto& tested) { return std::string(tested.param); });

Demand demand(const std::string& exercise, const std::string& file, const Corners& corners) {
  const LocalOperation& operation = *find_local_operation(exercise);
  const FaceLists lists = face_lists_of(sample_dump(file));
  return operation.answer(lists, {corners}).demand;
}

TEST(RightAnswer, OfACollapseIsByTheLinkOfItsEdge) {
  EXPECT_EQ(demand("edge_collapse", "single_triangle.obj", {0, 1}), Demand::kRefuse);
  EXPECT_EQ(demand("edge_collapse", "single_quad.obj", {0, 1}), Demand::kMust);
  EXPECT_EQ(demand("edge_collapse", "tetrahedron.obj", {0, 1}), Demand::kEither);
  EXPECT_EQ(demand("edge_collapse", "octahedron.off", {0, 1}), Demand::kMust);
  // The hexagon has both ends, which have no neighbour in common.
  EXPECT_EQ(demand("edge_collapse", "lens.obj", {0, 3}), Demand::kRefuse);
  // The three edges of the double pyramid's middle look like a triangle.
  EXPECT_EQ(demand("edge_collapse", "bipyramid_3.obj", {0, 1}), Demand::kEither);
}

TEST(RightAnswer, OfADissolvedEdgeRefusesFacesThatShareMore) {
  EXPECT_EQ(demand("edge_dissolve", "quad_cube.dae", {0, 1}), Demand::kMust);
  EXPECT_EQ(demand("edge_dissolve", "pouch.obj", {0, 1}), Demand::kRefuse);
  EXPECT_EQ(demand("edge_dissolve", "single_quad.obj", {0, 1}), Demand::kRefuse);
}

TEST(RightAnswer, OfACollapsedFaceIsByWhatTouchesIt) {
  const auto demands = [](const std::string& file) {
    std::set<Demand> all;
    const FaceLists lists = face_lists_of(sample_dump(file));
    for (const Corners& face : lists.faces)
      all.insert(find_local_operation("face_collapse")->answer(lists, {face}).demand);
    return all;
  };
  EXPECT_EQ(demands("dodecahedron.obj"), std::set<Demand>{Demand::kMust});
  EXPECT_EQ(demands("quad_cube.dae"), std::set<Demand>{Demand::kMust});
  EXPECT_EQ(demands("tetrahedron.obj"), std::set<Demand>{Demand::kRefuse});
  EXPECT_EQ(demands("single_quad.obj"), std::set<Demand>{Demand::kRefuse});
  // Each quad of the ring touches both boundaries.
  EXPECT_EQ(demands("ring_5.obj"), std::set<Demand>{Demand::kRefuse});
}

}  // namespace
}  // namespace meshgrade
