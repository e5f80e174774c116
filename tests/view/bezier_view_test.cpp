// What the viewer answers for curves and surfaces, and what it refuses.

#include "grader/view/bezier_view.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/support/user_error.h"
#include "tests/view/student_folder.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

const StudentProgram& right_program() {
  static const Student student({"bezier_curve.cpp", "bezier_patch.cpp"});
  return *student.program;
}

Json square_net(std::size_t rows, std::size_t cols) {
  Json net = Json::array();
  for (std::size_t i = 0; i < rows; ++i) {
    net.push_back(Json::array());
    for (std::size_t j = 0; j < cols; ++j)
      net.back().push_back({j, i, 0});
  }
  return net;
}

TEST(BezierView, LevelsOfALineAreItsPointAtT) {
  const Json answer = view_curve(right_program(), {{"points", {{0, 0}, {4, 8}}}, {"t", 0.25}});
  EXPECT_EQ(answer["levels"], Json::parse("[[[1.0, 2.0]]]"));
  EXPECT_EQ(answer["told"]["verdict"], "passed");
}

TEST(BezierView, CurveOfARightSolutionIsTheExactOne) {
  const Json answer =
      view_curve(right_program(), {{"points", {{0, 0}, {1, 3}, {2, -1}, {4, 0}}}, {"t", 0.5}});
  ASSERT_EQ(answer["curve"].size(), answer["exact"].size());
  for (std::size_t i = 0; i < answer["curve"].size(); ++i) {
    for (const std::size_t axis : {0, 1}) {
      EXPECT_NEAR(answer["curve"][i][axis].get<double>(),
                  answer["exact"][i][axis].get<double>(), 1e-6);
    }
  }
}

TEST(BezierView, CurveThatCrashesHasNoPointsAndStillItsExactOne) {
  const Student student({}, "cube.obj", "bezier_curve.cpp",
                        "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n"
                        "std::vector<Vector2D> BezierCurve::evaluateStep(\n"
                        "    const std::vector<Vector2D>&) { int* n = nullptr; *n = 1;\n"
                        "  return {}; }\n}\n");
  ASSERT_TRUE(student.program->compiled()) << student.program->files()[0].messages;
  const Json answer = view_curve(*student.program, {{"points", {{0, 0}, {4, 8}}}, {"t", 0.25}});
  EXPECT_EQ(answer["told"]["verdict"], "crashed");
  for (const Json& point : answer["curve"])
    EXPECT_TRUE(point.is_null());
  EXPECT_EQ(answer["exact"].front(), Json::parse("[0.0, 0.0]"));
}

TEST(BezierView, FlatSquareNetGivesAnEvenGridWithUFastest) {
  const Json answer = view_patch(right_program(), {{"net", square_net(3, 3)}, {"density", 2}});
  EXPECT_EQ(answer["told"]["verdict"], "passed");
  // Linear precision: u and v go from 0 to 2, one of them along the rows.
  const bool u_along_rows = answer["grid"][1] == Json::parse("[1.0, 0.0, 0.0]");
  for (std::size_t k = 0; k < 9; ++k) {
    const double u = static_cast<double>(k % 3);
    const double v = static_cast<double>(k / 3);
    EXPECT_EQ(answer["grid"][k], u_along_rows ? Json({u, v, 0.0}) : Json({v, u, 0.0}));
  }
}

TEST(BezierView, IsocurvesMeetInTheAskedPointAndLieOnTheSurface) {
  const Json request{{"net", square_net(3, 3)}, {"u", 0.25}, {"v", 0.5}};
  const Json answer = view_isocurves(right_program(), request);
  const std::size_t last = answer["along_u"].size() - 1;
  ASSERT_EQ(answer["along_v"].size(), last + 1);
  EXPECT_EQ(answer["along_u"][last / 4], answer["along_v"][last / 2]);
  // Linear precision: on the flat net of side 2, one coordinate is 2 u and the other 2 v.
  for (std::size_t i = 0; i <= last; ++i) {
    const double x = 2.0 * static_cast<double>(i) / static_cast<double>(last);
    for (const auto& [curve, fixed] : {std::pair{"along_u", 1.0}, std::pair{"along_v", 0.5}}) {
      const auto p = answer[curve][i].get<Point3>();
      EXPECT_NEAR(p[0] + p[1], x + fixed, 1e-12);
      EXPECT_NEAR(p[0] * p[1], x * fixed, 1e-12);
    }
  }
}

/// The text of the refusal, or of the JSON that could not be read.
template <class View>
std::string refusal(View view, const Json& request) {
  try {
    view(right_program(), request);
  } catch (const Json::exception& error) {
    return error.what();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(BezierView, IsocurvesOfNoPointAreRefused) {
  for (const char* place : {R"("u": 2, "v": 0)", R"("u": 0.5)", R"("u": null, "v": 0)",
                            R"("u": -1e300, "v": 0.5)"}) {
    Json request = Json::parse(std::string("{") + place + "}");
    request["net"] = square_net(2, 2);
    EXPECT_NE(refusal(view_isocurves, request), "") << place;
  }
}

TEST(BezierView, CurvesThatAreNoneAreRefused) {
  const double huge = std::numeric_limits<double>::max();
  const Json good{{0, 0}, {1, 1}};
  for (const Json& request : {
           Json{{"t", 0.5}},
           Json{{"points", good}},
           Json{{"points", {{0, 0}}}, {"t", 0.5}},
           Json{{"points", std::vector<Point2>(41)}, {"t", 0.5}},
           Json{{"points", {{0, nullptr}, {1, 1}}}, {"t", 0.5}},
           Json{{"points", {{0}, {1, 1}}}, {"t", 0.5}},
           Json{{"points", "0 0"}, {"t", 0.5}},
           Json{{"points", good}, {"t", "half"}},
           Json{{"points", good}, {"t", huge}},
           Json{{"points", good}, {"t", -0.01}},
           Json::array(),
       }) {
    EXPECT_NE(refusal(view_curve, request), "") << request;
  }
}

TEST(BezierView, NetsThatAreNoneAreRefused) {
  Json ragged = square_net(3, 3);
  ragged[1].erase(2);
  const double huge = std::numeric_limits<double>::max();
  for (const Json& request : {
           Json{{"net", square_net(3, 3)}},
           Json{{"net", square_net(1, 3)}, {"density", 4}},
           Json{{"net", square_net(3, 1)}, {"density", 4}},
           Json{{"net", square_net(41, 2)}, {"density", 4}},
           Json{{"net", ragged}, {"density", 4}},
           Json{{"net", square_net(3, 3)}, {"density", 0}},
           Json{{"net", square_net(3, 3)}, {"density", 65}},
           Json{{"net", square_net(3, 3)}, {"density", huge}},
           Json{{"net", nullptr}, {"density", 4}},
       }) {
    EXPECT_NE(refusal(view_patch, request), "") << request;
  }
}

}  // namespace
}  // namespace meshgrade
