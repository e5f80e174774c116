#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "grader/files/mesh_file.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

using SimplifyCommand = CommandLine;

TEST_F(SimplifyCommand, LeavesSoManyFacesOfTheSameTopologyAndOnlyGivenPoints) {
  const std::string fine = result("fine.obj");
  ASSERT_EQ(call({"subdivide", given("double_torus.obj"), "-n", "2", "-o", fine}).status, 0);
  const PolygonMesh before = read_mesh(fine).mesh;
  const std::size_t asked = before.polygons.size() / 4;
  const std::string out = result("coarse.off");
  const Said said = call({"simplify", fine, "--faces", std::to_string(asked), "-o", out});
  EXPECT_EQ(said.status, 0) << said.output;
  const PolygonMesh after = read_mesh(out).mesh;
  EXPECT_EQ(after.polygons.size(), asked);
  EXPECT_THAT(said.output, HasSubstr(std::to_string(asked) + " faces (before: "));
  for (const Point3& p : after.positions)
    EXPECT_EQ(std::count(before.positions.begin(), before.positions.end(), p), 1);
  EXPECT_THAT(call({"mesh-info", out}).output, HasSubstr("genus       2\n"));
}

TEST_F(SimplifyCommand, AMeshThatIsSmallEnoughStaysAsItIs) {
  const Said said =
      call({"simplify", given("tetrahedron.obj"), "--faces", "4", "-o", result("same.obj")});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("4 vertices, 4 faces, as they were"));
  EXPECT_EQ(read_mesh(result("same.obj")).mesh.polygons,
            read_mesh(given("tetrahedron.obj")).mesh.polygons);
}

TEST_F(SimplifyCommand, SaysWhereNoEdgeMayBeCollapsedAnyMore) {
  const Said said =
      call({"simplify", given("octahedron.off"), "--faces", "1", "-o", result("least.obj")});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("more faces than 1"));
  EXPECT_EQ(read_mesh(result("least.obj")).mesh.polygons.size(), 4U);
}

/// A flat square of 2 n n triangles with the area n n.
PolygonMesh square(std::uint32_t n) {
  PolygonMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.positions.push_back({static_cast<double>(x), static_cast<double>(y), 0.0});
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = y * (n + 1) + x;
      mesh.polygons.push_back({v, v + 1, v + n + 2});
      mesh.polygons.push_back({v, v + n + 2, v + n + 1});
    }
  }
  return mesh;
}

double area_above(const PolygonMesh& mesh) {
  double twice = 0.0;
  for (const auto& t : mesh.polygons) {
    const Point3& p = mesh.positions[t[0]];
    const Point3& q = mesh.positions[t[1]];
    const Point3& r = mesh.positions[t[2]];
    const double cross = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    EXPECT_GT(cross, 0.0) << "a triangle is turned over, or has no area";
    twice += cross;
  }
  return twice / 2.0;
}

TEST_F(SimplifyCommand, AFlatSquareKeepsItsOutlineAndLiesNowhereOnItself) {
  write_mesh(result("square.obj"), square(8));
  for (const char* faces : {"64", "16", "2"}) {
    const Said said =
        call({"simplify", result("square.obj"), "--faces", faces, "-o", result("less.obj")});
    EXPECT_EQ(said.status, 0) << said.output;
    const PolygonMesh less = read_mesh(result("less.obj")).mesh;
    EXPECT_LE(less.polygons.size(), std::stoul(faces));
    EXPECT_DOUBLE_EQ(area_above(less), 64.0) << faces;
  }
}

TEST_F(SimplifyCommand, ABentBoundaryStaysWhole) {
  PolygonMesh bent = square(8);
  for (Point3& p : bent.positions)
    p[2] = 0.05 * p[0] * p[0] + 0.03 * p[1] * p[1];
  write_mesh(result("bent.obj"), bent);
  const Said said =
      call({"simplify", result("bent.obj"), "--faces", "40", "-o", result("less.obj")});
  EXPECT_EQ(said.status, 0) << said.output;
  const PolygonMesh less = read_mesh(result("less.obj")).mesh;
  EXPECT_LE(less.polygons.size(), 40U);
  EXPECT_DOUBLE_EQ(area_above(less), 64.0);
  std::size_t on_rim = 0;
  for (const Point3& p : less.positions)
    on_rim += p[0] == 0.0 || p[0] == 8.0 || p[1] == 0.0 || p[1] == 8.0 ? 1 : 0;
  EXPECT_EQ(on_rim, 32U);
}

TEST_F(SimplifyCommand, RefusesPolygonsAndNamesTheFirst) {
  const Said said =
      call({"simplify", given("mixed_strip.obj"), "--faces", "2", "-o", result("out.obj")});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("mixed_strip.obj: face f"));
  EXPECT_THAT(said.output, HasSubstr("only meshes of triangles are simplified"));
  EXPECT_FALSE(fs::exists(result("out.obj")));
}

TEST_F(SimplifyCommand, RefusesWhatIsNoManifoldRatherThanLosingFaces) {
  for (const char* file : {"bow_tie.obj", "moebius_strip.obj", "inconsistent_winding.obj"}) {
    const Said said = call({"simplify", given(std::string("invalid/") + file), "--faces", "1",
                            "-o", result("out.obj")});
    EXPECT_EQ(said.status, 2) << file;
    EXPECT_THAT(said.output, HasSubstr(file));
    EXPECT_THAT(said.output, HasSubstr("only a manifold of triangles is simplified")) << file;
    EXPECT_FALSE(fs::exists(result("out.obj"))) << file;
  }
}

TEST_F(SimplifyCommand, NeedsTheNumberOfFaces) {
  const Said said = call({"simplify", given("cube.obj"), "-o", result("out.obj")});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("--faces is required"));
  EXPECT_EQ(
      call({"simplify", given("cube.obj"), "--faces", "0", "-o", result("out.obj")}).status, 2);
}

}  // namespace
}  // namespace meshgrade
