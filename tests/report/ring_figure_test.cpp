// Pictures of wrong operations on polygons: what is in them, and that they can be read.

#include "grader/judge/ring_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grader/base/random.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"
#include "grader/report/svg_figure.h"
#include "tests/report/figure_support.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

/// An operation that has one right answer on an element.
struct Done {
  std::string name;
  const LocalOperation& operation;
  MeshDump before;
  Picked picked;
  Answer answer;
  MeshDump right;
};

template <class Visit>
void for_every_done(Visit visit) {
  for (const std::string& exercise : all_exercises()) {
    const LocalOperation* operation = find_local_operation(exercise);
    if (operation == nullptr || operation->picks_two) continue;
    for (const char* file :
         {"prism_5.obj", "quad_grid_3x3.obj", "tetrahedron.obj", "umbrella.obj"}) {
      const MeshDump mesh = sample_dump(file);
      const FaceLists lists = face_lists_of(mesh);
      for (std::uint32_t i = 0; i < count_elements(mesh, operation->picks); ++i) {
        const Picked picked = pick(mesh, operation->picks, i);
        const Answer answer = operation->answer(lists, picked);
        if (answer.demand != Demand::kMust) continue;
        visit(Done{exercise + " " + std::to_string(i) + " of " + file, *operation, mesh, picked,
                   answer, mesh_of(answer.after)});
      }
    }
  }
}

RingFigure figure_of(const Done& done, const MeshDump& after,
                     const std::optional<LabelMap>& known = std::nullopt) {
  return figure_of_ring(done.before, done.picked, done.answer, after, known, "e5");
}

std::size_t differing(const RingPanel& panel) {
  return static_cast<std::size_t>(
      std::count_if(panel.faces.begin(), panel.faces.end(),
                    [](const RingFace& face) { return face.differs; }));
}

CaseReport report_with(RingFigure ring) {
  Finding finding;
  finding.rule = "surface";
  finding.element = "e5";
  finding.ring = std::move(ring);
  CaseReport report;
  report.id = "edge_collapse:basic/1";
  report.title = "collapse e5";
  report.findings.push_back({finding, {}});
  return report;
}

TEST(RingFigure, OfARightAnswerHasNoFaceThatDiffers) {
  std::size_t drawn = 0;
  std::size_t all = 0;
  for_every_done([&](const Done& done) {
    ++all;
    const auto known = match_faces(done.answer, face_lists_of(done.right));
    ASSERT_TRUE(known) << done.name;
    const RingFigure figure = figure_of(done, done.right, known);
    if (figure.empty()) return;
    ++drawn;
    EXPECT_EQ(differing(figure.yours), 0U) << done.name;
    EXPECT_EQ(differing(figure.expected), 0U) << done.name;
    EXPECT_EQ(figure.yours.faces.size(), figure.expected.faces.size()) << done.name;
    for (const RingVertex& vertex : figure.expected.vertices)
      EXPECT_NE(vertex.name, "new") << done.name;
  });
  EXPECT_GT(drawn, 150U);
  EXPECT_GT(10 * drawn, 9 * all);  // a ring that is no disc is rare
}

TEST(RingFigure, OfNothingDoneShowsWhatIsMissingAndWhatIsLeft) {
  for_every_done([&](const Done& done) {
    const RingFigure figure = figure_of(done, done.before);
    if (figure.empty()) return;
    EXPECT_GT(differing(figure.yours) + differing(figure.expected), 0U) << done.name;
    EXPECT_EQ(figure.yours.faces.size(), figure.before.faces.size()) << done.name;
    EXPECT_EQ(differing(figure.before), 0U) << done.name;
  });
}

TEST(RingFigure, RimVerticesHaveTheSamePlaceInEveryPanel) {
  for_every_done([&](const Done& done) {
    const RingFigure figure = figure_of(done, done.right);
    std::map<std::string, std::size_t> places;
    for (const RingPanel* panel : {&figure.before, &figure.yours, &figure.expected}) {
      for (const RingVertex& vertex : panel->vertices) {
        if (vertex.rim == kInsideRim) continue;
        EXPECT_LT(vertex.rim, figure.rim);
        EXPECT_EQ(places.insert({vertex.name, vertex.rim}).first->second, vertex.rim);
      }
    }
  });
}

TEST(RingFigure, CanBeReadInThePictureAndInWords) {
  for_every_done([&](const Done& done) {
    const CaseReport report = report_with(figure_of(done, done.before));
    const RingFigure& figure = report.findings[0].finding.ring;
    if (figure.empty()) return;
    const Picture picture(report);
    const std::string words = picture.root.child("desc").text().get();
    for (const char* name : {"before", "yours", "expected"})
      EXPECT_EQ(overlapping_labels(picture.panel(name)), "") << done.name << " " << name;
    EXPECT_EQ(picture.of_class("differs", picture.panel("expected")).size(),
              differing(figure.expected))
        << done.name;
    const std::string shown = all_text(picture.panel("before"));
    for (const RingVertex& vertex : figure.before.vertices) {
      EXPECT_NE(shown.find(vertex.name), std::string::npos) << done.name;
      EXPECT_NE(words.find(vertex.name), std::string::npos) << done.name;
    }
    // At a boundary there may be nothing but faces to remove.
    EXPECT_EQ(words.find("(missing)") != std::string::npos, differing(figure.expected) > 0);
    EXPECT_EQ(words.find("(not asked for)") != std::string::npos, differing(figure.yours) > 0);
  });
}

TEST(RingFigure, OfAnyPointersIsFiniteOrNotThere) {
  Random random(11, "ring");
  for_every_done([&](const Done& done) {
    MeshDump spoiled = done.right;
    for (int i = 0; i < 6; ++i) {
      const auto n = static_cast<std::uint32_t>(spoiled.halfedges.size());
      HalfedgeRecord& h = spoiled.halfedges[random.below(n)];
      const Ref target = random.below(2) == 0 ? kUnsetRef : random.below(99);
      (random.below(2) == 0 ? h.next : h.vertex) = target;
    }
    spoiled.faces[0].halfedge = 12'345;
    const std::string text = to_svg(report_with(figure_of(done, spoiled)), "p");
    for (const char* never : {"nan", "\"inf", "\"-inf"})
      EXPECT_EQ(text.substr(std::min(text.size(), text.find("</desc>"))).find(never),
                std::string::npos)
          << done.name;
  });
}

}  // namespace
}  // namespace meshgrade
