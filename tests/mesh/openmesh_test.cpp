// OpenMesh as a second opinion on what a manifold is, and on flips and splits.

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "grader/base/random.h"
#include "grader/judge/operation_model.h"
#include "grader/mesh/mesh_rules.h"
#include "tests/support/openmesh.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

using Triangle = std::array<Ref, 3>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<>;

Triangle turned(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::set<Triangle> triangles(const MeshDump& mesh) {
  std::set<Triangle> result;
  for (const FaceRecord& f : mesh.faces) {
    if (f.live == 0) continue;
    const HalfedgeRecord& x = mesh.halfedges[f.halfedge];
    const HalfedgeRecord& y = mesh.halfedges[x.next];
    result.insert(turned({x.vertex, y.vertex, mesh.halfedges[y.next].vertex}));
  }
  return result;
}

std::set<Triangle> triangles(const TriMesh& mesh) {
  std::set<Triangle> result;
  for (const auto face : mesh.faces()) {
    Triangle t{};
    std::size_t i = 0;
    for (const auto v : mesh.fv_range(face))
      t.at(i++) = static_cast<Ref>(v.idx());
    result.insert(turned(t));
  }
  return result;
}

TriMesh to_openmesh(const MeshDump& dump) {
  std::vector<Point3> positions;
  for (const VertexRecord& v : dump.vertices)
    positions.push_back(v.position);
  auto mesh = openmesh_with_vertices<TriMesh>(positions);
  for (const Triangle& t : triangles(dump)) {
    const auto handle = [&](std::size_t i) { return mesh.vertex_handle(t.at(i)); };
    EXPECT_TRUE(mesh.add_face(handle(0), handle(1), handle(2)).is_valid());
  }
  return mesh;
}

OpenMesh::EdgeHandle find_edge(const TriMesh& mesh, Ref a, Ref b) {
  return mesh.edge_handle(mesh.find_halfedge(mesh.vertex_handle(a), mesh.vertex_handle(b)));
}

std::pair<Ref, Ref> ends(const MeshDump& mesh, Ref edge) {
  const HalfedgeRecord& h = mesh.halfedges[mesh.edges[edge].halfedge];
  return {h.vertex, mesh.halfedges[h.twin].vertex};
}

void expect_same_surface(const MeshDump& ours, const TriMesh& theirs,
                         const std::string& where) {
  EXPECT_EQ(triangles(ours), triangles(theirs)) << where;
  const Counts counts = count(ours);
  EXPECT_EQ(counts.vertices, theirs.n_vertices()) << where;
  EXPECT_EQ(counts.edges, theirs.n_edges()) << where;
  EXPECT_EQ(counts.faces, theirs.n_faces()) << where;
}

TEST(OpenMeshAgrees, OnWhatIsAManifoldAndWhereItsBoundaryLies) {
  for (const std::string& file : triangle_mesh_files()) {
    const MeshDump dump = sample_dump(file);
    const TriMesh mesh = to_openmesh(dump);
    expect_same_surface(dump, mesh, file);
    for (const auto v : mesh.vertices())
      EXPECT_TRUE(mesh.is_manifold(v)) << file;
    for (Ref e = 0; e < dump.edges.size(); ++e) {
      const auto [a, b] = ends(dump, e);
      EXPECT_EQ(is_boundary_edge(dump, e), mesh.is_boundary(find_edge(mesh, a, b))) << file;
    }
  }
}

TEST(OpenMeshAgrees, OnEveryEdgeThatMayBeFlipped) {
  for (const std::string& file : triangle_mesh_files()) {
    const MeshDump dump = sample_dump(file);
    TriMesh mesh = to_openmesh(dump);
    const TriangleSet set(sample_polygons(file));
    for (Ref e = 0; e < dump.edges.size(); ++e) {
      const auto [a, b] = ends(dump, e);
      EXPECT_EQ(set.can_flip(std::minmax(a, b)), mesh.is_flip_ok(find_edge(mesh, a, b)))
          << file << " " << edge_name(e);
    }
  }
}

TEST(OpenMeshAgrees, OnRandomFlips) {
  Random random(7, "flips");
  for (const char* file : {"octahedron.off", "icosahedron.obj", "torus.ply", "grid_4x4.obj",
                           "valence_zoo.obj", "double_torus.obj"}) {
    MeshDump dump = sample_dump(file);
    TriMesh mesh = to_openmesh(dump);
    int flips = 0;
    for (int i = 0; i < 200; ++i) {
      const Ref e = random.below(static_cast<std::uint32_t>(dump.edges.size()));
      const auto [a, b] = ends(dump, e);
      const auto theirs = find_edge(mesh, a, b);
      ASSERT_TRUE(theirs.is_valid());
      if (!mesh.is_flip_ok(theirs)) continue;
      mesh.flip(theirs);
      model_flip(dump, e);
      ++flips;
      ASSERT_EQ(triangles(dump), triangles(mesh)) << file;
      ASSERT_TRUE(find_broken_rules(dump).empty()) << file;
    }
    EXPECT_GT(flips, 20) << file;
  }
}

TEST(OpenMeshAgrees, OnRandomSplitsInsideAndOnTheBoundary) {
  Random random(8, "splits");
  for (const char* file : {"tetrahedron.obj", "single_triangle.obj", "grid_4x4.obj",
                           "cylinder.dae", "double_torus.obj"}) {
    MeshDump dump = sample_dump(file);
    TriMesh mesh = to_openmesh(dump);
    for (int i = 0; i < 40; ++i) {
      const Ref e = random.below(static_cast<std::uint32_t>(dump.edges.size()));
      const auto [a, b] = ends(dump, e);
      const auto theirs = find_edge(mesh, a, b);
      ASSERT_TRUE(theirs.is_valid());
      const auto v = mesh.add_vertex(mesh.calc_edge_midpoint(theirs));
      mesh.split(theirs, v);
      const Ref m = model_split(dump, e);
      ASSERT_EQ(m, static_cast<Ref>(v.idx()));
      expect_same_surface(dump, mesh, file);
      ASSERT_TRUE(find_broken_rules(dump).empty()) << file;
    }
  }
}

}  // namespace
}  // namespace meshgrade
