#include "grader/submission/dialect.h"

#include <gtest/gtest.h>

#include <string>

namespace meshgrade {
namespace {

Dialect recognise_text(const std::string& text) {
  Submission submission;
  submission.sources = {{"student_code.cpp", text}};
  settle_dialect(submission);
  return submission.dialect;
}

TEST(Dialect, OurOwnIsMeshedit) {
  EXPECT_EQ(recognise_text("#include \"meshedit/meshedit.h\"\nnamespace meshedit {}\n"),
            Dialect::kMeshedit);
}

TEST(Dialect, TheCourseIsKnownByItsNamespaceOrItsHeader) {
  EXPECT_EQ(recognise_text("namespace\n  CGL\n{\n}\n"), Dialect::kCourse2020);
  EXPECT_EQ(recognise_text("  #  include <student_code.h>\n"), Dialect::kCourse2020);
  EXPECT_EQ(recognise_text("using namespace CGL;\n"), Dialect::kCourse2020);
}

TEST(Dialect, CommentsAndSimilarNamesDoNotCount) {
  EXPECT_EQ(recognise_text("// namespace CGL\n/* namespace CGL */\n"), Dialect::kMeshedit);
  EXPECT_EQ(recognise_text("namespace CGLike { }\n"), Dialect::kMeshedit);
  EXPECT_EQ(recognise_text("const char* s = \"namespace CGL\";\n"), Dialect::kMeshedit);
}

TEST(Dialect, AStepWithoutPointsIsOf2017) {
  EXPECT_EQ(recognise_text("namespace CGL { void BezierCurve :: evaluateStep( void ) {} }"),
            Dialect::kCourse2017);
}

TEST(Dialect, PointsByValueAreOf2017) {
  const std::string head = "namespace CGL { Vector3D BezierPatch::evaluate1D(";
  EXPECT_EQ(recognise_text(head + "std::vector<Vector3D> points, double t) const {} }"),
            Dialect::kCourse2017);
  EXPECT_EQ(recognise_text(head + "std::vector<Vector3D> const &points, double t) const {} }"),
            Dialect::kCourse2020);
}

TEST(Dialect, ThePatchThatPreparesItselfIsOf2016) {
  EXPECT_EQ(recognise_text("namespace CGL { void BezierPatch::preprocess() {} }"),
            Dialect::kCourse2016);
}

TEST(Dialect, TheCourseFilesAreSortedOut) {
  Submission submission;
  submission.sources = {{"main.cpp", "int main() {}"},
                        {"student_code.cpp", "namespace CGL {}"}};
  submission.headers = {{"halfEdgeMesh.h", ""}, {"student_code.h", ""}, {"mine.h", ""}};
  settle_dialect(submission);
  ASSERT_EQ(submission.sources.size(), 1U);
  EXPECT_EQ(submission.sources[0].name, "student_code.cpp");
  EXPECT_EQ(submission.headers.size(), 2U);
  ASSERT_EQ(submission.course_headers.size(), 1U);
  EXPECT_EQ(submission.course_headers[0].name, "halfEdgeMesh.h");
  EXPECT_EQ(submission.notes.size(), 3U);
}

TEST(Dialect, OtherSubmissionsKeepTheirFiles) {
  Submission submission;
  submission.sources = {{"main.cpp", "int main() {}"}};
  settle_dialect(submission);
  EXPECT_EQ(submission.sources.size(), 1U);
  EXPECT_TRUE(submission.notes.empty());
}

}  // namespace
}  // namespace meshgrade
