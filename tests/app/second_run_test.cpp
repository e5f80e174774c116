// Subdivision is judged on its own, whatever the student's flip and split do.

#include "grader/app/second_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/app/grading.h"
#include "tests/app/spoiled_reference.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SourceFile broken_split() {
  return spoiled("edge_split.cpp", "return m;", "h->next() = h;\n  ");
}

std::vector<SourceFile> files(SourceFile flip, SourceFile split, SourceFile loop) {
  return {std::move(flip), std::move(split), std::move(loop)};
}

class SecondRun : public testing::Test {
 protected:
  ExerciseReport loop_of(std::vector<SourceFile> sources) {
    Submission submission;
    submission.name = "test";
    submission.sources = std::move(sources);
    const Report report = grade(read_assignment(standard_assignment()), submission, home_,
                                {"loop_subdivision"}, [](const auto&) {});
    return report.exercises.at(0);
  }

  SourceFile flip_ = reference_file("edge_flip.cpp");
  SourceFile split_ = reference_file("edge_split.cpp");
  SourceFile loop_ = reference_file("loop_subdivision.cpp");
  Home home_ = find_home();
};

TEST_F(SecondRun, IsNotNeededWhenAllIsRight) {
  const ExerciseReport report = loop_of(files(flip_, split_, loop_));
  EXPECT_EQ(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.stand_ins, IsEmpty());
}

// Only the caller can see which edges are marked as new: the split's own exercise leaves it
// open.
TEST_F(SecondRun, NamesASplitThatMarksNothingForASubdivisionThatReliesOnIt) {
  const SourceFile forgetful =
      altered("edge_split.cpp", "new_edge->isNew = true;", "new_edge->isNew = false;");
  const ExerciseReport report = loop_of(files(flip_, forgetful, loop_));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_THAT(report.stand_ins, IsEmpty()) << "the points are those of the student's own";
  EXPECT_THAT(
      report.notes,
      Contains(HasSubstr(
          "with a right edge_split in place of yours, loop_subdivision:basic/1 passes")));
}

TEST_F(SecondRun, BlamesNoSplitForASubdivisionThatIsWrongItself) {
  const SourceFile wrong =
      altered("loop_subdivision.cpp", "3.0 / 8.0 * ends", "2.0 / 8.0 * ends");
  for (const std::string& note : loop_of(files(flip_, split_, wrong)).notes)
    EXPECT_THAT(note, testing::Not(HasSubstr("in place of yours")));
}

TEST_F(SecondRun, BlamesNoSplitForASubdivisionThatDependsOnEarlierCases) {
  const SourceFile wrong =
      altered("loop_subdivision.cpp", "// 1. All new points",
              "static int calls = 0;\n  if (++calls > 2) return;\n  // 1. All new points");
  const ExerciseReport report = loop_of(files(flip_, split_, wrong));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  for (const std::string& note : report.notes)
    EXPECT_THAT(note, testing::Not(HasSubstr("in place of yours")));
}

TEST_F(SecondRun, GivesARightSubdivisionItsPointsDespiteABrokenSplit) {
  const ExerciseReport report = loop_of(files(flip_, broken_split(), loop_));
  EXPECT_EQ(report.verdict, Verdict::kPassed);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_EQ(report.extra_points, report.max_extra_points);
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
  EXPECT_THAT(report.notes.at(0), HasSubstr("your own edge_split is part of this and fails"));
  EXPECT_THAT(report.notes.at(1), HasSubstr("32 of 32 cases pass, instead of 0"));
}

TEST_F(SecondRun, JudgesASubdivisionBeforeTheSplitIsWritten) {
  const ExerciseReport report = loop_of({flip_, loop_});
  EXPECT_EQ(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
  EXPECT_THAT(report.notes.at(0),
              HasSubstr("edge_split is part of this and is not written yet"));
}

TEST_F(SecondRun, SaysOfAnUntouchedSkeletonThatNothingIsWritten) {
  EXPECT_THAT(
      loop_of({}).notes,
      testing::IsSupersetOf({"your own edge_flip is part of this and is not written yet",
                             "your own edge_split is part of this and is not written yet"}));
}

TEST_F(SecondRun, FindsWhatIsWrongWithTheSubdivisionItself) {
  const SourceFile wrong =
      spoiled("loop_subdivision.cpp", "// 4. Move all",
              "mesh.verticesBegin()->newPosition = mesh.verticesBegin()->position;\n  ");
  const ExerciseReport report = loop_of(files(flip_, broken_split(), wrong));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(report.cases.at(0).findings.at(0).finding.rule, "position");
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
}

// A place in a file that the student has never seen helps nobody.
TEST_F(SecondRun, ShowsNoFramesOfAStandIn) {
  const SourceFile unset = altered("loop_subdivision.cpp", "mesh.splitEdge(e)->newPosition",
                                   "mesh.splitEdge(EdgeIter())->newPosition");
  const ExerciseReport report = loop_of(files(flip_, broken_split(), unset));
  ASSERT_FALSE(report.cases.at(0).findings.empty());
  const auto& places = report.cases.at(0).findings[0].places;
  ASSERT_FALSE(places.empty());
  for (const CodePlace& place : places)
    EXPECT_NE(place.file.at(0), '~') << place.file;
}

TEST_F(SecondRun, LeavesTheStubsAlone) {
  const ExerciseReport report = loop_of({});
  EXPECT_EQ(report.verdict, Verdict::kNotImplemented);
  EXPECT_THAT(report.stand_ins, IsEmpty());
}

TEST_F(SecondRun, BlamesTheSubdivisionOnlyForItsOwnWhenTheSplitIsRight) {
  const SourceFile wrong = spoiled("loop_subdivision.cpp", "// 4. Move all", "return;\n  ");
  const ExerciseReport report = loop_of(files(flip_, split_, wrong));
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_THAT(report.notes, IsEmpty());
}

TEST_F(SecondRun, TakesBothFunctionsOutOfOneFile) {
  SourceFile all{"all.cpp", spoiled("edge_flip.cpp", "return e0;\n  // SOL",
                                    "f->halfedge() = HalfedgeIter();\n  ")
                                    .text +
                                broken_split().text + loop_.text};
  const ExerciseReport report = loop_of({all});
  EXPECT_EQ(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_flip", "edge_split"));
}

TEST_F(SecondRun, GivesTheExtraCreditToWhoRefusesBoundarySplits) {
  const ExerciseReport report = loop_of(files(
      flip_,
      [&] {
        SourceFile refusing = split_;
        const std::string start = "const HalfedgeIter h = e0->halfedge();";
        refusing.text.insert(refusing.text.find(start),
                             "if (e0->isBoundary()) return VertexIter();\n  ");
        return refusing;
      }(),
      loop_));
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_EQ(report.extra_points, report.max_extra_points);
}

TEST_F(SecondRun, SaysWhenTheFunctionCannotBeTakenOut) {
  SourceFile hidden = broken_split();
  const std::string name = "HalfedgeMesh::splitEdge(";
  const std::size_t at = hidden.text.find("VertexIter " + name);
  hidden.text.replace(at, 11 + name.size(), "VertexIter MINE(");
  hidden.text.insert(0, "#define MINE HalfedgeMesh::splitEdge\n");
  const ExerciseReport report = loop_of(files(flip_, hidden, loop_));
  EXPECT_EQ(report.points, 0.0);
  EXPECT_THAT(report.notes, Contains(HasSubstr("could not be run again")));
}

TEST_F(SecondRun, SaysWhenThePackageHasNoReference) {
  home_.reference.clear();
  const ExerciseReport report = loop_of(files(flip_, broken_split(), loop_));
  EXPECT_EQ(report.points, 0.0);
  EXPECT_NE(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.notes.at(0), HasSubstr("your own edge_split is part of this and fails"));
  EXPECT_THAT(report.notes.at(1), HasSubstr("this package comes without one"));
}

}  // namespace
}  // namespace meshgrade
