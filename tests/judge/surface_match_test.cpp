#include "grader/judge/surface_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "grader/base/random.h"
#include "grader/judge/operation_model.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

std::vector<Ref> all_halfedges(const MeshDump& mesh) {
  std::vector<Ref> list(mesh.halfedges.size());
  std::iota(list.begin(), list.end(), 0U);
  return list;
}

bool match(const MeshDump& a, const MeshDump& b, SurfaceMatch& result) {
  return match_surfaces(
      a, b, all_halfedges(a), [&](Ref) { return all_halfedges(b); }, result);
}
bool match(const MeshDump& a, const MeshDump& b) {
  SurfaceMatch result(a);
  return match(a, b, result);
}

/// The same surface with other numbers: polygons in another order, each begun at another
/// corner.
PolygonMesh renumbered(PolygonMesh mesh, Random& random) {
  for (std::size_t i = mesh.polygons.size(); i > 1; --i)
    std::swap(mesh.polygons[i - 1], mesh.polygons[random.below(static_cast<std::uint32_t>(i))]);
  for (auto& polygon : mesh.polygons)
    std::rotate(polygon.begin(), polygon.begin() + random.below(3), polygon.end());
  return in_build_order(mesh);
}

PolygonMesh mirrored(PolygonMesh mesh) {
  for (auto& polygon : mesh.polygons)
    std::reverse(polygon.begin(), polygon.end());
  return mesh;
}

TEST(SurfaceMatch, RenumberedMeshIsMappedWithAllItsRelations) {
  Random random(1, "renumber");
  for (const std::string& file : triangle_mesh_files()) {
    const PolygonMesh polygons = sample_polygons(file);
    const MeshDump a = dump_polygons(polygons);
    const MeshDump b = dump_polygons(renumbered(polygons, random));
    SurfaceMatch map(a);
    ASSERT_TRUE(match(a, b, map)) << file;
    for (Ref h = 0; h < a.halfedges.size(); ++h) {
      const HalfedgeRecord& mine = a.halfedges[h];
      const HalfedgeRecord& other = b.halfedges[map.halfedge[h]];
      EXPECT_EQ(map.halfedge[mine.next], other.next);
      EXPECT_EQ(map.halfedge[mine.twin], other.twin);
      EXPECT_EQ(map.vertex[mine.vertex], other.vertex);
      EXPECT_EQ(map.edge[mine.edge], other.edge);
    }
  }
}

TEST(SurfaceMatch, MirrorImageOfALopsidedSurfaceDoesNotMatch) {
  const PolygonMesh zoo = sample_polygons("valence_zoo.obj");
  EXPECT_TRUE(match(dump_polygons(zoo), dump_polygons(zoo)));
  EXPECT_FALSE(match(dump_polygons(zoo), dump_polygons(mirrored(zoo))));
}

TEST(SurfaceMatch, AnotherSurfaceWithTheSameCountsDoesNotMatch) {
  const MeshDump a = sample_dump("icosahedron.obj");
  MeshDump b = a;
  model_flip(b, 0);
  ASSERT_EQ(count(a), count(b));
  EXPECT_FALSE(match(a, b));
  EXPECT_FALSE(match(sample_dump("fan.obj"), sample_dump("octahedron.off")));
}

TEST(SurfaceMatch, ComponentsAreMatchedInAnyOrderAndEachOnlyOnce) {
  PolygonMesh two = sample_polygons("two_components.obj");
  const MeshDump a = dump_polygons(two);
  std::reverse(two.polygons.begin(), two.polygons.end());
  EXPECT_TRUE(match(a, dump_polygons(in_build_order(two))));

  // Two tetrahedra against two of them where both components may land on the first.
  const PolygonMesh tetrahedron = sample_polygons("tetrahedron.obj");
  PolygonMesh pair = tetrahedron;
  for (const auto& t : tetrahedron.polygons)
    pair.polygons.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  pair.positions.insert(pair.positions.end(), tetrahedron.positions.begin(),
                        tetrahedron.positions.end());
  const MeshDump b = dump_polygons(pair);
  const auto first_only = [](Ref) { return std::vector<Ref>{0}; };
  SurfaceMatch both_on_first(b);
  EXPECT_FALSE(match_surfaces(b, b, all_halfedges(b), first_only, both_on_first));
}

TEST(SurfaceMatch, InsideIsNotMatchedWithOutside) {
  const MeshDump mesh = sample_dump("single_triangle.obj");
  const Ref outside = mesh.boundaries[0].halfedge;
  const Ref inside = mesh.faces[0].halfedge;
  SurfaceMatch map(mesh);
  EXPECT_FALSE(match_component(mesh, mesh, inside, outside, map));
  EXPECT_TRUE(std::all_of(map.halfedge.begin(), map.halfedge.end(),
                          [](Ref h) { return h == kUnsetRef; }));
  EXPECT_TRUE(match_component(mesh, mesh, inside, inside, map));
}

}  // namespace
}  // namespace meshgrade
