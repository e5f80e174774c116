// A homework that lies in the course's project, among the course's own files, is the homework
// alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "grader/base/process.h"
#include "grader/submission/course_files.h"
#include "grader/submission/dialect.h"
#include "tests/dropin/course_project.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kHomework = fs::path(MESHGRADE_SOURCE_DIR) / "tests" / "dropin" / "homework";

std::vector<std::string> all_text(const std::vector<SourceFile>& files) {
  std::vector<std::string> texts;
  for (const SourceFile& file : files)
    texts.push_back(file.name + "\n" + file.text);
  return texts;
}

void expect_same_work(const Submission& alone, const Submission& whole) {
  EXPECT_EQ(whole.dialect, alone.dialect);
  EXPECT_EQ(all_text(whole.sources), all_text(alone.sources));
  EXPECT_EQ(all_text(whole.headers), all_text(alone.headers));
}

class WholeProject : public testing::TestWithParam<std::string> {};

TEST_P(WholeProject, IsTheHomeworkInIt) {
  const ScratchFolder folder;
  put_into_course_project(kHomework / GetParam(), folder.path());
  expect_same_work(find_submission(kHomework / GetParam(), SubmissionRules()),
                   find_submission(folder.path(), SubmissionRules()));
}

TEST_P(WholeProject, MayLieDeeperBesideAReport) {
  const ScratchFolder folder;
  put_into_course_project(kHomework / GetParam(), folder.path() / "hand-in" / "p2-meshedit");
  fs::create_directories(folder.path() / "hand-in" / "report");
  std::ofstream(folder.path() / "hand-in" / "report.pdf") << "%PDF";
  expect_same_work(find_submission(kHomework / GetParam(), SubmissionRules()),
                   find_submission(folder.path(), SubmissionRules()));
}

INSTANTIATE_TEST_SUITE_P(Years, WholeProject,
                         testing::Values("of_2016", "of_2017", "of_2019", "since_2020",
                                         "one_point", "untouched", "untouched_2016",
                                         "untouched_2017", "added_members"),
                         [](const auto& tested) { return tested.param; });

TEST(CourseFiles, AreKnownByName) {
  for (const char* name : {"camera", "collada", "light", "material", "mesh", "scene", "texture",
                           "meshEdit", "bezierCurve", "bezierPatch", "halfEdgeMesh", "png"}) {
    EXPECT_TRUE(is_course_file({std::string(name) + ".cpp", "namespace CGL { int n; }\n"}));
    EXPECT_TRUE(is_course_file({std::string(name) + ".h", "namespace CGL { class C; }\n"}));
  }
  EXPECT_FALSE(is_course_file({"student_code.cpp", "namespace CGL {}\n"}));
  EXPECT_FALSE(is_course_file({"my_helpers.cpp", "namespace CGL {}\n"}));
}

TEST(CourseFiles, ASourceWithAGradedFunctionIsTheStudentsWhateverItsName) {
  EXPECT_FALSE(is_course_file(
      {"mesh.cpp", "namespace CGL { Vector3D Vertex::normal( void ) const { return 1; } }"}));
  EXPECT_FALSE(
      is_course_file({"bezierCurve.cpp", "void CGL::BezierCurve::evaluateStep() { t = 0; }"}));
}

TEST(CourseFiles, ACallOrADeclarationIsNoDefinition) {
  EXPECT_TRUE(is_course_file(
      {"meshEdit.cpp", "void f() { HalfedgeMesh::flipEdge(e); if (x) { g(); } }"}));
  EXPECT_TRUE(is_course_file({"mesh.cpp", "// Vector3D Vertex::normal() const { }\n"}));
}

TEST(CourseFiles, WhatBuildsOnTheStudentsHeaderIsTheStudents) {
  EXPECT_FALSE(is_course_file(
      {"mesh.cpp",
       "#include \"student_code.h\"\nnamespace CGL { double mine() { return 1; } }"}));
  EXPECT_TRUE(is_course_file({"meshEdit.cpp", "#include \"student_code.h\"\n"}));
}

TEST(CourseFiles, AHeaderWithoutAdditionsIsAsHandedOut) {
  const std::string head =
      "#include \"halfEdgeMesh.h\"\nusing namespace std;\nnamespace CGL {\n";
  const std::string body =
      "class MeshResampler{\npublic:\nMeshResampler(){};\n~MeshResampler(){}\n"
      "void upsample(HalfedgeMesh& mesh);\n";
  EXPECT_TRUE(is_as_handed_out({"student_code.h", head + body + "};\n}\n"}));
  EXPECT_FALSE(is_as_handed_out({"student_code.h", head + body + "int calls;\n};\n}\n"}));
  EXPECT_FALSE(is_as_handed_out({"other.h", head + body + "};\n}\n"}));
}

TEST(WholeProject, ManyFilesOfTheCourseAreToldInOneLine) {
  const ScratchFolder folder;
  put_into_course_project(kHomework / "since_2020", folder.path());
  const Submission submission = find_submission(folder.path(), SubmissionRules());
  EXPECT_EQ(submission.course_sources.size(), 13U);
  EXPECT_EQ(submission.notes.size(), 3U);
  for (const std::string& note : submission.notes)
    EXPECT_LT(note.size(), 160U) << note;
}

TEST(WholeProject, TheStudentsFilesCountFirst) {
  const ScratchFolder folder;
  put_into_course_project(kHomework / "since_2020", folder.path());
  SubmissionRules rules;
  rules.files = 2;
  const Submission submission = find_submission(folder.path(), rules);
  ASSERT_EQ(submission.sources.size(), 1U);
  EXPECT_EQ(submission.sources[0].name, "student_code.cpp");
  EXPECT_EQ(submission.headers.size(), 1U);
}

}  // namespace
}  // namespace meshgrade
