// Cases on meshes of the instructor's own.

#include "grader/cases/own_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "grader/cases/mesh_input.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

/// Two triangles on v1 and v2, and a vertex that no face has, first.
constexpr const char* kTwo = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 2 3 4\nf 4 3 5\n";

class OwnMeshes : public testing::Test {
 protected:
  Assignment assignment(const std::string& exercise, const std::string& keys) const {
    write_file_safely(folder_.path() / "two.obj", kTwo);
    write_file_safely(folder_.path() / "quad.obj",
                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    write_file_safely(folder_.path() / "no_surface.obj",
                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                      "f 1 2 3\nf 2 1 4\nf 1 2 5\n");
    const std::string group = exercise == "bezier_curve" ? "basic" : "ours";
    write_file_safely(folder_.path() / "a.toml",
                      "version = 1\ntitle = \"T\"\nseed = 1\n[[exercise]]\nname = \"" +
                          exercise + "\"\n[[exercise.group]]\nname = \"" + group +
                          "\"\npoints = 1\n[[exercise.group.mesh]]\n" + keys);
    return read_assignment(folder_.path() / "a.toml");
  }

  std::vector<Case> cases(const std::string& exercise, const std::string& keys) const {
    const Assignment read = assignment(exercise, keys);
    check_own_meshes(read);
    return make_cases(read, read.exercises[0], MESHGRADE_SOURCE_DIR "/meshes");
  }

  std::string complaint(const std::string& exercise, const std::string& keys) const {
    return user_error([&] { cases(exercise, keys); });
  }

  ScratchFolder folder_;
};

TEST_F(OwnMeshes, EveryEdgeIsTriedInBothWaysThatItCanBeAnchored) {
  EXPECT_EQ(cases("edge_flip", "file = \"two.obj\"").size(), 2U * 1U);
  EXPECT_EQ(cases("edge_split", "file = \"two.obj\"\nedges = \"boundary\"").size(), 2U * 4U);
  EXPECT_EQ(cases("edge_split", "file = \"two.obj\"\nedges = \"every\"").size(), 2U * 5U);
}

TEST_F(OwnMeshes, NamedEdgesAreThoseOfTheFile) {
  const std::vector<Case> made = cases("edge_flip", "file = \"two.obj\"\nedges = [[2, 1]]");
  ASSERT_EQ(made.size(), 2U);
  const auto input = from_wire<OperationsInput>(made[0].input);
  // The first vertex of the file belongs to no face: it is left out and not counted.
  EXPECT_EQ(input.operations.at(0).a, 1U);
  EXPECT_EQ(input.operations.at(0).b, 2U);
  EXPECT_EQ(input.mesh.positions.size(), 4U);
}

TEST_F(OwnMeshes, LevelsAreThoseOfTheAssignment) {
  const std::vector<Case> made = cases("loop_subdivision", "file = \"two.obj\"\nlevels = 3");
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(from_wire<SubdivisionInput>(made[0].input).levels, 3U);
  EXPECT_EQ(cases("vertex_normal", "file = \"two.obj\"").size(), 1U);
}

TEST_F(OwnMeshes, HiddenOnesAreHiddenCasesAndMayBeMissing) {
  const std::vector<Case> made = cases("edge_flip", "file = \"two.obj\"\nhidden = true");
  ASSERT_FALSE(made.empty());
  EXPECT_TRUE(std::all_of(made.begin(), made.end(), [](const Case& c) { return c.hidden; }));
  EXPECT_EQ(cases("edge_flip", "file = \"gone.obj\"\nhidden = true").size(), 0U);
}

TEST_F(OwnMeshes, WhatIsWrongIsToldWithItsLine) {
  const auto told = [&](const std::string& exercise, const std::string& keys,
                        const std::string& what) {
    const std::string said = complaint(exercise, keys);
    EXPECT_THAT(said, HasSubstr("a.toml:"));
    EXPECT_THAT(said, HasSubstr(what));
  };
  told("edge_flip", "file = \"gone.obj\"", "there is no file");
  told("edge_flip", "file = \"quad.obj\"", "face 0 has 4 corners");
  told("edge_flip", "file = \"no_surface.obj\"", "is no surface");
  told("edge_flip", "file = \"two.obj\"\nedges = [[1, 4]]",
       "has no edge between its vertices 1 and 4");
  told("edge_flip", "file = \"two.obj\"\nedges = [[0, 3]]", "has no edge");
  told("edge_flip", "file = \"two.obj\"\nlevels = 2", "has no use for the key levels");
  told("loop_subdivision", "file = \"two.obj\"\nedges = \"every\"", "has no use for the key");
  told("bezier_curve", "file = \"two.obj\"", "has no use for a mesh");
  told("edge_flip", "file = \"../two.obj\"", "beside the assignment");
  told("edge_flip", "file = \"/two.obj\"", "beside the assignment");
  told("edge_flip", "file = \"two.obj\"\nedges = \"all\"", "must be \"inner\"");
  told("edge_flip", "file = \"two.obj\"\nedges = [[1]]", "list of pairs");
  told("edge_flip", "file = \"two.obj\"\nedges = []", "list of pairs");
  told("loop_subdivision", "file = \"two.obj\"\nlevels = 9", "at most 5");
}

}  // namespace
}  // namespace meshgrade
