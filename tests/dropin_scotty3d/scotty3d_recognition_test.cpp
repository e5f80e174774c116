// Homework for Scotty3D is recognised alone, in the course's project and in an archive of it;
// the course's own files are left out.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "grader/base/errors.h"
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

/// The same until Spring 2022, when all homework of the course lay in one folder, and the
/// header that students add members to in another one.
void put_into_project_of_2020(const fs::path& homework, const fs::path& project) {
  const fs::path student = project / "src" / "student";
  fs::create_directories(student);
  for (const char* name : {"bbox.cpp", "bvh.inl", "camera.cpp", "debug.cpp", "pathtracer.cpp",
                           "samplers.cpp", "shapes.cpp", "skeleton.cpp", "tri_mesh.cpp"}) {
    write(student / name, "#include \"../rays/pathtracer.h\"\nint of_course() { return 1; }\n");
  }
  write(student / "debug.h",
        "#pragma once\nstruct Debug_Data { bool normal_colors = false; };\n"
        "extern Debug_Data debug_data;\n");
  write(project / "src" / "geometry" / "halfedge.h", "#pragma once\nclass Of_Course;\n");
  write(project / "src" / "geometry" / "halfedge.cpp", "#include \"halfedge.h\"\n");
  write(project / "src" / "lib" / "mathlib.h", "#pragma once\n");
  write(project / "src" / "main.cpp", "int main() {}\n");
  for (const auto& file : fs::directory_iterator(homework)) {
    const fs::path folder =
        file.path().extension() == ".h" ? project / "src" / "geometry" : student;
    fs::copy(file.path(), folder, fs::copy_options::overwrite_existing);
  }
}

void expect_same_scotty3d_work(const Submission& alone, const Submission& whole) {
  EXPECT_EQ(whole.dialect, alone.dialect);
  EXPECT_TRUE(is_scotty3d(whole.dialect));
  EXPECT_EQ(names_and_texts(whole.sources), names_and_texts(alone.sources));
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

class Scotty3dProjectOf2020 : public testing::TestWithParam<std::string> {};

TEST_P(Scotty3dProjectOf2020, IsTheHomeworkInItWithItsHeader) {
  const ScratchFolder folder;
  put_into_project_of_2020(kScotty3dHomework / GetParam(), folder.path());
  const Submission alone = find_submission(kScotty3dHomework / GetParam(), SubmissionRules());
  const Submission whole = find_submission(folder.path(), SubmissionRules());
  EXPECT_EQ(whole.dialect, Dialect::kScotty3d2020);
  expect_same_scotty3d_work(alone, whole);
  ASSERT_EQ(whole.course_headers.size(), 1U);
  EXPECT_EQ(whole.course_headers[0].name, "halfedge.h");
  if (!alone.course_headers.empty()) {
    EXPECT_EQ(whole.course_headers[0].text, alone.course_headers[0].text);
  }
  ASSERT_EQ(whole.headers.size(), 1U);
  EXPECT_EQ(whole.headers[0].name, "debug.h");
}

TEST_P(Scotty3dProjectOf2020, MayLieInAnArchive) {
  const ScratchFolder folder;
  put_into_project_of_2020(kScotty3dHomework / GetParam(), folder.path() / "Cardinal3D");
  const ScratchFolder hand_in;
  const std::string archive = (hand_in.path() / "a2.tar.gz").string();
  ASSERT_EQ(
      std::system(
          ("tar -czf " + archive + " -C " + folder.path().string() + " Cardinal3D").c_str()),
      0);
  expect_same_scotty3d_work(find_submission(kScotty3dHomework / GetParam(), SubmissionRules()),
                            find_submission(archive, SubmissionRules()));
}

INSTANTIATE_TEST_SUITE_P(Years, Scotty3dProjectOf2020,
                         testing::Values("of_2020", "of_spring_2022", "untouched_2020"),
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
  for (const Dialect years : {Dialect::kScotty3d, Dialect::kScotty3d2020}) {
    const auto is_of_course = [&](const SourceFile& file) {
      return is_scotty3d_course_file(file, years);
    };
    EXPECT_TRUE(is_of_course({"halfedge.cpp", "void Halfedge_Mesh::swap() {}\n"}));
    EXPECT_FALSE(is_of_course({"halfedge.cpp",
                               "std::optional<Halfedge_Mesh::EdgeRef> "
                               "Halfedge_Mesh::flip_edge(EdgeRef e) { return e; }"}));
    EXPECT_FALSE(is_of_course({"my_helpers.cpp", "int n;\n"}));
    EXPECT_FALSE(is_of_course({"debug.h", "int n;\n"}));
  }
}

TEST(Scotty3dFiles, AFileOfAnotherTaskIsTheCoursesWhereAllLieInOneFolder) {
  const SourceFile shapes{"shapes.cpp", "int n;\n"};
  EXPECT_TRUE(is_scotty3d_course_file(shapes, Dialect::kScotty3d2020));
  EXPECT_FALSE(is_scotty3d_course_file(shapes, Dialect::kScotty3d));
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

TEST(Scotty3dDialect, OfEarlierYearsIsKnownByItsPointersOrItsNames) {
  const std::string flip =
      "std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(Halfedge_Mesh::EdgeRef "
      "e) ";
  EXPECT_EQ(dialect_of("meshedit.cpp", flip + "{ HalfedgeRef h = e->halfedge(); return e; }"),
            Dialect::kScotty3d2020);
  EXPECT_EQ(dialect_of("mine.cpp", flip + "{ e->_halfedge->_next = e->_halfedge; return e; }"),
            Dialect::kScotty3d2020);
  EXPECT_EQ(dialect_of("meshedit.cpp",
                       "std::optional<Halfedge_Mesh::FaceRef> "
                       "Halfedge_Mesh::bevel_face(FaceRef f) { return std::nullopt; }"),
            Dialect::kScotty3d2020);
  EXPECT_EQ(dialect_of("mine.cpp",
                       flip + "{ HalfedgeRef h = emplace_halfedge(); h->next = h; return e; } "
                              "// h->next()"),
            Dialect::kScotty3d);
}

TEST(Scotty3dDialect, IsNotToldFromTheNameMeshedit) {
  EXPECT_EQ(dialect_of("meshedit.cpp",
                       "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n"
                       "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) { return "
                       "e->halfedge()->next()->edge(); }\n}\n"),
            Dialect::kMeshedit);
}

TEST(Scotty3dDialect, OfTheFirstYearsIsRefusedInOneSentence) {
  const ScratchFolder folder;
  write(folder.path() / "src" / "meshEdit.cpp",
        "#include \"halfEdgeMesh.h\"\nnamespace CMU462 {\n"
        "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) { return e0; }\n}\n");
  write(folder.path() / "CMakeLists.txt", "project(Scotty3D)\n");
  try {
    find_submission(folder.path(), SubmissionRules());
    ADD_FAILURE() << "it was taken";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("Scotty3D of 2015 to 2019"), std::string::npos);
  }
}

TEST(Scotty3dDialect, IsOfTheSecondAssignment) {
  EXPECT_EQ(load_assignment_of("", kScotty3dHomework / "of_2022").folder, "polygon_meshes");
  EXPECT_EQ(load_assignment_of("", kScotty3dHomework / "untouched").folder, "polygon_meshes");
  EXPECT_EQ(load_assignment_of("", kScotty3dHomework / "of_2020").folder, "polygon_meshes");
  EXPECT_EQ(load_assignment_of("", kScotty3dHomework / "untouched_2020").folder,
            "polygon_meshes");
}

}  // namespace
}  // namespace meshgrade
