#include "grader/operations/face_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

/// Two quads with the edge 1-2 in common.
FaceLists two_quads() {
  return {std::vector<Point3>(6), {{0, 1, 2, 3}, {2, 1, 4, 5}}};
}

TEST(FaceLists, AreTheSameMeshAgain) {
  for (const char* file : {"prism_5.obj", "mixed_strip.obj", "tube_6.obj", "pouch.obj"}) {
    const MeshDump mesh = sample_dump(file);
    const FaceLists lists = face_lists_of(mesh);
    EXPECT_EQ(lists.faces.size(), count(mesh).faces) << file;
    EXPECT_TRUE(count(mesh_of(lists)) == count(mesh)) << file;
    EXPECT_EQ(trouble_of(lists), "") << file;
  }
}

TEST(FaceLists, CanonicalListsAreEqualForEqualFacesOnly) {
  EXPECT_EQ(canonical({3, 1, 2}), canonical({2, 3, 1}));
  EXPECT_NE(canonical({3, 1, 2}), canonical({2, 1, 3}));
}

TEST(Surface, KnowsSidesNeighboursAndBoundaries) {
  const Surface surface(two_quads());
  EXPECT_EQ(surface.face_with_side(1, 2), 0U);
  EXPECT_EQ(surface.face_with_side(2, 1), 1U);
  EXPECT_EQ(surface.face_with_side(1, 0), std::nullopt);
  EXPECT_TRUE(surface.is_edge(1, 0));
  EXPECT_FALSE(surface.is_edge(0, 2));
  EXPECT_TRUE(surface.is_boundary_edge(0, 1));
  EXPECT_FALSE(surface.is_boundary_edge(1, 2));
  EXPECT_THAT(surface.neighbours(1), testing::ElementsAre(0, 2, 4));
  EXPECT_TRUE(surface.are_neighbours(1, 4));
  EXPECT_FALSE(surface.are_neighbours(1, 3));
  EXPECT_THAT(surface.faces_at(2), testing::ElementsAre(0, 1));
  EXPECT_THROW(surface.faces_at(6), std::out_of_range);
  EXPECT_THROW(surface.neighbours(6), std::out_of_range);
  EXPECT_EQ(surface.face_with_side(6, 7), std::nullopt);
  // Outside, the boundary runs the other way round: 0, 3, 2, 5, 4, 1.
  EXPECT_EQ(surface.loop_of(0, 3).size(), 6U);
  EXPECT_EQ(surface.loop_of(1, 0).size(), 6U);
}

TEST(Surface, CountsTheVerticesOfItsBoundary) {
  const auto on_boundary = [](const char* file) {
    const FaceLists lists = face_lists_of(sample_dump(file));
    const Surface surface(lists);
    std::size_t n = 0;
    for (Label v = 0; v < lists.positions.size() + 2; ++v)
      n += surface.is_boundary(v) ? 1 : 0;
    return n;
  };
  EXPECT_EQ(on_boundary("prism_5.obj"), 0U);
  EXPECT_EQ(on_boundary("tube_6.obj"), 12U);
}

TEST(FaceLists, TroubleIsWhatIsNoSurfaceOrADegenerateOne) {
  FaceLists none;
  EXPECT_NE(trouble_of(none), "");
  FaceLists twice = two_quads();
  twice.faces.push_back({0, 1, 4});  // a third face at the edge 0-1, on the same side
  EXPECT_NE(trouble_of(twice), "");
  FaceLists pillow{std::vector<Point3>(3), {{0, 1, 2}, {2, 1, 0}}};
  EXPECT_NE(trouble_of(pillow), "");
  FaceLists bow{std::vector<Point3>(5), {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_NE(trouble_of(bow), "");
}

}  // namespace
}  // namespace meshgrade
