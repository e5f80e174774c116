#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "grader/base/process.h"
#include "grader/files/mesh_file.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

using SubdivideCommand = CommandLine;

TEST_F(SubdivideCommand, CatmullClarkTakesPolygonsAndMakesQuadrilaterals) {
  const std::string out = result("ball.obj");
  const Said said = call(
      {"subdivide", given("quad_cube.dae"), "--scheme", "catmull-clark", "-n", "2", "-o", out});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("98 vertices, 192 edges, 96 faces"));
  const PolygonMesh mesh = read_mesh(out).mesh;
  EXPECT_EQ(mesh.positions.size(), 98U);
  ASSERT_EQ(mesh.polygons.size(), 96U);
  for (const auto& polygon : mesh.polygons)
    EXPECT_EQ(polygon.size(), 4U);
}

TEST_F(SubdivideCommand, LoopSaysWhichSchemeTakesPolygons) {
  const Said said = call({"subdivide", given("quad_cube.dae"), "-o", result("out.obj")});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("quad_cube.dae: face f0 has 4 corners"));
  EXPECT_THAT(said.output, HasSubstr("--scheme catmull-clark takes any polygons"));
  EXPECT_FALSE(fs::exists(result("out.obj")));
}

TEST_F(SubdivideCommand, OnlyLoopHasRulesToChooseFrom) {
  const Said said = call({"subdivide", given("quad_cube.dae"), "--scheme", "catmull-clark",
                          "--rule", "warren", "-o", result("out.obj")});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr("--rule chooses among Loop's weights"));
}

TEST_F(SubdivideCommand, WhatAFormatCannotHoldIsSaidWithOneThatCan) {
  const Said said = call({"subdivide", given("quad_cube.dae"), "--scheme", "catmull-clark",
                          "-o", result("out.stl")});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, HasSubstr(".stl allows 3; choose .obj"));
}

}  // namespace
}  // namespace meshgrade
