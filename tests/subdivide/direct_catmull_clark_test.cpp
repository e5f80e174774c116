#include "grader/subdivide/direct_catmull_clark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grader/base/errors.h"
#include "grader/subdivide/opensubdiv_level.h"
#include "tests/subdivide/comparison.h"
#include "tests/subdivide/course_meshes.h"

namespace meshgrade {
namespace {

SubdivisionOptions catmull_clark_levels(unsigned n,
                                        CornerRule corner_rule = CornerRule::kSmooth) {
  SubdivisionOptions options;
  options.levels = n;
  options.corner_rule = corner_rule;
  return options;
}

/// Two polygons of n corners, joined by n quadrilaterals that are bent.
PolygonMesh prism(std::uint32_t n) {
  PolygonMesh mesh;
  std::vector<std::uint32_t> bottom;
  std::vector<std::uint32_t> top;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.1 * i});
    mesh.positions.push_back({2.0 * std::cos(angle + 0.3), std::sin(angle), 2.0 - 0.2 * i});
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
    const std::uint32_t next = (i + 1) % n;
    mesh.polygons.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  mesh.polygons.push_back(bottom);
  mesh.polygons.push_back(top);
  return mesh;
}

/// A prism without its top and one side: open, with boundary vertices of one, two and three
/// faces.
PolygonMesh open_prism(std::uint32_t n) {
  PolygonMesh mesh = prism(n);
  mesh.polygons.pop_back();
  mesh.polygons.erase(mesh.polygons.begin());
  return mesh;
}

std::vector<NamedMesh> polygon_meshes() {
  std::vector<NamedMesh> all = triangle_meshes();
  all.push_back(
      {"quad_cube.dae", read_mesh(MESHGRADE_SOURCE_DIR "/meshes/quad_cube.dae").mesh});
  for (std::uint32_t n = 3; n <= 12; ++n) {
    all.push_back({"prism of " + std::to_string(n), prism(n)});
    all.push_back({"open prism of " + std::to_string(n), open_prism(n)});
  }
  PolygonMesh two = prism(5);
  const auto shift = static_cast<std::uint32_t>(two.positions.size());
  const PolygonMesh other = open_prism(7);
  for (const Point3& p : other.positions)
    two.positions.push_back({p[0] + 9.0, p[1], p[2]});
  for (std::vector<std::uint32_t> polygon : other.polygons) {
    for (std::uint32_t& v : polygon)
      v += shift;
    two.polygons.push_back(polygon);
  }
  all.push_back({"a closed and an open component", two});
  return all;
}

/// OpenSubdiv's vertex for each one that DirectCatmullClark makes: old ones, edges, faces.
std::vector<std::uint32_t> names_of_children(const PolygonMesh& old, const PolygonMesh& ours,
                                             const SubdivisionLevel& level) {
  const auto child_of_edge = children_of_edges(level);
  std::vector<std::uint32_t> names(ours.positions.size());
  std::copy(level.child_of_vertex.begin(), level.child_of_vertex.end(), names.begin());
  std::size_t corner = 0;
  for (std::size_t f = 0; f < old.polygons.size(); ++f) {
    const auto& polygon = old.polygons[f];
    for (std::size_t k = 0; k < polygon.size(); ++k, ++corner) {
      const std::uint32_t a = polygon[k];
      const std::uint32_t b = polygon[(k + 1) % polygon.size()];
      names[ours.polygons[corner][1]] = child_of_edge.at({std::min(a, b), std::max(a, b)});
      names[ours.polygons[corner][2]] = level.child_of_face[f];
    }
  }
  return names;
}

TEST(DirectCatmullClark, EqualsOpenSubdivOnEveryMeshRuleAndLevel) {
  for (const auto& [name, mesh] : polygon_meshes()) {
    for (const CornerRule corner_rule : {CornerRule::kSmooth, CornerRule::kCorner}) {
      PolygonMesh old = mesh;
      for (int level = 1; level <= 4 && old.polygons.size() < 5000; ++level) {
        SCOPED_TRACE(name + ", level " + std::to_string(level));
        const PolygonMesh ours =
            direct_catmull_clark(old, catmull_clark_levels(1, corner_rule));
        const SubdivisionLevel theirs = opensubdiv_catmull_clark(old, corner_rule);
        ASSERT_EQ(ours.positions.size(), theirs.mesh.positions.size());
        const auto names = names_of_children(old, ours, theirs);
        EXPECT_EQ(renamed_faces(ours, &names), renamed_faces(theirs.mesh, nullptr));
        expect_same_points(ours, theirs.mesh, names);
        old = ours;
      }
    }
  }
}

TEST(DirectCatmullClark, ManyLevelsAtOnceAreManyTimesOneLevel) {
  for (const auto& [name, mesh] : polygon_meshes()) {
    const PolygonMesh at_once =
        direct_catmull_clark(mesh, catmull_clark_levels(3, CornerRule::kCorner));
    PolygonMesh one_by_one = mesh;
    for (int level = 0; level < 3; ++level) {
      one_by_one =
          direct_catmull_clark(one_by_one, catmull_clark_levels(1, CornerRule::kCorner));
    }
    // Faces are numbered alike, vertices need not be.
    ASSERT_EQ(at_once.polygons.size(), one_by_one.polygons.size()) << name;
    const double tolerance = 1e-12 * largest_coordinate(mesh);
    for (std::size_t f = 0; f < at_once.polygons.size(); ++f) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Point3& a = at_once.positions[at_once.polygons[f][k]];
        const Point3& b = one_by_one.positions[one_by_one.polygons[f][k]];
        for (std::size_t axis = 0; axis < 3; ++axis)
          ASSERT_NEAR(a[axis], b[axis], tolerance) << name << ", face f" << f;
      }
    }
  }
}

TEST(DirectCatmullClark, CornersOfACubeMoveToFiveNinths) {
  const PolygonMesh cube = read_mesh(MESHGRADE_SOURCE_DIR "/meshes/quad_cube.dae").mesh;
  Point3 middle{};
  for (const Point3& p : cube.positions) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] += p[axis] / 8.0;
  }
  const PolygonMesh finer = direct_catmull_clark(cube, catmull_clark_levels(1));
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(finer.positions[v][axis] - middle[axis],
                  5.0 / 9.0 * (cube.positions[v][axis] - middle[axis]), 1e-15);
    }
  }
}

TEST(DirectCatmullClark, BoundaryOfASquareIsACubicSpline) {
  const PolygonMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  const PolygonMesh smooth = direct_catmull_clark(square, catmull_clark_levels(1));
  EXPECT_EQ(smooth.positions[0], (Point3{0.125, 0.125, 0}));
  EXPECT_EQ(smooth.positions[smooth.polygons[0][1]], (Point3{0.5, 0, 0}));
  EXPECT_EQ(smooth.positions[smooth.polygons[0][2]], (Point3{0.5, 0.5, 0}));
  const PolygonMesh corner =
      direct_catmull_clark(square, catmull_clark_levels(1, CornerRule::kCorner));
  EXPECT_EQ(corner.positions[0], square.positions[0]);
}

TEST(DirectCatmullClark, CountsGrowAsTheyMust) {
  for (const auto& [name, mesh] : polygon_meshes()) {
    DirectCatmullClark surface(mesh);
    const std::size_t announced = surface.n_faces_after(3);
    std::size_t n_corners = 0;
    for (const auto& polygon : mesh.polygons)
      n_corners += polygon.size();
    for (int level = 0; level < 3; ++level) {
      const std::size_t v = surface.n_vertices();
      const std::size_t e = surface.n_edges();
      const std::size_t f = surface.n_faces();
      surface.subdivide(catmull_clark_levels(1));
      EXPECT_EQ(surface.n_vertices(), v + e + f) << name;
      EXPECT_EQ(surface.n_edges(), 2 * e + n_corners) << name;
      EXPECT_EQ(surface.n_faces(), n_corners) << name;
      n_corners *= 4;
    }
    EXPECT_EQ(surface.n_faces(), announced) << name;
  }
}

TEST(DirectCatmullClark, NumberOfThreadsChangesNoBit) {
  SubdivisionOptions options = catmull_clark_levels(3);
  const PolygonMesh mesh = torus_mesh(40, 40);
  const PolygonMesh one = direct_catmull_clark(mesh, options);
  for (const unsigned threads : {2U, 5U}) {
    options.threads = threads;
    const PolygonMesh many = direct_catmull_clark(mesh, options);
    EXPECT_EQ(one.positions, many.positions) << threads << " threads";
    EXPECT_EQ(one.polygons, many.polygons) << threads << " threads";
  }
}

TEST(DirectCatmullClark, NoLevelGivesThePolygonsBack) {
  const PolygonMesh mesh = prism(7);
  const PolygonMesh same = direct_catmull_clark(mesh, catmull_clark_levels(0));
  EXPECT_EQ(same.positions, mesh.positions);
  EXPECT_EQ(same.polygons, mesh.polygons);
}

std::string why_not(const PolygonMesh& mesh, unsigned n_levels = 1) {
  try {
    direct_catmull_clark(mesh, catmull_clark_levels(n_levels));
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(DirectCatmullClark, WhatIsNoManifoldIsRefusedByName) {
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  PolygonMesh three = prism(4);
  three.positions.push_back({5, 5, 5});
  three.polygons.push_back({0, 2, 8});
  EXPECT_TRUE(has(why_not(three), "the edge from v0 to v2 has 3 faces (f0, f4, f6 ...)"))
      << why_not(three);
  PolygonMesh turned = prism(4);
  std::reverse(turned.polygons[1].begin(), turned.polygons[1].end());
  EXPECT_TRUE(has(why_not(turned), "is run in the same direction by f0 and f1"));
  PolygonMesh pinched = prism(4);
  pinched.polygons[4] = {0, 2, 4, 2};
  EXPECT_TRUE(has(why_not(pinched), "face f4 has a repeated or missing corner"));
  PolygonMesh thin = prism(4);
  thin.polygons[0] = {0, 2};
  EXPECT_TRUE(has(why_not(thin), "face f0 has fewer than three corners"));
  EXPECT_TRUE(has(why_not(prism(4), 15), "15 levels of 6 faces are more than the"));
}

}  // namespace
}  // namespace meshgrade
