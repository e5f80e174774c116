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

TEST(UnknownMembers, AreReadFromBothCompilers) {
  const char* gcc =
      "a.cpp:12:8: error: \u2018const class meshedit::Vertex\u2019 has no member named "
      "\u2018mark\u2019; did you mean \u2018Face\u2019?\n";
  const char* clang = "a.cpp:12:8: error: no member named 'mark' in 'meshedit::Vertex'\n";
  for (const char* messages : {gcc, clang}) {
    const auto members = unknown_members(messages);
    ASSERT_EQ(members.size(), 1U) << messages;
    EXPECT_EQ(members[0].class_name, "Vertex");
    EXPECT_EQ(members[0].name, "mark");
    EXPECT_EQ(members[0].place, "a.cpp:12");
  }
}

TEST(UnknownMembers, DefinitionsCountAsUses) {
  const char* gcc =
      "a.cpp:7:6: error: no declaration matches \u2018bool "
      "meshedit::HalfedgeMesh::ok(meshedit::EdgeIter)\u2019\n";
  const char* clang =
      "a.cpp:7:6: error: out-of-line definition of 'ok' does not match any declaration in "
      "'meshedit::HalfedgeMesh'\n";
  for (const char* messages : {gcc, clang}) {
    const auto members = unknown_members(messages);
    ASSERT_EQ(members.size(), 1U) << messages;
    EXPECT_EQ(members[0].class_name, "HalfedgeMesh");
    EXPECT_EQ(members[0].name, "ok");
  }
}

TEST(UnknownMembers, OtherComplaintsAreNone) {
  EXPECT_TRUE(unknown_members("a.cpp:1:1: error: expected ';'\n"
                              "a.cpp:2:1: error: 'class Mine' has no member named 'x'\n"
                              "a.cpp:3:1: warning: no member named 'x' in 'Vertex'\n")
                  .empty());
}

TEST(UnknownMembers, AreLookedUpInTheHeaders) {
  const SourceFile header{"halfEdgeMesh.h", "class Vertex {\n  // mark\n  int mark;\n};\n"};
  EXPECT_EQ(place_of_member({header}, "mark"), "halfEdgeMesh.h, line 3");
  EXPECT_EQ(place_of_member({header}, "mar"), "");
}

TEST(LeavingOut, WhatIsAsHandedOutIsNotImplemented) {
  const std::set<std::string> asked{"A::f", "A::g"};
  const auto is_marked = [&](const std::string& text) {
    LeavingOut rest("a.cpp", text);
    rest.mark_unwritten(asked);
    return rest.text().find("notImplemented(\"A::") != std::string::npos;
  };
  for (const char* body :
       {"", "/* { */ // TODO\n", "return;", "return Vector3D();", "return EdgeIter();",
        "return std::vector<Vector2D>();", "return Vector3D( 0, 0, 0 );", "return {};",
        "return e0;", "VertexIter v;\n  return v;", "showError(\"f() is to do.\");",
        "std::cout << \"to do\" << std::endl;\n  return VertexIter();"}) {
    EXPECT_TRUE(is_marked("int A::f( EdgeIter e0 ) const\n{\n" + std::string(body) + "\n}\n"))
        << body;
    EXPECT_FALSE(is_marked("int A::h( EdgeIter e0 )\n{\n" + std::string(body) + "\n}\n"))
        << body;
  }
  for (const char* body :
       {"return helper();", "return newVertex();", "return position;", "flip(e0); return e0;",
        "if (x) return Vector3D();", "Vector3D n = f(); return n;", "return centroid;"}) {
    EXPECT_FALSE(is_marked("int CGL::A::g(EdgeIter e0) {\n" + std::string(body) + "\n}\n"))
        << body;
  }
}

}  // namespace
}  // namespace meshgrade
