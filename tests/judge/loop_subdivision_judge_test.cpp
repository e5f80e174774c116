#include <gtest/gtest.h>

#include "grader/judge/judge.h"
#include "grader/judge/point_compare.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

const char* const kLoop = "Loop's weights";

/// Judges cases one after the other, as one solution.
class LoopJudge {
 public:
  explicit LoopJudge(const std::string& vertex_rule = "either") {
    rubric_.options["vertex_rule"].value = vertex_rule;
    judge_ = find_exercise_judge(rubric_);
    conventions_ = judge_.conventions;
  }

  CaseJudgement operator()(const std::string& id, const Outcome& outcome) {
    return judge_case(judge_, {standard_case(id), outcome, rubric_, 1e-5}, conventions_);
  }
  CaseJudgement operator()(const std::string& id, VertexRule rule,
                           CornerRule corner = CornerRule::kSmooth) {
    return (*this)(id, right_outcome(standard_case(id), rule, corner));
  }

  const Conventions& conventions() const { return conventions_; }

 private:
  ExerciseRubric rubric_ = *standard_rubric().find("loop_subdivision");
  ExerciseJudge judge_{{}, {}, nullptr};
  Conventions conventions_;
};

std::string id_of(const std::string& words) {
  for (const Case& c : standard_cases("loop_subdivision")) {
    if (c.title.find(words) != std::string::npos) return c.id();
  }
  ADD_FAILURE() << words;
  return "";
}

TEST(LoopOracle, OctahedronAndTetrahedronMoveByTheirClosedForms) {
  // Octahedron: the neighbours of a vertex sum to 0, so the vertex becomes (1 - 4 b) v.
  const PolygonMesh octahedron = sample_polygons("octahedron.off");
  const std::pair<VertexRule, double> rules[] = {{VertexRule::kLoop, 0.12109375},
                                                 {VertexRule::kWarren, 0.09375}};
  for (const auto& [rule, b] : rules) {
    const SubdivisionLevel level = opensubdiv_loop(octahedron, rule, CornerRule::kSmooth);
    for (std::size_t v = 0; v < octahedron.positions.size(); ++v) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(level.mesh.positions[level.child_of_vertex[v]][i],
                    (1 - 4 * b) * octahedron.positions[v][i], 1e-15);
      }
    }
  }
  // Tetrahedron: b = 3/16 by both rules.
  const PolygonMesh t = sample_polygons("tetrahedron.obj");
  for (VertexRule rule : {VertexRule::kLoop, VertexRule::kWarren}) {
    const SubdivisionLevel level = opensubdiv_loop(t, rule, CornerRule::kSmooth);
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t i = 0; i < 3; ++i) {
        double others = -t.positions[v][i];
        for (const Point3& p : t.positions)
          others += p[i];
        EXPECT_NEAR(level.mesh.positions[level.child_of_vertex[v]][i],
                    7.0 / 16.0 * t.positions[v][i] + 3.0 / 16.0 * others, 1e-15);
      }
    }
  }
}

TEST(LoopOracle, InsideOfARegularGridKeepsItsPlaces) {
  const PolygonMesh grid = sample_polygons("grid_4x4.obj");
  const TriangleSet set(grid);
  std::vector<bool> boundary(grid.positions.size(), false);
  std::vector<int> valence(grid.positions.size(), 0);
  for (const VertexPair& e : set.edges()) {
    ++valence[e.first];
    ++valence[e.second];
    if (set.is_boundary(e)) boundary[e.first] = boundary[e.second] = true;
  }
  const SubdivisionLevel level = opensubdiv_loop(grid, VertexRule::kLoop, CornerRule::kSmooth);
  int inside = 0;
  for (std::size_t v = 0; v < grid.positions.size(); ++v) {
    if (boundary[v] || valence[v] != 6) continue;
    ++inside;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(level.mesh.positions[level.child_of_vertex[v]][i], grid.positions[v][i],
                  1e-14);
    }
  }
  EXPECT_GT(inside, 3);
}

TEST(LoopSubdivisionJudge, SaysWhichWeightsWereFound) {
  LoopJudge judge;
  EXPECT_EQ(judge.conventions().size(), 4U);
  EXPECT_EQ(judge(id_of("octahedron"), VertexRule::kLoop).verdict, Verdict::kPassed);
  EXPECT_EQ(judge.conventions(), (Conventions{kLoop, "Loop's weights, fixed corners"}));
}

TEST(LoopSubdivisionJudge, SolutionThatMixesTheWeightsFails) {
  LoopJudge judge;
  EXPECT_EQ(judge(id_of("1 level on octahedron"), VertexRule::kLoop).verdict, Verdict::kPassed);
  const CaseJudgement mixed = judge(id_of("1 level on icosahedron"), VertexRule::kWarren);
  EXPECT_EQ(mixed.verdict, Verdict::kFailed);
  ASSERT_FALSE(mixed.findings.empty());
  EXPECT_EQ(mixed.findings[0].rule, "position");
  EXPECT_NE(mixed.findings[0].expected.find(kLoop), std::string::npos);
}

TEST(LoopSubdivisionJudge, MixedCornersFailAsWell) {
  LoopJudge judge;
  const std::string id = id_of("1 level on single_triangle");
  EXPECT_EQ(judge(id, VertexRule::kLoop, CornerRule::kCorner).verdict, Verdict::kPassed);
  EXPECT_EQ(judge(id, VertexRule::kLoop, CornerRule::kSmooth).verdict, Verdict::kFailed);
}

TEST(LoopSubdivisionJudge, LevelsByDifferentWeightsFailAndLeaveAChoice) {
  // Level 1 by Warren, level 2 as if level 1 had been by Loop: no solution does that, but a
  // forged answer may.
  LoopJudge judge;
  const std::string id = id_of("3 levels on octahedron");
  Outcome outcome = right_outcome(standard_case(id), VertexRule::kLoop);
  outcome.steps[0] = right_outcome(standard_case(id), VertexRule::kWarren).steps[0];
  EXPECT_EQ(judge(id, outcome).verdict, Verdict::kFailed);
  EXPECT_FALSE(judge.conventions().empty());
  EXPECT_EQ(judge(id, VertexRule::kWarren).verdict, Verdict::kPassed);
}

TEST(LoopSubdivisionJudge, PinnedRuleTakesNoOther) {
  LoopJudge warren("warren");
  EXPECT_EQ(warren(id_of("octahedron"), VertexRule::kWarren).verdict, Verdict::kPassed);
  EXPECT_EQ(warren(id_of("octahedron"), VertexRule::kLoop).verdict, Verdict::kFailed);
  LoopJudge loop("loop");
  EXPECT_EQ(loop(id_of("octahedron"), VertexRule::kLoop).verdict, Verdict::kPassed);
  EXPECT_EQ(loop(id_of("octahedron"), VertexRule::kWarren).verdict, Verdict::kFailed);
  EXPECT_EQ(loop(id_of("torus.ply"), VertexRule::kWarren).verdict, Verdict::kPassed);
}

TEST(LoopSubdivisionJudge, NamesTheRuleForEachKindOfMistake) {
  const std::string id = id_of("1 level on octahedron");
  const Case& c = standard_case(id);
  const auto right = from_wire<MeshDump>(right_outcome(c).steps[0]);
  const auto rule = [&](const MeshDump& mesh) {
    Outcome outcome;
    outcome.steps = {to_wire(mesh)};
    const CaseJudgement judgement = LoopJudge()(id, outcome);
    EXPECT_EQ(judgement.verdict, Verdict::kFailed);
    return judgement.findings.at(0).rule;
  };
  EXPECT_EQ(rule(dump_polygons(from_wire<SubdivisionInput>(c.input).mesh)), "counts");
  MeshDump flipped = right;
  model_flip(flipped, 3);
  EXPECT_EQ(rule(flipped), "connectivity");
  MeshDump moved = right;
  moved.vertices[5].position[1] += 0.01;
  EXPECT_EQ(rule(moved), "position");
  MeshDump broken = right;
  broken.halfedges[2].next = kUnsetRef;
  EXPECT_EQ(rule(broken), "live-pointer");
}

/// The first level of an octahedron inside a large tetrahedron, with one vertex moved by a part
/// of the octahedron's edges.
CaseJudgement judge_moved_vertex(double part) {
  const Case& c = standard_case(id_of("an octahedron inside a tetrahedron"));
  const PolygonMesh mesh = from_wire<SubdivisionInput>(c.input).mesh;
  Outcome outcome = right_outcome(c);
  auto dump = from_wire<MeshDump>(outcome.steps.at(0));
  const double edge = distance(mesh.positions[0], mesh.positions[1]);
  for (VertexRecord& v : dump.vertices) {
    if (distance(v.position, mesh.positions[0]) > edge) continue;
    v.position[1] += part * edge;
    break;
  }
  outcome.steps[0] = to_wire(dump);
  return LoopJudge()(c.id(), outcome);
}

TEST(LoopJudging, PositionsAreJudgedByTheEdgesAroundAndNotByTheWholeMesh) {
  EXPECT_EQ(judge_moved_vertex(1e-7).verdict, Verdict::kPassed);
  const CaseJudgement wrong = judge_moved_vertex(1e-3);
  EXPECT_EQ(wrong.verdict, Verdict::kFailed);
  ASSERT_FALSE(wrong.findings.empty());
  EXPECT_NE(wrong.findings[0].actual.find(" of the "), std::string::npos);
}

}  // namespace
}  // namespace meshgrade
