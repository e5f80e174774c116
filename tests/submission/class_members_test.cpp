#include "grader/submission/class_members.h"

#include <gtest/gtest.h>

#include <string>

namespace meshgrade {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::string& text) {
  Names names;
  for (const ClassMember& member : find_members(text, "Vertex"))
    names.insert(names.end(), member.names.begin(), member.names.end());
  return names;
}

std::vector<ClassMember> members_of(const std::string& body) {
  return find_members("class Vertex : public Element\n{\n public:\n" + body + "\n};\n",
                      "Vertex");
}

std::string only_text(const std::string& body) {
  const auto members = members_of(body);
  return members.size() == 1 ? members[0].text : "there are " + std::to_string(members.size());
}

TEST(ClassMembers, AreFoundInTheirClassOnly) {
  EXPECT_EQ(
      names_of("class Vertex;\nclass Edge { int a; };\n"
               "list<class Vertex> f();\nclass Vertex { int b; };\nclass Face { int c; };"),
      (Names{"b"}));
  EXPECT_EQ(names_of("class Edge { int a; };"), Names{});
}

TEST(ClassMembers, AreToldByWhatTheyAre) {
  const auto members = members_of(
      "  bool a, b = true;  // int comment;\n"
      "  std::vector<std::pair<int, int>> many;\n"
      "  int width : 3;\n"
      "  double row[3];\n"
      "  static int count;\n"
      "  enum Color { RED, BLUE };\n"
      "  typedef std::list<int> Ints;\n"
      "protected:\n"
      "  Vector3D area( void ) const { if (a) { return row[0]; } return 0; }\n"
      "  void g(std::map<int, int> m, int n);\n");
  Names all;
  std::vector<MemberKind> kinds;
  for (const ClassMember& member : members) {
    all.insert(all.end(), member.names.begin(), member.names.end());
    kinds.push_back(member.kind);
  }
  EXPECT_EQ(all,
            (Names{"a", "b", "many", "width", "row", "count", "Color", "Ints", "area", "g"}));
  using K = MemberKind;
  EXPECT_EQ(kinds, (std::vector<K>{K::kData, K::kData, K::kData, K::kData, K::kFunction,
                                   K::kType, K::kType, K::kFunction, K::kFunction}));
  EXPECT_EQ(members[7].parameters, 0);
  EXPECT_EQ(members[8].parameters, 2);
  EXPECT_EQ(members[0].line, 4);
}

TEST(ClassMembers, ConstructorsOperatorsAndFriendsArePassedOver) {
  EXPECT_TRUE(members_of("Vertex() : a(1) {}\n~Vertex();\nfriend class Mesh;\n"
                         "bool operator<(const Vertex& v) const { return true; };\n")
                  .empty());
}

TEST(ClassMembers, DataBeginAtZeroOrAtWhatTheClassGivesThem) {
  EXPECT_EQ(only_text("bool isBlue;"), "bool isBlue{};");
  EXPECT_EQ(only_text("int a, b[2], c = 7;"), "int a{}, b[2]{}, c = 7;");
  EXPECT_EQ(only_text("std::string name;"), "std::string name{};");
  EXPECT_EQ(only_text("int mark;\nVertex() : mark( -1 ) {}"), "int mark{-1};");
  EXPECT_EQ(only_text("bool fresh;\nVertex() { fresh = true; }"), "bool fresh{true};");
  EXPECT_EQ(only_text("int mark;\nVertex(int m) : mark(m) {}"), "int mark{};");
}

TEST(ClassMembers, AnyTextIsRead) {
  for (const char* text :
       {"", "class Vertex", "class Vertex {", "class Vertex { int", "Vertex {",
        "class Vertex { ;;; : } } (", "class Vertex { f( ; ", "class Vertex {[",
        "class Vertex { int , , = ; }", "class Vertex { <> < ; }"}) {
    find_members(text, "Vertex");
  }
}

}  // namespace
}  // namespace meshgrade
