#include <gtest/gtest.h>

#include "grader/judge/judge.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

CaseJudgement judge(const Case& c, const std::vector<OperationStep>& steps) {
  const ExerciseRubric& rubric = *standard_rubric().find(c.exercise);
  const ExerciseJudge exercise = find_exercise_judge(rubric);
  Outcome outcome;
  for (const OperationStep& step : steps)
    outcome.steps.push_back(to_wire(step));
  Conventions conventions;
  return judge_case(exercise, {c, outcome, rubric, 1e-5}, conventions);
}

Case operation_case(const std::string& exercise, const std::string& group,
                    const std::string& file, Operation operation) {
  return {
      exercise,
      group,
      1,
      "",
      to_wire(OperationsInput{file, sample_polygons(file), Anchoring::kAsBuilt, {operation}}),
      1000};
}

OperationStep right_step(const Case& c) {
  return from_wire<OperationStep>(right_outcome(c).steps.at(0));
}

/// A step that leaves the mesh as it was.
OperationStep idle_step(const Case& c) {
  OperationStep step = right_step(c);
  step.after = dump_polygons(from_wire<OperationsInput>(c.input).mesh);
  step.returned = step.edge;
  return step;
}

std::string rule_of(const CaseJudgement& judgement) {
  EXPECT_EQ(judgement.verdict, Verdict::kFailed);
  return judgement.findings.empty() ? "" : judgement.findings[0].rule;
}

class OperationsJudge : public testing::Test {
 protected:
  Case flip_ =
      operation_case("edge_flip", "basic", "octahedron.off", {OperationKind::kFlip, 0, 1});
  Case split_ =
      operation_case("edge_split", "basic", "octahedron.off", {OperationKind::kSplit, 0, 1});
  Case border_ = operation_case("edge_split", "boundary", "single_triangle.obj",
                                {OperationKind::kSplit, 0, 1});
};

TEST_F(OperationsJudge, FlipInEitherDirectionIsRight) {
  // Two more flips turn the edge by half a turn: the same surface, the half-edges swapped.
  OperationStep step = right_step(flip_);
  EXPECT_EQ(judge(flip_, {step}).verdict, Verdict::kPassed);
  model_flip(step.after, step.edge);
  model_flip(step.after, step.edge);
  EXPECT_EQ(judge(flip_, {step}).verdict, Verdict::kPassed);
  for (VertexRecord& v : step.after.vertices) {
    const Ref t = step.after.halfedges[v.halfedge].twin;
    v.halfedge = step.after.halfedges[t].next;
  }
  EXPECT_EQ(judge(flip_, {step}).verdict, Verdict::kPassed);
}

TEST_F(OperationsJudge, NothingDoneToAnInnerEdgeIsToldAsSuch) {
  EXPECT_EQ(rule_of(judge(flip_, {idle_step(flip_)})), "nothing-done");
  EXPECT_EQ(rule_of(judge(split_, {idle_step(split_)})), "nothing-done");
}

TEST_F(OperationsJudge, ShareOfWhatIsRightCountsPointersAndTheReturnedHandle) {
  EXPECT_EQ(judge(flip_, {idle_step(flip_)}).right_share, 0.0);
  EXPECT_EQ(judge(split_, {idle_step(split_)}).right_share, 0.0);
  OperationStep step = right_step(split_);
  step.returned = kUnsetRef;
  const double only_returned = judge(split_, {step}).right_share;
  EXPECT_GT(only_returned, 0.9);
  step.after.edges[step.edge].halfedge = kUnsetRef;
  const double one_more = judge(split_, {step}).right_share;
  // Of the same number of things one more is wrong.
  EXPECT_NEAR(1.0 - one_more, 2.0 * (1.0 - only_returned), 1e-12);
}

// The same pointers as of an inner edge: the boundary loop was taken for a triangle.
TEST_F(OperationsJudge, BoundaryEdgeSplitLikeAnInnerOneIsToldAsSuch) {
  OperationStep step = idle_step(border_);
  for (int i = 0; i < 6; ++i)
    step.after.halfedges.push_back({0, 0, 0, 0, 0, 1});
  step.after.vertices.push_back({0, 1, {}});
  for (int i = 0; i < 3; ++i)
    step.after.edges.push_back({0, 1});
  for (int i = 0; i < 2; ++i)
    step.after.faces.push_back({0, 1, 0});
  step.after.halfedges[0].next = 7;
  const CaseJudgement judgement = judge(border_, {step});
  EXPECT_EQ(rule_of(judgement), "boundary-edge");
  EXPECT_NE(judgement.findings[0].look_at.find("no test for a boundary"), std::string::npos);
}

// Nobody can tell it from one that keeps them but by a handle kept from before.
TEST_F(OperationsJudge, SplitThatReplacesHalfedgesFacesAndItsEdgeIsRightWithANote) {
  OperationStep step = right_step(split_);
  MeshDump& mesh = step.after;
  const auto replace = [](auto& records, Ref old) {
    records.push_back(records[old]);
    records[old].live = 0;
    return static_cast<Ref>(records.size() - 1);
  };
  const Ref h = mesh.edges[step.edge].halfedge;
  const Ref face = mesh.halfedges[h].face;
  const Ref new_edge = replace(mesh.edges, step.edge);
  const Ref new_face = replace(mesh.faces, face);
  const Ref new_halfedge = replace(mesh.halfedges, h);
  for (HalfedgeRecord& record : mesh.halfedges) {
    if (record.edge == step.edge) record.edge = new_edge;
    if (record.face == face) record.face = new_face;
    if (record.next == h) record.next = new_halfedge;
    if (record.twin == h) record.twin = new_halfedge;
  }
  for (auto* anchor : {&mesh.edges[new_edge].halfedge, &mesh.faces[new_face].halfedge})
    *anchor = new_halfedge;
  for (VertexRecord& v : mesh.vertices) {
    if (v.halfedge == h) v.halfedge = new_halfedge;
  }
  const CaseJudgement judgement = judge(split_, {step});
  EXPECT_EQ(judgement.verdict, Verdict::kPassed);
  EXPECT_NE(judgement.note.find("deletes old elements"), std::string::npos);
}

TEST_F(OperationsJudge, AnotherReturnedElementIsToldAsSuch) {
  OperationStep step = right_step(flip_);
  step.returned = step.edge + 1;
  EXPECT_EQ(rule_of(judge(flip_, {step})), "returned");
  step = right_step(split_);
  step.returned = 0;
  EXPECT_EQ(rule_of(judge(split_, {step})), "returned");
}

TEST_F(OperationsJudge, MovedVertexIsToldAsSuch) {
  OperationStep step = right_step(flip_);
  step.after.vertices[2].position[0] += 1e-9;
  EXPECT_EQ(rule_of(judge(flip_, {step})), "position");
}

TEST_F(OperationsJudge, SplitAwayFromTheMiddleIsToldAsSuch) {
  OperationStep step = right_step(split_);
  step.after.vertices[step.returned].position[0] += 0.01;
  EXPECT_EQ(rule_of(judge(split_, {step})), "midpoint");
}

TEST_F(OperationsJudge, HalfedgeOfTheNewVertexLiesAlongTheOldEdge) {
  OperationStep step = right_step(split_);
  VertexRecord& m = step.after.vertices[step.returned];
  m.halfedge = step.after.halfedges[step.after.halfedges[m.halfedge].twin].next;
  EXPECT_EQ(rule_of(judge(split_, {step})), "along-edge");
}

TEST_F(OperationsJudge, SplitOfAnotherEdgeIsWrong) {
  OperationStep step = idle_step(split_);
  step.returned = model_split(step.after, (step.edge + 1) % 12);
  EXPECT_EQ(judge(split_, {step}).verdict, Verdict::kFailed);
}

TEST_F(OperationsJudge, DeletedOldElementIsTold) {
  OperationStep step = right_step(flip_);
  step.after.vertices[0].live = 0;
  EXPECT_EQ(rule_of(judge(flip_, {step})), "counts");
}

TEST_F(OperationsJudge, SwappedOldEdgesAreTold) {
  OperationStep step = right_step(flip_);
  MeshDump& mesh = step.after;
  const Ref a = step.edge == 0 ? 1 : 0;
  const Ref b = step.edge == 2 ? 3 : 2;
  for (HalfedgeRecord& h : mesh.halfedges) {
    if (h.edge == a || h.edge == b) h.edge = a + b - h.edge;
  }
  std::swap(mesh.edges[a], mesh.edges[b]);
  EXPECT_EQ(rule_of(judge(flip_, {step})), "identity");
}

TEST_F(OperationsJudge, BoundaryEdgeMayBeSplitOrRefusedButNotHarmed) {
  EXPECT_EQ(judge(border_, {right_step(border_)}).verdict, Verdict::kPassed);
  EXPECT_EQ(judge(border_, {idle_step(border_)}).verdict, Verdict::kPassed);
  OperationStep harmed = idle_step(border_);
  harmed.after.vertices.push_back({0, 1, {}});
  EXPECT_EQ(judge(border_, {harmed}).verdict, Verdict::kFailed);
}

TEST_F(OperationsJudge, RefusedBoundarySplitEarnsNoExtraCredit) {
  border_.group = "boundary_split";
  EXPECT_EQ(judge(border_, {right_step(border_)}).verdict, Verdict::kPassed);
  EXPECT_EQ(judge(border_, {idle_step(border_)}).verdict, Verdict::kNotImplemented);
}

TEST_F(OperationsJudge, FlippedBoundaryEdgeIsWrongWhateverIsDoneToIt) {
  const Case c = operation_case("edge_flip", "boundary", "two_triangles.obj",
                                {OperationKind::kFlip, 0, 1});
  ASSERT_TRUE(is_boundary_edge(idle_step(c).after, idle_step(c).edge));
  EXPECT_EQ(judge(c, {idle_step(c)}).verdict, Verdict::kPassed);
  OperationStep harmed = idle_step(c);
  harmed.after.vertices[0].halfedge = kUnsetRef;
  EXPECT_EQ(rule_of(judge(c, {harmed})), "boundary-edge");
}

TEST_F(OperationsJudge, RefusedOperationMovesNoVertex) {
  const Case flip = operation_case("edge_flip", "boundary", "two_triangles.obj",
                                   {OperationKind::kFlip, 0, 1});
  const Case doubling =
      operation_case("edge_flip", "basic", "tetrahedron.obj", {OperationKind::kFlip, 0, 1});
  Case extra = border_;
  extra.group = "boundary_split";
  for (const Case& c : {flip, doubling, border_, extra}) {
    OperationStep step = idle_step(c);
    step.after.vertices[2].position[1] += 1e-9;
    EXPECT_EQ(rule_of(judge(c, {step})), "position") << c.exercise << " " << c.group;
  }
}

/// The split of a short edge, moved by a part of its length.
CaseJudgement judge_moved_middle(const Point3& place, double part) {
  OperationsInput input{"",
                        sample_polygons("octahedron.off"),
                        Anchoring::kAsBuilt,
                        {{OperationKind::kSplit, 0, 1}}};
  input.mesh = mapped(input.mesh, [&](const Point3& p) {
    return Point3{p[0] + place[0], p[1] + place[1], p[2] + place[2]};
  });
  PolygonMesh large = mapped(sample_polygons("tetrahedron.obj"), [](const Point3& p) {
    return Point3{1e4 * p[0], 1e4 * p[1], 1e4 * p[2]};
  });
  for (auto& polygon : large.polygons) {
    for (std::uint32_t& corner : polygon)
      corner += 6;
    input.mesh.polygons.push_back(polygon);
  }
  input.mesh.positions.insert(input.mesh.positions.end(), large.positions.begin(),
                              large.positions.end());
  const Case c{"edge_split", "basic", 1, "", to_wire(input), 1000};
  OperationStep step = right_step(c);
  const Point3& a = input.mesh.positions[0];
  const Point3& b = input.mesh.positions[1];
  step.after.vertices[step.returned].position[0] += part * distance(a, b);
  return judge(c, {step});
}

TEST_F(OperationsJudge, MiddleIsJudgedByTheLengthOfItsEdgeAndNotByTheWholeMesh) {
  EXPECT_EQ(judge_moved_middle({}, 1e-6).verdict, Verdict::kPassed);
  const CaseJudgement wrong = judge_moved_middle({}, 1e-3);
  EXPECT_EQ(rule_of(wrong), "midpoint");
  EXPECT_NE(wrong.findings.at(0).actual.find("of the length of the edge"), std::string::npos);
}

TEST_F(OperationsJudge, MiddleFarFromTheOriginMayBeRoundedToFloat) {
  const double rounding = std::ldexp(1000.0, -24);
  EXPECT_EQ(judge_moved_middle({1000.0, 0.0, 0.0}, rounding).verdict, Verdict::kPassed);
  EXPECT_EQ(rule_of(judge_moved_middle({1000.0, 0.0, 0.0}, 0.01)), "midpoint");
}

TEST_F(OperationsJudge, AnchorsAreSetBeforeEachOperationWhereTheCaseSaysSo) {
  OperationsInput input{"", sample_polygons("icosahedron.obj"), Anchoring::kOnEachEdge, {}};
  TriangleSet set(input.mesh);
  for (int i = 0; i < 3; ++i) {
    const VertexPair edge = set.edges()[5];
    input.operations.push_back({OperationKind::kFlip, edge.first, edge.second});
    set.flip(edge);
  }
  const Case c{"edge_flip", "basic", 1, "", to_wire(input), 1000};
  const Outcome right = right_outcome(c);
  std::vector<OperationStep> steps;
  for (const std::string& bytes : right.steps)
    steps.push_back(from_wire<OperationStep>(bytes));
  EXPECT_EQ(judge(c, steps).verdict, Verdict::kPassed);
  // The end of an edge that keeps the half-edge that has turned away: seen only since the edge
  // was what anchored it.
  MeshDump before = steps[1].after;
  model_anchor_on(before, steps[2].edge);
  const Ref h = before.edges[steps[2].edge].halfedge;
  steps[2].after.vertices[before.halfedges[h].vertex].halfedge = h;
  EXPECT_EQ(rule_of(judge(c, steps)), "anchor");
}

TEST_F(OperationsJudge, FlipThatWouldDoubleAnEdgeMayBeDoneOrLeft) {
  const Case c =
      operation_case("edge_flip", "basic", "tetrahedron.obj", {OperationKind::kFlip, 0, 1});
  OperationStep step = idle_step(c);
  EXPECT_EQ(judge(c, {step}).verdict, Verdict::kPassed);
  model_flip(step.after, step.edge);
  EXPECT_EQ(judge(c, {step}).verdict, Verdict::kPassed);
}

TEST_F(OperationsJudge, MirroredNeighbourhoodIsNoticed) {
  // All faces turned inside out is another surface, though its faces have the same corners.
  OperationStep step = right_step(flip_);
  PolygonMesh turned;
  for (const VertexRecord& v : step.after.vertices)
    turned.positions.push_back(v.position);
  for (const FaceRecord& f : step.after.faces) {
    const HalfedgeRecord& x = step.after.halfedges[f.halfedge];
    const HalfedgeRecord& y = step.after.halfedges[x.next];
    turned.polygons.push_back({y.vertex, x.vertex, step.after.halfedges[y.next].vertex});
  }
  step.after = dump_polygons(turned);
  EXPECT_EQ(judge(flip_, {step}).verdict, Verdict::kFailed);
}

TEST_F(OperationsJudge, FlipThatGoesWrongInASequenceOfSplitsIsNotJudged) {
  for (const Case& c : standard_cases("edge_split")) {
    const auto input = from_wire<OperationsInput>(c.input);
    if (input.operations[0].kind != OperationKind::kFlip) continue;
    OperationStep step = from_wire<OperationStep>(right_outcome(c).steps[0]);
    step.after.halfedges[0].next = kUnsetRef;
    const CaseJudgement judgement = judge(c, {step});
    EXPECT_EQ(judgement.verdict, Verdict::kNotJudged);
    EXPECT_NE(judgement.note.find("edge_flip"), std::string::npos);
    return;
  }
  FAIL() << "no sequence begins with a flip";
}

}  // namespace
}  // namespace meshgrade
