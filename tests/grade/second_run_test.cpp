// Subdivision is judged on its own, whatever the student's flip and split do.

#include "grader/grade/second_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "grader/grade/grading.h"
#include "tests/grade/spoiled_reference.h"
#include "tests/support/home_that_keeps.h"
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
  ExerciseReport loop_of(std::vector<SourceFile> sources,
                         std::vector<SourceFile> headers = {}) {
    Submission submission;
    submission.name = "test";
    submission.sources = std::move(sources);
    submission.headers = std::move(headers);
    return loop_of_submission(submission);
  }

  ExerciseReport loop_of_submission(const Submission& submission) {
    const Report report = grade(read_assignment(standard_assignment()), submission, home_,
                                {"loop_subdivision"}, [](const auto&) {});
    return report.exercises.at(0);
  }

  SourceFile flip_ = reference_file("edge_flip.cpp");
  SourceFile split_ = reference_file("edge_split.cpp");
  SourceFile loop_ = reference_file("loop_subdivision.cpp");
  Home home_ = home_that_keeps();
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
  EXPECT_THAT(report.notes.at(1), HasSubstr("cases pass, instead of 0; these points count"));
}

TEST_F(SecondRun, JudgesASubdivisionBeforeTheSplitIsWritten) {
  const ExerciseReport report = loop_of({flip_, loop_});
  EXPECT_EQ(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
  EXPECT_THAT(report.notes.at(0),
              HasSubstr("edge_split is part of this and is not written yet"));
}

TEST_F(SecondRun, FindsMistakesInASubdivisionBeforeTheSplitIsWritten) {
  const SourceFile wrong =
      altered("loop_subdivision.cpp", "3.0 / 8.0 * ends", "2.0 / 8.0 * ends");
  const ExerciseReport report = loop_of({flip_, wrong});
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(report.cases.at(0).findings.at(0).finding.rule, "position");
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
}

TEST_F(SecondRun, SaysOfAnUntouchedSkeletonThatNothingIsWritten) {
  EXPECT_THAT(
      loop_of({}).notes,
      testing::IsSupersetOf({"your own edge_flip is part of this and is not written yet",
                             "your own edge_split is part of this and is not written yet"}));
}

// The hole: the extra-credit part of the split is missing, so a stand-in came in, and hid that
// the student's own parts do not fit together.
TEST_F(SecondRun, ComesNotWhileTheSplitDoesAllThatItMust) {
  SourceFile forgetful =
      altered("edge_split.cpp", "new_edge->isNew = true;", "new_edge->isNew = false;");
  const std::string start = "const HalfedgeIter h = e0->halfedge();";
  forgetful.text.insert(forgetful.text.find(start),
                        "if (e0->isBoundary()) return VertexIter();\n  ");
  const ExerciseReport report = loop_of(files(flip_, forgetful, loop_));
  EXPECT_EQ(report.points, 0.0);
  EXPECT_EQ(report.extra_points, 0.0);
  EXPECT_THAT(report.stand_ins, IsEmpty());
  EXPECT_THAT(report.notes, Contains(HasSubstr("your edge_split is right on its own")));
}

/// The marks that a split leaves on the two halves of an edge that was marked `before`.
struct Marks {
  const char* name;
  const char* before;
  const char* wanted;  ///< a condition on the marks `one` and `other`
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Marks& marks, std::ostream* out) {
  *out << marks.name;
}

class MarksOfTheHalves : public SecondRun, public testing::WithParamInterface<Marks> {};

// They are between a split and its caller: a right split may leave, clear or set them.
TEST_P(MarksOfTheHalves, AreThoseThatTheSubdivisionReliesOn) {
  SourceFile relying = loop_;
  const std::string split = "mesh.splitEdge(e)->newPosition = point;";
  const std::size_t at = relying.text.find(split);
  ASSERT_NE(at, std::string::npos);
  relying.text.replace(
      at, split.size(),
      "e->isNew = " + std::string(GetParam().before) +
          ";\n    const VertexIter m = mesh.splitEdge(e);\n    m->newPosition = point;\n"
          "    const EdgeIter half = m->halfedge()->edge();\n    const EdgeIter rest = "
          "m->halfedge()->twin()->next()->twin()->next()->edge();\n"
          "    const bool one = half->isNew;\n    const bool other = rest->isNew;\n"
          "    if (!(" +
          GetParam().wanted + ")) return;\n    half->isNew = rest->isNew = false;");
  const ExerciseReport report = loop_of(files(flip_, broken_split(), relying));
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
}

INSTANTIATE_TEST_SUITE_P(Split, MarksOfTheHalves,
                         testing::Values(Marks{"left", "true", "one != other"},
                                         Marks{"cleared", "true", "!one && !other"},
                                         Marks{"set", "false", "one && other"}),
                         [](const testing::TestParamInfo<Marks>& marks) {
                           return marks.param.name;
                         });

TEST_F(SecondRun, KeepsWhatTheFirstRunFoundWhereTheCaseFailsAllTheSame) {
  const SourceFile wrong =
      altered("loop_subdivision.cpp", "3.0 / 8.0 * ends", "2.0 / 8.0 * ends");
  const SourceFile refusing = altered(
      "edge_split.cpp", "const HalfedgeIter h = e0->halfedge();", "const HalfedgeIter h;");
  const ExerciseReport report = loop_of(files(flip_, refusing, wrong));
  EXPECT_EQ(report.points, 0.0);
  EXPECT_EQ(report.cases.at(0).findings.at(0).finding.rule, "unset-handle");
  EXPECT_THAT(report.notes,
              Contains(HasSubstr("loop_subdivision:basic/1 fails with a right solution of "
                                 "edge_split, too: the positions are those of Loop")));
}

// Crashes begin new processes in the first run, so that the third call comes nowhere; the
// second run has it in the third case, which passes alone.
TEST_F(SecondRun, CountsWhatTheSubdivisionKeepsFromCallToCall) {
  const SourceFile wrong =
      altered("loop_subdivision.cpp", "// 1. All new points",
              "static int calls = 0;\n  if (++calls == 3) return;\n  // 1. All new points");
  const SourceFile often =
      spoiled("edge_split.cpp", "return m;", "if (nFaces() < 40) std::abort();\n  ");
  const ExerciseReport report = loop_of(files(flip_, often, wrong));
  EXPECT_NE(report.verdict, Verdict::kPassed);
  EXPECT_LT(report.points, report.max_points);
}

TEST_F(SecondRun, FindsWhatIsWrongWithTheSubdivisionItself) {
  const SourceFile wrong =
      spoiled("loop_subdivision.cpp", "// 4. Move all",
              "mesh.verticesBegin()->newPosition = mesh.verticesBegin()->position;\n  ");
  const ExerciseReport report = loop_of(files(flip_, broken_split(), wrong));
  EXPECT_NE(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.notes, Contains(HasSubstr("fails with a right solution of edge_split, "
                                               "too: the positions are those of Loop")));
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

TEST_F(SecondRun, TakesAFunctionOutOfAHeader) {
  const SourceFile including{"edge_split.cpp", "#include \"split.h\"\n"};
  const SourceFile header{"split.h", "#pragma once\n" + broken_split().text};
  const ExerciseReport report = loop_of(files(flip_, including, loop_), {header});
  EXPECT_EQ(report.verdict, Verdict::kPassed);
  EXPECT_THAT(report.stand_ins, ElementsAre("edge_split"));
}

/// A split that leaves boundary edges as they are.
SourceFile refusing(SourceFile split) {
  const std::string start = "const HalfedgeIter h = e0->halfedge();";
  split.text.insert(split.text.find(start), "if (e0->isBoundary()) return VertexIter();\n  ");
  return split;
}

TEST_F(SecondRun, GivesTheExtraCreditToWhoRefusesBoundarySplits) {
  const ExerciseReport report = loop_of(files(flip_, refusing(split_), loop_));
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_EQ(report.extra_points, report.max_extra_points);
}

TEST_F(SecondRun, GivesTheExtraCreditToWhoAsksForBoundariesInAHeaderOrAMacro) {
  SourceFile loop = loop_;
  loop.text = "#include \"rim.h\"\n" +
              std::regex_replace(loop.text,
                                 std::regex("((?:\\w+->)*\\w+(?:\\(\\))?)->isBoundary\\(\\)"),
                                 "ON_RIM($1)");
  loop.text = std::regex_replace(loop.text, std::regex("boundary"), "rim");
  ASSERT_EQ(loop.text.find("oundar"), std::string::npos);
  const std::string macro = "#define ON_RIM(x) (x)->isBoundary()\n";
  const SourceFile split = refusing(split_);
  const ExerciseReport by_header = loop_of(files(flip_, split, loop), {{"rim.h", macro}});
  EXPECT_EQ(by_header.extra_points, by_header.max_extra_points);
  loop.text = macro + loop.text.substr(loop.text.find('\n') + 1);
  const ExerciseReport by_macro = loop_of(files(flip_, split, loop));
  EXPECT_EQ(by_macro.extra_points, by_macro.max_extra_points);
}

TEST_F(SecondRun, GivesTheExtraCreditToWhoAsksForBoundariesInAMemberOfTheirOwn) {
  SourceFile loop = loop_;
  loop.text = "#include \"student_code.h\"\n" +
              std::regex_replace(loop.text, std::regex("isBoundary"), "onRim");
  loop.text = std::regex_replace(loop.text, std::regex("boundary"), "rim");
  ASSERT_EQ(loop.text.find("oundar"), std::string::npos);
  Submission submission;
  submission.name = "test";
  submission.dialect = Dialect::kCourse2020;
  submission.sources = files(flip_, refusing(split_), loop);
  std::string header;
  for (const char* element : {"Halfedge", "Vertex", "Edge", "Face"}) {
    header += std::string("class ") + element +
              " {\n public:\n  bool onRim() const { return isBoundary(); }\n};\n";
  }
  submission.course_headers = {{"halfEdgeMesh.h", header}};
  const ExerciseReport report = loop_of_submission(submission);
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
