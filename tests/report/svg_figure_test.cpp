// Pictures of wrong flips, splits and subdivided meshes: what is in them, and that they can be
// read.

#include "grader/report/svg_figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "grader/base/random.h"
#include "grader/report/svg_pen.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

using Kind = ElementKind;

CaseReport judged(const Case& c, const std::vector<std::string>& steps) {
  const ExerciseRubric& rubric = *standard_rubric().find(c.exercise);
  const ExerciseJudge exercise = find_exercise_judge(rubric);
  Outcome outcome;
  outcome.steps = steps;
  Conventions conventions = exercise.conventions;
  const CaseJudgement judgement = judge_case(exercise, {c, outcome, rubric, 1e-5}, conventions);
  CaseReport report;
  report.id = c.id();
  report.title = c.title;
  report.verdict = judgement.verdict;
  for (const Finding& finding : judgement.findings)
    report.findings.push_back({finding, {}});
  return report;
}

OperationStep right_step(const Case& c) {
  return from_wire<OperationStep>(right_outcome(c).steps.at(0));
}

Case operation_case(const PolygonMesh& mesh, OperationKind kind) {
  const bool flip = kind == OperationKind::kFlip;
  return {flip ? "edge_flip" : "edge_split",
          "basic",
          1,
          "an edge",
          to_wire(OperationsInput{"a mesh", mesh, Anchoring::kAsBuilt, {{kind, 0, 1}}}),
          1000};
}

/// One case of each kind of neighbourhood.
std::vector<Case> operation_cases() {
  Case border = operation_case(sample_polygons("single_triangle.obj"), OperationKind::kSplit);
  border.group = "boundary_split";
  Case grid = operation_case(sample_polygons("grid_4x4.obj"), OperationKind::kSplit);
  grid.group = "boundary_split";
  return {operation_case(sample_polygons("octahedron.off"), OperationKind::kFlip),
          operation_case(sample_polygons("octahedron.off"), OperationKind::kSplit),
          operation_case(sample_polygons("tetrahedron.obj"), OperationKind::kSplit), border,
          grid};
}

/// Leads one pointer of a half-edge astray.
void spoil_pointer(MeshDump& mesh, Ref h, std::size_t pointer, Ref target) {
  constexpr Ref HalfedgeRecord::*kPointers[] = {&HalfedgeRecord::next, &HalfedgeRecord::twin,
                                                &HalfedgeRecord::vertex, &HalfedgeRecord::edge,
                                                &HalfedgeRecord::face};
  mesh.halfedges[h].*kPointers[pointer] = target;
}

/// What a submission with some random wrong pointers gets, many times.
std::vector<CaseReport> random_failures() {
  std::vector<CaseReport> reports;
  Random random(7, "wrong pointers");
  for (const Case& c : operation_cases()) {
    for (int i = 0; i < 40; ++i) {
      OperationStep step = right_step(c);
      MeshDump& mesh = step.after;
      const int faults = 1 + i % 6;
      for (int k = 0; k < faults; ++k) {
        const auto h =
            static_cast<Ref>(random.below(static_cast<std::uint32_t>(mesh.halfedges.size())));
        const auto near =
            static_cast<Ref>(random.below(static_cast<std::uint32_t>(mesh.halfedges.size())));
        const Ref target = i % 5 == 0 ? kUnsetRef : i % 7 == 0 ? kForeignRef : near;
        spoil_pointer(mesh, h, random.below(5), target);
      }
      if (i % 4 == 0) mesh.vertices[0].halfedge = kUnsetRef;
      if (i % 3 == 0) mesh.faces[0].halfedge = 1 + mesh.faces[0].halfedge % 3;
      CaseReport report = judged(c, {to_wire(step)});
      if (!report.findings.empty()) reports.push_back(std::move(report));
    }
  }
  return reports;
}

struct Picture {
  explicit Picture(const CaseReport& report) : text(to_svg(report, "p")) {
    const pugi::xml_parse_result result =
        document.load_buffer(text.data(), text.size(), pugi::parse_full);
    EXPECT_TRUE(result) << result.description() << "\n" << text;
    root = document.child("svg");
  }

  /// All elements whose class attribute has this word.
  std::vector<pugi::xml_node> of_class(const std::string& word, pugi::xml_node under) const {
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xpath_node& node : under.select_nodes(
             (".//*[contains(concat(' ', @class, ' '), ' " + word + " ')]").c_str())) {
      nodes.push_back(node.node());
    }
    return nodes;
  }
  pugi::xml_node panel(const std::string& name) const {
    const auto found = of_class(name, root);
    return found.empty() ? pugi::xml_node() : found[0];
  }

  std::string text;
  pugi::xml_document document;
  pugi::xml_node root;
};

std::string all_text(pugi::xml_node node) {
  std::string text;
  for (const pugi::xpath_node& found : node.select_nodes(".//text"))
    text += std::string(found.node().text().get()) + "\n";
  return text;
}

/// What a text covers, by a measure of its own: letters of the code type are 0.6 wide.
Box letters_of(pugi::xml_node text) {
  const double size = text.attribute("font-size").as_double();
  const double width = 0.6 * size * static_cast<double>(std::string(text.text().get()).size());
  const std::string anchor = text.attribute("text-anchor").as_string("start");
  const double x = text.attribute("x").as_double() - (anchor == "middle" ? 0.5 * width
                                                      : anchor == "end"  ? width
                                                                         : 0.0);
  const double y = text.attribute("y").as_double();
  return {x, y - 0.75 * size, x + width, y + 0.15 * size};
}

std::string overlapping_labels(pugi::xml_node panel) {
  std::vector<pugi::xml_node> texts;
  for (const pugi::xpath_node& found : panel.select_nodes(".//text"))
    texts.push_back(found.node());
  std::string faults;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!overlap(letters_of(texts[i]), letters_of(texts[j]))) continue;
      faults += std::string(texts[i].text().get()) + " at " +
                texts[i].attribute("x").as_string() + " " +
                texts[i].attribute("y").as_string() + " on " + texts[j].text().get() + " at " +
                texts[j].attribute("x").as_string() + " " +
                texts[j].attribute("y").as_string() + "\n";
    }
  }
  return faults;
}

double luminance(const std::string& color) {
  const auto part = [&](std::size_t at) {
    const double c = std::stoi(color.substr(at, 2), nullptr, 16) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

/// Of the web's accessibility guidelines: from 1 to 21.
double contrast(const std::string& a, const std::string& b) {
  const double x = luminance(a);
  const double y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// What a text stands on: the box just before it, or the ground of the picture.
std::string ground_of(pugi::xml_node text) {
  const pugi::xml_node box = text.previous_sibling();
  return box.name() == std::string("rect") ? box.attribute("fill").as_string() : ink::kPaper;
}

Finding& finding_of(CaseReport& report) {
  return report.findings.at(0).finding;
}

TEST(SvgFigure, RightAnswersHaveNone) {
  for (const Case& c : operation_cases()) {
    const CaseReport report = judged(c, right_outcome(c).steps);
    EXPECT_EQ(report.verdict, Verdict::kPassed) << c.id();
    EXPECT_EQ(to_svg(report, "p"), "");
  }
}

TEST(SvgFigure, EveryBrokenNeighbourhoodHasOne) {
  const std::vector<CaseReport> failures = random_failures();
  EXPECT_GT(failures.size(), 150U);
  for (const CaseReport& report : failures)
    EXPECT_NE(pictured_finding(report), nullptr) << report.id;
}

TEST(SvgFigure, StandsAloneAndInAPage) {
  for (const CaseReport& report : random_failures()) {
    const Picture picture(report);
    EXPECT_EQ(picture.root.attribute("role").as_string(), std::string("img"));
    EXPECT_EQ(picture.root.attribute("aria-labelledby").as_string(),
              std::string("p-title p-desc"));
    EXPECT_EQ(picture.root.child("title").attribute("id").as_string(), std::string("p-title"));
    EXPECT_EQ(picture.root.child("desc").attribute("id").as_string(), std::string("p-desc"));
    EXPECT_EQ(picture.root.select_nodes("//@id").size(), 2U);
    for (const char* never : {"<style", "<script", "url(", "nan", "inf"})
      EXPECT_EQ(picture.text.find(never), std::string::npos) << never;
  }
}

TEST(SvgFigure, TellsEveryWrongPointerInWords) {
  for (CaseReport& report : random_failures()) {
    const Picture picture(report);
    const std::string words = picture.root.child("desc").text().get();
    for (const WrongPointer& pointer : finding_of(report).pointers.wrong) {
      if (pointer.name.starts_with("the new ")) continue;  // told as not created
      EXPECT_NE(words.find(pointer.name + " " + must_be_text(pointer)), std::string::npos)
          << pointer.name << "\n"
          << words;
    }
  }
}

TEST(SvgFigure, ListsAndNumbersTheFirstWrongPointers) {
  for (CaseReport& report : random_failures()) {
    const Picture picture(report);
    const std::string list = all_text(picture.panel("list"));
    const std::vector<FigureFault>& faults = finding_of(report).pointers.figure.faults;
    for (std::size_t i = 0; i < std::min<std::size_t>(faults.size(), 12); ++i) {
      const std::string start = faults[i].text.substr(0, 60);
      EXPECT_NE(list.find("\n" + std::to_string(i + 1) + "\n" + start), std::string::npos)
          << start << "\nin\n"
          << list;
    }
  }
}

TEST(SvgFigure, EveryHalfedgeOfTheNeighbourhoodIsInEachPanel) {
  const std::set<std::string> flip_before = {"bc", "ca", "ab", "cb", "bd", "dc"};
  const std::set<std::string> flip_after = {"da", "ab", "bd", "ad", "dc", "ca"};
  const std::set<std::string> split_after = {"bm", "ma", "ab", "mc", "ca", "am",
                                             "mb", "bd", "dm", "cm", "md", "dc"};
  const std::set<std::string> border_before = {"bc",         "ca",         "ab",
                                               "cb outside", "ba outside", "ac outside"};
  const std::set<std::string> border_after = {
      "bm", "ma",         "ab",         "mc",         "ca",
      "am", "mb outside", "cm outside", "ba outside", "ac outside"};
  const std::vector<Case> cases = operation_cases();
  const std::pair<std::set<std::string>, std::set<std::string>> wanted[] = {
      {flip_before, flip_after},
      {flip_before, split_after},
      {flip_before, split_after},
      {border_before, border_after}};
  for (std::size_t i = 0; i < std::size(wanted); ++i) {
    OperationStep step = right_step(cases[i]);
    // The half-edge from b within its triangle: no far side is drawn for its sake.
    step.after.halfedges[step.after.edges[step.edge].halfedge].face = kUnsetRef;
    const Picture picture(judged(cases[i], {to_wire(step)}));
    const auto corners = [&](const char* panel) {
      std::set<std::string> seen;
      for (pugi::xml_node node : picture.of_class("halfedge", picture.panel(panel)))
        EXPECT_TRUE(seen.insert(node.attribute("data-corners").as_string()).second);
      return seen;
    };
    EXPECT_EQ(corners("before"), wanted[i].first) << i;
    EXPECT_EQ(corners("yours"), wanted[i].second) << i;
    EXPECT_EQ(corners("expected"), wanted[i].second) << i;
  }
}

TEST(SvgFigure, OnlyTheWrongHalfedgeIsMarked) {
  for (const Case& c : operation_cases()) {
    for (std::size_t pointer = 0; pointer < 5; ++pointer) {
      OperationStep step = right_step(c);
      const Ref h = step.after.edges[step.edge].halfedge;
      spoil_pointer(step.after, h, pointer, kUnsetRef);
      CaseReport report = judged(c, {to_wire(step)});
      ASSERT_EQ(finding_of(report).pointers.wrong.size(), 1U);
      const Picture picture(report);
      std::set<std::string> wrong;
      for (pugi::xml_node node : picture.of_class("halfedge", picture.panel("yours"))) {
        const std::string words = node.attribute("class").as_string();
        if (words.find("wrong") != std::string::npos)
          wrong.insert(node.child("title").text().get());
      }
      ASSERT_EQ(wrong.size(), 1U);
      EXPECT_TRUE(wrong.begin()->starts_with(halfedge_name(h) + " ")) << *wrong.begin();
      for (const char* panel : {"yours", "expected"}) {
        EXPECT_NE(all_text(picture.panel(panel))
                      .find(std::string("1 ") + pointer_name(Kind::kHalfedge, pointer)),
                  std::string::npos);
      }
      EXPECT_EQ(all_text(picture.panel("before")).find("1 "), std::string::npos);
    }
  }
}

TEST(SvgFigure, LabelsDoNotOverlap) {
  for (const CaseReport& report : random_failures()) {
    const Picture picture(report);
    for (const char* panel : {"before", "yours", "expected"})
      EXPECT_EQ(overlapping_labels(picture.panel(panel)), "") << report.id << " " << panel;
  }
}

TEST(SvgFigure, LabelsOfLargeMeshesDoNotOverlap) {
  for (CaseReport& report : random_failures()) {
    NeighbourhoodFigure& figure = finding_of(report).pointers.figure;
    for (FigurePanel* panel : {&figure.before, &figure.yours, &figure.expected}) {
      for (std::vector<FigureElement>& elements : panel->elements) {
        for (FigureElement& element : elements) {
          if (!element.name.empty()) element.name = element.name[0] + std::string("12345");
        }
      }
    }
    const Picture picture(report);
    for (const char* panel : {"before", "yours", "expected"})
      EXPECT_EQ(overlapping_labels(picture.panel(panel)), "") << report.id << " " << panel;
  }
}

TEST(SvgFigure, SliversLookLikeAnyOtherTriangles) {
  PolygonMesh mesh = sample_polygons("octahedron.off");
  PolygonMesh flat = mesh;
  for (Point3& p : flat.positions)
    p = {p[0] + 1e-9 * p[1], 1e-9 * p[1], p[2] * 1e6};
  std::vector<std::string> pictures;
  for (const PolygonMesh& shape : {mesh, flat}) {
    const Case c = operation_case(shape, OperationKind::kSplit);
    OperationStep step = right_step(c);
    step.after.halfedges[0].next = 0;
    pictures.push_back(to_svg(judged(c, {to_wire(step)}), "p"));
  }
  EXPECT_FALSE(pictures[0].empty());
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(SvgFigure, TextIsReadableOnItsGround) {
  for (const CaseReport& report : random_failures()) {
    const Picture picture(report);
    for (const pugi::xpath_node& found : picture.root.select_nodes("//text")) {
      const pugi::xml_node text = found.node();
      EXPECT_GE(contrast(text.attribute("fill").as_string(), ground_of(text)), 4.5)
          << text.text().get();
    }
  }
}

TEST(SvgFigure, HostileTextStaysText) {
  const std::string hostile = "</desc><script>alert(1)</script>\"'&amp;]]>\x01\xff\n<!--";
  for (CaseReport& report : random_failures()) {
    report.title = hostile;
    Finding& finding = finding_of(report);
    finding.where = finding.meaning = finding.actual = finding.expected = hostile;
    for (FigureFault& fault : finding.pointers.figure.faults)
      fault.text = hostile;
    for (auto& elements : finding.pointers.figure.yours.elements) {
      for (FigureElement& element : elements)
        element.name = hostile;
    }
    const Picture picture(report);
    EXPECT_EQ(picture.root.select_nodes("//script | //comment()").size(), 0U);
    EXPECT_EQ(picture.text.find('\x01'), std::string::npos);
    EXPECT_NE(std::string(picture.root.child("title").text().get()).find("<script>alert(1)"),
              std::string::npos);
    break;
  }
}

TEST(SvgFigure, WhatIsNotCreatedIsShownAsMissing) {
  const Case c = operation_cases()[1];
  OperationStep step = right_step(c);
  MeshDump before = dump_polygons(sample_polygons("octahedron.off"));
  // Only a lonely vertex is created.
  before.vertices.push_back(step.after.vertices.back());
  step.after = before;
  const Picture picture(judged(c, {to_wire(step)}));
  EXPECT_EQ(picture.of_class("halfedge", picture.panel("yours")).size(), 12U);
  std::set<std::string> missing;
  for (pugi::xml_node node : picture.of_class("halfedge", picture.panel("yours"))) {
    const std::string words = node.attribute("class").as_string();
    if (words.find("missing") != std::string::npos)
      missing.insert(node.attribute("data-corners").as_string());
  }
  EXPECT_EQ(missing.size(), 6U);
  EXPECT_NE(all_text(picture.panel("list")).find("Not created: half-edges"), std::string::npos);
}

TEST(SvgFigure, NothingDoneShowsWhatMustBe) {
  const Case c = operation_cases()[0];
  OperationStep step = right_step(c);
  step.after = dump_polygons(sample_polygons("octahedron.off"));
  const Picture picture(judged(c, {to_wire(step)}));
  EXPECT_EQ(all_text(picture.panel("before")).substr(7),
            all_text(picture.panel("yours")).substr(6));
  EXPECT_EQ(picture.of_class("wrong", picture.root).size(), 0U);
  EXPECT_NE(all_text(picture.panel("list")).find("an inner edge is turned"), std::string::npos);
}

TEST(SvgFigure, MovedVertexIsMarkedByItself) {
  const Case c = operation_cases()[1];
  OperationStep step = right_step(c);
  step.after.vertices[step.returned].position[0] += 0.1;
  const Picture picture(judged(c, {to_wire(step)}));
  const auto wrong = picture.of_class("wrong", picture.panel("yours"));
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_EQ(std::string(wrong[0].child("text").text().get()),
            "m " + vertex_name(step.returned));
}

// ---- Loop subdivision ----------------------------------------------------------------------

Case loop_case(const std::string& words) {
  for (const Case& c : standard_cases("loop_subdivision")) {
    if (c.title.find(words) != std::string::npos) return c;
  }
  throw std::out_of_range("no case with " + words);
}

TEST(SvgFigure, WrongVerticesOfLoopAreMarkedWorstFirst) {
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

TEST(SvgFigure, MeshThatIsFarOutsideIsDrawnWithFiniteNumbers) {
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

TEST(SvgFigure, LargeMeshIsShownAroundItsWorstVertex) {
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
  const LoopLevel level = opensubdiv_loop(mesh, VertexRule::kWarren, CornerRule::kSmooth);
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

TEST(SvgFigure, SurfaceThatIsJoinedInAnotherWayIsShownWithItsOddVertices) {
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

TEST(SvgFigure, MeshThatIsDeletedAsAWholeHasNone) {
  const CaseReport report = judged(loop_case("1 level on icosahedron"), {to_wire(MeshDump{})});
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(to_svg(report, "p"), "");
}

TEST(SvgFigure, TheSameCaseGivesTheSameBytes) {
  const std::vector<CaseReport> once = random_failures();
  const std::vector<CaseReport> twice = random_failures();
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_EQ(to_svg(once[i], "p"), to_svg(twice[i], "p"));
}

}  // namespace
}  // namespace meshgrade
