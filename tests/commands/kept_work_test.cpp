// What is kept of earlier checks saves work, and never changes a report. Counted is what is
// the same on every machine: how often the compiler, the linker and the worker are started.

#include "grader/commands/kept_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "grader/grade/grading.h"
#include "grader/report/json_report.h"
#include "tests/commands/command_line.h"
#include "tests/grade/spoiled_reference.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

/// How often programs were started.
struct Starts {
  std::size_t compilers = 0;
  std::size_t linkers = 0;
  std::size_t workers = 0;
};

struct Checked {
  std::string json;
  Starts starts;
};

class KeptWorkTest : public testing::Test {
 protected:
  KeptWorkTest() { ::setenv("XDG_CACHE_HOME", scratch_.path().c_str(), 1); }

  static Assignment standard() { return read_assignment(standard_assignment()); }

  static Submission reference() {
    return find_submission(MESHGRADE_SOURCE_DIR "/reference", SubmissionRules{});
  }

  static Submission wrong(const std::string& name) {
    return find_submission(MESHGRADE_SOURCE_DIR "/tests/submissions/wrong/" + name,
                           SubmissionRules{});
  }

  static Checked check(const Submission& submission, bool keeps_work = true,
                       const Assignment& assignment = standard()) {
    const auto times = std::make_shared<StageTimes>();
    const Home home = find_home({keeps_work, times});
    const Report report = grade(assignment, submission, home, {}, [](const auto&) {});
    Checked checked{to_json(report), {}};
    for (const Stage& stage : times->stages()) {
      if (stage.name == "compile") checked.starts.compilers = stage.count;
      if (stage.name == "link") checked.starts.linkers = stage.count;
      if (stage.name == "run cases in a worker") checked.starts.workers = stage.count;
    }
    return checked;
  }

  static void expect_nothing_started(const Checked& checked) {
    EXPECT_EQ(checked.starts.compilers, 0U);
    EXPECT_EQ(checked.starts.linkers, 0U);
    EXPECT_EQ(checked.starts.workers, 0U);
  }

  std::filesystem::path kept() const { return scratch_.path() / "meshgrade" / "kept"; }

  ScratchFolder scratch_;
};

TEST_F(KeptWorkTest, TheSecondCheckOfTheSameFilesStartsNothingAndSaysTheSame) {
  const Checked plain = check(reference(), false);
  EXPECT_FALSE(std::filesystem::exists(kept()));
  const Checked first = check(reference());
  const Checked second = check(reference());
  EXPECT_GT(plain.starts.compilers, 0U);
  EXPECT_EQ(first.starts.workers, plain.starts.workers);
  EXPECT_EQ(first.json, plain.json);
  EXPECT_EQ(second.json, plain.json);
  expect_nothing_started(second);
}

TEST_F(KeptWorkTest, AfterOneChangedFileOnlyThatIsCompiledAndOnlyWhatCallsItIsRun) {
  Submission submission = reference();
  check(submission);
  for (int save = 1; save <= 3; ++save) {
    SourceFile& normal = submission.sources.at(5);
    ASSERT_EQ(normal.name, "vertex_normal.cpp");
    normal.text += "// saved once more\n";
    const Checked changed = check(submission);
    EXPECT_EQ(changed.starts.workers, 2U);  // the cases, and those that need a fresh process
    // The first time its old neighbours are made into a unit without it.
    EXPECT_EQ(changed.starts.compilers, save == 1 ? 2U : 1U) << save;
    EXPECT_EQ(changed.starts.linkers, 1U);
    EXPECT_EQ(changed.json, check(submission, false).json);
  }
}

TEST_F(KeptWorkTest, AChangedHeaderChangesAll) {
  Submission submission = wrong("edge_split/helper_defined_twice");
  submission.headers = {{"helper.h", "// nothing\n"}};
  const Checked first = check(submission);
  submission.headers[0].text = "// nothing at all\n";
  EXPECT_EQ(check(submission).starts.compilers, first.starts.compilers);
}

TEST_F(KeptWorkTest, WithMembersOfTheStudentsOwnOnlyTheChangedFileIsCompiled) {
  Submission submission = find_submission(
      MESHGRADE_SOURCE_DIR "/tests/dropin_scotty3d/homework/of_2026", SubmissionRules{});
  Assignment assignment = load_assignment("polygon_meshes");
  std::erase_if(assignment.exercises, [](const ExerciseRubric& rubric) {
    return rubric.name != "edge_flip_polygon";
  });
  const Checked first = check(submission, true, assignment);
  EXPECT_EQ(first.starts.compilers, 4U);  // two files of the student's, two of the grader's
  submission.sources.at(0).text += "// saved once more\n";
  const Checked changed = check(submission, true, assignment);
  EXPECT_EQ(changed.starts.compilers, 1U);
  EXPECT_EQ(changed.json, check(submission, false, assignment).json);
  // Another member changes the classes that all of them see.
  submission.headers.push_back(
      {"halfedge.h",
       "class Halfedge_Mesh {\n  class Vertex {\n    bool is_mine = false;\n"
       "  };\n};\n"});
  submission.sources.at(0).text +=
      "bool mine(Halfedge_Mesh::VertexRef v) { return v->is_mine; }\n";
  EXPECT_GE(check(submission, true, assignment).starts.compilers, 4U);
}

TEST_F(KeptWorkTest, WhatAFileWithMacrosCallsIsSeenToHaveChanged) {
  Submission submission = reference();
  SourceFile& loop = submission.sources.at(4);
  SourceFile& split = submission.sources.at(3);
  ASSERT_EQ(loop.name, "loop_subdivision.cpp");
  ASSERT_EQ(split.name, "edge_split.cpp");
  loop.text = "#define SIXTH (1.0 / 6.0)\n" + loop.text;
  const std::string right = split.text;
  split.text.insert(split.text.find("const HalfedgeIter h = e0->halfedge();"),
                    "if (e0->isBoundary()) return VertexIter();\n  ");
  ASSERT_NE(split.text, right);
  EXPECT_EQ(check(submission).json, check(submission, false).json);
  split.text = right;
  EXPECT_EQ(check(submission).json, check(submission, false).json);
}

TEST_F(KeptWorkTest, WhatOnlyAHeaderCallsIsSeenToHaveChanged) {
  Submission submission = reference();
  submission.headers = {
      {"again.h", "inline int turned() { extern int sign(); return sign(); }\n"}};
  SourceFile& normal = submission.sources.at(5);
  ASSERT_EQ(normal.name, "vertex_normal.cpp");
  normal.text.insert(0, "#include \"again.h\"\n");
  const std::string right = "return sum.unit();";
  normal.text.replace(normal.text.find(right), right.size(), "return turned() * sum.unit();");
  submission.sources.push_back({"sign.cpp", "int sign() { return 1; }\n"});
  const Checked before = check(submission);
  EXPECT_EQ(before.json, check(submission, false).json);
  submission.sources.back().text = "int sign() { return -1; }\n";
  const Checked after = check(submission);
  EXPECT_NE(after.json, before.json);
  EXPECT_EQ(after.json, check(submission, false).json);
}

TEST_F(KeptWorkTest, ReportsOfWrongSubmissionsAreTheSame) {
  for (const char* name :
       {"edge_flip/next_wrong", "edge_flip/does_not_compile", "edge_flip/exits",
        "edge_flip/null_pointer", "edge_split/half_of_a_boundary_edge_again",
        "vertex_normal/third_call_wrong", "bezier_curve/without_its_class"}) {
    const Checked plain = check(wrong(name), false);
    EXPECT_EQ(check(wrong(name)).json, plain.json) << name;
    EXPECT_EQ(check(wrong(name)).json, plain.json) << name;
  }
}

TEST_F(KeptWorkTest, WhatEndedByTheClockIsRunAgain) {
  Assignment impatient = standard();
  impatient.limits.case_wall_ms = 300;
  const Submission endless = wrong("edge_flip/sleeps");
  check(endless, true, impatient);
  const Checked again = check(endless, true, impatient);
  EXPECT_EQ(again.starts.compilers, 0U);
  EXPECT_GT(again.starts.workers, 0U);
}

TEST_F(KeptWorkTest, DamageCostsTimeAndNoVerdict) {
  const Checked first = check(reference());
  for (const auto& entry : std::filesystem::directory_iterator(kept()))
    std::filesystem::resize_file(entry, entry.file_size() / 2);
  const Checked second = check(reference());
  EXPECT_EQ(second.json, first.json);
  EXPECT_EQ(second.starts.compilers, first.starts.compilers);
}

TEST_F(KeptWorkTest, NothingIsKeptWhereASubmissionCouldWriteToIt) {
  Home home = find_home();
  home.sandbox.layer = Layer::kSameUser;
  home.sandbox.bounds_files = false;
  keep_work(home);
  EXPECT_EQ(home.kept, nullptr);
  EXPECT_THAT(kept_work_text(home), HasSubstr("submissions could write to it"));
}

using KeptWorkCommand = CommandLine;

TEST_F(KeptWorkCommand, NoCacheKeepsNothingAndDoctorTellsWhatThereIs) {
  const std::filesystem::path kept = scratch_.path() / "cache" / "meshgrade" / "kept";
  const Said without = call({"check", reference(), "vertex_normal", "--no-cache"});
  EXPECT_EQ(without.status, 0) << without.output;
  EXPECT_FALSE(std::filesystem::exists(kept));
  const Said with = call({"check", reference(), "vertex_normal"});
  EXPECT_EQ(with.output, without.output);
  EXPECT_FALSE(std::filesystem::is_empty(kept));
  EXPECT_THAT(call({"doctor"}).output, HasSubstr("in " + kept.string()));
}

TEST_F(KeptWorkCommand, TimingIsATableAndAPartOfTheJsonReport) {
  const std::filesystem::path json = scratch_.path() / "report.json";
  const Said said = call({"check", reference(), "vertex_normal", "--timing", "--json", json});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, testing::ContainsRegex("compile +[12] +[0-9]+ ms"));
  EXPECT_THAT(said.output, testing::ContainsRegex("run cases in a worker +[12] +[0-9]+ ms"));
  std::ifstream stream(json);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_THAT(text, HasSubstr("\"stage\": \"link\""));
}

}  // namespace
}  // namespace meshgrade
