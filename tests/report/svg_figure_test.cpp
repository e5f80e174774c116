// Pictures of wrong flips and splits: what is in them, and that they can be read.

#include "grader/report/svg_figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "grader/base/random.h"
#include "grader/report/svg_pen.h"
#include "tests/report/figure_support.h"
#include "tests/support/right_answers.h"

namespace meshgrade {
namespace {

using Kind = ElementKind;

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

TEST(SvgFigure, DeletedOldElementsAreShownAsMissing) {
  for (const Case& c : operation_cases()) {
    OperationStep step = right_step(c);
    const Ref h = step.after.edges[step.edge].halfedge;
    step.after.halfedges[h] = {kUnsetRef, kUnsetRef, kUnsetRef, kUnsetRef, kUnsetRef, 0};
    CaseReport report = judged(c, {to_wire(step)});
    EXPECT_EQ(finding_of(report).element, halfedge_name(h));
    const Picture picture(report);
    const auto missing = picture.of_class("missing", picture.panel("yours"));
    ASSERT_EQ(missing.size(), 2U) << c.id() << ": the arrow, and its name";
    EXPECT_NE(all_text(picture.panel("yours")).find("no " + halfedge_name(h)),
              std::string::npos);
    EXPECT_NE(
        all_text(picture.panel("list")).find("Deleted, but must stay: " + halfedge_name(h)),
        std::string::npos);
    EXPECT_NE(std::string(picture.root.child("desc").text().get())
                  .find("deleted, but must stay: " + halfedge_name(h)),
              std::string::npos);
    EXPECT_EQ(overlapping_labels(picture.panel("yours")), "");
  }
}

TEST(SvgFigure, PointerToWhatWasDeletedIsNotToldAsSet) {
  const Case c = operation_cases()[0];
  OperationStep step = right_step(c);
  const Ref h = step.after.edges[step.edge].halfedge;
  const Ref twin = step.after.halfedges[h].twin;
  step.after.halfedges[h] = {kUnsetRef, kUnsetRef, kUnsetRef, kUnsetRef, kUnsetRef, 0};
  step.after.halfedges[twin].twin = h | kDeletedBit;
  CaseReport report = judged(c, {to_wire(step)});
  std::string words;
  for (const FigureFault& fault : finding_of(report).pointers.figure.faults)
    if (!fault.was_set) words += fault.text + "\n";
  EXPECT_NE(words.find(halfedge_name(twin) + ".twin must be"), std::string::npos) << words;
}

TEST(SvgFigure, OldEdgeWithAnotherInItsPlaceIsToldAsDeleted) {
  const Case c = operation_cases()[0];
  OperationStep step = right_step(c);
  MeshDump& mesh = step.after;
  const auto fresh = static_cast<Ref>(mesh.edges.size());
  mesh.edges.push_back(mesh.edges[step.edge]);
  mesh.edges[step.edge] = {kUnsetRef, 0};
  for (HalfedgeRecord& h : mesh.halfedges)
    if (h.edge == step.edge) h.edge = fresh;
  const Picture picture(judged(c, {to_wire(step)}));
  const std::string list = all_text(picture.panel("list"));
  EXPECT_NE(list.find("Created, but not needed: " + edge_name(fresh)), std::string::npos);
  EXPECT_NE(list.find("Deleted, but must stay: " + edge_name(step.edge)), std::string::npos);
}

TEST(SvgFigure, StoppedOperationShowsWhatWasDoneUntilThen) {
  const Case c = operation_cases()[1];
  OperationStep step = right_step(c);
  const MeshDump before = dump_polygons(sample_polygons("octahedron.off"));
  const Ref h = before.edges[step.edge].halfedge;
  step.after = before;
  step.after.halfedges[h].next = before.halfedges[h].twin;
  Outcome outcome;
  outcome.ending = Ending::kFault;
  outcome.fault_kind = static_cast<std::uint32_t>(meshedit::FaultKind::kUnsetHandle);
  outcome.subject = "HalfedgeIter";
  outcome.interrupted = to_wire(step);
  CaseReport report = judged(c, outcome);
  EXPECT_EQ(report.verdict, Verdict::kCrashed);
  const NeighbourhoodFigure& figure = finding_of(report).pointers.figure;
  ASSERT_EQ(figure.faults.size(), 1U) << "what was still to be done is no fault";
  const Picture picture(report);
  EXPECT_NE(all_text(picture.panel("yours")).find("when it was stopped"), std::string::npos);
  const std::string list = all_text(picture.panel("list"));
  EXPECT_NE(list.find(halfedge_name(h) + ".next"), std::string::npos);
  EXPECT_NE(list.find("Not yet created: half-edges"), std::string::npos);
  EXPECT_EQ(list.find("Not changed"), std::string::npos);
}

TEST(SvgFigure, StopInAStateThatCannotBeReadHasNone) {
  const Case c = operation_cases()[1];
  OperationStep step = right_step(c);
  step.edge += 1;
  Outcome outcome;
  outcome.ending = Ending::kFault;
  for (const std::string& state : {std::string("xxx"), to_wire(step)}) {
    outcome.interrupted = state;
    const CaseReport report = judged(c, outcome);
    EXPECT_EQ(report.verdict, Verdict::kCrashed);
    EXPECT_EQ(to_svg(report, "p"), "");
  }
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

TEST(SvgFigure, TheSameCaseGivesTheSameBytes) {
  const std::vector<CaseReport> once = random_failures();
  const std::vector<CaseReport> twice = random_failures();
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_EQ(to_svg(once[i], "p"), to_svg(twice[i], "p"));
}

}  // namespace
}  // namespace meshgrade
