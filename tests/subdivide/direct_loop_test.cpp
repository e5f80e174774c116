#include "grader/subdivide/direct_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "grader/base/errors.h"
#include "grader/subdivide/opensubdiv_level.h"
#include "tests/subdivide/comparison.h"
#include "tests/subdivide/course_meshes.h"

namespace meshgrade {
namespace {

constexpr std::array<VertexRule, 2> kVertexRules = {VertexRule::kLoop, VertexRule::kWarren};
constexpr std::array<CornerRule, 2> kCornerRules = {CornerRule::kSmooth, CornerRule::kCorner};

SubdivisionOptions levels(unsigned n, VertexRule vertex_rule = VertexRule::kLoop,
                          CornerRule corner_rule = CornerRule::kSmooth) {
  SubdivisionOptions options;
  options.levels = n;
  options.vertex_rule = vertex_rule;
  options.corner_rule = corner_rule;
  return options;
}

/// The vertex of `to` that carries the name of each vertex of `from`, by the edges that both
/// have split: `from` is numbered by DirectLoop, `level` by OpenSubdiv.
std::vector<std::uint32_t> names_in_level(const PolygonMesh& old, const PolygonMesh& from,
                                          const SubdivisionLevel& level) {
  const auto child_of_edge = children_of_edges(level);
  std::vector<std::uint32_t> names(from.positions.size());
  std::copy(level.child_of_vertex.begin(), level.child_of_vertex.end(), names.begin());
  for (std::size_t f = 0; f < old.polygons.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = old.polygons[f][k];
      const std::uint32_t b = old.polygons[f][(k + 1) % 3];
      names[from.polygons[4 * f + k][1]] = child_of_edge.at({std::min(a, b), std::max(a, b)});
    }
  }
  return names;
}

TEST(DirectLoop, EqualsOpenSubdivOnEveryMeshRuleAndLevel) {
  for (const auto& [name, mesh] : triangle_meshes()) {
    for (const VertexRule vertex_rule : kVertexRules) {
      for (const CornerRule corner_rule : kCornerRules) {
        PolygonMesh old = mesh;
        for (int level = 1; level <= 3; ++level) {
          SCOPED_TRACE(name + ", level " + std::to_string(level));
          const PolygonMesh ours = direct_loop(old, levels(1, vertex_rule, corner_rule));
          const SubdivisionLevel theirs = opensubdiv_loop(old, vertex_rule, corner_rule);
          ASSERT_EQ(ours.positions.size(), theirs.mesh.positions.size());
          const auto names = names_in_level(old, ours, theirs);
          EXPECT_EQ(renamed_faces(ours, &names), renamed_faces(theirs.mesh, nullptr));
          expect_same_points(ours, theirs.mesh, names);
          old = ours;
        }
      }
    }
  }
}

TEST(DirectLoop, ManyLevelsAtOnceAreManyTimesOneLevel) {
  for (const auto& [name, mesh] : triangle_meshes()) {
    for (const CornerRule corner_rule : kCornerRules) {
      const PolygonMesh at_once = direct_loop(mesh, levels(3, VertexRule::kLoop, corner_rule));
      PolygonMesh step_by_step = mesh;
      for (int level = 0; level < 3; ++level) {
        step_by_step = direct_loop(step_by_step, levels(1, VertexRule::kLoop, corner_rule));
      }
      // Faces are numbered alike, vertices need not be.
      ASSERT_EQ(at_once.polygons.size(), step_by_step.polygons.size()) << name;
      const double tolerance = 1e-12 * largest_coordinate(mesh);
      for (std::size_t f = 0; f < at_once.polygons.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
          const Point3& a = at_once.positions[at_once.polygons[f][k]];
          const Point3& b = step_by_step.positions[step_by_step.polygons[f][k]];
          for (std::size_t axis = 0; axis < 3; ++axis) {
            ASSERT_NEAR(a[axis], b[axis], tolerance) << name << ", face f" << f;
          }
        }
      }
    }
  }
}

TEST(DirectLoop, OctahedronKeepsItsCornersByTheClosedForm) {
  const PolygonMesh& mesh = triangle_mesh("octahedron.off");
  for (const auto& [rule, b] :
       {std::pair(VertexRule::kLoop, 0.12109375), std::pair(VertexRule::kWarren, 0.09375)}) {
    const PolygonMesh finer = direct_loop(mesh, levels(1, rule));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(finer.positions[v][axis], (1 - 4 * b) * mesh.positions[v][axis], 1e-15);
      }
    }
  }
}

TEST(DirectLoop, BoundaryIsACubicSplineOfItsOwn) {
  const PolygonMesh& mesh = triangle_mesh("single_triangle.obj");
  const PolygonMesh smooth = direct_loop(mesh, levels(1));
  EXPECT_EQ(smooth.positions[0], (Point3{1.0 / 8, 1.0 / 8, 0}));
  EXPECT_EQ(smooth.positions[1], (Point3{6.0 / 8, 1.0 / 8, 0}));
  EXPECT_EQ(smooth.positions[smooth.polygons[0][1]], (Point3{1.0 / 2, 0, 0}));
  const PolygonMesh corner =
      direct_loop(mesh, levels(1, VertexRule::kLoop, CornerRule::kCorner));
  EXPECT_EQ(corner.positions[0], mesh.positions[0]);
}

TEST(DirectLoop, CountsGrowAsTheyMust) {
  for (const auto& [name, mesh] : triangle_meshes()) {
    DirectLoop surface(mesh);
    for (int level = 0; level < 3; ++level) {
      const std::size_t v = surface.n_vertices();
      const std::size_t e = surface.n_edges();
      const std::size_t f = surface.n_faces();
      surface.subdivide(levels(1));
      EXPECT_EQ(surface.n_vertices(), v + e) << name;
      EXPECT_EQ(surface.n_edges(), 2 * e + 3 * f) << name;
      EXPECT_EQ(surface.n_faces(), 4 * f) << name;
    }
  }
}

TEST(DirectLoop, CommutesWithAffineMaps) {
  const auto map = [](const Point3& p) {
    return Point3{2 * p[0] - p[1] + 0.5 * p[2] + 3, 0.25 * p[0] + p[1] - 7,
                  -p[0] + 3 * p[1] + 1.5 * p[2] + 1};
  };
  for (const auto& [name, mesh] : triangle_meshes()) {
    PolygonMesh moved = mesh;
    std::transform(mesh.positions.begin(), mesh.positions.end(), moved.positions.begin(), map);
    const PolygonMesh map_first = direct_loop(moved, levels(2));
    const PolygonMesh map_last = direct_loop(mesh, levels(2));
    for (std::size_t v = 0; v < map_last.positions.size(); ++v) {
      const Point3 expected = map(map_last.positions[v]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(map_first.positions[v][axis], expected[axis], 1e-12) << name;
      }
    }
  }
}

TEST(DirectLoop, NumberOfThreadsChangesNoBit) {
  const PolygonMesh mesh = torus_mesh(100, 100);
  SubdivisionOptions options = levels(2);
  const PolygonMesh one = direct_loop(mesh, options);
  for (const unsigned threads : {2U, 3U, 7U}) {
    options.threads = threads;
    const PolygonMesh many = direct_loop(mesh, options);
    EXPECT_EQ(one.positions, many.positions) << threads << " threads";
    EXPECT_EQ(one.polygons, many.polygons) << threads << " threads";
  }
}

TEST(DirectLoop, ProgressRisesToOne) {
  SubdivisionOptions options = levels(3);
  double last = 0;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  direct_loop(torus_mesh(20, 10), options);
  EXPECT_NEAR(last, 1, 1e-12);
}

std::string refusal(const PolygonMesh& mesh, unsigned n_levels = 1) {
  try {
    direct_loop(mesh, levels(n_levels));
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(DirectLoop, WhatIsNoManifoldIsRefusedByName) {
  const auto invalid = [](const std::string& name) {
    return refusal(read_mesh(MESHGRADE_SOURCE_DIR "/meshes/invalid/" + name).mesh);
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(invalid("three_faces_on_an_edge.obj"), "edge from v0 to v1 has 3 faces"));
  EXPECT_TRUE(has(invalid("inconsistent_winding.obj"), "same direction by f0 and f3"));
  EXPECT_TRUE(has(invalid("moebius_strip.obj"), "same direction"));
  EXPECT_TRUE(has(invalid("bow_tie.obj"), "vertex v0 form more than one fan"));
  EXPECT_TRUE(has(invalid("closed_bow_tie.obj"), "vertex v0 form more than one fan"));
  const std::string tetrahedron = MESHGRADE_SOURCE_DIR "/meshes/tetrahedron.obj";
  PolygonMesh with_unused = read_mesh(tetrahedron).mesh;
  with_unused.positions.push_back({5, 5, 5});  // reading would leave it out
  EXPECT_TRUE(has(refusal(with_unused), "v4 belongs to no face"));
  const PolygonMesh cube = read_mesh(MESHGRADE_SOURCE_DIR "/meshes/quad_cube.dae").mesh;
  EXPECT_TRUE(has(refusal(cube), "face f0 has 4 corners"));
}

TEST(DirectLoop, TooManyLevelsAreRefusedBeforeTheyAreTried) {
  const PolygonMesh& mesh = triangle_mesh("tetrahedron.obj");
  EXPECT_NE(refusal(mesh, 15).find("15 levels of 4 faces"), std::string::npos);
  EXPECT_NE(refusal(mesh, 4000000000U).find("take fewer levels"), std::string::npos);
}

}  // namespace
}  // namespace meshgrade
