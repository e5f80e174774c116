// Pictures by right and by broken functions.

#include "grader/writeup/writeup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/base/safe_file.h"
#include "tests/view/student_folder.h"

namespace meshgrade {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> kAll{"bezier_curve.cpp",  "bezier_patch.cpp",
                                    "vertex_normal.cpp", "edge_flip.cpp",
                                    "edge_split.cpp",    "loop_subdivision.cpp"};

class WriteupOf {
 public:
  explicit WriteupOf(StudentFolder& folder) : assignment_(standard_rubric()) {
    const WriteupRubric rubric = read_rubric(
        std::string(MESHGRADE_SOURCE_DIR) + "/docs/writeup_rubric.toml", test_home().meshes);
    StudentProgram program(assignment_, test_home(), folder.path());
    program.rebuild();
    std::filesystem::create_directories(out_.path() / kWriteupPictures);
    const WriteupSetup setup{out_.path(), "", true};
    writeup_ = make_writeup(rubric, program, setup, [&](const WriteupPicture& picture) {
      pictures_[picture.file] = picture;
      EXPECT_THAT(file(picture.file), HasSubstr("<svg")) << picture.file;
    });
  }

  std::string file(const std::string& name) const {
    return read_whole_file(out_.path() / name);
  }
  const std::string& told(const std::string& name) const {
    return pictures_.at("pictures/" + name + ".svg").told;
  }
  bool right() const { return is_right(writeup_); }

 private:
  ScratchFolder out_;
  Assignment assignment_;
  std::map<std::string, WriteupPicture> pictures_;
  Writeup writeup_;
};

TEST(Writeup, OfRightFunctionsShowsAllAndNothingWrong) {
  StudentFolder folder(kAll);
  const WriteupOf made(folder);
  EXPECT_TRUE(made.right());
  // Level k of six points has 6 - k of them.
  EXPECT_THAT(made.file("pictures/curve_level_5.svg"), HasSubstr("level level-5"));
  EXPECT_THAT(made.file("pictures/normals.svg"), HasSubstr("class=\"normals\""));
}

TEST(Writeup, StepsThatFailAreShownAsTheyFail) {
  StudentFolder folder(kAll);
  folder.write("edge_flip.cpp",
               flip_file("e0->halfedge()->next() = e0->halfedge();\n  return e0;"));
  folder.write("vertex_normal.cpp",
               normal_of_vertex("*(volatile int*)nullptr = 1;\n  return {};"));
  const WriteupOf made(folder);
  EXPECT_FALSE(made.right());
  EXPECT_THAT(made.told("flip_after"), AllOf(StartsWith("flip e"), HasSubstr(": failed\n")));
  EXPECT_THAT(made.told("flip_after"), HasSubstr("yours "));
  EXPECT_THAT(made.told("shading_smooth"), HasSubstr("Vertex::normal"));
  EXPECT_EQ(made.told("flip_before"), "");
  EXPECT_EQ(made.told("split_after"), "");
}

}  // namespace
}  // namespace meshgrade
