#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <vector>

#include "faults.h"
#include "mesh_invariants.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

static_assert(std::is_convertible<HalfedgeIter, HalfedgeCIter>::value, "to const");
static_assert(std::is_convertible<VertexIter, VertexCIter>::value, "to const");
static_assert(std::is_convertible<EdgeIter, EdgeCIter>::value, "to const");
static_assert(std::is_convertible<FaceIter, FaceCIter>::value, "to const");
static_assert(!std::is_constructible<HalfedgeIter, HalfedgeCIter>::value, "not back");
static_assert(!std::is_constructible<VertexIter, VertexCIter>::value, "not back");
static_assert(!std::is_constructible<EdgeIter, EdgeCIter>::value, "not back");
static_assert(!std::is_constructible<FaceIter, FaceCIter>::value, "not back");
static_assert(!std::is_constructible<VertexIter, EdgeIter>::value, "kinds do not mix");
static_assert(!std::is_constructible<VertexIter, Vertex*>::value, "no handle from a pointer");
static_assert(
    std::is_same<decltype(std::declval<const Halfedge>().next()), HalfedgeCIter>::value,
    "a const element gives const handles, by value");
static_assert(std::is_same<decltype(std::declval<Halfedge&>().next()), HalfedgeIter&>::value,
              "any other gives access to the pointer itself");

class Handles : public FaultTest {};

TEST_F(Handles, UnsetHandleIsNoticedWithItsKind) {
  EXPECT_EQ(fault_of([] { HalfedgeIter()->next(); }),
            sentence(FaultKind::kUnsetHandle, "half-edge handle"));
  EXPECT_EQ(fault_of([] { VertexCIter()->isBoundary(); }),
            sentence(FaultKind::kUnsetHandle, "vertex handle"));
  EXPECT_EQ(fault_of([] { EdgeIter()->length(); }),
            sentence(FaultKind::kUnsetHandle, "edge handle"));
  EXPECT_EQ(fault_of([] { (*FaceIter()).degree(); }),
            sentence(FaultKind::kUnsetHandle, "face handle"));
  EXPECT_EQ(fault_of([] { ++EdgeIter(); }), sentence(FaultKind::kUnsetHandle, "edge handle"));
  EXPECT_EQ(fault_of([] { --EdgeIter(); }), sentence(FaultKind::kUnsetHandle, "edge handle"));
}

TEST_F(Handles, PointersOfNewElementsAreUnset) {
  HalfedgeMesh mesh;
  const HalfedgeIter h = mesh.newHalfedge();
  EXPECT_EQ(fault_of([&] { h->twin()->next(); }),
            sentence(FaultKind::kUnsetHandle, "half-edge handle"));
  EXPECT_EQ(fault_of([&] { h->isBoundary(); }),
            sentence(FaultKind::kUnsetHandle, "face handle"));
}

TEST_F(Handles, NewElementsBeginWithZeros) {
  HalfedgeMesh mesh;
  const VertexIter v = mesh.newVertex();
  EXPECT_FALSE(v->isNew);
  EXPECT_EQ(v->position.norm(), 0.0);
  EXPECT_EQ(v->newPosition.norm(), 0.0);
  const EdgeIter e = mesh.newEdge();
  EXPECT_FALSE(e->isNew);
  EXPECT_EQ(e->newPosition.norm(), 0.0);
  EXPECT_FALSE(mesh.newFace()->isBoundary());
  EXPECT_TRUE(mesh.newBoundary()->isBoundary());
}

TEST_F(Handles, DeletedElementIsNoticed) {
  HalfedgeMesh mesh = mesh_of(diamond());
  EdgeIter e = mesh.edgesBegin();
  EdgeIter copy = e;
  mesh.deleteEdge(e);
  const std::string expected = sentence(FaultKind::kDeletedHandle, "edge handle");
  EXPECT_EQ(fault_of([&] { copy->isNew = true; }), expected);
  EXPECT_EQ(fault_of([&] { ++copy; }), expected);
  EXPECT_EQ(fault_of([&] { --copy; }), expected);
  EXPECT_EQ(fault_of([&] { mesh.deleteEdge(e); }), expected);
}

TEST_F(Handles, DeletedElementIsNeverMistakenForALaterOne) {
  HalfedgeMesh mesh;
  const VertexIter old = mesh.newVertex();
  mesh.deleteVertex(old);
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(mesh.newVertex() != old);
  }
  EXPECT_EQ(fault_of([&] { old->position = 1; }),
            sentence(FaultKind::kDeletedHandle, "vertex handle"));
}

TEST_F(Handles, EndIsNoElement) {
  HalfedgeMesh mesh = mesh_of(diamond());
  const std::string expected = sentence(FaultKind::kPastEndHandle, "face handle");
  EXPECT_EQ(fault_of([&] { mesh.facesEnd()->degree(); }), expected);
  EXPECT_EQ(fault_of([&] { ++mesh.facesEnd(); }), expected);
  EXPECT_EQ(fault_of([&] { mesh.deleteFace(mesh.facesEnd()); }), expected);
}

TEST_F(Handles, NothingIsBeforeTheFirst) {
  HalfedgeMesh mesh = mesh_of(diamond());
  VertexIter v = mesh.verticesBegin();
  EXPECT_EQ(fault_of([&] { --v; }), sentence(FaultKind::kPastEndHandle, "vertex handle"));
  EXPECT_TRUE(v == mesh.verticesBegin());
  HalfedgeMesh empty;
  EXPECT_EQ(fault_of([&] { --empty.verticesEnd(); }),
            sentence(FaultKind::kPastEndHandle, "vertex handle"));
}

TEST_F(Handles, ElementsOfAnotherMeshAreNoticed) {
  HalfedgeMesh mesh = mesh_of(diamond());
  HalfedgeMesh other = mesh_of(diamond());
  EXPECT_EQ(fault_of([&] { mesh.deleteEdge(other.edgesBegin()); }),
            sentence(FaultKind::kForeignHandle, "edge handle"));
  EXPECT_EQ(mesh.nEdges(), 5U);
  EXPECT_EQ(other.nEdges(), 5U);

  const HalfedgeIter h = mesh.newHalfedge();
  const HalfedgeIter own = mesh.halfedgesBegin();
  EXPECT_EQ(fault_of([&] {
              h->setNeighbors(own, own, other.verticesBegin(), own->edge(), own->face());
            }),
            sentence(FaultKind::kForeignHandle, "vertex handle"));
  EXPECT_EQ(fault_of([&] {
              h->setNeighbors(own, own, own->vertex(), own->edge(), own->face());
              h->setNeighbors({}, {}, {}, {}, {});
            }),
            "");
}

TEST_F(Handles, SetNeighborsTakesNextTwinVertexEdgeFace) {
  HalfedgeMesh mesh;
  const HalfedgeIter h = mesh.newHalfedge();
  const HalfedgeIter next = mesh.newHalfedge();
  const HalfedgeIter twin = mesh.newHalfedge();
  const VertexIter v = mesh.newVertex();
  const EdgeIter e = mesh.newEdge();
  const FaceIter f = mesh.newFace();
  h->setNeighbors(next, twin, v, e, f);
  EXPECT_TRUE(h->next() == next);
  EXPECT_TRUE(h->twin() == twin);
  EXPECT_TRUE(h->vertex() == v);
  EXPECT_TRUE(h->edge() == e);
  EXPECT_TRUE(h->face() == f);
}

TEST_F(Handles, ComparingIsNoFaultWhateverTheyPointTo) {
  HalfedgeMesh mesh = mesh_of(diamond());
  const EdgeIter first = mesh.edgesBegin();
  const EdgeIter deleted = std::next(first);
  mesh.deleteEdge(deleted);
  EXPECT_EQ(fault_of([&] {
              EXPECT_TRUE(EdgeIter() == EdgeIter());
              EXPECT_TRUE(EdgeIter() == EdgeCIter());
              EXPECT_TRUE(EdgeIter() != first);
              EXPECT_TRUE(EdgeCIter(first) == first);
              EXPECT_TRUE(deleted != first);
              EXPECT_TRUE(first < deleted);
              EXPECT_TRUE(deleted < mesh.edgesEnd());
              EXPECT_TRUE(EdgeIter() < first);
              EXPECT_FALSE(EdgeIter() < EdgeCIter());
              EXPECT_TRUE(first <= first && first >= first && !(first > first));
            }),
            "");
}

TEST_F(Handles, ConstHandlesSeeTheSameElements) {
  HalfedgeMesh mesh = mesh_of(diamond());
  const HalfedgeMesh& read_only = mesh;
  EXPECT_TRUE(mesh.verticesBegin() == read_only.verticesBegin());
  EXPECT_TRUE(mesh.verticesEnd() == read_only.verticesEnd());
  const VertexCIter v = mesh.verticesBegin();
  EXPECT_EQ(elementAddress(v), elementAddress(mesh.verticesBegin()));
  EXPECT_EQ(elementAddress(VertexIter()), nullptr);
}

TEST_F(Handles, StepForwardAndBackGiveTheSameElements) {
  HalfedgeMesh mesh = mesh_of(torus(6, 5));
  std::vector<EdgeIter> forward;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++) {
    forward.push_back(e);
  }
  ASSERT_EQ(forward.size(), mesh.nEdges());
  EdgeIter e = mesh.edgesEnd();
  for (std::size_t i = forward.size(); i-- > 0;) {
    EXPECT_TRUE(--e == forward[i]);
  }
  EXPECT_TRUE(e == mesh.edgesBegin());
  EXPECT_TRUE(e++ == forward[0]);
  EXPECT_TRUE(e-- == forward[1]);
}

TEST_F(Handles, WorkWithTheStandardLibrary) {
  HalfedgeMesh mesh = mesh_of(octahedron());
  EXPECT_EQ(std::distance(mesh.edgesBegin(), mesh.edgesEnd()), 12);
  EXPECT_TRUE(std::next(mesh.edgesBegin(), 12) == mesh.edgesEnd());
  EXPECT_TRUE(std::prev(mesh.edgesEnd(), 12) == mesh.edgesBegin());
  const auto old = std::count_if(mesh.verticesBegin(), mesh.verticesEnd(),
                                 [](const Vertex& v) { return !v.isNew; });
  EXPECT_EQ(old, 6);
}

TEST_F(Handles, SetsAreInTheOrderOfTheList) {
  HalfedgeMesh mesh = mesh_of(sheet(9, 9));
  std::set<VertexIter> set;
  std::map<VertexCIter, Index> numbers;
  std::vector<VertexIter> list;
  for (VertexIter v = mesh.verticesEnd(); v != mesh.verticesBegin();) {
    --v;
    set.insert(v);
    numbers[v] = number_of(mesh, v);
    list.insert(list.begin(), v);
  }
  EXPECT_EQ(set.size(), mesh.nVertices());
  EXPECT_TRUE(std::equal(set.begin(), set.end(), list.begin(), list.end()));
  Index expected = 0;
  for (const auto& entry : numbers) {
    EXPECT_EQ(entry.second, expected++);
  }
}

TEST_F(Handles, SetsTellBoundaryLoopsFromFaces) {
  HalfedgeMesh mesh = mesh_of(sheet(2, 2));
  std::set<FaceIter> set;
  std::map<FaceCIter, bool> is_boundary;
  for (HalfedgeIter h = mesh.halfedgesBegin(); h != mesh.halfedgesEnd(); ++h) {
    set.insert(h->face());
    is_boundary[h->face()] = h->isBoundary();
  }
  EXPECT_EQ(set.size(), mesh.nFaces() + mesh.nBoundaries());
  for (const auto& [face, outside] : is_boundary)
    EXPECT_EQ(face->isBoundary(), outside);
  EXPECT_TRUE(mesh.facesBegin() < mesh.boundariesBegin());
  // A deleted loop keeps its place in the order.
  const FaceIter loop = mesh.boundariesBegin();
  mesh.deleteBoundary(loop);
  EXPECT_EQ(set.count(loop), 1U);
  EXPECT_EQ(set.count(mesh.facesBegin()), 1U);
}

TEST_F(Handles, ReferenceRewiresAndCopyDoesNot) {
  HalfedgeMesh mesh = mesh_of(diamond());
  const HalfedgeIter h = mesh.halfedgesBegin();
  const HalfedgeIter next = h->next();
  HalfedgeIter copy = h->next();
  copy = h;
  EXPECT_TRUE(h->next() == next);
  HalfedgeIter& reference = h->next();
  reference = h;
  EXPECT_TRUE(h->next() == h);
}

TEST_F(Handles, StubSaysWhichFunctionIsMissing) {
  EXPECT_EQ(fault_of([] { notImplemented("Vertex::normal"); }),
            "Vertex::normal is not implemented yet");
}

TEST(Faults, StopTheProgramWhereNobodyHandlesThem) {
  EXPECT_DEATH(VertexIter()->degree(), "meshedit: vertex handle was never set");
}

}  // namespace
}  // namespace meshedit
