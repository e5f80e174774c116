// The mesh of Scotty3D homework of Fall 2020 to Spring 2022: what is erased is marked, and goes
// later; then it is a mistake to use it.

#include <gtest/gtest.h>

#include "dropin_scotty3d/detail/mesh_bridge.h"
#include "dropin_scotty3d_2020/mesh_access.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"
#include "tests/dropin_scotty3d/expect_fault.h"

namespace meshgrade {
namespace {

using meshedit::FaultKind;
using Mesh = Halfedge_Mesh;
using Bridge = meshedit::detail::scotty3d::MeshBridge<meshedit::detail::scotty3d::MeshAccess>;

/// Two squares side by side.
PolygonMesh two_squares() {
  PolygonMesh mesh;
  for (double y : {0.0, 1.0}) {
    for (double x : {0.0, 1.0, 2.0})
      mesh.positions.push_back({x, y, 0.0});
  }
  mesh.polygons = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  return mesh;
}

/// The same as a mesh of the homework.
struct Squares {
  Squares() : bridge(built(ours), theirs) {}

  static meshedit::HalfedgeMesh& built(meshedit::HalfedgeMesh& mesh) {
    build_mesh(two_squares(), mesh);
    return mesh;
  }

  meshedit::HalfedgeMesh ours;
  Mesh theirs;
  Bridge bridge;
};

TEST(MarkedElements, BeginWithoutPointersAndWithNumbersOfOneCounter) {
  Mesh mesh;
  const Mesh::HalfedgeRef h = mesh.new_halfedge();
  const Mesh::FaceRef f = mesh.new_face(true);
  EXPECT_EQ(f->id(), h->id() + 1);
  EXPECT_TRUE(f->is_boundary());
  EXPECT_TRUE(h->next() == Mesh::HalfedgeRef());
  const auto fault = fault_of([&] { (void)h->next()->twin(); });
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->kind, FaultKind::kUnsetHandle);
}

TEST(MarkedElements, StayInTheirListsUntilTheyGo) {
  Squares squares;
  Mesh& mesh = squares.theirs;
  const Mesh::VertexRef v = mesh.vertices_begin();
  mesh.erase(v);
  mesh.erase(v);
  EXPECT_EQ(mesh.n_vertices(), 6U);
  EXPECT_EQ(v->pos, Vec3(0.0f, 0.0f, 0.0f));
  EXPECT_TRUE(v->halfedge()->vertex() == v);
  mesh.do_erase();
  EXPECT_EQ(mesh.n_vertices(), 5U);
}

TEST(MarkedElements, ThatWentAreNotUsed) {
  Squares squares;
  Mesh& mesh = squares.theirs;
  const Mesh::EdgeRef e = mesh.edges_begin();
  mesh.erase(e);
  mesh.do_erase();
  mesh.new_edge();
  const auto fault = fault_of([&] { (void)e->halfedge(); });
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->kind, FaultKind::kDeletedHandle);
}

TEST(MarkedElements, ThatLeadToNothingCannotBeMarked) {
  Mesh mesh;
  const auto fault = fault_of([&] { mesh.erase(Mesh::FaceRef()); });
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->kind, FaultKind::kUnsetHandle);
}

TEST(MarkedElements, GoWithAMeshThatIsRight) {
  Squares squares;
  Mesh& mesh = squares.theirs;
  mesh.erase(mesh.new_edge());
  EXPECT_FALSE(mesh.validate().has_value());
  EXPECT_EQ(mesh.n_edges(), 7U);
}

TEST(MarkedElements, ThatOthersLeadToAreToldAndStay) {
  Squares squares;
  Mesh& mesh = squares.theirs;
  mesh.erase(mesh.faces_begin());
  const auto broken = mesh.validate();
  ASSERT_TRUE(broken.has_value());
  EXPECT_EQ(broken->second, "a pointer of the half-edge leads to no live element");
  EXPECT_EQ(mesh.n_faces(), 3U);
}

TEST(MarkedElements, AreDeletedWhenAFunctionHasReturned) {
  Squares squares;
  squares.theirs.erase(squares.theirs.edges_begin());
  meshedit::detail::scotty3d::MeshAccess::finish(squares.theirs);
  squares.bridge.write_back();
  const MeshDump after = dump_mesh(squares.ours);
  EXPECT_EQ(after.edges[0].live, 0U);
  EXPECT_EQ(count(after).edges, 6U);
}

TEST(MeshOf2020, CountsTheFacesAtAVertexAsItsDegree) {
  Squares squares;
  for (Mesh::VertexRef v = squares.theirs.vertices_begin(); v != squares.theirs.vertices_end();
       ++v) {
    EXPECT_TRUE(v->on_boundary());
    EXPECT_EQ(v->degree(), v->pos.x == 1.0f ? 2U : 1U);
  }
  EXPECT_TRUE(squares.theirs.has_boundary());
  EXPECT_EQ(squares.theirs.n_boundaries(), 1U);
}

TEST(MeshOf2020, TakesNextBeforeTwin) {
  Squares squares;
  const Mesh::HalfedgeRef h = squares.theirs.halfedges_begin();
  const Mesh::HalfedgeRef next = h->next();
  const Mesh::HalfedgeRef twin = h->twin();
  h->set_neighbors(twin, next, h->vertex(), h->edge(), h->face());
  EXPECT_TRUE(h->next() == twin && h->twin() == next);
}

}  // namespace
}  // namespace meshgrade
