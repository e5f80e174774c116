#include "grader/submission/header_definitions.h"

#include <gtest/gtest.h>

#include <string>

namespace meshgrade {
namespace {

const char* const kPatch =
    "#pragma once\n"
    "namespace CGL {\n"
    "class BezierPatch {\n"
    " public:\n"
    "  std::vector<Vector3D> evaluateStep(std::vector<Vector3D> const &p, double t) const {\n"
    "    return p;  // { not yet\n"
    "  }\n"
    "  Vector3D evaluate1D(std::vector<Vector3D> const &p, double t) const;\n"
    "  Vector3D evaluate(double u, double v) const;\n"
    "  Vector3D evaluate(double u, double v, int level) const { return Vector3D(); }\n"
    "};\n"
    "inline Vector3D CGL::BezierPatch::evaluate(double u, double v) const {\n"
    "  return Vector3D(u, v, 0);\n"
    "}\n"
    "}\n";

std::vector<SourceFile> from(const std::string& name, const std::string& text,
                             const std::vector<SourceFile>& own = {}) {
  return sources_from_headers({{name, text}}, own);
}

/// A line of a text, from 1.
std::string line(const std::string& text, int number) {
  std::size_t begin = 0;
  for (; number > 1; --number)
    begin = text.find('\n', begin) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(HeaderDefinitions, StandOnTheLinesOfTheHeaderWithTheirClass) {
  const auto sources = from("bezierPatch.h", kPatch);
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].name, "bezierPatch.h.cpp");
  const std::string& text = sources[0].text;
  EXPECT_EQ(line(text, 1), "#include \"student_code.h\"");
  EXPECT_EQ(line(text, 5),
            "namespace CGL { using namespace std; std::vector<Vector3D> "
            "BezierPatch::evaluateStep(std::vector<Vector3D> const &p, double t) const {");
  EXPECT_EQ(line(text, 6), "    return p;  // { not yet");
  EXPECT_EQ(line(text, 13), "  return Vector3D(u, v, 0);");
}

TEST(HeaderDefinitions, OfMembersThatWereAddedStayWhereTheyAre) {
  const std::string text = from("bezierPatch.h", kPatch)[0].text;
  EXPECT_EQ(text.find("int level"), std::string::npos);
  EXPECT_EQ(text.find("evaluate1D"), std::string::npos);
}

TEST(HeaderDefinitions, OfTheStudentsOwnFilesComeFirst) {
  const SourceFile own{"student_code.cpp",
                       "namespace CGL {\nVector3D BezierPatch::evaluate(double u, double v) "
                       "const { return {}; }\n}\n"};
  const std::string text = from("bezierPatch.h", kPatch, {own})[0].text;
  EXPECT_EQ(text.find("Vector3D(u, v, 0)"), std::string::npos);
  EXPECT_NE(text.find("evaluateStep"), std::string::npos);
}

TEST(HeaderDefinitions, AreWithoutWhatOnlyAClassOrAHeaderAllows) {
  const std::string text = from("halfEdgeMesh.h",
                                "class Vertex : public HalfedgeElement {\n"
                                "  virtual inline Vector3D normal(void) const { return n; }\n"
                                "};\n")[0]
                               .text;
  EXPECT_EQ(text.find("virtual"), std::string::npos);
  EXPECT_EQ(text.find("inline"), std::string::npos);
  EXPECT_NE(text.find("Vector3D Vertex::normal(void) const { return n; }"), std::string::npos);
}

TEST(HeaderDefinitions, ThereAreNoneInAHeaderThatOnlyDeclares) {
  EXPECT_TRUE(from("halfEdgeMesh.h", "class Vertex { Vector3D normal() const; };").empty());
  EXPECT_TRUE(from("halfEdgeMesh.h", "class Vertex { Vector3D normal() const {").empty());
  EXPECT_TRUE(from("halfEdgeMesh.h", "").empty());
}

}  // namespace
}  // namespace meshgrade
