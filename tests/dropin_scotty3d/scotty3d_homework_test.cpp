// Homework written for Scotty3D is graded as it was handed in. tests/dropin_scotty3d/homework
// holds some, in the styles of different years and authors; the broken ones are made from them
// by one edit.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>

#include "grader/grade/dialect_fit.h"
#include "grader/grade/grading.h"
#include "grader/report/terminal_report.h"
#include "tests/support/home_that_keeps.h"

namespace meshgrade {
namespace {

using Verdicts = std::map<std::string, std::string>;

Submission scotty3d_hand_in(const std::string& folder) {
  const std::filesystem::path homework =
      std::filesystem::path(MESHGRADE_SOURCE_DIR) / "tests" / "dropin_scotty3d" / "homework";
  return find_submission(homework / folder, SubmissionRules());
}

Report grade_scotty3d(const Submission& submission,
                      const std::vector<std::string>& exercises = {}) {
  static const Assignment assignment = load_assignment("polygon_meshes");
  return grade(assignment, submission, home_that_keeps(), exercises, [](const std::string&) {});
}

Verdicts scotty3d_verdicts(const Report& report) {
  Verdicts all;
  for (const ExerciseReport& exercise : report.exercises)
    all[exercise.name] = verdict_name(exercise.verdict);
  return all;
}

bool has_scotty3d_note(const Report& report, const std::string& part) {
  return std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
    return note.find(part) != std::string::npos;
  });
}

void replace_in_file(Submission& submission, const std::string& part,
                     const std::string& replacement) {
  for (SourceFile& source : submission.sources) {
    const std::size_t at = source.text.find(part);
    if (at == std::string::npos) continue;
    source.text.replace(at, part.size(), replacement);
    return;
  }
  ADD_FAILURE() << "the homework does not hold " << part;
}

const Finding& first_scotty3d_finding(const ExerciseReport& report) {
  static const Finding none;
  for (const CaseReport& c : report.cases) {
    if (!c.findings.empty()) return c.findings[0].finding;
  }
  return none;
}

/// A folder of homework, and which exercises it leaves as they are handed out.
struct RightFolder {
  const char* folder;
  std::vector<std::string> unwritten;
};

std::ostream& operator<<(std::ostream& out, const RightFolder& folder) {
  return out << folder.folder;
}

class RightScotty3dHomework : public testing::TestWithParam<RightFolder> {};

TEST_P(RightScotty3dHomework, PassesInAllThatItHas) {
  const Report report = grade_scotty3d(scotty3d_hand_in(GetParam().folder));
  const std::vector<std::string>& unwritten = GetParam().unwritten;
  for (const ExerciseReport& exercise : report.exercises) {
    const bool is_written =
        std::find(unwritten.begin(), unwritten.end(), exercise.name) == unwritten.end();
    EXPECT_EQ(verdict_name(exercise.verdict),
              std::string(is_written ? "passed" : "not implemented"))
        << exercise.name << ": " << first_scotty3d_finding(exercise).actual;
    EXPECT_EQ(exercise.points, is_written ? exercise.max_points : 0.0) << exercise.name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Years, RightScotty3dHomework,
    testing::Values(RightFolder{"of_2022",
                                {"face_collapse", "vertex_bevel", "edge_bevel", "face_remove",
                                 "edge_weld", "extrude_positions", "bevel_positions",
                                 "triangulation", "linear_subdivision", "catmull_clark",
                                 "loop_refinement", "isotropic_remeshing", "simplification"}},
                    RightFolder{"of_2024", {}}, RightFolder{"of_2020", {}},
                    RightFolder{
                        "of_spring_2022",
                        {"edge_dissolve", "vertex_dissolve", "face_extrude", "face_collapse",
                         "vertex_bevel", "edge_bevel", "catmull_clark", "loop_refinement"}},
                    RightFolder{"of_2026",
                                {"face_collapse", "edge_bevel", "face_remove", "edge_weld",
                                 "bevel_positions", "linear_subdivision", "loop_refinement",
                                 "isotropic_remeshing", "simplification"}}),
    [](const auto& tested) { return std::string(tested.param.folder); });

TEST(Scotty3dHomework, AsHandedOutIsNotImplementedAndCompilesWhole) {
  const Report report = grade_scotty3d(scotty3d_hand_in("untouched"));
  EXPECT_EQ(report.points, 0.0);
  for (const auto& [exercise, verdict] : scotty3d_verdicts(report))
    EXPECT_EQ(verdict, "not implemented") << exercise;
  EXPECT_TRUE(has_scotty3d_note(report, "recognised: homework for Carnegie Mellon's Scotty3D"));
  for (const FileReport& file : report.files)
    EXPECT_TRUE(file.compiled) << file.name << ": " << file.messages;
  EXPECT_EQ(report.notes.size(), 1U);
}

TEST(Scotty3dHomework, OfEarlierYearsAsHandedOutIsNotImplementedAndCompilesWhole) {
  const Report report = grade_scotty3d(scotty3d_hand_in("untouched_2020"));
  EXPECT_EQ(report.points, 0.0);
  for (const auto& [exercise, verdict] : scotty3d_verdicts(report))
    EXPECT_EQ(verdict, "not implemented") << exercise;
  for (const FileReport& file : report.files)
    EXPECT_TRUE(file.compiled) << file.name << ": " << file.messages;
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_TRUE(has_scotty3d_note(report, "Fall 2020 to Spring 2022"));
}

TEST(Scotty3dHomework, OfEarlierYearsIsAskedForWhatItsYearHad) {
  const Assignment given = load_assignment("polygon_meshes");
  const Assignment early = fit_to_submission(given, scotty3d_hand_in("of_2020"));
  for (const char* later :
       {"vertex_inset", "face_remove", "edge_weld", "extrude_positions", "bevel_positions"}) {
    EXPECT_EQ(early.find(later), nullptr) << later;
    EXPECT_NE(given.find(later), nullptr) << later;
  }
  EXPECT_EQ(early.find("catmull_clark")->groups.size(), 3U);
  EXPECT_EQ(early.find("loop_refinement")->groups.size(), 3U);
  EXPECT_EQ(early.find("linear_subdivision")->groups.size(), 4U);
  const Assignment spring = fit_to_submission(given, scotty3d_hand_in("of_spring_2022"));
  EXPECT_NE(spring.find("vertex_inset"), nullptr);
  const Assignment again = fit_to_submission(spring, scotty3d_hand_in("of_spring_2022"));
  EXPECT_EQ(again.points(), spring.points());
}

TEST(Scotty3dHomework, IsToldInTheNamesOfItsCourse) {
  const Report report = grade_scotty3d(scotty3d_hand_in("untouched"), {"edge_collapse"});
  EXPECT_EQ(report.exercises.at(0).cases.at(0).note,
            "Halfedge_Mesh::collapse_edge is not implemented");
  EXPECT_EQ(to_terminal(report, TerminalStyle()).find("PolyMesh"), std::string::npos);
}

struct Scotty3dMistake {
  const char* name;
  const char* exercise;
  const char* folder;
  const char* was;
  const char* becomes;
  const char* rule;  ///< of the first finding
};

std::ostream& operator<<(std::ostream& out, const Scotty3dMistake& mistake) {
  return out << mistake.exercise << ": " << mistake.name;
}

class WrongScotty3dHomework : public testing::TestWithParam<Scotty3dMistake> {};

TEST_P(WrongScotty3dHomework, LosesPointsAndIsToldWhy) {
  const Scotty3dMistake& mistake = GetParam();
  Submission submission = scotty3d_hand_in(mistake.folder);
  replace_in_file(submission, mistake.was, mistake.becomes);
  const ExerciseReport report = grade_scotty3d(submission, {mistake.exercise}).exercises.at(0);
  EXPECT_LT(report.points, report.max_points);
  const Finding& finding = first_scotty3d_finding(report);
  EXPECT_EQ(finding.rule, mistake.rule) << finding.actual << "; " << finding.look_at;
  EXPECT_FALSE(finding.actual.empty());
  EXPECT_FALSE(finding.look_at.empty());
  EXPECT_EQ(finding.look_at.find("PolyMesh"), std::string::npos);
}

const Scotty3dMistake kScotty3dMistakes[] = {
    {"BoundaryEdgeIsNotRefused", "edge_flip_polygon", "of_2026",
     "if (e->on_boundary()) return std::nullopt;", "", "not-refused"},
    {"ReturnsTheEdgeWhereItRefuses", "edge_flip_polygon", "of_2026",
     "if (e->on_boundary()) return std::nullopt;", "if (e->on_boundary()) return e;",
     "not-refused"},
    {"RightForTrianglesOnly", "edge_flip_polygon", "of_2022",
     "while (hl->next != h) hl = hl->next;", "hl = h2;", "twin-opposite"},
    {"FaceKeepsAHalfedgeOfTheOtherSide", "edge_flip_polygon", "of_2022",
     "    f->halfedge = h;\n    g->halfedge = t;\n    return e;", "    return e;", "anchor"},
    {"EndOfTwoEdgesIsNotRefused", "edge_flip_polygon", "of_2026",
     "if (has_corner(h, d) || has_corner(t, c)) return std::nullopt;", "", "not-refused"},
    {"RefusesVerticesOfThreeEdges", "edge_flip_polygon", "of_2026",
     "if (e->on_boundary()) return std::nullopt;",
     "if (e->on_boundary() || e->halfedge->vertex->degree() <= 3) return std::nullopt;",
     "refused"},
    {"RefusesAfterTheFirstWrites", "edge_flip_polygon", "of_2022",
     "    // a face must not come to a corner twice",
     "    h->face = g;\n    // a face must not come to a corner twice", "refused-unchanged"},
    {"TakesTheAnchorToBeInside", "edge_split_polygon", "of_2022",
     "if (h->face->boundary) h = h->twin; // h is inside", "", "counts"},
    {"JoinsAnotherCorner", "edge_split_polygon", "of_2024",
     "link(s, s->next->next, emplace_face());", "link(s, s->prev(), emplace_face());",
     "face-loop"},
    {"ReturnedVertexAnchorsOnACut", "edge_split_polygon", "of_2024",
     "link(s, s->next->next, emplace_face());",
     "m->halfedge = link(s, s->next->next, emplace_face())->halfedge;", "along-edge"},
    {"ReadsAnUnsetReference", "edge_split_polygon", "of_2022",
     "    m->position = (a->position + b->position) * 0.5f;",
     "    m->position = (a->position + b->position) * 0.5f;\n    FaceRef none;\n"
     "    none->boundary = false;",
     "unset-handle"},
    {"ReadsThePointerOfANewElement", "edge_split_polygon", "of_2022",
     "    m->position = (a->position + b->position) * 0.5f;",
     "    m->position = (a->position + m->halfedge->twin->vertex->position) * 0.5f;",
     "end-reference"},
    {"FigureOfEight", "edge_collapse", "of_2026",
     "if (a->on_boundary() && b->on_boundary() && !e->on_boundary()) return std::nullopt;", "",
     "not-refused"},
    {"LoneTriangle", "edge_collapse", "of_2026",
     "if (side->face->boundary) return std::nullopt;\n"
     "\t\tVertexRef tip = side->next->next->vertex;\n"
     "\t\tif (tip->degree() < 3) return std::nullopt;",
     "VertexRef tip = side->next->next->vertex;", "not-refused"},
    {"RefusesAllOfTheBoundary", "edge_collapse", "of_2026",
     "if (a->on_boundary() && b->on_boundary() && !e->on_boundary()) return std::nullopt;",
     "if (a->on_boundary() || b->on_boundary()) return std::nullopt;", "refused"},
    {"RenamesTheFirstTwoOnly", "edge_collapse", "of_2022",
     "    for (auto k : of_b) k->vertex = a;",
     "    for (size_t i = 0; i < 2; i++) of_b[i]->vertex = a;", "live-pointer"},
    {"ApexKeepsAnErasedHalfedge", "edge_collapse", "of_2022",
     "        pt->vertex->halfedge = pt;\n", "", "live-pointer"},
    {"ReturnsTheErasedVertex", "edge_collapse", "of_2022",
     "    erase_vertex(b);\n    return a;", "    erase_vertex(b);\n    return b;", "returned"},
    {"ForgetsToErase", "edge_collapse", "of_2024", "\terase_vertex(a);\n\terase_edge(e);",
     "\terase_edge(e);", "counts"},
    {"NeighbourMeanOfErasedElements", "edge_collapse", "of_2022",
     "    erase_vertex(b);\n    return a;",
     "    erase_vertex(b);\n    a->position = (a->position + b->position) * 0.5f;\n"
     "    return a;",
     "finite"},
    {"ScratchVertexForTheMean", "face_extrude", "of_2024", "\tFaceRef inner = emplace_face();",
     "\tFaceRef inner = emplace_face();\n\templace_vertex()->position = f->center();",
     "counts"},
    {"QuadsOnly", "face_extrude", "of_2022", "int n = int(low.size());",
     "int n = 4; low.resize(4, low[0]);", "counts"},
    {"MovesTheCopyAtOnce", "face_extrude", "of_2026", "v->position = h->vertex->position;",
     "v->position = lerp(h->vertex->position, "
     "f->center(), 0.25f);",
     "new-position"},
    {"UnsignedMinusOne", "face_extrude", "of_2022", "l = (i - 1 + n) % n;",
     "l = int((size_t(i) - 1) % size_t(n));", "twin-opposite"},
    {"FaceAnchorIsLeftUnset", "vertex_inset", "of_2022", "        fs[i]->halfedge = hs[i];\n",
     "", "live-pointer"},
    {"BevelsAVertexOfTwoEdges", "vertex_bevel", "of_2024",
     "if (spokes.size() < 3) return std::nullopt;", "", "not-refused"},
    {"TouchesTheBoundaryElsewhere", "edge_dissolve", "of_2022",
     "if (f->boundary && k->vertex->on_boundary()) return std::nullopt;", "", "not-refused"},
    {"CornerContactIsNotRefused", "face_remove", "of_2024",
     "if (s->vertex->on_boundary() && !s->twin->outside() && !s->prev()->twin->outside()) "
     "return std::nullopt;",
     "", "not-refused"},
    {"EndlessWalk", "edge_collapse", "of_2022", "while (l->next != s) l = l->next;",
     "while (l->next != e->halfedge->twin->twin) l = l->next;", "out-of-steps"},
    {"DriftsWithEachCall", "extrude_positions", "of_2024",
     "outer.push_back(s->twin->next->twin->vertex->position);",
     "outer.push_back(s->vertex->position);", "new-position"},
    {"RightUpToQuads", "triangulation", "of_2024", "i + 1 < sides.size()",
     "i + 1 < sides.size() && i < 3", "triangles"},
    {"CutsTrianglesForEver", "triangulation", "of_2024", "i + 1 < sides.size()", "i < 3",
     "out-of-steps"},
    {"EdgePointsWithoutFaces", "catmull_clark", "of_2024", "if (e->on_boundary()) {",
     "if (true) {", "position"},
    {"QuarterForTheBoundary", "catmull_clark", "of_2026",
     "(6.0f * v->position + rim[v]) / 8.0f", "(v->position * 2.0f + rim[v]) / 4.0f",
     "position"},
    {"ThreeSixteenthsInWholeNumbers", "loop_refinement", "of_2024", "3.0f / 16.0f", "3 / 16",
     "position"},
    {"CollapsesWhatIsErased", "isotropic_remeshing", "of_2024", "e->id == id && ", "",
     "end-reference"},
    {"UsesARefusedCollapse", "isotropic_remeshing", "of_2024",
     "params.shorter_factor * mean) collapse_edge(e);",
     "params.shorter_factor * mean) collapse_edge(e).value()->id;", "exception"},
    {"SmoothsVertexByVertex", "isotropic_remeshing", "of_2024", "to[v] = v->position +",
     "to[v] = v->position +=", "position"},
    {"OffsetOfThePlaneWithTheWrongSign", "simplification", "of_2024",
     "plane(n, -dot(n, f->halfedge->vertex->position))",
     "plane(n, dot(n, f->halfedge->vertex->position))", "new-position"},
    {"GivesUpAtTheFirstRefusal", "simplification", "of_2024",
     "for (EdgeRef e : was_in) if (e != best.edge) put_in(e);\n"
     "\t\t\tcontinue;",
     "return false;", "gave-up"},
    {"FailedAssertion", "vertex_inset", "of_2026",
     "VertexRef m = emplace_vertex();\n\tm->position = f->center();",
     "VertexRef m = emplace_vertex();\n\tassert(sides.size() == 4);\n\tm->position = "
     "f->center();",
     "assertion"},
    // Until Spring 2022.
    {"EarlyBoundaryEdgeIsNotRefused", "edge_flip_polygon", "of_2020",
     "flip_edge(Halfedge_Mesh::EdgeRef e) {\n    if(e->on_boundary()) return std::nullopt;",
     "flip_edge(Halfedge_Mesh::EdgeRef e) {", "not-refused"},
    {"EarlyReturnsTheEdgeWhereItRefuses", "edge_flip_polygon", "of_2020",
     "flip_edge(Halfedge_Mesh::EdgeRef e) {\n    if(e->on_boundary()) return std::nullopt;",
     "flip_edge(Halfedge_Mesh::EdgeRef e) {\n    if(e->on_boundary()) return e;",
     "not-refused"},
    {"EarlyRightForTrianglesOnly", "edge_flip_polygon", "of_2020",
     "HalfedgeRef hl = before(h), tl = before(t);\n    VertexRef a",
     "HalfedgeRef hl = h2, tl = t2;\n    VertexRef a", "twin-opposite"},
    {"EarlyEndOfTwoEdgesIsNotRefused", "edge_flip_polygon", "of_spring_2022",
     "for(HalfedgeRef s = h->next()->next(); s != h; s = s->next()) if(s->vertex() == from) "
     "return std::nullopt;",
     "", "not-refused"},
    {"EarlyRefusesFacesThatAreNotFlat", "edge_flip_polygon", "of_2020",
     "FaceRef f = h->face(), g = t->face();\n    for(auto k : sides_of(f)) if(k->vertex() == "
     "d)",
     "FaceRef f = h->face(), g = t->face();\n    if((f->normal() - g->normal()).norm() > 0.1f) "
     "return std::nullopt;\n    for(auto k : sides_of(f)) if(k->vertex() == d)",
     "refused"},
    {"EarlyTakesTheAnchorToBeInside", "edge_split_polygon", "of_2020",
     "if(h->is_boundary()) h = h->twin();", "", "refused"},
    {"EarlyHasNoBranchForTheBoundary", "edge_split_polygon", "of_spring_2022",
     "if(s->is_boundary()) continue;", "", "counts"},
    {"EarlyJoinsTheMiddleToEveryCorner", "edge_split_polygon", "of_spring_2022",
     "connect(s, s->next()->next());",
     "for(HalfedgeRef k = connect(s, s->next()->next())->halfedge(); k->face()->degree() > "
     "3;)\n"
     "            k = connect(k, k->next()->next())->halfedge();",
     "counts"},
    {"EarlyReadsThePointerOfANewElement", "edge_split_polygon", "of_2020",
     "m->pos = e->center();\n    EdgeRef e1",
     "m->pos = m->halfedge()->edge()->center();\n    "
     "EdgeRef e1",
     "unset-handle"},
    {"EarlyFigureOfEight", "edge_collapse", "of_spring_2022",
     "if(a->on_boundary() && b->on_boundary() && !e->on_boundary()) return {};", "",
     "not-refused"},
    {"EarlyApexKeepsAnErasedHalfedge", "edge_collapse", "of_2020",
     "        xt->vertex()->halfedge() = xt;\n        a->halfedge() = yt;",
     "        a->halfedge() = yt;", "live-pointer"},
    {"EarlyReturnsTheErasedVertex", "edge_collapse", "of_2020", "    erase(b);\n    return a;",
     "    erase(b);\n    return b;", "returned"},
    {"EarlyForgetsToErase", "edge_collapse", "of_2020", "    erase(e);\n    erase(b);",
     "    erase(b);", "counts"},
    {"EarlyUsesWhatIsGone", "edge_collapse", "of_2020", "    erase(b);\n    return a;",
     "    erase(b);\n    do_erase();\n    a->pos = 0.5f * (a->pos + b->pos);\n    return a;",
     "deleted-handle"},
    {"EarlyEndlessWalk", "edge_collapse", "of_2020", "while(p->next() != h) p = p->next();",
     "while(p->next() != h->twin()->twin()->next()->twin()) p = p->next();", "out-of-steps"},
    {"EarlyTwoSidesAreLeft", "face_collapse", "of_2020", "gone.push_back(g);", "", "counts"},
    {"EarlyBevelsAVertexOfTwoEdges", "vertex_bevel", "of_2020",
     "if(spokes.size() < 3) return std::nullopt;", "", "not-refused"},
    {"EarlyMovesTheCopyAtOnce", "face_extrude", "of_2020", "v.back()->pos = s->vertex()->pos;",
     "v.back()->pos = 0.9f * s->vertex()->pos + 0.1f * f->center();", "new-position"},
    {"EarlyRightUpToQuads", "triangulation", "of_2020", "i + 2 < sides.size()",
     "i + 2 < sides.size() && i < 2", "triangles"},
    {"EarlyMeanOfNewEdgePoints", "catmull_clark", "of_2020", "R += s->edge()->center() / n;",
     "R += s->edge()->new_pos / n;", "position"},
    {"EarlyTheSameFaceTwice", "catmull_clark", "of_2020", "h->twin()->face()->new_pos) / 4.0f",
     "h->face()->new_pos) / 4.0f", "position"},
    {"EarlyCornersOfThreeAreNotSpecial", "loop_refinement", "of_2020",
     "v->degree() == 3 ? 3.0f / 16.0f : ", "", "position"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, WrongScotty3dHomework, testing::ValuesIn(kScotty3dMistakes),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Scotty3dHomework, WhoseCollapseIsWrongIsToldToMendThatFirst) {
  Submission submission = scotty3d_hand_in("of_2024");
  replace_in_file(submission, "\terase_vertex(a);\n\terase_edge(e);", "\terase_edge(e);");
  const ExerciseReport report = grade_scotty3d(submission, {"simplification"}).exercises.at(0);
  EXPECT_LT(report.points, report.max_points);
  ASSERT_EQ(report.notes.size(), 2U);
  EXPECT_EQ(report.notes[0],
            "your own edge_collapse is part of this and fails: see there first");
  EXPECT_NE(report.notes[1].find("first mend your own"), std::string::npos);
}

TEST(Scotty3dHomework, ThatDoesNotCompileInOneFunctionIsGradedInTheOthers) {
  Submission submission = scotty3d_hand_in("of_2026");
  replace_in_file(submission, "EdgeRef e2 = emplace_edge(e->sharp);", "EdgeRef e2 = nonsense;");
  const Report report =
      grade_scotty3d(submission, {"edge_flip_polygon", "edge_split_polygon", "vertex_inset"});
  EXPECT_EQ(report.exercises.at(0).verdict, Verdict::kPassed);
  EXPECT_NE(report.exercises.at(1).verdict, Verdict::kPassed);
  EXPECT_EQ(report.exercises.at(2).verdict, Verdict::kPassed);
  EXPECT_TRUE(has_scotty3d_note(report, "Halfedge_Mesh::bisect_edge does not compile"));
}

TEST(Scotty3dHomework, MayDefineWhatTheGraderHasAsWell) {
  Submission submission = scotty3d_hand_in("of_2026");
  submission.sources.at(0).text +=
      "\nVec3 Halfedge_Mesh::Edge::center() const {\n"
      "  return 0.5f * (halfedge->vertex->position + halfedge->twin->vertex->position); }\n"
      "Vec3 Halfedge_Mesh::Face::center() const { return Vec3(7.0f, 7.0f, 7.0f); }\n";
  const Report report = grade_scotty3d(submission, {"edge_split_polygon", "vertex_inset"});
  EXPECT_EQ(report.exercises.at(0).verdict, Verdict::kPassed);
  EXPECT_EQ(first_scotty3d_finding(report.exercises.at(1)).rule, "new-position");
}

TEST(Scotty3dHomework, IsToldWhatWasLeftOver) {
  Submission submission = scotty3d_hand_in("of_2022");
  replace_in_file(submission, "    (void)e;\n",
                  "    if (validate()) return {};\n"
                  "    std::cout << \"flipping \" << e->id << std::endl;\n");
  const ExerciseReport report =
      grade_scotty3d(submission, {"edge_flip_polygon"}).exercises.at(0);
  EXPECT_EQ(report.points, report.max_points);
  ASSERT_EQ(report.notes.size(), 2U);
  EXPECT_NE(report.notes[0].find("validate() looks at the whole mesh"), std::string::npos);
  EXPECT_NE(report.notes[1].find("it prints while it works, for example \"flipping "),
            std::string::npos);
}

TEST(Scotty3dHomework, WithMembersOfItsOwnIsToldThatTheyWereTakenOver) {
  const Report report = grade_scotty3d(scotty3d_hand_in("of_2024"), {"vertex_inset"});
  EXPECT_TRUE(has_scotty3d_note(report, "halfedge.h holds members of your own"));
  EXPECT_TRUE(has_scotty3d_note(report, "Vertex::mark"));
}

TEST(Scotty3dHomework, OfEarlierYearsMayHaveMembersOfItsOwn) {
  const Report report =
      grade_scotty3d(scotty3d_hand_in("of_spring_2022"), {"edge_split_polygon"});
  EXPECT_EQ(report.exercises.at(0).verdict, Verdict::kPassed);
  EXPECT_TRUE(
      has_scotty3d_note(report,
                        "halfedge.h holds members of your own, which are taken over for this: "
                        "Halfedge::prev, Halfedge_Mesh::connect, Vertex::outgoing"));
}

TEST(Scotty3dHomework, OfEarlierYearsIsToldWhatWasLeftOver) {
  Submission submission = scotty3d_hand_in("of_2020");
  replace_in_file(submission, "    f->halfedge() = hl;\n",
                  "    f->halfedge() = hl;\n"
                  "    validate();\n"
                  "    std::cout << \"erased\\n\";\n");
  const ExerciseReport report = grade_scotty3d(submission, {"edge_dissolve"}).exercises.at(0);
  EXPECT_EQ(report.points, report.max_points);
  EXPECT_EQ(report.notes.size(), 2U);
}

TEST(Scotty3dHomework, WhoseHeaderIsMissingIsNotJudgedWhereItIsNeeded) {
  Submission submission = scotty3d_hand_in("of_2024");
  submission.course_headers.clear();
  const Report report = grade_scotty3d(submission, {"vertex_inset", "edge_collapse"});
  // The data member is declared nowhere, the functions by their definitions.
  EXPECT_EQ(report.exercises.at(0).verdict, Verdict::kNotJudged);
  EXPECT_TRUE(has_scotty3d_note(report, "hand in the header that adds it"));
}

}  // namespace
}  // namespace meshgrade
