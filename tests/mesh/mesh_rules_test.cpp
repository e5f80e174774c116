// Every rule broken on purpose, by as few numbers as possible, in a mesh that is right.

#include "grader/mesh/mesh_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "grader/mesh/torus_mesh.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

const RuleBreak* find_rule(const std::vector<RuleBreak>& breaks, const std::string& rule) {
  for (const RuleBreak& b : breaks) {
    if (b.rule == rule) return &b;
  }
  return nullptr;
}

std::set<std::string> rule_names(const MeshDump& mesh) {
  std::set<std::string> names;
  for (const RuleBreak& b : find_broken_rules(mesh))
    names.insert(b.rule);
  return names;
}

/// The first break of a rule is at this element and names this pointer.
void expect_break(const MeshDump& mesh, const std::string& rule, const std::string& element,
                  const std::string& pointer) {
  const std::vector<RuleBreak> breaks = find_broken_rules(mesh);
  const RuleBreak* found = find_rule(breaks, rule);
  ASSERT_NE(found, nullptr) << rule << " is not noticed";
  EXPECT_EQ(found->element, element);
  EXPECT_NE(found->look_at.find(pointer), std::string::npos) << found->look_at;
  EXPECT_FALSE(found->expected.empty());
  EXPECT_FALSE(found->actual.empty());
  EXPECT_NE(found->expected, found->actual);
}

Ref twin(const MeshDump& mesh, Ref h) {
  return mesh.halfedges[h].twin;
}
Ref next(const MeshDump& mesh, Ref h) {
  return mesh.halfedges[h].next;
}

/// A half-edge in a boundary loop.
Ref outer_halfedge(const MeshDump& mesh) {
  return mesh.boundaries.at(0).halfedge;
}

class MeshRules : public testing::Test {
 protected:
  MeshDump closed_ = sample_dump("octahedron.off");
  MeshDump open_ = sample_dump("grid_4x4.obj");
};

TEST_F(MeshRules, RightMeshesBreakNone) {
  ASSERT_GE(triangle_mesh_files().size(), 18U);
  for (const std::string& file : triangle_mesh_files()) {
    EXPECT_TRUE(rule_names(sample_dump(file)).empty()) << file;
  }
}

TEST_F(MeshRules, LargeRightMeshBreaksNone) {
  const MeshDump mesh = dump_polygons(torus_mesh(200, 200));
  EXPECT_EQ(count(mesh).faces, 80'000U);
  EXPECT_TRUE(find_broken_rules(mesh).empty());
}

TEST_F(MeshRules, EachHasANameAndAMeaning) {
  std::set<std::string_view> names;
  for (const Rule& rule : mesh_rules()) {
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_FALSE(rule.meaning.empty());
    EXPECT_EQ(rule_meaning(rule.name), rule.meaning);
  }
  EXPECT_EQ(names.size(), 14U);
  EXPECT_TRUE(rule_meaning("no-such-rule").empty());
}

TEST_F(MeshRules, LivePointerIsBrokenByEveryKindOfUnsetPointer) {
  const auto broken = [&](auto change, const std::string& element, const std::string& pointer) {
    MeshDump mesh = open_;
    change(mesh);
    expect_break(mesh, "live-pointer", element, pointer);
  };
  broken([](MeshDump& m) { m.halfedges[5].next = kUnsetRef; }, "h5", "h5.next");
  broken([](MeshDump& m) { m.halfedges[5].twin = kUnsetRef; }, "h5", "h5.twin");
  broken([](MeshDump& m) { m.halfedges[5].vertex = kUnsetRef; }, "h5", "h5.vertex");
  broken([](MeshDump& m) { m.halfedges[5].edge = kUnsetRef; }, "h5", "h5.edge");
  broken([](MeshDump& m) { m.halfedges[5].face = kUnsetRef; }, "h5", "h5.face");
  broken([](MeshDump& m) { m.vertices[3].halfedge = kUnsetRef; }, "v3", "v3.halfedge");
  broken([](MeshDump& m) { m.edges[3].halfedge = kUnsetRef; }, "e3", "e3.halfedge");
  broken([](MeshDump& m) { m.faces[3].halfedge = kUnsetRef; }, "f3", "f3.halfedge");
  broken([](MeshDump& m) { m.boundaries[0].halfedge = kUnsetRef; }, "b0", "b0.halfedge");
}

TEST_F(MeshRules, LivePointerTellsWhereAWrongPointerLeads) {
  const auto actual = [&](Ref next) {
    MeshDump mesh = closed_;
    mesh.halfedges[4].next = next;
    return find_broken_rules(mesh).at(0).actual;
  };
  EXPECT_EQ(actual(kUnsetRef), "h4.next was never set");
  EXPECT_NE(actual(kPastEndRef).find("past the end"), std::string::npos);
  EXPECT_NE(actual(kForeignRef).find("no element of this mesh"), std::string::npos);
  EXPECT_NE(actual(7 | kDeletedBit).find("h7 (deleted)"), std::string::npos);
  EXPECT_NE(actual(1000).find("h1000"), std::string::npos);
}

TEST_F(MeshRules, LivePointerIsBrokenByADeletedElementThatIsStillPointedTo) {
  closed_.vertices[2].live = 0;
  const RuleBreak first = find_broken_rules(closed_).at(0);
  EXPECT_EQ(first.rule, "live-pointer");
  EXPECT_NE(first.look_at.find(".vertex"), std::string::npos);
}

TEST_F(MeshRules, TwinInvolutionIsBrokenByAHalfedgeThatIsItsOwnTwin) {
  closed_.halfedges[6].twin = 6;
  expect_break(closed_, "twin-involution", "h6", "h6.twin");
}

TEST_F(MeshRules, TwinInvolutionIsBrokenByATwinThatLooksElsewhere) {
  // The twin of h0 goes to a half-edge whose own twin is another one.
  const Ref wrong = twin(closed_, next(closed_, 0));
  closed_.halfedges[0].twin = wrong;
  expect_break(closed_, "twin-involution", "h0", halfedge_name(wrong) + ".twin");
}

TEST_F(MeshRules, TwinEdgeIsBrokenByOneWrongEdgePointer) {
  const Ref other = closed_.halfedges[next(closed_, 0)].edge;
  closed_.halfedges[0].edge = other;
  expect_break(closed_, "twin-edge", "h0", "h0.edge");
}

TEST_F(MeshRules, TwinEdgeIsBrokenByAnEdgeThatNoHalfedgeNames) {
  closed_.edges.push_back({0, 1});
  const std::string lost = edge_name(static_cast<Ref>(closed_.edges.size() - 1));
  expect_break(closed_, "twin-edge", lost, lost);
  EXPECT_NE(find_rule(find_broken_rules(closed_), "twin-edge")->actual.find("0 half-edges do"),
            std::string::npos);
}

TEST_F(MeshRules, TwinEdgeIsBrokenByTwoEdgesThatBecomeOne) {
  const Ref e = closed_.halfedges[0].edge;
  const Ref h = next(closed_, 0);
  const Ref merged = closed_.halfedges[h].edge;
  closed_.halfedges[h].edge = e;
  closed_.halfedges[twin(closed_, h)].edge = e;
  expect_break(closed_, "twin-edge", edge_name(std::min(e, merged)), ".edge");
}

TEST_F(MeshRules, TwinOppositeIsBrokenByOneWrongVertexPointer) {
  const Ref h = 0;
  closed_.halfedges[h].vertex = closed_.halfedges[next(closed_, next(closed_, h))].vertex;
  // h no longer starts where its twin ends: the twin and what lies before h both notice.
  const std::vector<RuleBreak> breaks = find_broken_rules(closed_);
  std::set<std::string> elements;
  for (const RuleBreak& b : breaks) {
    if (b.rule == "twin-opposite") elements.insert(b.element);
  }
  EXPECT_EQ(elements, (std::set<std::string>{halfedge_name(twin(closed_, h)),
                                             halfedge_name(next(closed_, next(closed_, h)))}));
  const Ref first = std::min(twin(closed_, h), next(closed_, next(closed_, h)));
  expect_break(closed_, "twin-opposite", halfedge_name(first), ".vertex");
}

TEST_F(MeshRules, NextPermutationIsBrokenByOneWrongNextPointer) {
  const Ref h = 0;
  const Ref lost = next(closed_, h);
  const Ref wrong = next(closed_, lost);
  closed_.halfedges[h].next = wrong;
  expect_break(closed_, "next-permutation", halfedge_name(wrong), halfedge_name(h) + ".next");
  bool none = false;
  for (const RuleBreak& b : find_broken_rules(closed_)) {
    none = none || (b.rule == "next-permutation" && b.element == halfedge_name(lost) &&
                    b.actual == "none does");
  }
  EXPECT_TRUE(none);
}

TEST_F(MeshRules, NextFaceIsBrokenByOneWrongFacePointer) {
  const Ref h = 0;
  closed_.halfedges[h].face = closed_.halfedges[twin(closed_, h)].face;
  expect_break(closed_, "next-face", "h0", "h0.face");
}

TEST_F(MeshRules, FaceLoopIsBrokenByAFaceOfFourSides) {
  // Two triangles become one quad; the edge between them is taken out whole.
  MeshDump mesh = sample_dump("two_triangles.obj");
  Ref h = 0;
  while (((mesh.halfedges[h].face | mesh.halfedges[twin(mesh, h)].face) & kBoundaryBit) != 0)
    ++h;
  const Ref t = twin(mesh, h);
  const Ref face = mesh.halfedges[h].face;
  const auto before = [&](Ref x) { return next(mesh, next(mesh, x)); };
  const Ref before_h = before(h);
  const Ref before_t = before(t);
  mesh.halfedges[before_h].next = next(mesh, t);
  mesh.halfedges[before_t].next = next(mesh, h);
  for (Ref x : {next(mesh, h), next(mesh, t), before_h, before_t})
    mesh.halfedges[x].face = face;
  for (Ref v : {mesh.halfedges[h].vertex, mesh.halfedges[t].vertex}) {
    for (Ref x : {next(mesh, h), next(mesh, t), before_h, before_t}) {
      if (mesh.halfedges[x].vertex == v) mesh.vertices[v].halfedge = x;
    }
  }
  mesh.faces[face].halfedge = before_h;
  mesh.faces[mesh.halfedges[t].face].live = 0;
  mesh.edges[mesh.halfedges[h].edge].live = 0;
  mesh.halfedges[h].live = mesh.halfedges[t].live = 0;
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"face-loop"}));
  expect_break(mesh, "face-loop", face_name(face), ".next");
}

TEST_F(MeshRules, FaceLoopIsBrokenByAFaceThatNoHalfedgeNames) {
  closed_.faces.push_back({closed_.faces[0].halfedge, 1, 0});
  expect_break(closed_, "face-loop", face_name(static_cast<Ref>(closed_.faces.size() - 1)),
               ".face");
}

TEST_F(MeshRules, FaceLoopIsBrokenByAWalkThatNeverComesBack) {
  const Ref h = closed_.faces[1].halfedge;
  closed_.halfedges[next(closed_, next(closed_, h))].next = next(closed_, h);
  expect_break(closed_, "face-loop", "f1", "f1.halfedge");
}

TEST_F(MeshRules, WalksThatNeverComeBackTakeLinearTime) {
  // Every next leads into one far trap: without a limit per face this would take minutes.
  MeshDump mesh = dump_polygons(torus_mesh(200, 200));
  const auto n = static_cast<Ref>(mesh.halfedges.size());
  for (Ref h = 0; h < n; ++h)
    mesh.halfedges[h].next = h + 1 < n ? h + 1 : n - 2;
  EXPECT_NE(find_rule(find_broken_rules(mesh), "face-loop"), nullptr);
}

TEST_F(MeshRules, AnchorIsBrokenByAVertexThatPointsToAHalfedgeOfAnother) {
  const Ref v = 1;
  const Ref wrong = twin(closed_, closed_.vertices[v].halfedge);
  closed_.vertices[v].halfedge = wrong;
  EXPECT_EQ(rule_names(closed_).count("anchor"), 1U);
  expect_break(closed_, "anchor", "v1", "v1.halfedge");
}

TEST_F(MeshRules, AnchorIsBrokenByAnEdgeThatPointsToAHalfedgeOfAnother) {
  closed_.edges[2].halfedge = closed_.edges[3].halfedge;
  EXPECT_EQ(rule_names(closed_), (std::set<std::string>{"anchor"}));
  expect_break(closed_, "anchor", "e2", "e2.halfedge");
}

TEST_F(MeshRules, AnchorIsBrokenByAFaceThatPointsToAHalfedgeOfAnother) {
  closed_.faces[2].halfedge = closed_.faces[3].halfedge;
  expect_break(closed_, "anchor", "f2", "f2.halfedge");
}

TEST_F(MeshRules, AnchorMayBeAnyRightHalfedge) {
  for (VertexRecord& v : open_.vertices)
    v.halfedge = next(open_, twin(open_, v.halfedge));
  for (EdgeRecord& e : open_.edges)
    e.halfedge = twin(open_, e.halfedge);
  for (FaceRecord& f : open_.faces)
    f.halfedge = next(open_, f.halfedge);
  for (FaceRecord& b : open_.boundaries)
    b.halfedge = next(open_, b.halfedge);
  EXPECT_TRUE(find_broken_rules(open_).empty());
}

TEST_F(MeshRules, VertexFanIsBrokenByTwoFansThatMeetInOneVertex) {
  // A bow-tie: one vertex of each component of the mesh becomes the same vertex.
  MeshDump mesh = sample_dump("two_components.obj");
  const Ref kept = mesh.halfedges[0].vertex;
  std::vector<bool> reached(mesh.vertices.size(), false);
  reached[kept] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const HalfedgeRecord& h : mesh.halfedges) {
      const Ref end = mesh.halfedges[h.twin].vertex;
      if (!reached[h.vertex] || reached[end]) continue;
      reached[end] = grown = true;
    }
  }
  Ref merged = 0;
  while (reached[merged])
    ++merged;
  for (HalfedgeRecord& h : mesh.halfedges) {
    if (h.vertex == merged) h.vertex = kept;
  }
  mesh.vertices[merged].live = 0;
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"vertex-fan"}));
  expect_break(mesh, "vertex-fan", vertex_name(kept), vertex_name(kept));
}

TEST_F(MeshRules, BoundaryIsBrokenByAWrongFlag) {
  MeshDump mesh = open_;
  mesh.faces[4].is_boundary = 1;
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"boundary"}));
  expect_break(mesh, "boundary", "f4", "f4");
  mesh = open_;
  mesh.boundaries[0].is_boundary = 0;
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"boundary"}));
  expect_break(mesh, "boundary", "b0", "b0");
}

TEST_F(MeshRules, BoundaryIsBrokenByAnEdgeWithNoSurfaceOnEitherSide) {
  MeshDump mesh = sample_dump("single_triangle.obj");
  const Ref inside = mesh.faces[0].halfedge;
  mesh.boundaries.push_back({inside, 1, 1});
  for (HalfedgeRecord& h : mesh.halfedges) {
    if (h.face == 0) h.face = 1 | kBoundaryBit;
  }
  mesh.faces[0].live = 0;
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"boundary"}));
  expect_break(mesh, "boundary", "e0", ".face");
}

TEST_F(MeshRules, BoundaryLoopThatIsLostBreaksLivePointer) {
  open_.boundaries[0].live = 0;
  expect_break(open_, "live-pointer", halfedge_name([&] {
                 Ref first = 0;
                 while ((open_.halfedges[first].face & kBoundaryBit) == 0)
                   ++first;
                 return first;
               }()),
               ".face");
}

TEST_F(MeshRules, BoundaryLoopOfOneHalfedgeMoreThanNamedBreaksFaceLoop) {
  const Ref h = outer_halfedge(open_);
  open_.halfedges[h].face = open_.halfedges[twin(open_, h)].face;
  EXPECT_EQ(rule_names(open_).count("face-loop"), 1U);
  expect_break(open_, "next-face",
               halfedge_name(std::min(h,
                                      [&] {
                                        Ref before = 0;
                                        while (next(open_, before) != h)
                                          ++before;
                                        return before;
                                      }())),
               ".face");
}

TEST_F(MeshRules, SimpleIsBrokenByTwoEdgesBetweenTheSameVertices) {
  // Any flip on a tetrahedron joins two vertices that are joined already.
  MeshDump mesh = sample_dump("tetrahedron.obj");
  const Ref h = mesh.edges[0].halfedge;
  const Ref t = twin(mesh, h);
  const Ref ca = next(mesh, h);
  const Ref ab = next(mesh, ca);
  const Ref bd = next(mesh, t);
  const Ref dc = next(mesh, bd);
  const Ref b = mesh.halfedges[h].vertex;
  const Ref c = mesh.halfedges[t].vertex;
  mesh.halfedges[h].vertex = mesh.halfedges[dc].vertex;
  mesh.halfedges[t].vertex = mesh.halfedges[ab].vertex;
  const auto triangle = [&](Ref f, Ref x, Ref y, Ref z) {
    mesh.halfedges[x] = {y, twin(mesh, x), mesh.halfedges[x].vertex, mesh.halfedges[x].edge, f,
                         1};
    mesh.halfedges[y] = {z, twin(mesh, y), mesh.halfedges[y].vertex, mesh.halfedges[y].edge, f,
                         1};
    mesh.halfedges[z] = {x, twin(mesh, z), mesh.halfedges[z].vertex, mesh.halfedges[z].edge, f,
                         1};
    mesh.faces[f].halfedge = x;
  };
  triangle(mesh.halfedges[h].face, h, ab, bd);
  triangle(mesh.halfedges[t].face, t, dc, ca);
  mesh.vertices[b].halfedge = bd;
  mesh.vertices[c].halfedge = ca;
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"simple"}));
  EXPECT_NE(find_broken_rules(mesh).at(0).actual.find("both join"), std::string::npos);
}

TEST_F(MeshRules, SimpleIsBrokenByAnEdgeFromAVertexToItself) {
  const Ref h = 0;
  closed_.halfedges[h].vertex = closed_.halfedges[twin(closed_, h)].vertex;
  expect_break(closed_, "simple", edge_name(closed_.halfedges[h].edge), ".vertex");
}

TEST_F(MeshRules, SimpleIsBrokenByTwoFacesWithTheSameCorners) {
  // Two triangles back to back: a pillow, closed and without any other fault.
  MeshDump mesh;
  for (Ref i = 0; i < 3; ++i) {
    mesh.vertices.push_back({i, 1, {static_cast<double>(i), i == 1 ? 1.0 : 0.0, 0.0}});
    mesh.edges.push_back({i, 1});
  }
  for (Ref i = 0; i < 3; ++i)
    mesh.halfedges.push_back({(i + 1) % 3, 3 + i, i, i, 0, 1});
  for (Ref i = 0; i < 3; ++i)
    mesh.halfedges.push_back({3 + (i + 2) % 3, i, (i + 1) % 3, i, 1, 1});
  mesh.faces = {{0, 1, 0}, {3, 1, 0}};
  EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"simple"}));
  expect_break(mesh, "simple", "f1", ".vertex");
}

TEST_F(MeshRules, FiniteIsBrokenByEveryCoordinateThatIsNoNumber) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      MeshDump mesh = closed_;
      mesh.vertices[4].position[axis] = bad;
      EXPECT_EQ(rule_names(mesh), (std::set<std::string>{"finite"}));
      expect_break(mesh, "finite", "v4", "v4.position");
    }
  }
}

TEST_F(MeshRules, DeletedElementsCountForNothing) {
  closed_.vertices.push_back({kUnsetRef, 0, {NAN, NAN, NAN}});
  closed_.edges.push_back({kForeignRef, 0});
  closed_.faces.push_back({77, 0, 1});
  closed_.halfedges.push_back({0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(find_broken_rules(closed_).empty());
}

TEST_F(MeshRules, OnlyAFewBreaksOfEachAreTold) {
  for (HalfedgeRecord& h : open_.halfedges)
    h.twin = h.next = kUnsetRef;
  EXPECT_LT(find_broken_rules(open_).size(), 9 * mesh_rules().size());
}

}  // namespace
}  // namespace meshgrade
