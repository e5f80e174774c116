// Pictures of wrong subdivided meshes: what is in them, and that they can be read.

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "grader/report/svg_figure.h"
#include "tests/report/figure_support.h"
#include "tests/support/right_answers.h"

namespace meshgrade {
namespace {

Case loop_case(const std::string& words) {
  for (const Case& c : standard_cases("loop_subdivision")) {
    if (c.title.find(words) != std::string::npos) return c;
  }
  throw std::out_of_range("no case with " + words);
}

TEST(SurfaceFigure, WrongVerticesOfLoopAreMarkedWorstFirst) {
  const Case c = loop_case("1 level on icosahedron");
  auto mesh = from_wire<MeshDump>(right_outcome(c).steps[0]);
  const std::map<Ref, double> moved = {{3, 0.2}, {17, 0.4}, {20, 0.1}};
  for (const auto& [v, by] : moved)
    mesh.vertices[v].position[0] += by;
  CaseReport report = judged(c, {to_wire(mesh)});
  const std::vector<SurfaceMark>& marks = finding_of(report).surface.marks;
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_EQ(marks[0].name, "v17");
  EXPECT_EQ(marks[1].name, "v3");
  EXPECT_EQ(marks[2].name, "v20");
  const Picture picture(report);
  EXPECT_EQ(picture.panel("yours").select_nodes(".//svg[@class='dots']/circle").size(), 3U);
  EXPECT_EQ(picture.panel("yours").select_nodes(".//svg[@class='surface']/path").size(),
            count(mesh).faces);
  EXPECT_EQ(overlapping_labels(picture.panel("yours")), "");
  for (const char* name : {"1 v17", "2 v3", "3 v20"})
    EXPECT_NE(all_text(picture.panel("yours")).find(name), std::string::npos);
  EXPECT_NE(all_text(picture.panel("list")).find("v17: off by"), std::string::npos);
  EXPECT_NE(std::string(picture.root.child("desc").text().get()).find("v20: off by"),
            std::string::npos);
}

TEST(SurfaceFigure, MeshThatIsFarOutsideIsDrawnWithFiniteNumbers) {
  const Case c = loop_case("1 level on icosahedron");
  auto mesh = from_wire<MeshDump>(right_outcome(c).steps[0]);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    mesh.vertices[v].position = {v % 2 == 0 ? 1e300 : -1e300, 1e308, 0.0};
  const CaseReport report = judged(c, {to_wire(mesh)});
  ASSERT_NE(pictured_finding(report), nullptr);
  const std::string text = to_svg(report, "p");
  for (const char* never : {"nan", "inf ", " inf", "e+"})
    EXPECT_EQ(text.substr(text.find("</desc>")).find(std::string("=\"") + never),
              std::string::npos);
  const Picture picture(report);
  for (const pugi::xpath_node& found : picture.root.select_nodes("//path")) {
    const std::string d = found.node().attribute("d").as_string();
    EXPECT_EQ(d.find_first_not_of("MLQZ0123456789.- "), std::string::npos) << d;
  }
}

TEST(SurfaceFigure, LargeMeshIsShownAroundItsWorstVertex) {
  const Case c = loop_case("torus.ply");
  Outcome outcome = right_outcome(c);
  auto mesh = from_wire<MeshDump>(outcome.steps.back());
  const std::size_t all = count(mesh).faces;
  mesh.vertices[5].position[1] += 1.0;
  outcome.steps.back() = to_wire(mesh);
  CaseReport report = judged(c, outcome.steps);
  const SurfaceFigure& figure = finding_of(report).surface;
  ASSERT_FALSE(figure.empty());
  EXPECT_EQ(figure.yours.triangles.size() + figure.left_out, all);
  EXPECT_EQ(figure.marks.at(0).name, "v5");
  EXPECT_EQ(figure.yours.positions.at(figure.marks[0].vertex)[1], mesh.vertices[5].position[1]);
}

/// One right step with the vertices numbered as by splitting edges: first the old ones.
MeshDump old_vertices_first(const PolygonMesh& mesh) {
  const SubdivisionLevel level =
      opensubdiv_loop(mesh, VertexRule::kWarren, CornerRule::kSmooth);
  std::vector<Ref> number(level.mesh.positions.size());
  for (Ref v = 0; v < level.child_of_vertex.size(); ++v)
    number[level.child_of_vertex[v]] = v;
  for (Ref e = 0; e < level.child_of_edge.size(); ++e)
    number[level.child_of_edge[e]] = static_cast<Ref>(level.child_of_vertex.size()) + e;
  MeshDump dump = dump_polygons(level.mesh);
  std::map<Point3, Ref> by_position;
  for (std::size_t v = 0; v < number.size(); ++v)
    by_position[level.mesh.positions[v]] = number[v];
  std::vector<Ref> renamed;
  for (const VertexRecord& v : dump.vertices)
    renamed.push_back(by_position.at(v.position));
  std::vector<VertexRecord> vertices(renamed.size());
  for (std::size_t v = 0; v < renamed.size(); ++v)
    vertices[renamed[v]] = dump.vertices[v];
  dump.vertices = std::move(vertices);
  for (HalfedgeRecord& h : dump.halfedges)
    h.vertex = renamed[h.vertex];
  return dump;
}

TEST(SurfaceFigure, SurfaceThatIsJoinedInAnotherWayIsShownWithItsOddVertices) {
  const Case c = loop_case("1 level on icosahedron");
  const PolygonMesh old = from_wire<SubdivisionInput>(c.input).mesh;
  MeshDump mesh = old_vertices_first(old);
  ASSERT_EQ(judged(c, {to_wire(mesh)}).verdict, Verdict::kPassed);
  // An edge between an old vertex and a new one is turned: it joins two new ones now.
  const Ref old_vertex = 4;
  model_flip(mesh, mesh.halfedges[mesh.vertices[old_vertex].halfedge].edge);
  CaseReport report = judged(c, {to_wire(mesh)});
  ASSERT_EQ(report.verdict, Verdict::kFailed);
  const SurfaceFigure& figure = finding_of(report).surface;
  ASSERT_EQ(figure.marks.size(), 1U);
  EXPECT_EQ(figure.marks[0].name, vertex_name(old_vertex));
  const Picture picture(report);
  EXPECT_NE(all_text(picture.panel("list")).find("v4: 4 edges, must be 5"), std::string::npos);
  EXPECT_EQ(picture.panel("expected").select_nodes(".//svg[@class='surface']/path").size(),
            4 * old.polygons.size());
}

TEST(SurfaceFigure, MeshThatIsDeletedAsAWholeHasNone) {
  const CaseReport report = judged(loop_case("1 level on icosahedron"), {to_wire(MeshDump{})});
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(to_svg(report, "p"), "");
}

}  // namespace
}  // namespace meshgrade
