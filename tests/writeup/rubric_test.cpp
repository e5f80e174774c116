// What a rubric says, and where it is wrong.

#include "grader/writeup/rubric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "tests/support/standard_assignment.h"
#include "tests/support/submissions.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

WriteupRubric rubric_of(const std::string& pictures) {
  const ScratchFolder folder;
  write_file_safely(folder.path() / "r.toml",
                    "version = 1\ntitle = \"T\"\n[[part]]\nheading = \"H\"\n" + pictures);
  return read_rubric(folder.path() / "r.toml", test_home().meshes);
}

std::string picture(const std::string& kind, const std::string& file, const std::string& more) {
  return "[[part.picture]]\nname = \"p\"\ncaption = \"c\"\nkind = \"" + kind + "\"\nfile = \"" +
         file + "\"\n" + more + "\n";
}

std::string error_of(const std::string& pictures) {
  try {
    rubric_of(pictures);
  } catch (const UserError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WriteupRubric, TheStandardOneCanBeRead) {
  const WriteupRubric rubric = read_rubric(
      std::string(MESHGRADE_SOURCE_DIR) + "/docs/writeup_rubric.toml", test_home().meshes);
  EXPECT_EQ(rubric.parts.size(), 6U);
  for (const RubricPart& part : rubric.parts)
    EXPECT_FALSE(part.pictures.empty()) << part.heading;
}

TEST(WriteupRubric, EachLevelOfACurveIsAPictureOfItsOwn) {
  const WriteupRubric rubric = rubric_of(picture("curve", "loop_6.bzc", "each_level = true"));
  ASSERT_EQ(rubric.parts.at(0).pictures.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(rubric.parts[0].pictures[i].levels_shown, i);
}

TEST(WriteupRubric, WhatIsWrongIsToldWithItsLine) {
  EXPECT_THAT(error_of(picture("mesh", "none.obj", "")),
              HasSubstr("r.toml:9: part.picture.file"));
  EXPECT_THAT(error_of(picture("mesh", "cube.obj", "steps = \"fold e3\"")),
              HasSubstr("r.toml:10: part.picture.steps"));
  EXPECT_THAT(error_of(picture("mesh", "cube.obj", "shading = \"soft\"")),
              HasSubstr("r.toml:10"));
  EXPECT_THAT(error_of(picture("curve", "cube.obj", "")), HasSubstr("r.toml:9"));
  EXPECT_THAT(error_of(picture("curve", "loop_6.bzc", "steps = \"flip e1\"")),
              HasSubstr("r.toml:10: unknown key part.picture.steps"));
  EXPECT_THAT(error_of(picture("dance", "cube.obj", "")), HasSubstr("r.toml:8"));
  const std::string two = picture("mesh", "cube.obj", "");
  EXPECT_THAT(error_of(two + two), HasSubstr("is there twice"));
}

TEST(WriteupRubric, NamesOfPicturesAreNoPaths) {
  EXPECT_THAT(error_of("[[part.picture]]\nname = \"../p\"\ncaption = \"c\"\nkind = \"mesh\"\n"
                       "file = \"cube.obj\"\n"),
              HasSubstr("r.toml:6: part.picture.name"));
}

}  // namespace
}  // namespace meshgrade
