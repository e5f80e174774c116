// Homework for Scotty3D is recognised alone, in the course's project and in an archive of it;
// the course's own files are left out.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "grader/base/process.h"
#include "grader/commands/context.h"
#include "grader/submission/dialect.h"
#include "grader/submission/scotty3d_files.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kScotty3dHomework =
    fs::path(MESHGRADE_SOURCE_DIR) / "tests" / "dropin_scotty3d" / "homework";

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// Puts a homework among files that are named as those of the course's project.
void put_into_scotty3d_project(const fs::path& homework, const fs::path& project) {
  const fs::path geometry = project / "src" / "geometry";
  fs::create_directories(geometry);
  for (const char* name :
       {"halfedge.cpp", "halfedge-utility.cpp", "indexed.cpp", "spline.cpp", "util.cpp"}) {
    write(geometry / name,
          "#include \"halfedge.h\"\nint Halfedge_Mesh::of_course() { return 1; }\n");
  }
  for (const char* name : {"halfedge.h", "indexed.h", "spline.h", "util.h"})
    write(geometry / name, "#pragma once\nclass Of_Course;\n");
  write(project / "src" / "main.cpp", "int main() {}\n");
  write(project / "src" / "lib" / "mathlib.h", "#pragma once\n");
  write(project / "src" / "rasterizer" / "pipeline.cpp", "int pipeline;\n");
  write(project / "tests" / "a2" / "test.a2.l1.edge_flip.cpp", "int test;\n");
  write(project / "README.md", "The project.\n");
  for (const auto& file : fs::directory_iterator(homework))
    fs::copy(file.path(), geometry, fs::copy_options::overwrite_existing);
}

std::vector<std::string> names_and_texts(const std::vector<SourceFile>& files) {
  std::vector<std::string> all;
  for (const SourceFile& file : files)
    all.push_back(file.name + "\n" + file.text);
  return all;
}

void expect_same_scotty3d_work(const Submission& alone, const Submission& whole) {
  EXPECT_EQ(whole.dialect, Dialect::kScotty3d);
  EXPECT_EQ(names_and_texts(whole.sources), names_and_texts(alone.sources));
  EXPECT_EQ(names_and_texts(whole.headers), names_and_texts(alone.headers));
}

class Scotty3dProject : public testing::TestWithParam<std::string> {};

TEST_P(Scotty3dProject, IsTheHomeworkInIt) {
  const ScratchFolder folder;
  put_into_scotty3d_project(kScotty3dHomework / GetParam(), folder.path());
  const Submission alone = find_submission(kScotty3dHomework / GetParam(), SubmissionRules());
  expect_same_scotty3d_work(alone, find_submission(folder.path(), SubmissionRules()));
}

TEST_P(Scotty3dProject, MayLieInAnArchive) {
  const ScratchFolder folder;
  put_into_scotty3d_project(kScotty3dHomework / GetParam(), folder.path() / "Scotty3D");
  const ScratchFolder hand_in;
  const Submission alone = find_submission(kScotty3dHomework / GetParam(), SubmissionRules());
  const std::string archive = (hand_in.path() / "a2.tar.gz").string();
  ASSERT_EQ(
      std::system(
          ("tar -czf " + archive + " -C " + folder.path().string() + " Scotty3D").c_str()),
      0);
  expect_same_scotty3d_work(alone, find_submission(archive, SubmissionRules()));
}

INSTANTIATE_TEST_SUITE_P(Years, Scotty3dProject,
                         testing::Values("of_2022", "of_2024", "of_2026", "untouched"),
                         [](const auto& tested) { return tested.param; });

TEST(Scotty3dProject, LeavesOutTheCoursesFilesInOneLine) {
  const ScratchFolder folder;
  put_into_scotty3d_project(kScotty3dHomework / "untouched", folder.path());
  const Submission submission = find_submission(folder.path(), SubmissionRules());
  EXPECT_EQ(submission.sources.size(), 2U);
  EXPECT_EQ(submission.course_sources.size(), 5U);
  EXPECT_EQ(submission.course_headers.size(), 4U);
  EXPECT_EQ(submission.notes.size(), 3U);
}

TEST(Scotty3dFiles, ASourceWithAGradedFunctionIsTheStudentsWhateverItsName) {
  EXPECT_TRUE(is_scotty3d_course_file({"halfedge.cpp", "void Halfedge_Mesh::swap() {}\n"}));
  EXPECT_FALSE(is_scotty3d_course_file({"halfedge.cpp",
                                        "std::optional<Halfedge_Mesh::EdgeRef> "
                                        "Halfedge_Mesh::flip_edge(EdgeRef e) { return e; }"}));
  EXPECT_FALSE(is_scotty3d_course_file({"my_helpers.cpp", "int n;\n"}));
}

Dialect dialect_of(const std::string& name, const std::string& text) {
  Submission submission;
  submission.sources = {{name, text}};
  settle_dialect(submission);
  return submission.dialect;
}

TEST(Scotty3dDialect, IsKnownByNameOrByItsFunctions) {
  EXPECT_EQ(dialect_of("halfedge-local.cpp", "// nothing yet\n"), Dialect::kScotty3d);
  EXPECT_EQ(dialect_of("mine.cpp",
                       "std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef "
                       "e) { e->halfedge->next = e->halfedge; return e; }"),
            Dialect::kScotty3d);
  EXPECT_EQ(dialect_of("mine.cpp", "// Halfedge_Mesh::flip_edge(EdgeRef e) {}\n"),
            Dialect::kMeshedit);
}

TEST(Scotty3dDialect, OfEarlierYearsIsToldThatItIsNotGraded) {
  Submission submission;
  submission.sources = {{"meshedit.cpp",
                         "std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge("
                         "Halfedge_Mesh::EdgeRef e) { e->halfedge() = e->halfedge()->twin(); "
                         "return e; }"}};
  settle_dialect(submission);
  ASSERT_EQ(submission.notes.size(), 1U);
  EXPECT_NE(submission.notes[0].find("2020 to Spring 2022"), std::string::npos);
}

TEST(Scotty3dDialect, OfEarlierYearsIsAnotherOne) {
  EXPECT_NE(
      dialect_of("meshedit.cpp",
                 "std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(Halfedge_"
                 "Mesh::EdgeRef e) { HalfedgeRef h = e->halfedge(); h->next() = h->twin(); "
                 "return e; }"),
      Dialect::kScotty3d);
}

TEST(Scotty3dDialect, IsOfTheSecondAssignment) {
  EXPECT_EQ(load_assignment_of("", kScotty3dHomework / "of_2022").folder, "polygon_meshes");
  EXPECT_EQ(load_assignment_of("", kScotty3dHomework / "untouched").folder, "polygon_meshes");
}

}  // namespace
}  // namespace meshgrade
