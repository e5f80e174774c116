// What homework for Scotty3D adds to the course's classes.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "grader/build/member_splice.h"

namespace meshgrade {
namespace {

Submission scotty3d_with(const std::string& source, const std::string& header = "",
                         const std::string& program = "") {
  Submission submission;
  submission.dialect = Dialect::kScotty3d;
  submission.sources = {{"halfedge-local.cpp", source}};
  if (!header.empty()) submission.course_headers = {{"halfedge.h", header}};
  if (!program.empty()) submission.course_sources = {{"halfedge.cpp", program}};
  return submission;
}

std::string spliced(const MemberSplice& splice, const std::string& file) {
  for (const SourceFile& made : splice.files()) {
    if (made.name == file) return made.text;
  }
  return {};
}

bool contains_text(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kScotty3dHeader =
    "class Halfedge_Mesh {\npublic:\n"
    "  class Vertex { public: HalfedgeRef halfedge; Index id; bool is_new; uint32_t degree() "
    "const; };\n"
    "  class Halfedge {\n   public:\n"
    "    HalfedgeRef twin, next;\n"
    "    HalfedgeRef prev();\n"
    "    int unused;\n"
    "  };\n"
    "  VertexRef emplace_vertex();\n"
    "  void set_corner_normals(float threshold = 30.0f);\n"
    "  std::optional<EdgeRef> flip_edge(EdgeRef e);\n"
    "};\n"
    "inline int helper() { return 1; }\n";

TEST(Scotty3dSplice, TakesWhatIsUsedAndTheCourseDoesNotHave) {
  const MemberSplice splice(scotty3d_with(
      "h->prev(); v->is_new = helper(); set_corner_normals();", kScotty3dHeader,
      "Halfedge_Mesh::HalfedgeRef Halfedge_Mesh::Halfedge::prev() { return next; }\n"
      "int Halfedge_Mesh::of_course() { return 1; }\n"));
  EXPECT_TRUE(contains_text(spliced(splice, "scotty3d_added_vertex.h"), "bool is_new{};"));
  EXPECT_FALSE(contains_text(spliced(splice, "scotty3d_added_vertex.h"), "degree"));
  const std::string halfedge = spliced(splice, "scotty3d_added_halfedge.h");
  EXPECT_TRUE(contains_text(halfedge, "#line 7 \"halfedge.h\"\nHalfedgeRef prev();"))
      << halfedge;
  EXPECT_FALSE(contains_text(halfedge, "unused"));
  EXPECT_TRUE(contains_text(spliced(splice, "scotty3d_added_mesh.h"), "threshold = 30.0f"));
  const std::string after = spliced(splice, "scotty3d_added_after.h");
  EXPECT_TRUE(
      contains_text(after, "inline Halfedge_Mesh::HalfedgeRef Halfedge_Mesh::Halfedge"));
  EXPECT_TRUE(contains_text(after, "inline int helper()"));
  EXPECT_FALSE(contains_text(after, "of_course"));
}

TEST(Scotty3dSplice, DeclaresWhatTheSourcesDefine) {
  const MemberSplice splice(scotty3d_with(
      "#include \"halfedge.h\"\n\n"
      "Halfedge_Mesh::FaceRef Halfedge_Mesh::add_face(std::vector<VertexRef> const &all,\n"
      "    bool boundary) { return faces.end(); }\n"
      "bool Halfedge_Mesh::Edge::is_long() const { return true; }\n"
      "std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef e) { return e; "
      "}\n"));
  const std::string mesh = spliced(splice, "scotty3d_added_mesh.h");
  EXPECT_TRUE(contains_text(mesh,
                            "Halfedge_Mesh::FaceRef add_face(std::vector<VertexRef> const "
                            "&all,\n    bool boundary)"))
      << mesh;
  EXPECT_TRUE(contains_text(mesh, "#line 3 \"halfedge-local.cpp\""));
  EXPECT_FALSE(contains_text(mesh, "flip_edge"));
  EXPECT_TRUE(contains_text(spliced(splice, "scotty3d_added_edge.h"), "bool is_long() const"));
  EXPECT_TRUE(splice.notes().empty());
}

TEST(Scotty3dSplice, LetsGoOfADeclarationThatDoesNotCompile) {
  MemberSplice splice(
      scotty3d_with("void Halfedge_Mesh::cost(Edge_Record r) {}\n"
                    "void Halfedge_Mesh::fine() {}\n"));
  splice.drop_blamed("halfedge-local.cpp:1:12: error: 'Edge_Record' has not been declared\n");
  const std::string mesh = spliced(splice, "scotty3d_added_mesh.h");
  EXPECT_FALSE(contains_text(mesh, "cost"));
  EXPECT_TRUE(contains_text(mesh, "fine"));
  ASSERT_EQ(splice.notes().size(), 1U);
  EXPECT_TRUE(contains_text(splice.notes()[0], "Halfedge_Mesh::cost cannot be taken over"));
}

TEST(Scotty3dSplice, IsEmptyWithoutAdditions) {
  EXPECT_TRUE(MemberSplice(scotty3d_with("int n;\n")).empty());
}

}  // namespace
}  // namespace meshgrade
