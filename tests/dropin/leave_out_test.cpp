#include "grader/build/leave_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "grader/build/added_members.h"

namespace meshgrade {
namespace {

const std::string kText =
    "int first() { return 1; }\n"
    "int second() {\n"
    "  return x;\n"
    "}\n"
    "int third() { return second(); }\n";
const std::string kMessages =
    "a.cpp: In function 'int second()':\n"
    "a.cpp:3:10: error: 'x' was not declared in this scope\n"
    "b.h:1:1: error: not in this file\n";

std::ptrdiff_t lines(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

TEST(LeavingOut, TheBodyGoesFirst) {
  LeavingOut rest("a.cpp", kText);
  ASSERT_TRUE(rest.learn_from(kMessages));
  EXPECT_NE(rest.text().find("int second() { ::meshedit::notImplemented(\"second\"); }"),
            std::string::npos);
  ASSERT_EQ(rest.left_out().size(), 1U);
  EXPECT_EQ(rest.left_out()[0].function, "second");
  EXPECT_EQ(rest.left_out()[0].line, 3);
  EXPECT_EQ(rest.left_out()[0].message, "'x' was not declared in this scope");
}

TEST(LeavingOut, TheWholeFunctionGoesIfThatIsNotEnough) {
  LeavingOut rest("a.cpp", kText);
  rest.learn_from(kMessages);
  ASSERT_TRUE(rest.learn_from("a.cpp:2:5: error: still wrong\n"));
  EXPECT_EQ(rest.text().find("int second"), std::string::npos);
  EXPECT_EQ(rest.left_out().size(), 1U);
}

TEST(LeavingOut, LinesKeepTheirNumbers) {
  LeavingOut rest("a.cpp", kText);
  rest.learn_from(kMessages);
  EXPECT_EQ(lines(rest.text()), lines(kText));
  rest.learn_from("a.cpp:2:5: error: still wrong\n");
  EXPECT_EQ(lines(rest.text()), lines(kText));
  EXPECT_EQ(lines(rest.text().substr(0, rest.text().find("int third"))), 4);
}

TEST(LeavingOut, TheLinkerIsUnderstood) {
  LeavingOut rest("a.cpp", kText);
  ASSERT_TRUE(rest.learn_from("ld: ././a.cpp:3: undefined reference to `x()'\n"));
  EXPECT_EQ(rest.left_out()[0].function, "second");
  EXPECT_EQ(rest.left_out()[0].message, "undefined reference to `x()'");
  EXPECT_FALSE(rest.learn_from("other_a.cpp:3: undefined reference to `x()'\n"));
}

TEST(LeavingOut, NothingIsToBlameOutsideOfFunctions) {
  LeavingOut rest("a.cpp", "int a = b;\n\nint f() { return 1; }\n");
  EXPECT_FALSE(rest.learn_from("a.cpp:1:9: error: 'b' was not declared\n"));
}

TEST(LeavingOut, FunctionsWithUnmatchedBracesGoBeforeTheOthers) {
  LeavingOut rest("a.cpp", "int A::f() {\n  if (x) {\n}\nint A::g() {\n  return 1;\n}\n");
  ASSERT_TRUE(rest.learn_from("a.cpp:4:8: error: qualified-id in declaration\n"));
  ASSERT_EQ(rest.left_out().size(), 1U);
  EXPECT_EQ(rest.left_out()[0].function, "A::f");
}

TEST(LeavingOut, MembersOfAClassGoTogether) {
  LeavingOut rest("a.cpp", "int A::f() { return 1; }\nint B::f() { return 1; }\n");
  rest.remove_members("A");
  EXPECT_EQ(rest.text(), "\nint B::f() { return 1; }\n");
}

TEST(AddedMembers, AreReadFromBothCompilers) {
  const SourceFile header{"halfEdgeMesh.h", "class Vertex {\n  // mark\n  int mark;\n};\n"};
  const char* gcc =
      "a.cpp:12:8: error: \u2018const class meshedit::Vertex\u2019 has no member named "
      "\u2018mark\u2019; did you mean \u2018Face\u2019?\n";
  const char* clang = "a.cpp:12:8: error: no member named 'mark' in 'meshedit::Vertex'\n";
  for (const char* messages : {gcc, clang}) {
    const auto sentences = explain_added_members(messages, {header});
    ASSERT_EQ(sentences.size(), 1U) << messages;
    EXPECT_EQ(sentences[0].find("a.cpp:12 uses Vertex::mark, a member that was added to the "
                                "course's header (halfEdgeMesh.h, line 3)"),
              0U)
        << sentences[0];
  }
}

TEST(AddedMembers, DefinitionsCountAsUses) {
  const char* gcc =
      "a.cpp:7:6: error: no declaration matches \u2018bool "
      "meshedit::HalfedgeMesh::ok(meshedit::EdgeIter)\u2019\n";
  const char* clang =
      "a.cpp:7:6: error: out-of-line definition of 'ok' does not match any declaration in "
      "'meshedit::HalfedgeMesh'\n";
  for (const char* messages : {gcc, clang}) {
    const auto sentences = explain_added_members(messages, {});
    ASSERT_EQ(sentences.size(), 1U) << messages;
    EXPECT_EQ(sentences[0].find("a.cpp:7 uses HalfedgeMesh::ok, which is no member"), 0U)
        << sentences[0];
  }
}

TEST(AddedMembers, OtherComplaintsAreNotExplained) {
  EXPECT_TRUE(explain_added_members("a.cpp:1:1: error: expected ';'\n"
                                    "a.cpp:2:1: error: 'class Mine' has no member named 'x'\n"
                                    "a.cpp:3:1: warning: no member named 'x' in 'Vertex'\n",
                                    {})
                  .empty());
}

}  // namespace
}  // namespace meshgrade
