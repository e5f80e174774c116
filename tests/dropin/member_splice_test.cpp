#include "grader/build/member_splice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace meshgrade {
namespace {

Submission homework(const std::string& source, const std::string& header = "",
                    const std::string& program = "") {
  Submission submission;
  submission.dialect = Dialect::kCourse2020;
  submission.sources = {{"student_code.cpp", source}};
  if (!header.empty()) submission.course_headers = {{"halfEdgeMesh.h", header}};
  if (!program.empty()) submission.course_sources = {{"halfEdgeMesh.cpp", program}};
  return submission;
}

std::string text_of(const MemberSplice& splice, const std::string& file) {
  for (const SourceFile& made : splice.files()) {
    if (made.name == file) return made.text;
  }
  return {};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool has_note(const MemberSplice& splice, const std::string& part) {
  const auto notes = splice.notes();
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return holds(note, part); });
}

const std::string kHeader =
    "class Halfedge { public: HalfedgeIter& twin( void ) { return _twin; } };\n"
    "class Vertex : public HalfedgeElement {\n public:\n"
    "  Vector3D position; Vector3D normal( void ) const;\n"
    "  bool isBlue;\n"
    "  int unused;\n"
    "  double weight() const { return helper(2) + marks(); }\n"
    "  int marks() const;\n"
    "  Matrix4x4 quadric;\n"
    " protected:\n  HalfedgeIter _halfedge;\n};\n"
    "inline double helper(double x) { return x; }\n"
    "inline void Vertex::computeCentroid() { centroid = position; }\n"
    "inline Vertex* elementAddress( VertexIter v ) { return &( *v ); }\n";

TEST(MemberSplice, TakesWhatIsUsedAndTheCourseDoesNotHave) {
  const MemberSplice splice(homework("v->isBlue = v->weight() > 1;", kHeader));
  const std::string data = text_of(splice, "meshedit_added_data.h");
  EXPECT_TRUE(holds(data, "#line 5 \"halfEdgeMesh.h\"\nbool isBlue{};")) << data;
  EXPECT_FALSE(holds(data, "unused"));
  EXPECT_FALSE(holds(data, "position"));
  EXPECT_FALSE(holds(data, "quadric"));
  const std::string functions = text_of(splice, "meshedit_added_vertex.h");
  EXPECT_TRUE(holds(functions, "double weight() const"));
  EXPECT_TRUE(holds(functions, "int marks() const;")) << "used by another that is used";
  EXPECT_TRUE(holds(text_of(splice, MemberSplice::kLater), "double helper(double x)"));
  EXPECT_FALSE(holds(text_of(splice, MemberSplice::kLater), "elementAddress"));
  EXPECT_TRUE(has_note(splice, "halfEdgeMesh.h holds members of your own"));
}

TEST(MemberSplice, TakesDefinitionsFromTheCoursesFiles) {
  const MemberSplice splice(homework("v->marks();", kHeader,
                                     "int Vertex::marks() const { return 3; }\n"
                                     "Vector3D Face::normal() const { return 1; }\n"));
  const std::string later = text_of(splice, MemberSplice::kLater);
  EXPECT_TRUE(holds(later, "inline int Vertex::marks() const { return 3; }")) << later;
  EXPECT_FALSE(holds(later, "Face::normal"));
}

TEST(MemberSplice, IsEmptyForTheCoursesOwnHeaderAndForOtherSkeletons) {
  EXPECT_TRUE(MemberSplice(homework("v->position = 0;", kHeader)).empty());
  Submission ours = homework("v->isBlue = true;", kHeader);
  ours.dialect = Dialect::kMeshedit;
  EXPECT_TRUE(MemberSplice(ours).empty());
}

TEST(MemberSplice, TellsDataFromTheirUse) {
  const Submission submission = homework(
      "e->isBlue = true; e->times++; e->weight = 0.5; e->middle = Vector3D(1, 2, 3);\n"
      "e->odd = other;\n");
  MemberSplice splice(submission);
  EXPECT_TRUE(splice.empty());
  std::vector<MemberUse> uses;
  for (const char* name : {"isBlue", "times", "weight", "middle", "odd"})
    uses.push_back({"Edge", name, "student_code.cpp:1"});
  EXPECT_TRUE(splice.add_from_use(uses, submission));
  const std::string data = text_of(splice, "meshedit_added_data.h");
  for (const char* declared :
       {"bool isBlue{};", "int times{};", "double weight{};", "Vector3D middle{};"}) {
    EXPECT_TRUE(holds(data, declared)) << declared << "\n" << data;
  }
  EXPECT_FALSE(holds(data, "odd"));
  EXPECT_TRUE(has_note(splice, "student_code.cpp:1 uses Edge::isBlue, which no header"));
  EXPECT_FALSE(splice.add_from_use(uses, submission)) << "only once";
}

TEST(MemberSplice, TellsDataFromTheirUseInCodeOfAnyLength) {
  const Submission submission = homework("e->isBlue" + std::string(500'000, ' ') +
                                         "= true;\n!e->" + std::string(500'000, 'x') +
                                         ";\ne->times = " + std::string(500'000, '1') + ";\n");
  MemberSplice splice(submission);
  splice.add_from_use(
      {{"Edge", "isBlue", "student_code.cpp:1"}, {"Edge", "times", "student_code.cpp:3"}},
      submission);
  EXPECT_TRUE(holds(text_of(splice, "meshedit_added_data.h"), "bool isBlue{};"));
}

TEST(MemberSplice, TellsFunctionsFromTheirDefinitions) {
  const Submission submission = homework(
      "bool CGL::HalfedgeMesh::canFlip( EdgeIter e /* any */ ) const { return true; }");
  MemberSplice splice(submission);
  EXPECT_TRUE(
      splice.add_from_use({{"HalfedgeMesh", "canFlip", "student_code.cpp:1"}}, submission));
  EXPECT_TRUE(holds(text_of(splice, "meshedit_added_mesh.h"), "bool canFlip( EdgeIter e"));
}

TEST(MemberSplice, ANameThatIsNearlyOneOfTheCourseIsAMistake) {
  const Submission submission = homework("e->isnew = true; v->postion = Vector3D();");
  MemberSplice splice(submission);
  EXPECT_FALSE(splice.add_from_use(
      {{"Edge", "isnew", "a.cpp:1"}, {"Vertex", "postion", "a.cpp:1"}}, submission));
  EXPECT_FALSE(MemberSplice::is_slip({"Edge", "isBlue", ""}));
  EXPECT_FALSE(MemberSplice::is_slip({"BezierCurve", "level", ""}));
}

TEST(MemberSplice, KnowsTheCurvesAndPatchesOfTheYear) {
  const std::string header =
      "class BezierCurve { public: void evaluateStep(); vector<vector<Vector2D> > "
      "evaluatedLevels;\n  Vector2D mix(Vector2D a, Vector2D b) { return a * (1 - t) + b * t; "
      "} };\n"
      "class BezierPatch { Vector3D evaluate1D(std::vector<Vector3D> points, double t) const;\n"
      "  std::vector<Vector3D> evaluateStep(std::vector<Vector3D> points, double t) const; "
      "};\n";
  Submission submission =
      homework("mix(a, b); evaluateStep(points, t); evaluatedLevels;", header);
  submission.dialect = Dialect::kCourse2017;
  const MemberSplice splice(submission);
  const std::string curve = text_of(splice, "meshedit_added_curve_2017.h");
  EXPECT_TRUE(holds(curve, "Vector2D mix(Vector2D a, Vector2D b)")) << curve;
  EXPECT_FALSE(holds(curve, "evaluateStep"));
  EXPECT_FALSE(holds(text_of(splice, "meshedit_added_data.h"), "evaluatedLevels"));
  const std::string patch = text_of(splice, "meshedit_added_patch_2017.h");
  EXPECT_TRUE(holds(patch, "evaluateStep")) << "this year's patch has no such function";
  EXPECT_FALSE(holds(patch, "evaluate1D"));
  submission.dialect = Dialect::kCourse2016;
  EXPECT_TRUE(MemberSplice(submission).empty()) << "its Bezier part is left out";
}

TEST(MemberSplice, AFunctionBesideTheOneThatItIsNearlyCalledIsNoMistake) {
  const MemberUse use{"BezierPatch", "evaluate2D", "student_code.cpp:1"};
  const std::string helper = "Vector3D BezierPatch::evaluate2D(double u) const { return u; }\n";
  Submission submission = homework(helper);
  MemberSplice alone(submission);
  EXPECT_FALSE(alone.add_from_use({use}, submission));
  submission = homework(helper +
                        "Vector3D BezierPatch::evaluate1D(std::vector<Vector3D> const &points, "
                        "double t) const { return points[0]; }\n");
  MemberSplice both(submission);
  EXPECT_TRUE(both.add_from_use({use}, submission));
  EXPECT_TRUE(
      holds(text_of(both, "meshedit_added_patch.h"), "Vector3D evaluate2D(double u) const"));
}

TEST(MemberSplice, DropsWhatDoesNotCompile) {
  MemberSplice splice(homework("v->isBlue; v->weight();", kHeader));
  splice.drop_blamed("halfEdgeMesh.h:7:9: error: no such thing\n");
  EXPECT_FALSE(splice.empty());
  EXPECT_FALSE(holds(text_of(splice, "meshedit_added_vertex.h"), "weight"));
  EXPECT_TRUE(
      has_note(splice, "halfEdgeMesh.h:7: Vertex::weight cannot be taken over: no such"));
  EXPECT_TRUE(splice.is_declared({"Vertex", "weight", ""}));
  splice.drop_blamed("collect2: error: out of luck\n");
  EXPECT_TRUE(splice.empty());
}

}  // namespace
}  // namespace meshgrade
