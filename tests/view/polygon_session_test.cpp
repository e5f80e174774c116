// The live viewer on meshes of polygons: all functions of the second assignment, one after the
// other on one mesh.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "grader/mesh/mesh_rules.h"
#include "grader/mesh/polygons_of.h"
#include "grader/operations/picked_element.h"
#include "grader/view/picture_request.h"
#include "tests/support/user_error.h"
#include "tests/view/student_folder.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

std::vector<ViewOperation> steps(const std::string& text) {
  return parse_steps(text, view_verbs(polygon_rubric()));
}

/// The reference with one file more or exchanged, and a session with a mesh.
struct PolygonStudent {
  explicit PolygonStudent(const std::string& mesh, const std::string& file = "",
                          const std::string& text = "")
      : folder({}) {
    for (const auto& entry :
         std::filesystem::directory_iterator(test_home().reference / "polygon_meshes")) {
      if (entry.path().extension() == ".cpp") {
        const std::string name = entry.path().filename().string();
        folder.write(name, reference_file("polygon_meshes/" + name));
      }
    }
    if (!file.empty()) folder.write(file, text);
    program.emplace(polygon_rubric(), test_home(), folder.path());
    session.emplace(*program);
    session->open(mesh, sample_polygons(mesh));
    session->rebuild();
  }

  void apply(const std::string& text) {
    for (const ViewOperation& step : steps(text))
      session->apply(step);
  }
  const ViewState& state() const { return session->states()[session->position()]; }
  const CaseReport& told() const { return state().told; }
  std::array<std::size_t, 3> sizes() const {
    const Counts c = count(state().mesh);
    return {c.vertices, c.edges, c.faces};
  }

  StudentFolder folder;
  std::optional<StudentProgram> program;
  std::optional<MeshSession> session;
};

std::string operation_file(const std::string& head, const std::string& body) {
  return "#include \"meshedit/meshedit.h\"\n#include \"meshedit/poly_mesh.h\"\n"
         "namespace meshedit {\n" +
         head + " {\n" + body + "\n}\n}\n";
}

TEST(PolygonSession, EveryVerbOfTheAssignmentIsDoneByTheStudentsFunctionAndJudgedRight) {
  PolygonStudent student("quad_grid_3x3.obj");
  for (const ViewVerb& verb : student.session->verbs()) {
    student.session->go_to(0);
    const MeshDump mesh = student.state().mesh;
    if (verb.picked == 0) {
      student.session->apply({verb.exercise, verb.picks, {}});
      EXPECT_EQ(student.told().verdict, Verdict::kPassed) << verb.exercise;
      continue;
    }
    for (Ref element = 0; element < count_elements(mesh, verb.picks); element += 3) {
      student.session->go_to(0);
      student.session->apply(
          {verb.exercise, verb.picks, std::vector<Ref>(verb.picked, element)});
      ASSERT_FALSE(student.session->stopped()) << verb.exercise;
      EXPECT_EQ(student.told().verdict, Verdict::kPassed) << verb.exercise << " " << element;
      EXPECT_TRUE(
          find_broken_rules(student.state().mesh, FaceShape::kDegeneratePolygons).empty());
    }
  }
}

TEST(PolygonSession, OneMeshGoesFromStepToStepWithItsNumbers) {
  PolygonStudent student("prism_5.obj");
  const auto [v, e, f] = student.sizes();
  student.apply("bevel v2");
  EXPECT_EQ(student.sizes(), (std::array{v + 2, e + 3, f + 1}));
  EXPECT_EQ(student.state().mesh.vertices.at(2).live, 0U);
  const auto face = static_cast<Ref>(student.state().mesh.faces.size() - 1);
  student.apply("collapse " + face_name(face));
  EXPECT_EQ(student.sizes(), (std::array{v, e, f}));
  EXPECT_NE(user_error([&] { student.apply("bevel v2"); }), "");
  EXPECT_EQ(student.session->operations().size(), 2U);
}

TEST(PolygonSession, ARefusalIsToldWithItsReasonAndLeavesTheMesh) {
  PolygonStudent student("quad_grid_3x3.obj");
  const std::string before = to_wire(student.state().mesh);
  student.apply("weld e0 e0");
  EXPECT_EQ(student.told().verdict, Verdict::kPassed);
  EXPECT_THAT(student.told().note, HasSubstr("refused, as it must be"));
  EXPECT_EQ(to_wire(student.state().mesh), before);
}

TEST(PolygonSession, AWrongRefusalAndAWrongResultAreNamed) {
  const std::string head = "std::optional<FaceIter> PolyMesh::removeFace(FaceIter f)";
  PolygonStudent refuses("prism_5.obj", "face_remove.cpp",
                         operation_file(head, "(void)f; return std::nullopt;"));
  refuses.apply("remove f0");
  EXPECT_EQ(refuses.told().verdict, Verdict::kFailed);
  EXPECT_EQ(refuses.told().findings.at(0).finding.rule, "refused");

  PolygonStudent forgets("prism_5.obj", "face_remove.cpp",
                         operation_file(head, "deleteFace(f); return f;"));
  forgets.apply("remove f0");
  EXPECT_EQ(forgets.told().verdict, Verdict::kFailed);
  EXPECT_FALSE(find_broken_rules(forgets.state().mesh, FaceShape::kPolygons).empty());
  EXPECT_THAT(user_error([&] { forgets.apply("triangulate"); }), HasSubstr("broken"));
}

TEST(PolygonSession, ACrashKeepsTheMeshAndIsDoneAgainAfterASave) {
  const std::string head = "std::optional<VertexIter> PolyMesh::insetVertex(FaceIter f)";
  PolygonStudent student("prism_5.obj", "vertex_inset.cpp",
                         operation_file(head, "(void)f; return HalfedgeIter()->vertex();"));
  student.apply("bevel v2, inset f0");
  ASSERT_TRUE(student.session->stopped());
  EXPECT_EQ(student.session->stopped()->told.verdict, Verdict::kCrashed);
  EXPECT_TRUE(student.session->stopped()->mesh);
  EXPECT_EQ(student.session->position(), 1U);
  student.folder.write("vertex_inset.cpp", reference_file("polygon_meshes/vertex_inset.cpp"));
  student.session->rebuild();
  EXPECT_FALSE(student.session->stopped());
  EXPECT_EQ(student.session->position(), 2U);
  EXPECT_EQ(student.told().verdict, Verdict::kPassed);
}

TEST(PolygonSession, AnEndlessWalkIsTold) {
  const std::string head = "std::optional<EdgeIter> PolyMesh::flipEdge(EdgeIter e)";
  PolygonStudent student(
      "prism_5.obj", "edge_flip_polygon.cpp",
      operation_file(head, "HalfedgeIter h = e->halfedge(); for (;;) h = h->next();"));
  student.apply("flip e3");
  ASSERT_TRUE(student.session->stopped());
  EXPECT_EQ(student.session->stopped()->told.verdict, Verdict::kOutOfSteps);
}

TEST(PolygonSession, LevelsAreMadeOfTheStudentsPointsAlsoAfterDeleting) {
  PolygonStudent student("prism_5.obj");
  student.apply("bevel v2, remove f0, catmull-clark");
  // One quad for each corner of the old faces; a vertex for each vertex, edge and face.
  const MeshDump& before = student.session->states()[2].mesh;
  const Counts old = count(before);
  std::size_t corners = 0;
  for (const HalfedgeRecord& h : before.halfedges)
    corners += h.live != 0 && (h.face & kBoundaryBit) == 0 ? 1 : 0;
  EXPECT_EQ(student.sizes()[0], old.vertices + old.edges + old.faces);
  EXPECT_EQ(student.sizes()[2], corners);
  EXPECT_EQ(student.told().verdict, Verdict::kPassed);
  student.apply("linear");
  EXPECT_EQ(student.told().verdict, Verdict::kPassed);
  EXPECT_EQ(student.session->levels().size(), 3U);
}

TEST(PolygonSession, TheDistanceFromOpenSubdivIsThatOfTheWrongPointsAlone) {
  PolygonStudent student("prism_5.obj");
  student.apply("catmull-clark");
  const Deviation right = student.state().deviation;
  ASSERT_EQ(right.of_vertex.size(), student.state().mesh.vertices.size());
  EXPECT_TRUE(right.worst.empty());
  EXPECT_LT(right.largest, 1e-12);

  const std::string catmull_clark = "RefinedPositions PolyMesh::catmullClarkPositions()";
  const std::string linear = "RefinedPositions PolyMesh::linearPositions()";
  // Face points are the same in both; the 10 vertices and 15 edges are not smoothed.
  PolygonStudent unsmoothed("prism_5.obj", "catmull_clark.cpp",
                            operation_file(catmull_clark, "return linearPositions();"));
  unsmoothed.apply("catmull-clark");
  EXPECT_EQ(unsmoothed.told().verdict, Verdict::kFailed);
  EXPECT_EQ(unsmoothed.state().deviation.worst.size(), 25U);

  PolygonStudent lifted(
      "prism_5.obj", "linear_subdivision.cpp",
      operation_file(linear,
                     "RefinedPositions p = catmullClarkPositions();\n"
                     "for (auto& [v, at] : p.vertices) at = v->position;\n"
                     "for (auto& [e, at] : p.edges)\n"
                     "  at = 0.5 * (e->halfedge()->vertex()->position +\n"
                     "              e->halfedge()->twin()->vertex()->position);\n"
                     "for (auto& [f, at] : p.faces) at.z += 1.0;\n"
                     "return p;"));
  lifted.apply("linear");
  EXPECT_EQ(lifted.told().verdict, Verdict::kFailed);
  EXPECT_EQ(lifted.state().deviation.worst.size(), 7U);
}

TEST(PolygonSession, LoopGoesOnWithTrianglesAsTheyAreAndRefusesOthers) {
  PolygonStudent student("prism_5.obj");
  student.apply("loop");
  EXPECT_EQ(student.told().verdict, Verdict::kPassed);
  EXPECT_THAT(student.told().note, HasSubstr("as it was"));
  student.apply("triangulate, loop, loop");
  EXPECT_EQ(student.told().verdict, Verdict::kPassed);
  EXPECT_FALSE(student.state().begun_with);
  EXPECT_EQ(student.state().deviation.worst.size(), 0U);
  EXPECT_FALSE(student.state().deviation.empty());
}

TEST(PolygonSession, UndoAndRedoShowTheStatesAsTheyWere) {
  PolygonStudent student("prism_5.obj");
  std::vector<std::string> seen{to_wire(student.state().mesh)};
  for (const char* step : {"bevel v2", "split e4", "catmull-clark", "collapse e0"}) {
    student.apply(step);
    seen.push_back(to_wire(student.state().mesh));
  }
  for (const std::size_t position : {3, 0, 4, 1}) {
    student.session->go_to(position);
    EXPECT_EQ(to_wire(student.state().mesh), seen[position]);
  }
}

TEST(PolygonsOf, GivesBackWhatWasBuiltAndNothingOfABrokenMesh) {
  for (const char* name : {"prism_5.obj", "quad_grid_3x3.obj", "pouch.obj", "tube_6.obj"}) {
    MeshDump mesh = built_mesh(sample_polygons(name));
    const auto polygons = polygons_of(mesh);
    ASSERT_TRUE(polygons) << name;
    EXPECT_EQ(to_wire(built_mesh(*polygons)), to_wire(mesh)) << name;
    for (const Ref wrong : {kUnsetRef, kForeignRef, kPastEndRef, Ref{0} | kDeletedBit}) {
      MeshDump broken = mesh;
      broken.halfedges[mesh.faces[0].halfedge].next = wrong;
      EXPECT_FALSE(polygons_of(broken)) << name;
    }
    MeshDump endless = mesh;
    const Ref first = mesh.faces[0].halfedge;
    endless.halfedges[mesh.halfedges[first].next].next = mesh.halfedges[first].next;
    EXPECT_FALSE(polygons_of(endless)) << name;
  }
}

}  // namespace
}  // namespace meshgrade
