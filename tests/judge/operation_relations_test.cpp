// Operations that undo each other, or that can be put together from others: what one answer
// says must be what the others say.

#include <gtest/gtest.h>

#include "grader/judge/face_match.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

const char* const kFiles[] = {
    "quad_cube.dae",   "prism_5.obj",       "pyramid_4.obj",   "dodecahedron.obj",
    "octahedron.off",  "quad_torus.obj",    "bipyramid_3.obj", "mixed_strip.obj",
    "tube_6.obj",      "quad_grid_3x3.obj", "ring_5.obj",      "fan.obj",
    "single_quad.obj", "two_triangles.obj", "two_patches.obj", "octagon.obj",
    "valence_zoo.obj", "grid_hole.off",     "tetrahedron.obj", "single_triangle.obj"};

Answer answer_to(const std::string& operation, const FaceLists& lists, const Corners& corners) {
  return find_local_operation(operation)->answer(lists, {corners});
}

/// Whether two answers leave the same surface, with new vertices in the same places.
void expect_same(const Answer& expected, const FaceLists& actual, const std::string& what) {
  const auto map = match_faces(expected, actual);
  ASSERT_TRUE(map) << what;
  for (const auto& [label, vertex] : *map) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(expected.after.positions[label][i], actual.positions[vertex][i], 1e-12)
          << what;
  }
}

class Relation : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    mesh_ = sample_dump(GetParam());
    lists_ = face_lists_of(mesh_);
  }

  template <class Visit>
  void for_each(ElementKind kind, Visit visit) {
    for (std::uint32_t i = 0; i < count_elements(mesh_, kind); ++i)
      visit(pick(mesh_, kind, i).corners,
            std::string(kind_name(kind)) + " " + std::to_string(i));
  }

  MeshDump mesh_;
  FaceLists lists_;
};

TEST_P(Relation, CollapsingABevelledVertexGivesItBack) {
  for_each(ElementKind::kVertex, [&](const Corners& v, const std::string& what) {
    const Answer bevel = answer_to("vertex_bevel", lists_, v);
    if (bevel.demand != Demand::kMust) return;
    const Answer back = answer_to("face_collapse", bevel.after, bevel.returned[0]);
    EXPECT_EQ(back.demand, Demand::kMust) << what << ": " << back.reason;
    Answer expected;
    expected.first_free = static_cast<Label>(lists_.positions.size());
    expected.after = merged(lists_, v, expected.first_free);
    expected.after.positions.push_back(lists_.positions[v[0]]);
    expect_same(expected, back.after, what);
  });
}

TEST_P(Relation, CollapsingABevelledEdgeIsToCollapseIt) {
  for_each(ElementKind::kEdge, [&](const Corners& e, const std::string& what) {
    const Answer bevel = answer_to("edge_bevel", lists_, e);
    if (bevel.demand != Demand::kMust) return;
    const Answer collapse = answer_to("edge_collapse", lists_, e);
    const Answer twice = answer_to("face_collapse", bevel.after, bevel.returned[0]);
    EXPECT_EQ(twice.demand, collapse.demand) << what << ": " << twice.reason;
    if (collapse.demand == Demand::kRefuse) return;
    EXPECT_TRUE(match_faces(collapse, twice.after)) << what;
  });
}

TEST_P(Relation, CollapsingTheMiddleOfAnExtrudedFaceIsToInsetAVertex) {
  for_each(ElementKind::kFace, [&](const Corners& f, const std::string& what) {
    const Answer extruded = answer_to("face_extrude", lists_, f);
    const Answer collapsed = answer_to("face_collapse", extruded.after, extruded.returned[0]);
    EXPECT_EQ(collapsed.demand, Demand::kMust) << what;
    expect_same(answer_to("vertex_inset", lists_, f), collapsed.after, what);
  });
}

TEST_P(Relation, DissolvingAnInsetVertexGivesTheFaceBack) {
  for_each(ElementKind::kFace, [&](const Corners& f, const std::string& what) {
    const Answer inset = answer_to("vertex_inset", lists_, f);
    const Answer dissolved = answer_to("vertex_dissolve", inset.after, inset.returned[0]);
    EXPECT_EQ(dissolved.demand, Demand::kMust) << what;
    Answer same;
    same.after = lists_;
    same.first_free = static_cast<Label>(lists_.positions.size());
    EXPECT_TRUE(match_faces(same, dissolved.after)) << what;
  });
}

/// What a series of edge collapses does, as long as each of them must be done, collapsing the
/// face does at once; but for where the vertex is.
TEST_P(Relation, CollapsingAFaceIsToCollapseItsEdgesOneByOne) {
  for_each(ElementKind::kFace, [&](const Corners& f, const std::string& what) {
    FaceLists lists = lists_;
    Label left = f[0];
    for (std::size_t i = 1; i < f.size(); ++i) {
      // The last but one makes a triangle vanish, and with it the last edge.
      if (i + 1 == f.size() && f.size() >= 3) break;
      const Answer step = answer_to("edge_collapse", lists, {left, f[i]});
      if (step.demand != Demand::kMust) return;
      lists = step.after;
      left = step.returned[0][0];
    }
    const Answer last = answer_to("edge_collapse", lists, {left, f.back()});
    if (last.demand != Demand::kMust) return;
    const Answer at_once = answer_to("face_collapse", lists_, f);
    EXPECT_EQ(at_once.demand, Demand::kMust) << what << ": " << at_once.reason;
    EXPECT_TRUE(match_faces(at_once, last.after)) << what;
  });
}

TEST_P(Relation, RemovingAFaceIsToDissolveItsOnlyBoundaryEdge) {
  for_each(ElementKind::kEdge, [&](const Corners& e, const std::string& what) {
    const Surface surface(lists_);
    if (!surface.is_boundary_edge(e[0], e[1])) return;
    const Answer dissolved = answer_to("edge_dissolve", lists_, e);
    if (dissolved.demand != Demand::kMust) return;
    const auto f = surface.face_with_side(e[0], e[1]);
    const std::size_t face = f ? *f : *surface.face_with_side(e[1], e[0]);
    const Answer removed = answer_to("face_remove", lists_, lists_.faces[face]);
    EXPECT_EQ(removed.demand, Demand::kMust) << what;
    EXPECT_TRUE(match_faces(removed, dissolved.after)) << what;
  });
}

/// A face that was cut off along one edge, and comes back there.
TEST_P(Relation, WeldingWhatWasCutOffGivesItBack) {
  for_each(ElementKind::kEdge, [&](const Corners& e, const std::string& what) {
    const Surface surface(lists_);
    const auto f = surface.face_with_side(e[0], e[1]);
    if (!f || surface.is_boundary_edge(e[0], e[1])) return;
    // Only a face that hangs on this edge alone: then it touches the rest in two corners.
    Corners cut = beginning_with(lists_.faces[*f], e[0]);
    for (std::size_t i = 2; i < cut.size(); ++i) {
      if (surface.faces_at(cut[i]).size() != 1) return;
    }
    if (surface.is_boundary_edge(cut[1], cut[2]) == false ||
        surface.is_boundary_edge(cut.back(), cut[0]) == false)
      return;
    FaceLists apart = lists_;
    cut[0] = apart.add(lists_.positions[e[0]]);
    cut[1] = apart.add(lists_.positions[e[1]]);
    apart.faces[*f] = cut;
    const Answer back =
        find_local_operation("edge_weld")->answer(apart, {{e[0], e[1]}, {cut[0], cut[1]}});
    EXPECT_EQ(back.demand, Demand::kMust) << what << ": " << back.reason;
    Answer expected;
    expected.first_free = static_cast<Label>(lists_.positions.size());
    expected.after = merged(lists_, {e[0]}, expected.first_free);
    expected.after = merged(expected.after, {e[1]}, expected.first_free + 1);
    expected.after.positions.push_back(lists_.positions[e[0]]);
    expected.after.positions.push_back(lists_.positions[e[1]]);
    expect_same(expected, back.after, what);
  });
}

INSTANTIATE_TEST_SUITE_P(Meshes, Relation, testing::ValuesIn(kFiles), [](const auto& tested) {
  std::string name = tested.param;
  for (char& letter : name)
    letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return name;
});

}  // namespace
}  // namespace meshgrade
