// What no line of a solution gets wrong by chance: a mesh turned inside out, and edges that
// swap their places where two of them have the same ends.

#include <gtest/gtest.h>

#include "grader/judge/judge.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

CaseJudgement judge_triangulation(const WholeMeshInput& input,
                                  const std::vector<MeshDump>& left_behind) {
  const ExerciseRubric& rubric = rubric_of("triangulation");
  const Case c{"triangulation", "basic", 1, "", to_wire(input), 1000};
  Outcome outcome;
  for (const MeshDump& mesh : left_behind)
    outcome.steps.push_back(to_wire(mesh));
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions;
  return judge_case(judge, {c, outcome, rubric, 1e-5}, conventions);
}

/// Every half-edge runs the other way, so that the faces are wound clockwise.
MeshDump inside_out(const MeshDump& mesh) {
  MeshDump turned = mesh;
  for (Ref h = 0; h < mesh.halfedges.size(); ++h) {
    const HalfedgeRecord& next = mesh.halfedges[mesh.halfedges[h].next];
    turned.halfedges[mesh.halfedges[h].next].next = h;
    turned.halfedges[h].vertex = next.vertex;
  }
  for (Ref h = 0; h < mesh.halfedges.size(); ++h)
    turned.vertices[turned.halfedges[h].vertex].halfedge = h;
  return turned;
}

TEST(TriangulationJudge, TellsThatAllTrianglesAreClockwise) {
  const WholeMeshInput input{"prism_5.obj", sample_polygons("prism_5.obj"), 0, 1};
  const auto right = from_wire<MeshDump>(right_triangulations(input)[0]);
  EXPECT_EQ(judge_triangulation(input, {right}).verdict, Verdict::kPassed);
  const CaseJudgement turned = judge_triangulation(input, {inside_out(right)});
  ASSERT_FALSE(turned.findings.empty());
  EXPECT_EQ(turned.findings[0].rule, "orientation");
}

/// Cuts the face between the corners `from` and the one after next, beginning with face `f`'s
/// side that starts at `from`.
void cut_corner(MeshDump& mesh, Ref f, Ref from) {
  Ref first = mesh.faces[f].halfedge;
  while (mesh.halfedges[first].vertex != from)
    first = mesh.halfedges[first].next;
  const Ref second = mesh.halfedges[first].next;
  const Ref third = mesh.halfedges[second].next;
  Ref last = third;
  while (mesh.halfedges[last].next != first)
    last = mesh.halfedges[last].next;
  const auto back = static_cast<Ref>(mesh.halfedges.size());
  const auto cut = static_cast<Ref>(mesh.edges.size());
  const auto triangle = static_cast<Ref>(mesh.faces.size());
  mesh.halfedges.push_back({first, back + 1, mesh.halfedges[third].vertex, cut, triangle, 1});
  mesh.halfedges.push_back({third, back, from, cut, f, 1});
  mesh.edges.push_back({back, 1});
  mesh.faces.push_back({back, 1, 0});
  mesh.faces[f].halfedge = third;
  mesh.halfedges[first].face = mesh.halfedges[second].face = triangle;
  mesh.halfedges[second].next = back;
  mesh.halfedges[last].next = back + 1;
}

/// Exchanges two edges that join the same vertices.
MeshDump with_swapped_edges(MeshDump mesh, Ref a, Ref b) {
  std::swap(mesh.edges[a], mesh.edges[b]);
  for (HalfedgeRecord& h : mesh.halfedges) {
    if (h.edge == a || h.edge == b) h.edge = h.edge == a ? b : a;
  }
  return mesh;
}

TEST(TriangulationJudge, TakesCutsWithTheEndsOfAnEdgeAndKeepsThemApart) {
  // Two of the faces of a pouch have four corners: v0-v1-v2-v3, beside the triangle v1-v3-v2,
  // whose edge v1-v3 a cut may double, and v1-v0-v4-v3.
  const WholeMeshInput input{"pouch.obj", sample_polygons("pouch.obj"), 0, 2};
  MeshDump cut = built_mesh(input.mesh);
  cut_corner(cut, 0, 1);
  cut_corner(cut, 1, 1);
  const CaseJudgement right = judge_triangulation(input, {cut, cut});
  EXPECT_EQ(right.verdict, Verdict::kPassed) << right.findings.at(0).actual;

  const auto doubled = static_cast<Ref>(cut.edges.size() - 2);
  const MeshDump swapped = with_swapped_edges(cut, find_edge(cut, 1, 3), doubled);
  const CaseJudgement judged = judge_triangulation(input, {cut, swapped});
  ASSERT_FALSE(judged.findings.empty());
  EXPECT_EQ(judged.findings[0].rule, "surface");
  EXPECT_EQ(judged.findings[0].where, "after call 2 of 2");
}

}  // namespace
}  // namespace meshgrade
