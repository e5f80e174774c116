// What the live viewer keeps, whatever the student's functions do.

#include "grader/view/mesh_session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grader/mesh/mesh_rules.h"
#include "tests/support/user_error.h"
#include "tests/view/student_folder.h"

namespace meshgrade {
namespace {

const std::vector<std::string> kFlip{"edge_flip.cpp"};
const std::vector<std::string> kAll{"edge_flip.cpp", "edge_split.cpp", "loop_subdivision.cpp"};

ViewOperation flip(Ref edge) {
  return {"edge_flip", ElementKind::kEdge, {edge}};
}
ViewOperation split(Ref edge) {
  return {"edge_split", ElementKind::kEdge, {edge}};
}
const ViewOperation kSubdivide{"loop_subdivision", ElementKind::kEdge, {}};

bool same(const MeshDump& a, const MeshDump& b) {
  return to_wire(a) == to_wire(b);
}

/// V, E, F.
std::array<std::size_t, 3> sizes(const MeshDump& mesh) {
  const Counts c = count(mesh);
  return {c.vertices, c.edges, c.faces};
}

TEST(MeshSession, EachOperationAddsTheElementsThatItMust) {
  Student student(kAll);
  const auto [v, e, f] = sizes(student.mesh());
  student.session->apply(flip(4));
  EXPECT_EQ(sizes(student.mesh()), (std::array{v, e, f}));
  student.session->apply(split(4));
  EXPECT_EQ(sizes(student.mesh()), (std::array{v + 1, e + 3, f + 2}));
  student.session->apply(kSubdivide);
  const std::array<std::size_t, 3> s{v + 1, e + 3, f + 2};
  EXPECT_EQ(sizes(student.mesh()), (std::array{s[0] + s[1], 2 * s[1] + 3 * s[2], 4 * s[2]}));
  for (std::size_t i = 1; i < student.session->states().size(); ++i) {
    EXPECT_EQ(student.session->states()[i].told.verdict, Verdict::kPassed);
    EXPECT_TRUE(find_broken_rules(student.session->states()[i].mesh).empty());
  }
}

TEST(MeshSession, UndoAndRedoShowTheStatesAsTheyWere) {
  Student student(kAll);
  std::vector<MeshDump> seen{student.mesh()};
  for (const ViewOperation& operation : {flip(4), split(7), flip(2)}) {
    student.session->apply(operation);
    seen.push_back(student.mesh());
  }
  for (const std::size_t position : {2, 0, 3, 1, 3}) {
    student.session->go_to(position);
    EXPECT_TRUE(same(student.mesh(), seen[position])) << "step " << position;
  }
  EXPECT_NE(user_error([&] { student.session->go_to(4); }), "");
  EXPECT_EQ(student.session->position(), 3U);
}

TEST(MeshSession, StepAfterAnUndoForgetsWhatWasUndone) {
  Student student(kAll);
  student.session->apply(flip(4));
  student.session->apply(split(4));
  student.session->go_to(1);
  const MeshDump flipped = student.mesh();
  student.session->apply(flip(7));
  EXPECT_EQ(student.session->operations().size(), 2U);
  EXPECT_EQ(student.session->operations()[1].picked.at(0), 7U);
  EXPECT_TRUE(same(student.session->states()[1].mesh, flipped));
}

TEST(MeshSession, RefusedStepForgetsNothing) {
  Student student(kAll);
  student.session->apply(flip(4));
  student.session->go_to(0);
  for (const Ref edge : {Ref{18}, Ref{1} << 30U, kUnsetRef, kDeletedBit | 4U}) {
    EXPECT_NE(user_error([&] { student.session->apply(flip(edge)); }), "") << edge;
  }
  EXPECT_EQ(student.session->states().size(), 2U);
}

/// A body of flipEdge that does not come to its end, and how that is called.
struct Stop {
  const char* name;
  const char* body;
  Verdict verdict;
};

class MeshSessionStop : public testing::TestWithParam<Stop> {};

TEST_P(MeshSessionStop, KeepsTheStateBeforeAndHealsAfterASave) {
  Student student({"edge_split.cpp"}, "cube.obj", "edge_flip.cpp", flip_file(GetParam().body));
  MeshSession& session = *student.session;
  session.apply(split(4));
  const MeshDump before = student.mesh();
  session.apply(flip(4));
  ASSERT_TRUE(session.stopped());
  EXPECT_EQ(session.stopped()->told.verdict, GetParam().verdict);
  EXPECT_EQ(session.position(), 1U);
  EXPECT_TRUE(same(student.mesh(), before));

  student.folder.write("edge_flip.cpp", reference_file("edge_flip.cpp"));
  session.rebuild();
  EXPECT_FALSE(session.stopped());
  EXPECT_EQ(session.position(), 2U);
  EXPECT_EQ(session.states().at(2).told.verdict, Verdict::kPassed);
  EXPECT_TRUE(same(session.states()[1].mesh, before));
}

INSTANTIATE_TEST_SUITE_P(
    All, MeshSessionStop,
    testing::Values(
        Stop{"Crash", "int* none = nullptr; *none = 1; return e0;", Verdict::kCrashed},
        Stop{"DanglingPointer", "deleteEdge(e0); return e0->halfedge()->edge();",
             Verdict::kCrashed},
        Stop{"UnsetHandle", "return HalfedgeIter()->edge();", Verdict::kCrashed},
        Stop{"EndlessWalk", "HalfedgeIter h = e0->halfedge(); for (;;) h = h->next();",
             Verdict::kOutOfSteps},
        Stop{"EndlessLoop", "volatile int i = 0; while (i == 0) {} return e0;",
             Verdict::kOutOfTime},
        Stop{"Exit", "std::_Exit(0);", Verdict::kCrashed}),
    [](const auto& stop) { return std::string(stop.param.name); });

TEST(MeshSession, StoppedStepIsGoneAfterAnUndoButNotAfterASaveThatChangesNothing) {
  Student student({}, "cube.obj", "edge_flip.cpp", flip_file("return HalfedgeIter()->edge();"));
  student.session->apply(flip(4));
  student.session->rebuild();
  ASSERT_TRUE(student.session->stopped());
  EXPECT_EQ(student.session->stopped()->operation.picked.at(0), 4U);
  student.session->go_to(0);
  EXPECT_FALSE(student.session->stopped());
}

TEST(MeshSession, BrokenStepIsKeptAndNothingIsSaidOfTheNext) {
  Student student({}, "cube.obj", "edge_flip.cpp",
                  flip_file("e0->halfedge()->next() = e0->halfedge(); return e0;"));
  student.session->apply(flip(4));
  EXPECT_EQ(student.session->states().at(1).told.verdict, Verdict::kFailed);
  EXPECT_FALSE(find_broken_rules(student.mesh()).empty());
  student.session->apply(flip(5));
  EXPECT_EQ(student.session->states().at(2).told.verdict, Verdict::kNotJudged);
}

TEST(MeshSession, FileThatDoesNotCompileLeavesTheProgramBefore) {
  Student student(kFlip);
  student.session->apply(flip(4));
  const MeshDump flipped = student.mesh();
  student.folder.write("edge_flip.cpp", "int f( {");
  student.session->rebuild();
  EXPECT_FALSE(student.program->compiled());
  EXPECT_TRUE(same(student.mesh(), flipped));
  student.session->apply(flip(4));
  EXPECT_EQ(student.session->states().at(2).told.verdict, Verdict::kPassed);
}

TEST(MeshSession, ReloadRepeatsAllStepsAndKeepsThePlace) {
  Student student(kAll);
  student.session->apply(split(4));
  student.session->apply(flip(7));
  student.session->go_to(1);
  const MeshDump seen = student.mesh();
  student.folder.write("edge_flip.cpp", flip_file("return e0;"));
  student.session->rebuild();
  EXPECT_EQ(student.session->position(), 1U);
  EXPECT_TRUE(same(student.mesh(), seen));
  EXPECT_EQ(student.session->states().at(2).told.verdict, Verdict::kFailed);
}

TEST(MeshSession, StepOnAnEdgeThatANewProgramDoesNotMakeIsTold) {
  Student student(kAll);
  student.session->apply(split(4));
  const auto made = static_cast<Ref>(student.mesh().edges.size() - 1);
  student.session->apply(flip(made));
  ASSERT_FALSE(student.session->stopped());
  student.folder.write("edge_split.cpp",
                       mesh_function("VertexIter HalfedgeMesh::splitEdge(EdgeIter e0)",
                                     "return e0->halfedge()->vertex();"));
  student.session->rebuild();
  ASSERT_TRUE(student.session->stopped());
  EXPECT_EQ(student.session->stopped()->operation.picked.at(0), made);
  EXPECT_EQ(student.session->stopped()->told.verdict, Verdict::kNotJudged);
  EXPECT_EQ(student.session->position(), 1U);
}

TEST(MeshSession, NormalsOfAnOctahedronPointToItsCorners) {
  Student student({"vertex_normal.cpp"}, "octahedron.off");
  const MeshSession::Normals given = student.session->normals();
  ASSERT_EQ(given.normals.size(), student.mesh().vertices.size());
  for (std::size_t v = 0; v < given.normals.size(); ++v) {
    const Point3& p = student.mesh().vertices[v].position;
    const double size = std::hypot(p[0], p[1], p[2]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(given.normals[v][axis], p[axis] / size, 1e-12);
  }
}

TEST(MeshSession, NormalThatCrashesIsToldAndChangesNothing) {
  Student student({}, "octahedron.off", "vertex_normal.cpp",
                  normal_of_vertex("return HalfedgeCIter()->vertex()->position;"));
  const MeshSession::Normals given = student.session->normals();
  EXPECT_TRUE(given.normals.empty());
  EXPECT_EQ(given.told.verdict, Verdict::kCrashed);
  EXPECT_NE(given.told.note, "");
  EXPECT_EQ(student.session->states().size(), 1U);
}

TEST(MeshSession, MeshThatHasNoHalfEdgesIsRefusedAndTheOneBeforeStays) {
  Student student(kFlip);
  student.session->apply(flip(4));
  const PolygonMesh bow_tie{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                            {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_NE(user_error([&] { student.session->open("bow tie", bow_tie); }), "");
  EXPECT_EQ(student.session->name(), "cube.obj");
  EXPECT_EQ(student.session->states().size(), 2U);
}

TEST(MeshSession, AnotherMeshBeginsAnew) {
  Student student(kFlip);
  student.session->apply(flip(4));
  student.session->open("tetrahedron.obj", sample_polygons("tetrahedron.obj"));
  EXPECT_EQ(student.session->states().size(), 1U);
  EXPECT_EQ(student.session->position(), 0U);
  EXPECT_EQ(sizes(student.mesh()), (std::array<std::size_t, 3>{4, 6, 4}));
}

}  // namespace
}  // namespace meshgrade
