#include "grader/files/bezier_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using BezierFile = FilesTest;

const std::string kNetFiles = MESHGRADE_SOURCE_DIR "/meshes/";

std::string fault(const std::function<void()>& read) {
  try {
    read();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST_F(BezierFile, NetsOfAnySizeSurviveWritingAndReading) {
  for (const std::string name : {"wavy.bez", "net_3x5.bez", "teapot.bez"}) {
    const std::vector<ControlNet> patches = read_bez(kNetFiles + name);
    write_bez(path("copy.bez"), patches);
    const std::vector<ControlNet> copies = read_bez(path("copy.bez"));
    ASSERT_EQ(copies.size(), patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
      EXPECT_EQ(copies[p].rows, patches[p].rows);
      EXPECT_EQ(copies[p].cols, patches[p].cols);
      EXPECT_EQ(copies[p].points, patches[p].points);
    }
  }
}

TEST_F(BezierFile, CurvesSurviveWritingAndReading) {
  const std::vector<Point2> points = {{0.1, -1e-300}, {1.0 / 3, 2}, {-7, 1e30}};
  write_bzc(path("curve.bzc"), points);
  EXPECT_EQ(read_bzc(path("curve.bzc")), points);
}

TEST_F(BezierFile, NetWithoutASizeIsFourByFour) {
  const std::vector<ControlNet> patches = read_bez(kNetFiles + "wavy.bez");
  ASSERT_EQ(patches.size(), 1U);
  EXPECT_EQ(patches[0].rows, 4U);
  EXPECT_EQ(patches[0].points.size(), 16U);
  EXPECT_EQ(patches[0].at(2, 1), (Point3{1, 2, 0.75}));
}

TEST_F(BezierFile, NumbersMayStandBetweenAnyBlanks) {
  const ControlNet wavy = read_bez(kNetFiles + "wavy.bez").at(0);
  std::string one_line = "1";
  std::string one_number_a_line =
      "\xEF\xBB\xBF"
      "1\r";
  for (const Point3& point : wavy.points) {
    for (const double x : point) {
      one_line += "  " + std::to_string(x);
      one_number_a_line += std::to_string(x) + "\r";
    }
  }
  for (const std::string& text : {one_line, one_number_a_line}) {
    const std::vector<ControlNet> patches = read_bez(write("a.bez", text));
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_EQ(patches[0].points, wavy.points);
    EXPECT_NE(fault([&] { read_bez(write("a.bez", text + " 1 ")); }), "");
    EXPECT_NE(fault([&] { read_bez(write("a.bez", text.substr(0, text.size() - 12))); }), "");
  }
  const std::vector<Point2> points = {{0.2, 0.3}, {0.3, 0.6}, {0.8, 0.7}, {0.9, 0.4}};
  for (const std::string text :
       {"4\n0.2 0.3   0.3 0.6   0.8 0.7   0.9 0.4\n", "4 0.2 0.3 0.3 0.6 0.8 0.7 0.9 0.4",
        "4\r0.2\r0.3\r0.3\r0.6\r0.8\r0.7\r0.9\r0.4\r"}) {
    EXPECT_EQ(read_bzc(write("a.bzc", text)), points);
  }
  EXPECT_NE(fault([&] {
              read_bzc(write("a.bzc", "2\n0 0 1 1 5\n"));
            }).find("a.bzc:2: more numbers than"),
            std::string::npos);
}

TEST_F(BezierFile, FaultsNameTheLine) {
  const auto bez = [&](const std::string& text) {
    return fault([&] { read_bez(write("a.bez", text)); });
  };
  const auto bzc = [&](const std::string& text) {
    return fault([&] { read_bzc(write("a.bzc", text)); });
  };
  const auto starts = [&](const std::string& message, const std::string& place) {
    return message.find(place) != std::string::npos && message.find('\n') == std::string::npos;
  };
  EXPECT_TRUE(starts(bez("0\n"), "a.bez:1: 0 patches"));
  EXPECT_TRUE(starts(bez("4000000000\n"), "a.bez:1: 4000000000 patches"));
  EXPECT_TRUE(starts(bez("1\n2 2\n0 0 0 1 1 1\n0 0 0 1 1\n"), "a.bez:4:"));
  EXPECT_TRUE(starts(bez("1\n2 2\n0 0 0 1 1 1 5\n0 0 0 1 1 1\n"), "a.bez:3:"));
  EXPECT_TRUE(starts(bez("1\n2 2\n0 0 0 1 1 1\n0 0 0 1 1 1\n0 0 0\n"), "a.bez:5:"));
  EXPECT_TRUE(starts(bez("1\n1 9\n"), "a.bez:2: 1 rows"));
  EXPECT_TRUE(starts(bzc("1\n0 0\n"), "a.bzc:1: 1 control points"));
  EXPECT_TRUE(starts(bzc("2\n0 0\n0 nan\n"), "a.bzc:3:"));
  EXPECT_TRUE(starts(bzc("3\n0 0\n0 1\n"), "a.bzc:3: the file ends"));
}

/// The rim of a net as unordered pairs of rows of points: its four border polygons.
std::vector<std::vector<Point3>> borders(const ControlNet& net) {
  std::vector<std::vector<Point3>> sides(4);
  for (std::size_t k = 0; k < 4; ++k) {
    sides[0].push_back(net.at(0, k));
    sides[1].push_back(net.at(3, k));
    sides[2].push_back(net.at(k, 0));
    sides[3].push_back(net.at(k, 3));
  }
  for (auto& side : sides)
    side = std::min(side, {side.rbegin(), side.rend()});
  return sides;
}

TEST(Teapot, HasThirtyTwoPatchesInItsKnownBox) {
  const std::vector<ControlNet> patches = read_bez(kNetFiles + "teapot.bez");
  ASSERT_EQ(patches.size(), 32U);
  Point3 low = patches[0].points[0];
  Point3 high = low;
  for (const ControlNet& net : patches) {
    for (const Point3& point : net.points) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
    }
  }
  EXPECT_EQ(low, (Point3{-3, -2, 0}));
  EXPECT_EQ(high, (Point3{3.525, 2, 3.15}));
}

TEST(Teapot, IsItsOwnMirrorImage) {
  std::multimap<double, Point3> by_sum;
  std::vector<Point3> points;
  for (const ControlNet& net : read_bez(kNetFiles + "teapot.bez")) {
    points.insert(points.end(), net.points.begin(), net.points.end());
  }
  // The tip of the lid has a handle of 0.002 that turns instead of being mirrored.
  for (const Point3& p : points) {
    const Point3 image = {p[0], -p[1], p[2]};
    const bool found = std::any_of(points.begin(), points.end(), [&](const Point3& q) {
      return std::abs(q[0] - image[0]) + std::abs(q[1] - image[1]) + std::abs(q[2] - image[2]) <
             1e-12;
    });
    EXPECT_TRUE(found) << p[0] << " " << p[1] << " " << p[2];
  }
}

TEST(Teapot, PatchesOfTheBodyMeetWithoutAGap) {
  // Rim, body, lid and bottom: 24 patches, four around. Every border that is not a rim of its
  // part is shared with a neighbour, control point by control point.
  const std::vector<ControlNet> patches = read_bez(kNetFiles + "teapot.bez");
  std::map<std::vector<Point3>, int> uses;
  for (std::size_t p = 0; p < 24; ++p) {
    for (const auto& side : borders(patches[p]))
      ++uses[side];
  }
  int n_alone = 0;
  for (const auto& [side, n] : uses) {
    const bool is_point = std::all_of(side.begin(), side.end(), [&](const Point3& q) {
      return std::abs(q[0]) < 0.01 && std::abs(q[1]) < 0.01;
    });
    if (!is_point && n == 1) ++n_alone;
  }
  // The inner edge of the rim and the outer edge of the lid: four borders each.
  EXPECT_EQ(n_alone, 8);
}

}  // namespace
}  // namespace meshgrade
