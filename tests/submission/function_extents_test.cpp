#include "grader/submission/function_extents.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

std::vector<std::string> names(const std::string& text) {
  std::vector<std::string> all;
  for (const FunctionExtent& function : find_functions(text))
    all.push_back(function.name);
  return all;
}

std::string text_of(const std::string& text, const FunctionExtent& function) {
  return text.substr(function.begin, function.end - function.begin);
}

using Names = std::vector<std::string>;

TEST(CodeOnly, KeepsTheSizeAndTheLines) {
  const std::string text =
      "a /* b\n c */ d // e\n#define F \\\n  g\nh \"i\\\"j\" 'k' R\"x(l)\")x\" m";
  const std::string code = code_only(text);
  EXPECT_EQ(code.size(), text.size());
  std::string letters;
  for (char c : code) {
    if (c != ' ') letters += c;
  }
  EXPECT_EQ(letters, "a\nd\n\n\nhRm");
}

TEST(CodeOnly, KnowsDigitSeparators) {
  EXPECT_EQ(code_only("1'000 + f('}')"), "1'000 + f(   )");
}

TEST(CodeOnly, EndsAnOpenQuoteAtTheEndOfTheLine) {
  EXPECT_EQ(code_only("\"open\n}"), "     \n}");
}

TEST(FunctionExtents, FindsFunctionsInNamespaces) {
  const std::string text =
      "namespace CGL {\n"
      "static int lerp(int a) { return a; }\n"
      "template <class T>\n"
      "T A::f( void ) const\n"
      "{ if (x) { y(); } }\n"
      "}\n"
      "void last() {}\n";
  EXPECT_EQ(names(text), (Names{"lerp", "A::f", "last"}));
  EXPECT_EQ(text_of(text, find_functions(text)[1]),
            "template <class T>\nT A::f( void ) const\n{ if (x) { y(); } }");
}

TEST(FunctionExtents, PassesOverClassesAndVariables) {
  EXPECT_EQ(names("struct S { int f() { return 1; } };\n"
                  "int a[] = {1, 2};\n"
                  "auto g = [](int x) { return x; };\n"
                  "enum class E { kA };\n"
                  "void h() { struct T { void m() {} }; }\n"),
            (Names{"h"}));
}

TEST(FunctionExtents, IgnoresBracesInCommentsStringsAndMacros) {
  EXPECT_EQ(names("#define OPEN {\n"
                  "void f() { /* } */ g(\"}\", '}'); // }\n"
                  "  h(R\"(})\"); }\n"
                  "void k() {}\n"),
            (Names{"f", "k"}));
}

TEST(FunctionExtents, AMissingBraceEndsWhereTheNextMemberBegins) {
  const std::string text =
      "namespace n {\n"
      "int A::f() { if (x) { return 1; }\n"
      "\n"
      "int A::g() { return 2; }\n"
      "}\n";
  const std::vector<FunctionExtent> functions =
      find_functions("namespace n {\n" + text + "}\n");
  ASSERT_EQ(functions.size(), 2U);
  EXPECT_FALSE(functions[0].balanced);
  EXPECT_TRUE(functions[1].balanced);
  EXPECT_EQ(functions[1].name, "A::g");
}

TEST(FunctionExtents, CallsAndConditionsDoNotLookLikeMembers) {
  const std::string text =
      "int A::f() {\n"
      "  if (B::c(1)) { d(); } else if (B::c(2)) { d(); }\n"
      "  std::sort(a, b, [](int x, int y) { return x < y; });\n"
      "  for (std::vector<int>::iterator i = v.begin(); i != v.end(); ++i) { d(); }\n"
      "  std::vector<int> w{B::c(3)};\n"
      "}\n";
  const std::vector<FunctionExtent> functions = find_functions(text);
  ASSERT_EQ(functions.size(), 1U);
  EXPECT_TRUE(functions[0].balanced);
}

TEST(FunctionExtents, ABraceTooManyIsCountedToItsFunction) {
  const std::string text =
      "namespace n {\n"
      "int A::f() { } return 1; }\n"
      "int A::g() { return 2; }\n"
      "}\n";
  const std::vector<FunctionExtent> functions = find_functions(text);
  ASSERT_EQ(functions.size(), 2U);
  EXPECT_FALSE(functions[0].balanced);
  EXPECT_EQ(text_of(text, functions[0]), "int A::f() { } return 1; }");
  EXPECT_TRUE(functions[1].balanced);
}

TEST(FunctionExtents, TheLastFunctionGivesTheNamespaceItsBraceBack) {
  const std::string text = "namespace n {\nvoid f() { if (x) {\n}\n}\n";
  const std::vector<FunctionExtent> functions = find_functions(text);
  ASSERT_EQ(functions.size(), 1U);
  EXPECT_FALSE(functions[0].balanced);
  EXPECT_EQ(text.substr(functions[0].end), "}\n");
}

TEST(FunctionExtents, AnyTextIsRead) {
  for (const char* text : {"", "}", "}}}", "{{{", "(", "void f() {", "namespace {", "\"", "/*",
                           "R\"(", "'", "#", "\\", "a::b() {", "int A::f() { int A::g() {"}) {
    for (const FunctionExtent& function : find_functions(text)) {
      EXPECT_LE(function.begin, function.body) << text;
      EXPECT_LE(function.body, function.end) << text;
      EXPECT_LE(function.end, std::string(text).size()) << text;
    }
  }
}

}  // namespace
}  // namespace meshgrade
