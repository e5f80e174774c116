// What `meshgrade view --screenshot` reads from its command line.

#include "grader/view/picture_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<ViewOperation> triangle_steps(const std::string& text) {
  return parse_steps(text, view_verbs({}));
}

std::vector<std::string> texts(const std::string& steps) {
  std::vector<std::string> list;
  for (const ViewOperation& operation : triangle_steps(steps))
    list.push_back(operation_text(operation));
  return list;
}

template <class Parse>
std::string complaint(Parse parse, const std::string& text) {
  return user_error([&] { parse(text); });
}

TEST(PictureSteps, AreReadInOrderAndSubdivisionsAsOftenAsAsked) {
  EXPECT_THAT(texts("flip e3, split e5, subdivide 2"),
              ElementsAre("flip e3", "split e5", "subdivide", "subdivide"));
  EXPECT_THAT(texts("  subdivide ,flip   e12"), ElementsAre("subdivide", "flip e12"));
}

TEST(PictureSteps, AStepThatCannotBeReadIsNamedWithItsNumberAndAnExample) {
  for (const char* bad :
       {"flop e3", "flip", "flip 3", "flip e", "flip e-1", "flip e3 e4", "flip v3", "split e3x",
        "subdivide 0", "subdivide 8", "subdivide -1", "subdivide two", "subdivide 1 2",
        "flip e4294967295", "flip e99999999999"}) {
    EXPECT_THAT(complaint(triangle_steps, std::string("subdivide, ") + bad),
                AllOf(HasSubstr(std::string("step 2, \"") + bad + "\""),
                      HasSubstr("for example --steps \"flip e3")))
        << bad;
  }
  EXPECT_THAT(complaint(triangle_steps, "flip e3,,split e5"),
              HasSubstr("step 2, \"\", is empty"));
  EXPECT_THAT(complaint(triangle_steps, "flip e3,"), HasSubstr("step 2"));
}

TEST(PictureSteps, MoreThanAMachineCanDoIsRefused) {
  EXPECT_EQ(texts("subdivide 7").size(), 7U);
  EXPECT_THAT(complaint(triangle_steps, "subdivide 4, subdivide 4"), HasSubstr("at most 7"));
  std::string many = "flip e0";
  for (int i = 0; i < 200; ++i)
    many += ",flip e0";
  EXPECT_THAT(complaint(triangle_steps, many), HasSubstr("at most 200 steps"));
}

TEST(PictureCamera, TwoOrThreeNumbersAreReadAndTheDistanceHasADefault) {
  const Camera two = parse_camera("45,-30.5");
  EXPECT_EQ(two.azimuth, 45.0);
  EXPECT_EQ(two.elevation, -30.5);
  EXPECT_EQ(two.distance, Camera().distance);
  EXPECT_EQ(parse_camera("0, 90, 2").distance, 2.0);
}

TEST(PictureCamera, AnythingElseIsRefusedWithAnExample) {
  for (const char* bad : {"", "45", "45,", "a,b", "45,30,4,5", "45,91", "400,0", "45,30,0",
                          "45,30,1e9", "nan,0", "inf,0", "45;30", "45,30 40"}) {
    EXPECT_THAT(complaint(parse_camera, bad), HasSubstr("for example --camera 45,30")) << bad;
  }
}

TEST(PictureSizes, WidthAndHeightAreReadAndAnythingElseIsRefused) {
  EXPECT_EQ(parse_size("640x480").width, 640);
  EXPECT_EQ(parse_size("640x480").height, 480);
  for (const char* bad : {"", "640", "640x", "x480", "640x480x3", "63x480", "640x4097",
                          "-640x480", "640*480", "640 x 480", "99999999999x480"}) {
    EXPECT_THAT(complaint(parse_size, bad), HasSubstr("for example --size 960x720")) << bad;
  }
}

TEST(PictureOptions, ControlCharactersDoNotReachTheTerminal) {
  EXPECT_THAT(complaint(triangle_steps, "\x1b[31mflip e3"), testing::Not(HasSubstr("\x1b")));
  EXPECT_THAT(complaint(parse_camera, "\x1b[31m"), testing::Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace meshgrade
