// The names of the course's element classes that homework uses, each as docs/dropin.md lists
// them. This file is written as homework is.

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <sstream>

#include "dropin/course.h"
#include "dropin/mutablePriorityQueue.h"

namespace CGL {

EdgeRecord::EdgeRecord(EdgeIter& of) : edge(of), score(of->length()) {}

void Vertex::computeCentroid() {
  HalfedgeIter h = _halfedge;
  centroid = Vector3D();
  do {
    centroid += h->twin()->vertex()->position / (double)degree();
    h = h->twin()->next();
  } while (h != _halfedge);
}

Vector3D Vertex::normal(void) const {
  Vector3D sum;
  HalfedgeCIter h = _halfedge;
  do {
    if (!h->face()->isBoundary()) sum += h->face()->normal();
    h = h->twin()->next();
  } while (h != _halfedge);
  return sum.unit();
}

// Not a flip: it goes to the lists themselves.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  edges.push_back(Edge());
  list<Edge>::iterator e = edges.insert(edges.end(), Edge());
  faces.emplace_back(true);
  halfedges.insert(halfedges.end(), Halfedge());
  vertices.push_back(Vertex());
  for (Edge& each : edges)
    each.isNew = true;
  edges.erase(e0);
  return e;
}

}  // namespace CGL

namespace {

using namespace CGL;

void make_tetrahedron(HalfedgeMesh& mesh) {
  mesh.build({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
             {Vector3D(0, 0, 0), Vector3D(1, 0, 0), Vector3D(0, 1, 0), Vector3D(0, 0, 1)});
}

class CourseApi : public testing::Test {
 protected:
  CourseApi() { make_tetrahedron(mesh); }

  HalfedgeMesh mesh;
};

TEST_F(CourseApi, ListIteratorsAreTheHandles) {
  list<Vertex>::iterator v = mesh.verticesBegin();
  std::list<Edge>::iterator e = mesh.edgesBegin();
  std::list<Halfedge>::iterator h = e->halfedge();
  std::list<Face>::const_iterator f = mesh.facesBegin();
  list<Vertex>::const_iterator cv = v;
  EXPECT_TRUE(cv == v);
  EXPECT_TRUE(h->edge() == e);
  EXPECT_FALSE(f->isBoundary());
  EXPECT_EQ(std::distance(mesh.edgesBegin(), mesh.edgesEnd()), 6);
  EXPECT_TRUE(std::next(e) == ++mesh.edgesBegin());
}

TEST_F(CourseApi, ListsOfElementsKeepCopies) {
  list<Vertex> copies;
  for (VertexIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++)
    copies.push_back(*v);
  EXPECT_EQ(copies.size(), 4U);
  EXPECT_EQ(copies.back().position.z, 1.0);
  list<EdgeIter> handles(3, mesh.edgesBegin());
  EXPECT_EQ(handles.size(), 3U);
}

TEST_F(CourseApi, ElementsTellWhatTheyAre) {
  EdgeIter e = mesh.edgesBegin();
  HalfedgeElement* element = elementAddress(e);
  EXPECT_EQ(element->getEdge(), &*e);
  EXPECT_EQ(element->getVertex(), nullptr);
  EXPECT_EQ(element->getFace(), nullptr);
  EXPECT_EQ(element->getHalfedge(), nullptr);
  EXPECT_EQ(e->halfedge()->getHalfedge(), &*e->halfedge());
  EXPECT_EQ(e->halfedge()->vertex()->getVertex(), &*e->halfedge()->vertex());
  EXPECT_EQ(e->halfedge()->face()->getFace(), &*e->halfedge()->face());
}

TEST_F(CourseApi, ElementAddressIsAPointerToTheElement) {
  VertexIter v = mesh.verticesBegin();
  Vertex* vertex = elementAddress(v);
  const Vertex* constant = elementAddress(VertexCIter(v));
  EXPECT_EQ(vertex, constant);
  vertex->position = Vector3D(7);
  EXPECT_EQ(v->position.x, 7.0);
}

TEST_F(CourseApi, HandlesOfOneKindAreOrdered) {
  set<EdgeIter> edges;
  map<VertexCIter, int> numbers;
  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); e++)
    edges.insert(e);
  for (VertexCIter v = mesh.verticesBegin(); v != mesh.verticesEnd(); v++)
    numbers[v] = 1;
  EXPECT_EQ(edges.size(), 6U);
  EXPECT_EQ(numbers.size(), 4U);
}

TEST_F(CourseApi, EdgeRecordsAreMadeOfEdgesAndOrderedByScore) {
  EdgeIter e = mesh.edgesBegin();
  e->record = EdgeRecord(e);
  EdgeRecord other;
  other.edge = e;
  other.score = e->record.score - 1.0;
  EXPECT_TRUE(e->record.edge == e);
  EXPECT_TRUE(other < e->record);
  MutablePriorityQueue<EdgeRecord> queue;
  queue.insert(e->record);
  queue.insert(other);
  EXPECT_EQ(queue.top().score, other.score);
}

TEST_F(CourseApi, HalfedgesHaveTheirNeighbours) {
  HalfedgeIter h = mesh.halfedgesBegin();
  HalfedgeIter n = h->next(), t = h->twin();
  VertexIter v = h->vertex();
  EdgeIter e = h->edge();
  FaceIter f = h->face();
  h->setNeighbors(n, t, v, e, f);
  EXPECT_TRUE(h->next() == n && h->twin() == t && h->vertex() == v && h->edge() == e &&
              h->face() == f);
  EXPECT_FALSE(h->isBoundary());
  HalfedgeCIter constant = h;
  EXPECT_TRUE(constant->twin()->twin() == h);
}

TEST_F(CourseApi, VerticesHaveTheirMembers) {
  VertexIter v = mesh.verticesBegin();
  v->isNew = false;
  v->newPosition = v->position;
  v->computeCentroid();
  EXPECT_NEAR(v->centroid.x, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(v->degree(), 3U);
  EXPECT_FALSE(v->isBoundary());
  EXPECT_NEAR(v->normal().norm(), 1.0, 1e-12);
  EXPECT_TRUE(v->halfedge()->vertex() == v);
}

TEST_F(CourseApi, EdgesHaveTheirMembers) {
  EdgeIter e = mesh.edgesBegin();
  e->isNew = true;
  e->newPosition = Vector3D(1, 2, 3);
  EXPECT_FALSE(e->isBoundary());
  EXPECT_GT(e->length(), 0.9);
  EXPECT_TRUE(e->halfedge()->edge() == e);
  Edge loose;
  EXPECT_FALSE(loose.isNew);
}

TEST_F(CourseApi, FacesHaveTheirMembers) {
  FaceIter f = mesh.facesBegin();
  EXPECT_EQ(f->degree(), 3U);
  EXPECT_FALSE(f->isBoundary());
  EXPECT_NEAR(f->normal().norm(), 1.0, 1e-12);
  EXPECT_TRUE(Face(true).isBoundary());
}

TEST_F(CourseApi, MeshesCountBeginAndEnd) {
  EXPECT_EQ(mesh.nHalfedges(), 12U);
  EXPECT_EQ(mesh.nVertices(), 4U);
  EXPECT_EQ(mesh.nEdges(), 6U);
  EXPECT_EQ(mesh.nFaces(), 4U);
  EXPECT_EQ(mesh.nBoundaries(), 0U);
  EXPECT_TRUE(mesh.boundariesBegin() == mesh.boundariesEnd());
  Size n = 0;
  for (HalfedgeIter h = mesh.halfedgesBegin(); h != mesh.halfedgesEnd(); h++)
    n++;
  for (FaceIter f = mesh.facesBegin(); f != mesh.facesEnd(); f++)
    n++;
  EXPECT_EQ(n, 16U);
}

TEST_F(CourseApi, MeshesMakeAndDeleteElements) {
  mesh.deleteHalfedge(mesh.newHalfedge());
  mesh.deleteVertex(mesh.newVertex());
  mesh.deleteEdge(mesh.newEdge());
  mesh.deleteFace(mesh.newFace());
  mesh.deleteBoundary(mesh.newBoundary());
  EXPECT_EQ(mesh.nEdges(), 6U);
}

TEST_F(CourseApi, MeshesAreCopiedDeeply) {
  HalfedgeMesh copy(mesh);
  HalfedgeMesh assigned;
  assigned = mesh;
  copy.verticesBegin()->position = Vector3D(9);
  EXPECT_EQ(mesh.verticesBegin()->position.x, 0.0);
  EXPECT_EQ(assigned.nEdges(), 6U);
}

TEST_F(CourseApi, ListsOfAMeshAreOpenToItsFunctions) {
  EdgeIter added = mesh.flipEdge(mesh.edgesBegin());
  EXPECT_EQ(mesh.nEdges(), 7U);
  EXPECT_EQ(mesh.nHalfedges(), 13U);
  EXPECT_EQ(mesh.nVertices(), 5U);
  EXPECT_EQ(mesh.nFaces(), 5U);
  EXPECT_TRUE(added == --mesh.edgesEnd());
  EXPECT_TRUE(added->isNew);
  EXPECT_EQ(added->getEdge(), &*added);
}

TEST(CourseMatrices, InvertWhatTheyMultiply) {
  Matrix3x3 a(2, 1, 0, 0, 3, 1, 1, 0, 4);
  EXPECT_NEAR(a.det(), 25.0, 1e-12);
  const Vector3D x(1, -2, 3);
  EXPECT_NEAR((a.inv() * (a * x) - x).norm(), 0.0, 1e-12);
  EXPECT_NEAR((a * a.inv() - Matrix3x3::identity()).norm(), 0.0, 1e-12);
  EXPECT_EQ(a.T()(0, 2), a(2, 0));
  EXPECT_EQ(a[2].y, a(1, 2));
  const Matrix4x4 b = Matrix4x4::identity() * 5.0 - outer(Vector4D(1, 0, 0, 1), Vector4D(1.0));
  EXPECT_NEAR((b.inv() * (b * Vector4D(1, 2, 3, 4)) - Vector4D(1, 2, 3, 4)).norm(), 0.0, 1e-12);
}

TEST(CourseMatrices, BeginAsTheCoursesDo) {
  EXPECT_EQ((Matrix3x3() - Matrix3x3::identity()).norm(), 0.0);
  EXPECT_EQ(Matrix4x4().norm(), 0.0);
  Matrix4x4 quadric;
  quadric += outer(Vector4D(1, 2, 3, 4), Vector4D(1, 2, 3, 4));
  quadric /= 2;
  EXPECT_EQ(quadric(1, 3), 4.0);
  EXPECT_EQ((-quadric)(1, 3), -4.0);
  EXPECT_EQ((3.0 * quadric).column(3)[1], 12.0);
}

TEST(CourseMatrices, CrossProductsAreMatrices) {
  const Vector3D u(1, 2, 3), v(-2, 0, 5);
  EXPECT_EQ((Matrix3x3::crossProduct(u) * v - cross(u, v)).norm(), 0.0);
  EXPECT_EQ(outer(u, v)(2, 0), -6.0);
}

TEST(CourseVectors, OfFourComponents) {
  Vector4D v(Vector3D(2, 4, 6), 2.0);
  EXPECT_EQ(v.projectTo3D().z, 3.0);
  EXPECT_EQ(v.to3D().z, 6.0);
  EXPECT_EQ(dot(v, Vector4D(1, 1, 1)), 12.0);
  v /= 2;
  EXPECT_EQ(v[3], 1.0);
  v.normalize();
  EXPECT_NEAR(v.norm(), 1.0, 1e-12);
}

TEST(CourseColors, AddAndScale) {
  Color c = Color(1, 0.5F, 0) + 0.5F * Color::White;
  EXPECT_EQ(c.r, 1.5F);
  EXPECT_TRUE(Color() == Color::Black);
  std::ostringstream text;
  text << c << Matrix3x3() << Vector4D();
  EXPECT_FALSE(text.str().empty());
}

}  // namespace
