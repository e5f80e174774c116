// What an instructor's tests of this homework look like: a few cases per exercise, compared by
// hand. They need not find everything; the benchmark asks what it costs to build and run them.

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <vector>

#include "meshedit/detail/halfedge_mesh.cpp"  // here, to pay for no source more than needed
#include "meshedit/meshedit.h"

namespace meshedit {
namespace {

class Curve : public BezierCurve {
 public:
  explicit Curve(float parameter) : BezierCurve(3) { t = parameter; }
};

HalfedgeMesh octahedron() {
  HalfedgeMesh mesh;
  mesh.build(
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  return mesh;
}

void expect_whole(HalfedgeMesh& mesh) {
  for (HalfedgeIter h = mesh.halfedgesBegin(); h != mesh.halfedgesEnd(); ++h) {
    EXPECT_TRUE(h->twin()->twin() == h);
    EXPECT_TRUE(h->isBoundary() || h->next()->next()->next() == h);
  }
}

TEST(Grading, CurveStep) {
  const std::vector<Vector2D> step = Curve(0.25F).evaluateStep({{0, 0}, {4, 0}, {4, 8}});
  ASSERT_EQ(step.size(), 2U);
  EXPECT_DOUBLE_EQ(step[0].x, 1.0);
  EXPECT_DOUBLE_EQ(step[1].y, 2.0);
}

TEST(Grading, Patch) {
  const BezierPatch patch({{{0, 0, 0}, {2, 0, 0}}, {{0, 4, 0}, {2, 4, 0}}});
  EXPECT_DOUBLE_EQ(patch.evaluate(0.5, 0.25).x, 1.0);
  EXPECT_DOUBLE_EQ(patch.evaluate(0.5, 0.25).y, 1.0);
}

TEST(Grading, Normal) {
  HalfedgeMesh mesh = octahedron();
  EXPECT_NEAR(mesh.verticesBegin()->normal().x, 1.0, 1e-9);
}

TEST(Grading, Flip) {
  for (Index i = 0; i < 12; ++i) {
    HalfedgeMesh mesh = octahedron();
    mesh.flipEdge(std::next(mesh.edgesBegin(), static_cast<std::ptrdiff_t>(i)));
    expect_whole(mesh);
  }
}

TEST(Grading, Split) {
  for (Index i = 0; i < 12; ++i) {
    HalfedgeMesh mesh = octahedron();
    mesh.splitEdge(std::next(mesh.edgesBegin(), static_cast<std::ptrdiff_t>(i)));
    EXPECT_EQ(mesh.nVertices(), 7U);
    EXPECT_EQ(mesh.nFaces(), 10U);
    expect_whole(mesh);
  }
}

TEST(Grading, Subdivision) {
  HalfedgeMesh mesh = octahedron();
  MeshResampler().upsample(mesh);
  EXPECT_EQ(mesh.nVertices(), 18U);
  EXPECT_EQ(mesh.nFaces(), 32U);
  expect_whole(mesh);
}

}  // namespace
}  // namespace meshedit
