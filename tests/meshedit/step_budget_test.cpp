#include <gtest/gtest.h>

#include <cstdint>

#include "faults.h"
#include "meshedit/meshedit.h"
#include "sample_meshes.h"

namespace meshedit {
namespace {

class StepBudget : public FaultTest {};

TEST_F(StepBudget, EndlessWalkStopsAfterExactlyTheBudget) {
  HalfedgeMesh mesh = mesh_of(diamond());
  HalfedgeIter h = mesh.halfedgesBegin();
  for (const std::int64_t budget : {0, 1, 2, 1000}) {
    detail::steps_left = budget;
    std::int64_t taken = 0;
    EXPECT_EQ(fault_of([&] {
                for (;;) {
                  h = h->next();
                  ++taken;
                }
              }),
              sentence(FaultKind::kOutOfSteps, "half-edge handle"));
    EXPECT_EQ(taken, budget);
  }
}

TEST_F(StepBudget, LoopThatFeedsItselfStops) {
  HalfedgeMesh mesh = mesh_of(diamond());
  detail::steps_left = 10000;
  EXPECT_EQ(fault_of([&] {
              for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
                mesh.newEdge();
              }
            }),
            sentence(FaultKind::kOutOfSteps, "edge handle"));
}

TEST_F(StepBudget, WalkThatSwingsBetweenTheEndAndTheLastStops) {
  HalfedgeMesh mesh = mesh_of(diamond());
  detail::steps_left = 100;
  FaceIter f = mesh.facesEnd();
  EXPECT_EQ(fault_of([&] {
              for (;;) {
                --f;
                ++f;
              }
            }),
            sentence(FaultKind::kOutOfSteps, "face handle"));
}

TEST_F(StepBudget, ComparingCostsNothing) {
  HalfedgeMesh mesh = mesh_of(diamond());
  detail::steps_left = 0;
  EXPECT_EQ(fault_of([&] { EXPECT_TRUE(mesh.edgesBegin() != mesh.edgesEnd()); }), "");
}

}  // namespace
}  // namespace meshedit
