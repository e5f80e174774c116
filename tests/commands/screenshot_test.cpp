// `meshgrade view --screenshot`, called as a person would.

#include <set>

#include "grader/base/safe_file.h"
#include "grader/view/browser.h"
#include "tests/commands/command_line.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Screenshot : public CommandLine {
 protected:
  Said shoot(const std::string& submission, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"view", MESHGRADE_SOURCE_DIR "/meshes/cube.obj",
                                         "--submission", submission});
    return call(arguments);
  }
  std::string picture(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  std::string text_of(const std::string& name) const {
    return read_whole_file(scratch_.path() / name);
  }
};

TEST_F(Screenshot, StepsAreDoneByTheStudentsFunctionsAndDrawnAsSvg) {
  const Said said = shoot(reference(), {"--screenshot", picture("a.svg"), "--steps",
                                        "flip e4, split e4, subdivide", "--compare"});
  EXPECT_EQ(said.status, 0) << said.output;
  // V + E, 2E + 3F and 4F of 9 vertices, 21 edges and 14 faces.
  EXPECT_THAT(said.output, AllOf(HasSubstr("flip e4: passed"), HasSubstr("split e4: passed"),
                                 HasSubstr("subdivide: passed"),
                                 HasSubstr("30 vertices, 84 edges, 56 faces"),
                                 HasSubstr("Every vertex is where it must be"),
                                 HasSubstr("drawn by the grader itself")));
  EXPECT_THAT(text_of("a.svg"), AllOf(testing::StartsWith("<svg"),
                                      HasSubstr("30 vertices, 84 edges, 56 faces</title>")));
}

TEST_F(Screenshot, WrongWeightsAreToldWithTheWorstVertex) {
  // Subdivision calls the flip and the split of the same submission.
  fs::copy(reference(), folder_, fs::copy_options::recursive);
  fs::copy(wrong("loop_subdivision/old_vertices_stay"), folder_,
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const Said said =
      shoot(folder_, {"--screenshot", picture("a.svg"), "--steps", "subdivide", "--compare"});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, AllOf(HasSubstr("subdivide: failed: position"),
                                 HasSubstr("Off: 8 of 26 vertices")));
  EXPECT_THAT(text_of("a.svg"), HasSubstr("class=\"worst\""));
}

TEST_F(Screenshot, ACrashGivesThePictureOfTheMeshBeforeAndOne) {
  const Said said = shoot(wrong("edge_flip/null_pointer"),
                          {"--screenshot", picture("a.svg"), "--steps", "flip e4"});
  EXPECT_EQ(said.status, 1) << said.output;
  EXPECT_THAT(said.output,
              AllOf(HasSubstr("flip e4: crashed: crash, yours the program crashed"),
                    HasSubstr("The picture shows the mesh before flip e4")));
  EXPECT_THAT(text_of("a.svg"), HasSubstr("8 vertices, 18 edges, 12 faces</title>"));
}

TEST_F(Screenshot, AnEdgeThatIsNotThereIsNamedWithItsStep) {
  const Said said =
      shoot(reference(), {"--screenshot", picture("a.svg"), "--steps", "flip e4, split e99"});
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.output, AllOf(HasSubstr("step 2, \"split e99\": there is no edge e99"),
                                 HasSubstr("18 edges then")));
  EXPECT_FALSE(fs::exists(picture("a.svg")));
}

TEST_F(Screenshot, WhatCannotBeDoneIsSaidBeforeAnythingIsBuilt) {
  const auto complains = [&](const std::vector<std::string>& arguments,
                             const std::string& why) {
    const Said said = shoot("/no/such/folder", arguments);
    EXPECT_EQ(said.status, 2) << said.output;
    EXPECT_THAT(said.output, HasSubstr(why));
  };
  complains({"--screenshot", picture("a.jpg")}, "a .png or an .svg");
  complains({"--screenshot", picture("no/a.png")}, "there is no folder");
  fs::create_directory(picture("folder.png"));
  complains({"--screenshot", picture("folder.png")}, "is a folder");
  complains({"--screenshot", picture("a.png"), "--steps", "flop e3"}, "step 1, \"flop e3\"");
  complains({"--screenshot", picture("a.png"), "--camera", "up"}, "--camera 45,30");
  complains({"--screenshot", picture("a.png"), "--size", "big"}, "--size 960x720");
  complains({"--steps", "flip e3"}, "--screenshot");
}

TEST_F(Screenshot, ACurveIsDrawnByTheStudentsStep) {
  const Said said = call({"view", MESHGRADE_SOURCE_DIR "/meshes/arch_4.bzc", "--submission",
                          reference(), "--screenshot", picture("a.svg")});
  EXPECT_EQ(said.status, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("evaluateStep at t = 0.5: passed"));
  EXPECT_TRUE(fs::exists(picture("a.svg")));
}

TEST_F(Screenshot, WhereNoBrowserIsAnSvgIsDrawnAndSaid) {
  const std::string path = std::getenv("PATH");
  fs::create_directory(scratch_.path() / "bin");
  for (const char* name :
       {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"}) {
    std::ofstream(scratch_.path() / "bin" / name) << "#!/bin/sh\necho no display\nexit 1\n";
    fs::permissions(scratch_.path() / "bin" / name, fs::perms::owner_all);
  }
  ::setenv("PATH", ((scratch_.path() / "bin").string() + ":" + path).c_str(), 1);
  const Said said = shoot(reference(), {"--screenshot", picture("a.png")});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, AllOf(HasSubstr("a.svg: drawn by the grader itself"),
                                 HasSubstr("took no picture; its last line: no display")));
  EXPECT_FALSE(fs::exists(picture("a.png")));
  EXPECT_TRUE(fs::exists(picture("a.svg")));
}

TEST_F(Screenshot, ABrowserTakesThePictureAndLeavesNothingElse) {
  if (find_browser().empty()) GTEST_SKIP() << "no Chromium or Chrome is on the PATH";
  const fs::path temporary = scratch_.path() / "tmp";
  fs::create_directory(temporary);
  ::setenv("TMPDIR", temporary.c_str(), 1);
  const std::vector<std::string> arguments{"--screenshot", picture("a.png"), "--steps",
                                           "subdivide 2",  "--levels",       "--size",
                                           "900x320"};
  const Said light = shoot(reference(), arguments);
  std::vector<std::string> in_the_dark = arguments;
  in_the_dark[1] = picture("dark.png");
  in_the_dark.emplace_back("--dark");
  const Said dark = shoot(reference(), in_the_dark);
  ::unsetenv("TMPDIR");
  EXPECT_EQ(light.status, 0);
  EXPECT_THAT(light.output, AllOf(HasSubstr("a.png: taken by"), Not(HasSubstr(".svg"))));
  EXPECT_EQ(dark.status, 0);
  const std::string png = text_of("a.png");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  // A mesh was drawn: an empty page of this size takes a few hundred bytes.
  EXPECT_GT(png.size(), 8000U);
  EXPECT_NE(png, text_of("dark.png"));
  EXPECT_TRUE(fs::is_empty(temporary)) << *fs::directory_iterator(temporary);
}

}  // namespace
}  // namespace meshgrade
