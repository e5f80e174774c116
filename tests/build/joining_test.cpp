// Sources are compiled as one only where none of them can see anything of another: then each
// means what it means alone. These tests name what one source could see of another.

#include "grader/build/joining.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kHead = "#include \"meshedit/meshedit.h\"\n";

std::string in_namespace(const std::string& code) {
  return kHead + "namespace meshedit {\n" + code + "\n}  // namespace meshedit\n";
}

std::vector<std::size_t> join(const std::vector<std::string>& texts,
                              const std::vector<SourceFile>& headers = {}) {
  std::vector<SourceFile> sources;
  for (const std::string& text : texts)
    sources.push_back({"file" + std::to_string(sources.size()) + ".cpp", text});
  return joinable(sources, headers);
}

/// A source that mentions weight and normalize, and cannot be seen by another.
const std::string kMember = in_namespace(
    "// # of neighbours\n"
    "Vector3D Vertex::normal() const { return normalize(Vector3D(weight(3), 0, 0)); }");

TEST(Joining, TakesSourcesWithMembersOnly) {
  const std::string other = in_namespace(
      "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) {"
      " auto go = [&](int n) { return n; }; return e; }");
  EXPECT_THAT(join({kMember, other}), ElementsAre(0, 1));
}

TEST(Joining, TakesSourcesWithHelpersThatOthersDoNotMention) {
  const std::string helper = in_namespace(
      "namespace {\nconstexpr double kHalf = 0.5;\nstruct Corner { int at; };\n"
      "enum class Side { kLeft };\nVector3D middle(const Vector3D& a, const Vector3D& b) {"
      " return kHalf * (a + b); }\nstd::vector<std::size_t> order(std::size_t size);\n}");
  EXPECT_THAT(join({kMember, helper}), ElementsAre(0, 1));
}

TEST(Joining, TakesSourcesWithTheSameDirectivesAndHeaders) {
  const std::string first = "#include <numeric>\nusing namespace std;\n" + kMember;
  EXPECT_THAT(join({first, "#include <numeric>\nusing namespace std;\n" +
                               in_namespace("void MeshResampler::upsample(HalfedgeMesh&) {}")}),
              ElementsAre(0, 1));
}

TEST(Joining, ChoosesTheLargestSetOfThoseThatFit) {
  const std::string plain = in_namespace("int HalfedgeMesh::a() { return 1; }");
  const std::string with = "using namespace std;\n" + plain;
  EXPECT_THAT(join({with, plain, with, plain, plain}), ElementsAre(1, 3, 4));
}

TEST(Joining, NeedsTwo) {
  EXPECT_THAT(join({kMember}), IsEmpty());
  EXPECT_THAT(join({}), IsEmpty());
}

/// A source that must not be joined with kMember, and why.
struct Visible {
  std::string what;
  std::string text;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Visible& visible, std::ostream* out) {
  *out << visible.what;
}

class WhatOthersSee : public testing::TestWithParam<Visible> {};

TEST_P(WhatOthersSee, KeepsASourceAlone) {
  EXPECT_THAT(join({kMember, GetParam().text}), IsEmpty());
  EXPECT_THAT(join({GetParam().text, kMember}), IsEmpty());
}

std::vector<Visible> visible_things() {
  return {
      {"an overload of a function", in_namespace("double weight(int n) { return n; }")},
      {"a function that is only declared", in_namespace("double weight(int n);")},
      {"a static function", in_namespace("static double weight(int n) { return n; }")},
      {"a template", in_namespace("template <class T> T weight(T n) { return n; }")},
      {"a variable", in_namespace("const double a = 1, weight = 2;")},
      {"a lambda", in_namespace("const auto weight = [](int n) { return n; };")},
      {"an array", in_namespace("static double weight[3] = {1, 2, 3};")},
      {"names of parts", in_namespace("static auto [weight, other] = std::pair(1, 2);")},
      {"names of parts by reference",
       in_namespace("int a[2]; static auto& [weight, other] = a;")},
      {"an attribute", in_namespace("[[nodiscard]] double weight(int n) { return n; }")},
      {"a braced value", in_namespace("static int weight{3};")},
      {"a pointer to a function", in_namespace("double (*weight)(int);")},
      {"a variable in parentheses", in_namespace("static Vertex (weight);")},
      {"a function in parentheses", in_namespace("double (weight)(int);")},
      {"a reference to an array", in_namespace("extern int a[2]; int (&weight)[2] = a;")},
      {"a type", in_namespace("struct weight { weight(int); operator double(); };")},
      {"another name of a type", in_namespace("using weight = double;")},
      {"another old name of a type", in_namespace("typedef double weight;")},
      {"an enumerator", in_namespace("enum Kind { small, weight };")},
      {"an enumerator of a named type", in_namespace("typedef enum { weight } Kind;")},
      {"a variable behind its type", in_namespace("struct { int n; } weight;")},
      {"a namespace", in_namespace("namespace weight { int n; }")},
      {"a name in the global namespace", kHead + "double weight(int n) { return n; }"},
      {"a macro", "#define weight(n) 3\n" + in_namespace("")},
      {"a macro behind a comment", "/* */ #define weight(n) 3\n" + in_namespace("")},
      {"a macro in two lines", "#\\\ndefine weight(n) 3\n" + in_namespace("")},
      {"a macro that is taken away", "#undef assert\n" + in_namespace("")},
      {"a condition", "#if 1\n#endif\n" + in_namespace("")},
      {"a pragma", "#pragma GCC optimize(\"O3\")\n" + in_namespace("")},
      {"another spelling of #", "%:define weight(n) 3\n" + in_namespace("")},
      {"another spelling of a brace", in_namespace("double weight(int n) <% return n; %>")},
      {"an operator", in_namespace("Vector3D operator*(Vector3D a, int) { return a; }")},
      {"a friend", in_namespace("struct A { friend double weight(A) { return 1; } };")},
      {"a specialization", in_namespace("template <> struct Foo<int> {};")},
      {"something in std", kHead + "namespace std { void f(); }"},
      {"a function that algorithms find", in_namespace("void swap(Vertex& a, Vertex& b) {}")},
      {"a C function", kHead + "extern \"C\" int weight(int n);"},
      {"a directive", "using namespace std;\n" + in_namespace("")},
      {"a directive in the namespace", in_namespace("using namespace std;")},
      {"a using declaration", in_namespace("using std::abs;")},
      {"another header", "#include <math.h>\n" + in_namespace("")},
      {"a header that is handed in", "#include \"mine.h\"\n" + in_namespace("")},
      {"a header of the grader's own",
       "#include \"meshedit/detail/mesh_builder.h\"\n" + in_namespace("")},
      {"a header in another folder",
       "#include \"meshedit/../dropin/course.h\"\n" + in_namespace("")},
      {"its own name", in_namespace("int HalfedgeMesh::a() { return sizeof __FILE__; }")},
      {"a brace too many", in_namespace("} namespace a {") + "}"},
      {"a brace too few", kHead + "namespace meshedit { int HalfedgeMesh::a() { return 1; }"},
  };
}

INSTANTIATE_TEST_SUITE_P(All, WhatOthersSee, testing::ValuesIn(visible_things()));

TEST(Joining, LeavesOutWhatIncludesAHandedInHeaderInAngleBrackets) {
  const std::string source = "#include <mine.h>\n" + kMember;
  const std::string other = "#include <mine.h>\n" + in_namespace("int Edge::a() { return 1; }");
  EXPECT_THAT(join({source, other}, {{"mine.h", ""}}), IsEmpty());
}

TEST(Joining, SharesOutInOrder) {
  EXPECT_THAT(share_out({0, 1, 2, 5, 7}, 2),
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(5, 7)));
  EXPECT_THAT(share_out({1, 2}, 8), ElementsAre(ElementsAre(1), ElementsAre(2)));
  EXPECT_THAT(share_out({}, 8), IsEmpty());
}

}  // namespace
}  // namespace meshgrade
