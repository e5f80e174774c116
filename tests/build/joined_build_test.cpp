// Files that are compiled as one fare as they do alone: what is said about each of them, what
// is left out, and what runs in the end.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/submissions.h"

namespace meshgrade {
namespace {

std::string described(const Build& build) {
  std::string text;
  for (const BuiltFile& file : build.files) {
    text += file.name + (file.ok ? " ok" : " not ok") + (file.linked ? "" : ", not linked") +
            "\n" + file.messages;
    for (const CompilerWarning& warning : file.warnings)
      text += warning.file + ":" + std::to_string(warning.line) + " " + warning.text + "\n";
    for (const LeftOut& left : file.left_out)
      text += left.function + " is left out: " + left.message + "\n";
  }
  return text;
}

Build build_as(bool joined, std::size_t cores, const std::vector<SourceFile>& sources) {
  Home home = test_home();
  home.joins_files = joined;
  home.cores = cores;
  return build_submission(submission_of(sources), home, Limits{});
}

std::string member(const std::string& code) {
  return "#include \"meshedit/meshedit.h\"\nnamespace meshedit {\n" + code + "\n}\n";
}

const SourceFile kNormal{"normal.cpp",
                         member("Vector3D Vertex::normal() const { return {1, 0, 0}; }")};
const SourceFile kFlip{"flip.cpp",
                       member("EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) { return e; }")};

struct Files {
  std::string what;
  SourceFile third;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Files& files, std::ostream* out) {
  *out << files.what;
}

class JoinedBuild : public testing::TestWithParam<Files> {};

TEST_P(JoinedBuild, SaysTheSameAsEachAlone) {
  const std::vector<SourceFile> sources{kNormal, kFlip, GetParam().third};
  const std::string alone = described(build_as(false, 1, sources));
  EXPECT_EQ(described(build_as(true, 1, sources)), alone);
  EXPECT_EQ(described(build_as(true, 2, sources)), alone);
}

INSTANTIATE_TEST_SUITE_P(
    All, JoinedBuild,
    testing::Values(
        Files{"a file without faults", {"split.cpp", member("namespace { int unused_one; }")}},
        Files{"a warning", {"split.cpp", member("static int unused_one() { return 1; }")}},
        Files{"a function that does not compile",
              {"split.cpp", member("VertexIter HalfedgeMesh::splitEdge(EdgeIter) { oops; }")}},
        Files{"a file that does not compile", {"split.cpp", member("int x = oops;")}},
        Files{
            "a call of what is nowhere",
            {"split.cpp", member("int nowhere();\nVertexIter HalfedgeMesh::splitEdge(EdgeIter)"
                                 " { nowhere(); return {}; }")}},
        Files{"a function that another file has, too", {"split.cpp", kFlip.text}},
        Files{"a file that ends within a comment", {"split.cpp", member("") + "/* open"}},
        Files{"a file without a line end", {"split.cpp", "int last"}}));

TEST(JoinedBuild, IsOneObject) {
  const Build build = build_as(true, 1, {kNormal, kFlip});
  EXPECT_TRUE(std::filesystem::exists(build.folder.path() / "~0.o"));
  EXPECT_FALSE(std::filesystem::exists(build.folder.path() / "flip.cpp.o"));
}

}  // namespace
}  // namespace meshgrade
