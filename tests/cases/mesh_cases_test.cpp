// The cases are able to tell right from wrong.

#include <gtest/gtest.h>

#include <set>

#include "grader/judge/point_compare.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

template <class Visit>
void for_operations(const std::string& exercise, Visit visit) {
  for (const Case& c : standard_cases(exercise))
    visit(c, from_wire<OperationsInput>(c.input));
}

TEST(OperationCases, AskOnlyForEdgesThatExist) {
  for (const char* exercise : {"edge_flip", "edge_split"}) {
    for_operations(exercise, [](const Case& c, const OperationsInput& input) {
      MeshDump mesh = first_mesh(input);
      for (const Operation& operation : input.operations) {
        const Ref e = find_edge(mesh, operation.a, operation.b);
        ASSERT_NE(e, kUnsetRef) << c.id();
        const bool boundary = is_boundary_edge(mesh, e);
        // Splits at the boundary may be mixed with others.
        const bool at_boundary = c.group.rfind("boundary", 0) == 0;
        const bool first = &operation == &input.operations.front();
        EXPECT_TRUE(boundary == at_boundary || (at_boundary && !first)) << c.id();
        if (operation.kind == OperationKind::kSplit) {
          model_split(mesh, e);
        } else if (!boundary) {
          const Diamond d = diamond_of(mesh, e);
          const bool doubled = find_edge(mesh, d.a, d.d) != kUnsetRef;
          // A flip with two right answers must not have anything after it.
          EXPECT_TRUE(!doubled || input.operations.size() == 1) << c.id();
          if (!doubled) model_flip(mesh, e);
        }
      }
    });
  }
}

TEST(OperationCases, TriangleSetAgreesWithTheHalfedgeModel) {
  for_operations("edge_split", [](const Case& c, const OperationsInput& input) {
    if (c.group != "stress" && c.group != "boundary_split") return;
    TriangleSet set(input.mesh);
    for (const Operation& operation : input.operations) {
      const VertexPair edge{operation.a, operation.b};
      ASSERT_TRUE(set.has_edge(edge.first, edge.second)) << c.id();
      if (operation.kind == OperationKind::kFlip) {
        EXPECT_TRUE(set.can_flip(edge)) << c.id();
        set.flip(edge);
      } else {
        set.split(edge);
      }
    }
    const auto last = from_wire<OperationStep>(right_operations(input).back());
    EXPECT_EQ(set.edges().size(), count(last.after).edges) << c.id();
    for (const VertexPair& edge : set.edges())
      EXPECT_NE(find_edge(last.after, edge.first, edge.second), kUnsetRef) << c.id();
  });
}

TEST(OperationCases, BasicOnesHaveEdgesAtVerticesOfManyValences) {
  for (const char* exercise : {"edge_flip", "edge_split"}) {
    std::set<std::size_t> valences;
    bool next_to_boundary = false;
    for_operations(exercise, [&](const Case& c, const OperationsInput& input) {
      if (c.group != "basic") return;
      const TriangleSet set(input.mesh);
      std::map<std::uint32_t, std::size_t> valence;
      std::set<std::uint32_t> boundary;
      for (const VertexPair& e : set.edges()) {
        ++valence[e.first];
        ++valence[e.second];
        if (set.is_boundary(e)) boundary.insert({e.first, e.second});
      }
      for (std::uint32_t end : {input.operations[0].a, input.operations[0].b}) {
        if (boundary.count(end) != 0) {
          next_to_boundary = true;
        } else {
          valences.insert(valence[end]);
        }
      }
    });
    for (std::size_t n : {3U, 4U, 5U, 6U})
      EXPECT_EQ(valences.count(n), 1U) << exercise << " " << n;
    EXPECT_TRUE(next_to_boundary) << exercise;
  }
}

TEST(OperationCases, FlipsAreAskedForWhereTheyWouldDoubleAnEdge) {
  bool found = false;
  for_operations("edge_flip", [&](const Case& c, const OperationsInput& input) {
    const TriangleSet set(input.mesh);
    const VertexPair edge{input.operations[0].a, input.operations[0].b};
    found = found || (c.group == "basic" && !set.is_boundary(edge) && !set.can_flip(edge));
  });
  EXPECT_TRUE(found);
}

TEST(VertexNormalCases, TellAreaWeightsFromTheOthersByFar) {
  const double far = 100 * standard_rubric().tolerance;
  std::map<std::string, int> telling;
  for (const Case& c : standard_cases("vertex_normal")) {
    const PolygonMesh mesh = from_wire<NormalInput>(c.input).mesh;
    const auto area = vertex_normals(mesh, NormalWeights::kArea);
    for (const Point3& n : area)
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, 1e-9) << c.title;
    const double equal = worst_point(area, vertex_normals(mesh, NormalWeights::kEqual)).error;
    const double angle = worst_point(area, vertex_normals(mesh, NormalWeights::kAngle)).error;
    if (equal > far && angle > far) ++telling[c.group];
  }
  EXPECT_GE(telling["basic"], 1);
  EXPECT_GE(telling["boundary"], 1);
  EXPECT_GE(telling["stress"], 1);
}

TEST(VertexNormalCases, BoundaryOnesHaveABoundaryAndBasicOnesHaveNone) {
  for (const Case& c : standard_cases("vertex_normal")) {
    if (c.group == "stress") continue;
    const Counts counts = count(dump_polygons(from_wire<NormalInput>(c.input).mesh));
    EXPECT_EQ(counts.boundaries > 0, c.group == "boundary") << c.title;
  }
}

TEST(LoopSubdivisionCases, TellLoopsWeightsFromWarrensByFar) {
  const double far = 100 * standard_rubric().tolerance;
  int telling = 0;
  for (const Case& c : standard_cases("loop_subdivision")) {
    if (c.group != "basic") continue;
    const PolygonMesh mesh = from_wire<SubdivisionInput>(c.input).mesh;
    const auto loop = opensubdiv_loop(mesh, VertexRule::kLoop, CornerRule::kSmooth).mesh;
    const auto warren = opensubdiv_loop(mesh, VertexRule::kWarren, CornerRule::kSmooth).mesh;
    if (worst_point(loop.positions, warren.positions).error > far * extent(mesh.positions))
      ++telling;
  }
  EXPECT_GE(telling, 3);
}

TEST(BezierCases, ParametersAreWhatAFloatCanHold) {
  for (const Case& c : standard_cases("bezier_curve")) {
    const auto input = from_wire<CurveInput>(c.input);
    EXPECT_EQ(static_cast<double>(static_cast<float>(input.t)), input.t) << c.id();
    EXPECT_GE(input.points.size(), 2U);
    EXPECT_LT(input.steps, input.points.size());
  }
}

TEST(BezierCases, TellMirroredParametersAndSwappedAxesByFar) {
  int swapped = 0;
  for (const Case& c : standard_cases("bezier_patch")) {
    auto input = from_wire<PatchInput>(c.input);
    if (c.group != "surface" || input.function != PatchFunction::kSurface) continue;
    std::vector<std::string> right = right_patch(input);
    for (auto& place : input.parameters)
      std::swap(place[0], place[1]);
    const std::vector<std::string> wrong = right_patch(input);
    for (std::size_t i = 0; i < right.size(); ++i) {
      const auto a = from_wire<std::vector<Point3>>(right[i]);
      const auto b = from_wire<std::vector<Point3>>(wrong[i]);
      if (distance(a[0], b[0]) > 0.1) ++swapped;
    }
  }
  EXPECT_GE(swapped, 3);
}

}  // namespace
}  // namespace meshgrade
