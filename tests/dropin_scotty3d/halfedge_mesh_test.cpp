// The mesh of Scotty3D homework: what the course's lists and elements do, and what files of
// students rely on.

#include "dropin_scotty3d/geometry/halfedge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/dropin_scotty3d/expect_fault.h"

namespace meshgrade {
namespace {

using meshedit::FaultKind;
using Mesh = Halfedge_Mesh;

constexpr Mesh::Index kErased = 0x80000000U;

std::optional<FaultKind> kind_of(const std::optional<meshedit::Fault>& fault) {
  if (!fault) return std::nullopt;
  return fault->kind;
}

TEST(Scotty3dElements, BeginWithPointersAtTheEndAndNumbersOfOneCounter) {
  Mesh mesh;
  const Mesh::VertexRef v = mesh.emplace_vertex();
  const Mesh::EdgeRef e = mesh.emplace_edge(true);
  const Mesh::FaceRef f = mesh.emplace_face(true);
  const Mesh::HalfedgeRef h = mesh.emplace_halfedge();
  EXPECT_EQ(v->id, 0U);
  EXPECT_EQ(e->id, 1U);
  EXPECT_EQ(f->id, 2U);
  EXPECT_EQ(h->id, 3U);
  EXPECT_TRUE(e->sharp);
  EXPECT_TRUE(f->boundary);
  EXPECT_EQ(v->position, Vec3(0.0f, 0.0f, 0.0f));
  EXPECT_TRUE(v->halfedge == mesh.halfedges.end());
  EXPECT_TRUE(e->halfedge == mesh.halfedges.end());
  EXPECT_TRUE(f->halfedge == mesh.halfedges.end());
  EXPECT_TRUE(h->twin == mesh.halfedges.end() && h->next == mesh.halfedges.end());
  EXPECT_TRUE(h->vertex == mesh.vertices.end());
  EXPECT_TRUE(h->edge == mesh.edges.end());
  EXPECT_TRUE(h->face == mesh.faces.end());
}

TEST(Scotty3dElements, ComeAtTheEndOfTheirList) {
  Mesh mesh;
  const Mesh::FaceRef first = mesh.emplace_face();
  const Mesh::FaceRef second = mesh.emplace_face();
  EXPECT_TRUE(mesh.faces.begin() == first);
  EXPECT_TRUE(std::next(first) == second);
  EXPECT_TRUE(std::prev(mesh.faces.end()) == second);
  EXPECT_EQ(mesh.faces.size(), 2U);
  EXPECT_EQ(std::distance(mesh.faces.begin(), mesh.faces.end()), 2);
  EXPECT_EQ(&mesh.faces.back(), &*second);
}

TEST(Scotty3dErasing, LeavesTheElementReadableAndWritable) {
  Mesh mesh = Mesh::cube(1.0f);
  const Mesh::VertexRef v = mesh.vertices.begin();
  const Mesh::Index id = v->id;
  mesh.erase_vertex(v);
  EXPECT_EQ(v->id, id | kErased);
  EXPECT_TRUE(std::isnan(v->position.x));
  EXPECT_TRUE(v->halfedge == mesh.halfedges.end());
  v->position = Vec3(1.0f, 2.0f, 3.0f);
  EXPECT_EQ(v->position.z, 3.0f);
  EXPECT_EQ(mesh.vertices.size(), 7U);
  const Mesh::HalfedgeRef h = mesh.halfedges.begin();
  mesh.erase_halfedge(h);
  EXPECT_TRUE(h->next == mesh.halfedges.end() && h->face == mesh.faces.end());
  EXPECT_TRUE(std::isnan(h->corner_uv.x) && std::isnan(h->corner_normal.y));
}

TEST(Scotty3dErasing, GivesTheOldestFreePlaceToTheNextNewElement) {
  Mesh mesh;
  const Mesh::EdgeRef a = mesh.emplace_edge();
  const Mesh::EdgeRef b = mesh.emplace_edge();
  mesh.erase_edge(b);
  mesh.erase_edge(a);
  const Mesh::EdgeRef c = mesh.emplace_edge(true);
  EXPECT_TRUE(c == b);
  EXPECT_EQ(c->id, 2U);
  EXPECT_TRUE(b->sharp);
  const Mesh::EdgeRef d = mesh.emplace_edge();
  EXPECT_TRUE(d == a);
  EXPECT_EQ(d->id, 3U);
  EXPECT_FALSE(d->sharp);
  EXPECT_TRUE(std::next(c) == d);
}

TEST(Scotty3dErasing, TwiceIsErasingOnce) {
  Mesh mesh;
  const Mesh::FaceRef f = mesh.emplace_face();
  mesh.emplace_face();
  mesh.erase_face(f);
  mesh.erase_face(f);
  EXPECT_EQ(mesh.faces.size(), 1U);
}

TEST(Scotty3dErasing, LetsAStaleReferenceWalkOnAmongTheFreeElements) {
  Mesh mesh;
  const Mesh::VertexRef a = mesh.emplace_vertex();
  const Mesh::VertexRef b = mesh.emplace_vertex();
  mesh.emplace_vertex();
  mesh.erase_vertex(a);
  mesh.erase_vertex(b);
  Mesh::VertexRef v = a;
  ++v;
  EXPECT_TRUE(v == b);
  ++v;
  EXPECT_FALSE(v == mesh.vertices.end());
  EXPECT_EQ(kind_of(fault_of([&] { ++v; })), FaultKind::kEndReference);
}

TEST(Scotty3dErasing, InALoopThatHasTheNextOneAlreadyIsFine) {
  Mesh mesh = Mesh::cube(1.0f);
  std::size_t visited = 0;
  for (Mesh::EdgeRef e = mesh.edges.begin(); e != mesh.edges.end();) {
    const Mesh::EdgeRef erased = e++;
    if (visited++ % 2 == 0) mesh.erase_edge(erased);
  }
  EXPECT_EQ(visited, 12U);
  EXPECT_EQ(mesh.edges.size(), 6U);
}

TEST(Scotty3dReferences, ThatLeadNowhereAreAFaultWhenUsed) {
  Mesh mesh;
  const Mesh::FaceRef unset;
  EXPECT_EQ(kind_of(fault_of([&] { unset->boundary = true; })), FaultKind::kUnsetHandle);
  const Mesh::HalfedgeRef h = mesh.emplace_halfedge();
  const auto fault = fault_of([&] { h->twin->next = h; });
  EXPECT_EQ(kind_of(fault), FaultKind::kEndReference);
  EXPECT_STREQ(fault->subject, "half-edge reference (HalfedgeRef)");
  EXPECT_EQ(kind_of(fault_of([&] { mesh.erase_edge(mesh.edges.end()); })),
            FaultKind::kEndReference);
  EXPECT_EQ(kind_of(fault_of([&] { --mesh.edges.begin(); })), FaultKind::kEndReference);
}

TEST(Scotty3dReferences, UseUpTheStepsOfAnEndlessWalk) {
  Mesh mesh = Mesh::cube(1.0f);
  const Mesh::VertexRef v = mesh.vertices.begin();
  v->halfedge->twin->next = v->halfedge->twin;
  meshedit::detail::steps_left = 1000;
  EXPECT_EQ(kind_of(fault_of([&] { v->degree(); })), FaultKind::kOutOfSteps);
  meshedit::detail::steps_left = INT64_MAX;
}

TEST(Scotty3dReferences, OfMembersAreReferencesIntoTheMesh) {
  Mesh mesh = Mesh::cube(1.0f);
  const Mesh::EdgeRef e = mesh.edges.begin();
  Mesh::HalfedgeRef& h = e->halfedge;
  h = h->twin;
  EXPECT_TRUE(e->halfedge == h);
}

TEST(Scotty3dReferences, AreKeysAndComparedWithConstOnes) {
  Mesh mesh = Mesh::cube(1.0f);
  const Mesh::VertexRef v = mesh.vertices.begin();
  const Mesh::VertexCRef c = v;
  EXPECT_TRUE(c == v && v == c && !(c != v));
  EXPECT_TRUE(v < mesh.vertices.end());
  EXPECT_FALSE(mesh.vertices.end() < v);
  EXPECT_TRUE(mesh.vertices.cbegin() == v);
  std::unordered_map<Mesh::VertexCRef, int> by_hash{{v, 1}};
  std::map<Mesh::VertexRef, int> by_order{{v, 2}};
  std::unordered_set<Mesh::HalfedgeRef> halfedges;
  std::set<Mesh::FaceCRef> faces;
  for (Mesh::HalfedgeRef h = mesh.halfedges.begin(); h != mesh.halfedges.end(); ++h) {
    halfedges.insert(h);
    faces.insert(h->face);
  }
  EXPECT_EQ(by_hash.at(v), 1);
  EXPECT_EQ(by_order.count(std::next(v)), 0U);
  EXPECT_EQ(halfedges.size(), 24U);
  EXPECT_EQ(faces.size(), 6U);
}

TEST(Scotty3dLists, AreReadLikeThoseOfTheLibrary) {
  Mesh mesh = Mesh::cube(1.0f);
  std::size_t n = 0;
  for (auto f : mesh.faces) {
    f.boundary = true;  // of a copy
    n += f.boundary ? 1 : 0;
  }
  for (auto& v : mesh.vertices) {
    v.position *= 2.0f;
    ++n;
  }
  EXPECT_EQ(n, 14U);
  EXPECT_EQ(mesh.n_boundaries(), 0U);
  EXPECT_EQ(mesh.vertices.front().position.abs(), Vec3(2.0f, 2.0f, 2.0f));
  std::list<Mesh::Vertex>::iterator it = mesh.vertices.begin();
  std::advance(it, 3);
  EXPECT_TRUE(it == std::next(mesh.vertices.begin(), 3));
  EXPECT_FALSE(mesh.edges.empty());
}

TEST(Scotty3dMesh, KnowsTheSizesOfACube) {
  const Mesh mesh = Mesh::cube(1.0f);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.edges.size(), 12U);
  EXPECT_EQ(mesh.faces.size(), 6U);
  EXPECT_EQ(mesh.halfedges.size(), 24U);
  EXPECT_FALSE(mesh.validate());
  EXPECT_NEAR(mesh.radius(), std::sqrt(3.0f), 1e-6f);
  for (Mesh::VertexCRef v = mesh.vertices.begin(); v != mesh.vertices.end(); ++v) {
    EXPECT_EQ(v->degree(), 3U);
    EXPECT_FALSE(v->on_boundary());
    EXPECT_NEAR(v->angle_defect(), PI_F / 2.0f, 1e-5f);
    EXPECT_NEAR(dot(v->normal(), v->position), std::sqrt(3.0f), 1e-5f);
    EXPECT_NEAR((v->neighborhood_center() - v->position / 3.0f).norm(), 0.0f, 1e-6f);
  }
  for (Mesh::FaceCRef f = mesh.faces.begin(); f != mesh.faces.end(); ++f) {
    EXPECT_EQ(f->degree(), 4U);
    EXPECT_NEAR(f->area(), 4.0f, 1e-6f);
    EXPECT_NEAR((f->normal() - f->center()).norm(), 0.0f, 1e-6f);
  }
  for (Mesh::EdgeCRef e = mesh.edges.begin(); e != mesh.edges.end(); ++e) {
    EXPECT_NEAR(e->length(), 2.0f, 1e-6f);
    EXPECT_NEAR((e->normal() - e->center().unit()).norm(), 0.0f, 1e-6f);
    EXPECT_FALSE(e->on_boundary());
  }
}

TEST(Scotty3dMesh, HasABoundaryFaceAroundALoneTriangle) {
  const Mesh mesh = Mesh::from_indexed_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(mesh.faces.size(), 2U);
  EXPECT_EQ(mesh.n_boundaries(), 1U);
  EXPECT_TRUE(mesh.vertices.begin()->on_boundary());
  EXPECT_TRUE(mesh.edges.begin()->on_boundary());
  EXPECT_FALSE(mesh.validate());
}

TEST(Scotty3dMesh, IsCopiedDeeply) {
  Mesh mesh = Mesh::cube(1.0f);
  mesh.erase_face(mesh.emplace_face());
  Mesh other = mesh.copy();
  EXPECT_EQ(mesh.describe(), other.describe());
  other.vertices.begin()->position = Vec3(9.0f, 9.0f, 9.0f);
  other.halfedges.begin()->next = other.halfedges.begin();
  EXPECT_NE(mesh.describe(), other.describe());
  EXPECT_FALSE(mesh.validate());
  EXPECT_TRUE(other.validate().has_value());
  EXPECT_FALSE(mesh.vertices.begin() == other.vertices.begin());
  mesh = other;
  EXPECT_EQ(mesh.describe(), other.describe());
}

TEST(Scotty3dMesh, ValidatesMeshesThatAreBroken) {
  Mesh mesh = Mesh::cube(1.0f);
  const Mesh::HalfedgeRef h = mesh.halfedges.begin();
  mesh.erase_edge(h->edge);
  ASSERT_TRUE(mesh.validate().has_value());
  mesh = Mesh::cube(1.0f);
  mesh.emplace_vertex();
  ASSERT_TRUE(mesh.validate().has_value());
  EXPECT_EQ(Mesh::id_of(mesh.validate()->first), mesh.vertices.back().id);
}

TEST(Scotty3dMesh, InterpolatesWhatElementsHoldBesidePositions) {
  Mesh mesh;
  const Mesh::VertexRef a = mesh.emplace_vertex();
  const Mesh::VertexRef b = mesh.emplace_vertex();
  const Mesh::VertexRef m = mesh.emplace_vertex();
  a->bone_weights = {{0, 1.0f}, {1, 1.0f}};
  b->bone_weights = {{1, 3.0f}};
  mesh.interpolate_data({a, b}, m);
  ASSERT_EQ(m->bone_weights.size(), 2U);
  EXPECT_EQ(m->bone_weights[0].weight, 0.5f);
  EXPECT_EQ(m->bone_weights[1].weight, 2.0f);
  const Mesh::HalfedgeRef h = mesh.emplace_halfedge();
  const Mesh::HalfedgeRef g = mesh.emplace_halfedge();
  h->corner_uv = Vec2(1.0f, 0.0f);
  g->corner_normal = Vec3(0.0f, 0.0f, 2.0f);
  mesh.interpolate_data({h, g}, g);
  EXPECT_EQ(g->corner_uv, Vec2(0.5f, 0.0f));
  EXPECT_EQ(g->corner_normal, Vec3(0.0f, 0.0f, 1.0f));
}

TEST(Scotty3dNumbers, MatricesAreByColumns) {
  Mat4 m = Mat4::I;
  m[3] = Vec4(1.0f, 2.0f, 3.0f, 1.0f);
  EXPECT_EQ(m * Vec3(1.0f, 1.0f, 1.0f), Vec3(2.0f, 3.0f, 4.0f));
  EXPECT_EQ(m.T()[0], Vec4(1.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_EQ(m.det(), 1.0f);
  EXPECT_EQ(m * m.inverse(), Mat4::I);
  EXPECT_EQ(Mat4::inverse(m), m.inverse());
  const Vec4 k(1.0f, 2.0f, 3.0f, 4.0f);
  EXPECT_EQ(outer(k, k)[2], 3.0f * k);
  EXPECT_EQ((Mat4::Zero + outer(k, k)).det(), 0.0f);
}

TEST(Scotty3dNumbers, VectorsAreAddedScaledAndCompared) {
  const Vec3 x(1.0f, 0.0f, 0.0f);
  const Vec3 y(0.0f, 1.0f, 0.0f);
  EXPECT_EQ(cross(x, y), Vec3(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(lerp(x, y, 0.25f), Vec3(0.75f, 0.25f, 0.0f));
  EXPECT_EQ((x + 2.0f * y - y / 2.0f).norm_squared(), 3.25f);
  EXPECT_TRUE(y < x);
  EXPECT_EQ(hmax(x, y), Vec3(1.0f, 1.0f, 0.0f));
  EXPECT_FALSE((x / 0.0f).valid());
  EXPECT_EQ(Vec4(x, 2.0f).project(), Vec3(0.5f, 0.0f, 0.0f));
  EXPECT_NEAR(Radians(180.0f), PI_F, 1e-6f);
  EXPECT_EQ(sign(-2.0f), -1.0f);
}

TEST(Scotty3dAssertions, AreFaultsThatSayWhatDoesNotHold) {
  const int corners = 4;
  EXPECT_FALSE(fault_of([&] { assert(corners == 4); }));
  const auto fault = fault_of([&] { assert(corners == 3); });
  EXPECT_EQ(kind_of(fault), FaultKind::kFailedAssertion);
  EXPECT_STREQ(fault->subject, "corners == 3");
}

}  // namespace
}  // namespace meshgrade
