#include <gmock/gmock.h>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class ObjFile : public FilesTest {
 protected:
  LoadedMesh read(const std::string& text) const { return read_mesh(write("a.obj", text)); }
  std::string fault(const std::string& text) const { return fault_of(write("a.obj", text)); }

  const std::string tetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
};

TEST_F(ObjFile, LinesMayEndAsOnAnySystem) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = "# by hand\n" + tetrahedron;
    for (std::size_t at = text.find('\n'); at != text.npos;
         at = text.find('\n', at + end.size()))
      text.replace(at, 1, end);
    expect_tetrahedron(read(text));
    EXPECT_THAT(fault(text + "f 1 2 9" + end), StartsWith("a.obj:10: "));
  }
}

TEST_F(ObjFile, ALineMayGoOnBehindABackslashAndBlanks) {
  for (const std::string end : {"\\\n", "\\ \n", "\\\t \r\n"}) {
    expect_tetrahedron(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 " + end +
                            " 3 2\nf 1 2 4\nf 2 3 4\nf 3 " + end + "1" + end + " 4\n"));
  }
}

TEST_F(ObjFile, WordsOfTheDescriptionThatAreNoShapeArePassedOver) {
  std::string text = tetrahedron;
  for (const std::string word : {"vt 0 0",
                                 "vn 0 0 1",
                                 "vp 0 0",
                                 "cstype bezier",
                                 "deg 3",
                                 "bmat u 1 0 0 1",
                                 "step 1 1",
                                 "curv2 1 2",
                                 "parm u 0 1",
                                 "trim 0 1 1",
                                 "hole 0 1 1",
                                 "scrv 0 1 1",
                                 "sp 1",
                                 "end",
                                 "con 1 0 1 1 2 0 1 1",
                                 "g a b",
                                 "s off",
                                 "mg 1 .5",
                                 "o thing",
                                 "bevel on",
                                 "c_interp on",
                                 "d_interp on",
                                 "lod 3",
                                 "usemtl red",
                                 "mtllib red.mtl",
                                 "shadow_obj a.obj",
                                 "trace_obj a.obj",
                                 "ctech cparm 1",
                                 "stech cparma 1 1",
                                 "usemap a",
                                 "maplib a",
                                 "csh -ls"}) {
    text += word + "\n";
  }
  expect_tetrahedron(read(text));
}

TEST_F(ObjFile, OtherShapesAreCounted) {
  expect_tetrahedron(
      read(tetrahedron + "l 1 2\nl 2 3 4\np 1 2 3\ncurv 0 1 1 2 3 4\nsurf 0 1 0 1 1\nbzp 1\n"),
      {"left out 2 lines, the first at line 9", "left out 3 points, the first at line 11",
       "left out 1 free-form curve, at line 12",
       "left out 2 free-form surfaces, the first at line 13"});
  EXPECT_THAT(
      fault("v 0 0 0\nv 1 0 0\nl 1 2\n"),
      AllOf(StartsWith("a.obj: holds no faces"), HasSubstr("left out 1 line, at line 3")));
}

TEST_F(ObjFile, TheOlderWordForFacesIsRead) {
  const PolygonMesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nfo 1 2 3\nf 3 2 4\n").mesh;
  EXPECT_THAT(mesh.polygons, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(2, 1, 3)));
}

TEST_F(ObjFile, UnknownWordsAreCountedUnlessNothingElseIsThere) {
  expect_tetrahedron(
      read("foo 1\n" + tetrahedron + "bar\n"),
      {"left out 2 lines that start with no word of OBJ ('foo' ...), the first at line 1"});
  EXPECT_EQ(
      fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
      "a.obj:1: 'OFF' starts no line of an OBJ file, and no line is a face; is it another "
      "format?");
}

TEST_F(ObjFile, VerticesOfNoFaceAreLeftOutWithANote) {
  expect_tetrahedron(read("v 5 5 5\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                          "f 2 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\n"),
                     {"left out 1 vertex that belongs to no face"});
}

TEST_F(ObjFile, FacesWithoutAreaAreLeftOutAndRepeatedCornersMerged) {
  expect_tetrahedron(read(tetrahedron + "f 1 2 2\nf 3 3 3\nf 1 2\nf 1 2 1 3\n"),
                     {"left out 3 faces without area (a corner twice), the first at line 9",
                      "left out 1 face with fewer than 3 corners, at line 11"});
  const LoadedMesh merged = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 3\n");
  EXPECT_THAT(merged.mesh.polygons, ElementsAre(ElementsAre(0, 1, 2)))
      << "a quad that two corners make a triangle is one";
  EXPECT_THAT(merged.notes, ElementsAre("left out 1 corner that repeats the one before it, at "
                                        "line 4"));
}

TEST_F(ObjFile, FaultsAreStillToldByTheLine) {
  EXPECT_EQ(fault(tetrahedron + "f 1 2 x\n"),
            "a.obj:9: 'x' where a vertex number should be; OBJ counts 1, 2, 3, ...");
  EXPECT_EQ(fault(tetrahedron + "f 1 2 2 9\n"),
            "a.obj:9: face f4 asks for vertex 9, but the 4 vertices are numbered from 1");
}

}  // namespace
}  // namespace meshgrade
