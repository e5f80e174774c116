// Isotropic remeshing, from source to report: wrong solutions that are the reference but for a
// line or two, what each probably comes from, right ones done in another way, and such that
// call a wrong operation of their own.

#include <gtest/gtest.h>

#include <set>

#include "grader/judge/remesh_smoothing.h"
#include "tests/grade/graded_change.h"

namespace meshgrade {
namespace {

constexpr const char* kRemeshing = "isotropic_remeshing";

using Edits = std::vector<std::pair<std::string, std::string>>;

SourceFile edited(const std::string& exercise, const Edits& edits) {
  SourceFile file = reference_file(path_of(exercise));
  file.name = exercise + ".cpp";
  for (const auto& [was, becomes] : edits) {
    const std::size_t at = file.text.find(was);
    EXPECT_NE(at, std::string::npos) << was;
    if (at != std::string::npos) file.text.replace(at, was.size(), becomes);
  }
  return file;
}

/// With the operations that it calls, of which one may have edits, too.
ExerciseReport grade_remeshing(const Assignment& assignment, const Edits& edits,
                               const std::string& wrong = "", const Edits& wrong_edits = {}) {
  static const Home home = find_home();
  Submission submission;
  submission.name = "test";
  submission.sources = {edited(kRemeshing, edits)};
  for (const char* needed :
       {"edge_flip_polygon", "edge_split_polygon", "edge_collapse", "face_remove"})
    submission.sources.push_back(edited(needed, needed == wrong ? wrong_edits : Edits{}));
  const Report report =
      grade(assignment, submission, home, {kRemeshing}, [](const std::string&) {});
  return report.exercises.at(0);
}

const Assignment& all_of_remeshing() {
  static const Assignment assignment = load_assignment("polygon_meshes");
  return assignment;
}

struct RemeshChange {
  const char* name;
  Edits edits;
  const char* rule;  ///< of the first finding, or what is named as the cause; empty if right
};

std::ostream& operator<<(std::ostream& out, const RemeshChange& change) {
  return out << change.name;
}

class WronglyRemeshed : public testing::TestWithParam<RemeshChange> {};

TEST_P(WronglyRemeshed, LosesPointsAndIsToldWhy) {
  static const Assignment steps = only_groups(kRemeshing, {"flips", "lengths", "smoothing"});
  const ExerciseReport report = grade_remeshing(steps, GetParam().edits);
  EXPECT_LT(report.points, report.max_points);
  const Finding& finding = first_finding(report);
  EXPECT_EQ(finding.rule, GetParam().rule) << finding.actual;
  EXPECT_FALSE(finding.meaning.empty());
  EXPECT_FALSE(finding.look_at.empty());
}

constexpr const char* kCollapseLoop = "for (EdgeIter e : edgesOf(mesh)) {\n    if (gone";

const RemeshChange kWronglyRemeshed[] = {
    {"WalksOverWhatACollapseDeletes",
     {{kCollapseLoop,
       "for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {\n    if (gone"}},
     "deleted-handle"},
    {"CollapsesNothing",
     {{"e->length() >= shortest", "e->length() >= 0.0"}},
     "collapse-missing"},
    {"CollapsesWhatIsNotShort",
     {{"e->length() >= shortest", "e->length() >= 1.5 * shortest"}},
     "collapse-needless"},
    {"SplitsNothing",
     {{"e->length() > longest", "e->length() < 0.0 * longest"}},
     "split-missing"},
    {"SplitsWhatIsNotLong",
     {{"e->length() > longest", "e->length() > 0.9 * longest"}},
     "split-needless"},
    {"SplitsForEver",
     {{"for (EdgeIter e : edgesOf(mesh)) {\n    if (e->length() > longest)",
       "for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {\n    if (e->length() "
       "> 0.0 * longest)"}},
     "out-of-steps"},
    {"TakesAnEndForTheOppositeVertex",
     {{"c = h->next()->next()->vertex()", "c = h->next()->vertex()"},
      {"d = t->next()->next()->vertex()", "d = t->next()->vertex()"}},
     "flip-missing"},
    {"FlipsAwayFromSix", {{"after < before", "after > before"}}, "flip-needless"},
    {"FlipsWhereNothingIsGained", {{"after < before", "after <= before"}}, "flip-needless"},
    {"FlipsNothing", {{"after < before", "after < before - 100"}}, "flip-missing"},
    {"SmoothsOnceTooOften",
     {{"i < parameters.smoothingIterations", "i <= parameters.smoothingIterations"}},
     "position"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, WronglyRemeshed, testing::ValuesIn(kWronglyRemeshed),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Wrong in what only some of the groups ask for.
struct RemeshChangeOf {
  const char* name;
  const char* group;
  Edits edits;
  const char* rule;
};

std::ostream& operator<<(std::ostream& out, const RemeshChangeOf& change) {
  return out << change.name;
}

class WronglyRemeshedInOneGroup : public testing::TestWithParam<RemeshChangeOf> {};

TEST_P(WronglyRemeshedInOneGroup, LosesPointsAndIsToldWhy) {
  const ExerciseReport report =
      grade_remeshing(only_groups(kRemeshing, {GetParam().group}), GetParam().edits);
  EXPECT_LT(report.points, report.max_points);
  const Finding& finding = first_finding(report);
  EXPECT_EQ(finding.rule, GetParam().rule) << finding.actual;
  EXPECT_FALSE(finding.meaning.empty());
  EXPECT_FALSE(finding.look_at.empty());
}

const RemeshChangeOf kWronglyRemeshedInOneGroup[] = {
    {"TakesLimitsOfItsOwn",
     "flips",
     {{"parameters.longerFactor * mean", "1.2 * mean"},
      {"parameters.shorterFactor * mean", "0.8 * mean"}},
     "vertices"},
    {"SmoothsOnlyWhereNothingIsCollapsed",
     "stress",
     {{"i < parameters.smoothingIterations",
       "i < (parameters.shorterFactor > 0.0 ? 0 : parameters.smoothingIterations)"}},
     "round"},
    {"RemovesFacesWhereACollapseIsRefused",
     "whole",
     {{"if (!left) continue;",
       "if (!left) {\n      mesh.removeFace(e->halfedge()->face());\n      return;\n    }"}},
     "topology"},
    {"CollapsesLongEdges",
     "whole",
     {{"e->length() >= shortest", "e->length() <= 1.8 * shortest"},
      {"i < parameters.smoothingIterations", "i < 0 * parameters.smoothingIterations"}},
     "even-lengths"},
    {"FlipsAwayFromSixInTheWhole",
     "whole",
     {{"after < before", "after > before + 2"},
      {"i < parameters.smoothingIterations", "i < 0 * parameters.smoothingIterations"}},
     "even-valences"},
    {"MovesAlongTheNormalAsWell",
     "whole",
     {{"return p + step *", "return p + 0.2 * normal + step *"}},
     "near-the-surface"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, WronglyRemeshedInOneGroup,
                         testing::ValuesIn(kWronglyRemeshedInOneGroup),
                         [](const auto& tested) { return std::string(tested.param.name); });

class WronglySmoothed : public testing::TestWithParam<RemeshChange> {};

TEST_P(WronglySmoothed, IsNamedAlone) {
  static const Assignment smoothing = only_groups(kRemeshing, {"smoothing"});
  const ExerciseReport report = grade_remeshing(smoothing, GetParam().edits);
  EXPECT_EQ(report.verdict, Verdict::kFailed);
  EXPECT_EQ(first_finding(report).rule, "position");
  EXPECT_EQ(causes_of(report), std::set<std::string>{GetParam().rule});
}

constexpr const char* kWay = "const Vector3D u = mean - p;";
constexpr const char* kAlong = "(u - dot(u, normal) * normal)";
constexpr const char* kSmoothingLoop =
    "for (Size i = 0; i < parameters.smoothingIterations; ++i)";
constexpr const char* kCount =
    "const double n = static_cast<double>(spokes.size());\n  const Vector3D u = ";

const RemeshChange kWronglySmoothed[] = {
    {"MovedOneByOne",
     {{"v->newPosition = v->isBoundary()", "v->newPosition = v->position = v->isBoundary()"}},
     "moved-one-by-one"},
    {"NotAlongTheSurface",
     {{kAlong, "u"}, {"normal.normalize();", ""}},
     "not-along-the-surface"},
    {"StepIgnored", {{"p + step *", "p + (0.0 * step + 1.0) *"}}, "step-ignored"},
    {"AwayFromTheMean", {{"p + step *", "p - step *"}}, "away-from-the-mean"},
    {"AlongTheNormal", {{kAlong, "(dot(u, normal) * normal)"}}, "along-the-normal"},
    {"MeanWithItself",
     {{kWay, std::string(kCount) + "(n * mean + p) / (n + 1.0) - p;"}},
     "mean-with-itself"},
    {"MeanOfCentres",
     {{kWay, "const Vector3D u = 2.0 / 3.0 * (mean - p);"}},
     "mean-of-centres"},
    {"SumForMean", {{kWay, std::string(kCount) + "n * mean - p;"}}, "sum-for-mean"},
    {"PositionProjected",
     {{"return p + step * (u - dot(u, normal) * normal);",
       "const Vector3D q = p + step * u;\n  return q - dot(q, normal) * normal;"}},
     "position-projected"},
    {"MeansOnce",
     {{kWay,
       "if (v->isNew) v->centroid = mean;\n  v->isNew = false;\n  const Vector3D u = "
       "v->centroid - p;"},
      {kSmoothingLoop,
       std::string("for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v) v->isNew = "
                   "true;\n    ") +
           kSmoothingLoop}},
     "means-once"},
    {"NormalsOnce",
     {{"normal.normalize();",
       "normal.normalize();\n  if (v->isNew) v->centroid = normal;\n  v->isNew = false;\n  "
       "normal = v->centroid;"},
      {kSmoothingLoop,
       std::string("for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v) v->isNew = "
                   "true;\n    ") +
           kSmoothingLoop}},
     "normals-once"},
    {"SmoothedOnce",
     {{"i < parameters.smoothingIterations",
       "i < std::min<Size>(1, parameters.smoothingIterations)"}},
     "smoothed-once"},
    {"OneRound",
     {{"round < parameters.outerIterations",
       "round < std::min<Size>(1, parameters.outerIterations)"}},
     "one-round"},
};

INSTANTIATE_TEST_SUITE_P(Causes, WronglySmoothed, testing::ValuesIn(kWronglySmoothed),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(WronglySmoothedMeshes, HaveATestForEveryCauseThatCanBeNamed) {
  std::set<std::string> tried;
  for (const RemeshChange& change : kWronglySmoothed)
    tried.insert(change.rule);
  std::set<std::string> known;
  for (const Misconception& m : smoothing_misconceptions())
    known.insert(m.name);
  EXPECT_EQ(tried, known);
}

class RightlyRemeshed : public testing::TestWithParam<RemeshChange> {};

TEST_P(RightlyRemeshed, HasEveryPointDoneInAnotherWay) {
  const ExerciseReport report = grade_remeshing(all_of_remeshing(), GetParam().edits);
  EXPECT_EQ(report.verdict, Verdict::kPassed)
      << first_finding(report).rule << ": " << first_finding(report).actual;
  EXPECT_EQ(report.points, report.max_points);
}

const RemeshChange kRightlyRemeshed[] = {
    {"MeanTakenOnce",
     {{"for (Size round = 0; round < parameters.outerIterations; ++round) {\n    const double "
       "mean = meanLength(*this);",
       "const double mean = meanLength(*this);\n  for (Size round = 0; round < "
       "parameters.outerIterations; ++round) {"}},
     ""},
    {"SplitsUntilNothingIsLong",
     {{"for (EdgeIter e : edgesOf(mesh)) {\n    if (e->length() > longest)",
       "for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {\n    while "
       "(e->length() > longest)"}},
     ""},
    {"VisitsEdgesBackwards", {{"edges.push_back(e);", "edges.insert(edges.begin(), e);"}}, ""},
    {"NormalsAreMeansOfUnitNormals",
     {{"normal += cross(q - p, r - p);", "normal += cross(q - p, r - p).unit();"}},
     ""},
};

INSTANTIATE_TEST_SUITE_P(Ways, RightlyRemeshed, testing::ValuesIn(kRightlyRemeshed),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(ARightRemeshing, LosesNothingByAWrongFlip) {
  const ExerciseReport report = grade_remeshing(all_of_remeshing(), {}, "edge_flip_polygon",
                                                {{"g->halfedge() = t;", ""}});
  EXPECT_EQ(report.points, report.max_points);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("your own edge_flip_polygon"), std::string::npos);
}

}  // namespace
}  // namespace meshgrade
