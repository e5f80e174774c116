#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "meshedit/meshedit.h"

namespace meshedit {
namespace {

testing::AssertionResult equal(const Vector3D& a, const Vector3D& b) {
  if (a.x == b.x && a.y == b.y && a.z == b.z) return testing::AssertionSuccess();
  return testing::AssertionFailure() << a << " is not " << b;
}

testing::AssertionResult equal(const Vector2D& a, const Vector2D& b) {
  if (a.x == b.x && a.y == b.y) return testing::AssertionSuccess();
  return testing::AssertionFailure() << a << " is not " << b;
}

TEST(Vectors, BeginAsZero) {
  EXPECT_TRUE(equal(Vector3D(), Vector3D(0, 0, 0)));
  EXPECT_TRUE(equal(Vector2D(), Vector2D(0, 0)));
}

TEST(Vectors, OneNumberFillsAllComponents) {
  Vector3D v;
  v = 2.5;
  EXPECT_TRUE(equal(v, Vector3D(2.5, 2.5, 2.5)));
}

TEST(Vectors, ArithmeticIsByComponent) {
  const Vector3D a(1, 2, 3);
  const Vector3D b(10, 20, 40);
  EXPECT_TRUE(equal(a + b, Vector3D(11, 22, 43)));
  EXPECT_TRUE(equal(b - a, Vector3D(9, 18, 37)));
  EXPECT_TRUE(equal(-a, Vector3D(-1, -2, -3)));
  EXPECT_TRUE(equal(2 * a, a * 2));
  EXPECT_TRUE(equal(b / 10, Vector3D(1, 2, 4)));
  EXPECT_TRUE(equal(Vector2D(1, 2) + Vector2D(3, 5), Vector2D(4, 7)));
  EXPECT_TRUE(equal(-(Vector2D(1, 2) - 2 * Vector2D(3, 5)) / 0.5, Vector2D(10, 16)));
}

TEST(Vectors, CompoundAssignmentIsTheSameAsTheOperator) {
  Vector3D v(1, 2, 3);
  v += Vector3D(1, 1, 1);
  v *= 4;
  v -= Vector3D(0, 0, 16);
  v /= 2;
  EXPECT_TRUE(equal(v, Vector3D(4, 6, 0)));
  v += v;
  EXPECT_TRUE(equal(v, Vector3D(8, 12, 0)));
  Vector2D w(1, 2);
  w += Vector2D(1, 0);
  w *= 6;
  w -= Vector2D(2, 2);
  w /= 5;
  EXPECT_TRUE(equal(w, Vector2D(2, 2)));
}

TEST(Vectors, IndexReachesTheComponents) {
  Vector3D v(1, 2, 3);
  v[1] = 7;
  EXPECT_TRUE(equal(v, Vector3D(1, 7, 3)));
  const Vector3D& read_only = v;
  EXPECT_EQ(read_only[0] + read_only[1] + read_only[2], 11.0);
}

TEST(Vectors, LengthOfA3412TriangleIs13) {
  EXPECT_EQ(Vector3D(3, 4, 12).norm(), 13.0);
  EXPECT_EQ(Vector3D(3, 4, 12).norm2(), 169.0);
  EXPECT_EQ(Vector2D(3, 4).norm(), 5.0);
  EXPECT_EQ(Vector2D(3, 4).norm2(), 25.0);
}

TEST(Vectors, UnitKeepsTheDirectionAndTheVector) {
  Vector3D v(0, -5, 0);
  EXPECT_TRUE(equal(v.unit(), Vector3D(0, -1, 0)));
  EXPECT_EQ(v.y, -5.0);
  v.normalize();
  EXPECT_EQ(v.y, -1.0);
  EXPECT_TRUE(equal(Vector2D(2, 0).unit(), Vector2D(1, 0)));
}

TEST(Vectors, ZeroHasNoDirection) {
  EXPECT_TRUE(std::isnan(Vector3D().unit().x));
  EXPECT_TRUE(std::isnan(Vector2D().unit().x));
}

TEST(Vectors, CrossIsRightHandedAndPerpendicular) {
  const Vector3D x(1, 0, 0);
  const Vector3D y(0, 1, 0);
  EXPECT_TRUE(equal(cross(x, y), Vector3D(0, 0, 1)));
  EXPECT_TRUE(equal(cross(y, x), Vector3D(0, 0, -1)));
  const Vector3D a(1, 2, 3);
  const Vector3D b(-4, 5, 6);
  EXPECT_EQ(dot(a, cross(a, b)), 0.0);
  EXPECT_EQ(dot(b, cross(a, b)), 0.0);
  EXPECT_EQ(dot(a, b), 24.0);
  EXPECT_EQ(cross(Vector2D(2, 0), Vector2D(7, 3)), 6.0);
  EXPECT_EQ(dot(Vector2D(2, 1), Vector2D(7, 3)), 17.0);
}

// A real mistake of students. The headers must not hide it, so that the grader can explain it.
TEST(Vectors, IntegerDivisionIsAsWrongAsEver) {
  const Vector3D v(1, 2, 3);
  EXPECT_TRUE(equal(3 / 8 * v, Vector3D(0, 0, 0)));  // NOLINT(bugprone-integer-division)
  EXPECT_TRUE(equal(3.0 / 8 * Vector3D(8, 16, 24), Vector3D(3, 6, 9)));
}

TEST(Vectors, PrintAsATuple) {
  std::ostringstream out;
  out << Vector3D(1, -2.5, 0) << Vector2D(3, 4);
  EXPECT_EQ(out.str(), "(1,-2.5,0)(3,4)");
}

}  // namespace
}  // namespace meshedit
