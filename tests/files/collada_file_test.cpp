#include <gmock/gmock.h>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using Box = std::array<Point3, 2>;

const std::string kTriangles = "<p>0 2 1 0 1 3 1 2 3 2 0 3</p>";

/// The sources of a mesh with the tetrahedron's points, then whatever primitives.
std::string mesh_content(const std::string& id, const std::string& primitives) {
  return "<source id='" + id +
         "-p'><float_array count='12'>0 0 0 1 0 0 0 1 0 0 0 1"
         "</float_array><technique_common><accessor count='4' stride='3'>"
         "<param name='X'/><param name='Y'/><param name='Z'/></accessor></technique_common>"
         "</source><vertices id='" +
         id + "-v'><input semantic='POSITION' source='#" + id + "-p'/></vertices>" + primitives;
}

std::string primitive(const std::string& kind, const std::string& id,
                      const std::string& lists) {
  return "<" + kind + "><input semantic='VERTEX' source='#" + id + "-v' offset='0'/>" + lists +
         "</" + kind + ">";
}

std::string geometry(const std::string& id, const std::string& element = "mesh") {
  return "<geometry id='" + id + "'><" + element + ">" +
         mesh_content(id, primitive("triangles", id, kTriangles)) + "</" + element +
         "></geometry>\n";
}

const std::string kShowA = "<node><instance_geometry url='#A'/></node>";

class ColladaFile : public FilesTest {
 protected:
  std::filesystem::path file(const std::string& geometries, const std::string& nodes) const {
    return write("a.dae",
                 "<?xml version='1.0'?>\n<COLLADA version='1.4.1'>\n<library_geometries>\n" +
                     geometries +
                     "</library_geometries>\n<library_visual_scenes><visual_scene "
                     "id='S'>" +
                     nodes +
                     "</visual_scene></library_visual_scenes>\n<scene>"
                     "<instance_visual_scene url='#S'/></scene></COLLADA>");
  }
  LoadedMesh read(const std::string& geometries, const std::string& nodes) const {
    return read_mesh(file(geometries, nodes));
  }
};

TEST_F(ColladaFile, RotationAboutNothingIsNone) {
  expect_tetrahedron(read(geometry("A"),
                          "<node><rotate>0 0 0 0</rotate><rotate>0 0 0 90</rotate>"
                          "<instance_geometry url='#A'/></node>"));
}

TEST_F(ColladaFile, WhatPlacesACameraMovesNoMesh) {
  expect_tetrahedron(read(geometry("A"),
                          "<node><lookat>0 0 5 0 0 0 0 1 0</lookat><instance_camera url='#c'/>"
                          "</node><node><skew>45 0 1 0 1 0 0</skew></node>" +
                              kShowA));
}

TEST_F(ColladaFile, LookAtTurnsAndMovesAMesh) {
  // From (0 0 5) along +x: right is +z, up stays, and -z becomes +x.
  const PolygonMesh mesh = read(geometry("A"),
                                "<node><lookat>0 0 5 1 0 5 0 1 0</lookat>"
                                "<instance_geometry url='#A'/></node>")
                               .mesh;
  const Box box = box_of(mesh);
  EXPECT_NEAR(box[0][0], -1, 1e-12);
  EXPECT_NEAR(box[1][0], 0, 1e-12);
  EXPECT_NEAR(box[1][1], 1, 1e-12);
  EXPECT_NEAR(box[1][2], 6, 1e-12);
  EXPECT_THAT(fault_of(file(geometry("A"),
                            "\n<node><skew>45 0 1 0 1 0 0</skew>"
                            "<instance_geometry url='#A'/></node>")),
              StartsWith("a.dae:7: skew is not read"));
}

TEST_F(ColladaFile, AReferenceIsLookedUpAmongElementsOfItsKind) {
  const LoadedMesh loaded =
      read(geometry("A") + geometry("B"),
           "<node id='A'><instance_geometry url='#A'/></node>"
           "<node id='B'><translate>5 0 0</translate><instance_geometry url='#B'/></node>");
  EXPECT_EQ(loaded.mesh.polygons.size(), 8U);
  EXPECT_EQ(box_of(loaded.mesh), (Box{{{0, 0, 0}, {6, 1, 1}}}));
  EXPECT_TRUE(loaded.notes.empty());
  EXPECT_THAT(
      fault_of(file(geometry("A"), "\n<node id='n'><instance_geometry url='#n'/></node>")),
      StartsWith("a.dae:7: '#n' names an element 'node' where geometry should be"));
}

TEST_F(ColladaFile, SourcesOfTheSameNameBelongToTheirOwnMesh) {
  std::string far = geometry("A");
  far.replace(far.find("'A'"), 3, "'B'");
  far.replace(far.find("0 0 0 1"), 1, "7");
  const PolygonMesh mesh =
      read(geometry("A") + far, kShowA + "<node><instance_geometry url='#B'/></node>").mesh;
  EXPECT_EQ(mesh.polygons.size(), 8U);
  EXPECT_EQ(box_of(mesh)[1][0], 7);
}

TEST_F(ColladaFile, ConvexMeshesAreMeshes) {
  EXPECT_EQ(read(geometry("A") + geometry("B", "convex_mesh"),
                 kShowA + "<node><instance_geometry url='#B'/></node>")
                .mesh.polygons.size(),
            8U);
  expect_tetrahedron(
      read(geometry("A") + "<geometry id='B'><convex_mesh convex_hull_of='#A'/></geometry>\n",
           kShowA + "<node><instance_geometry url='#B'/></node>"),
      {"left out 1 convex hull of another geometry, at line 5"});
}

TEST_F(ColladaFile, CommentsAndSectionsPartTextAndNumbers) {
  std::string text = geometry("A");
  text.replace(text.find("1 0 0 0 1"), 9, "1 <!-- second --> 0 0 <![CDATA[0 1]]>");
  text.replace(text.find("2 1 0 1"), 7, "2<!-- same face --> 1 0 1");
  expect_tetrahedron(read(text, kShowA));
}

TEST_F(ColladaFile, StripsAndFansAreCutIntoTriangles) {
  const auto shape = [](const std::string& kind, const std::string& lists) {
    return "<geometry id='A'><mesh>" + mesh_content("A", primitive(kind, "A", lists)) +
           "</mesh></geometry>";
  };
  EXPECT_THAT(read(shape("tristrips", "<p>0 1 2 3</p><p>0 2 1</p>"), kShowA).mesh.polygons,
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(2, 1, 3), ElementsAre(0, 2, 1)));
  EXPECT_THAT(read(shape("trifans", "<p>0 1 2 3</p>"), kShowA).mesh.polygons,
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
}

TEST_F(ColladaFile, NothingOfTheSceneGoesWithoutAWord) {
  const std::string lines = primitive("lines", "A", "<p>0 1 1 2</p>");
  std::string counted = lines;
  counted.insert(counted.find('>'), " count='2'");
  const std::string mixed =
      "<geometry id='A'><mesh>" +
      mesh_content("A", primitive("triangles", "A", kTriangles) + counted +
                            primitive("linestrips", "A", "<p>0 1 2</p><p>1 2</p>")) +
      "</mesh></geometry>\n<geometry id='C'><spline/></geometry>\n" + geometry("unseen");
  expect_tetrahedron(
      read(mixed, kShowA + "<node><instance_geometry url='#C'/></node>"),
      {"left out 2 lines, the first at line 4", "left out 2 line strips, the first at line 4",
       "left out 1 spline, at line 5",
       "left out 1 geometry that the scene does not show, at line 6"});
}

TEST_F(ColladaFile, FacesWithoutAreaAreLeftOutWithTheirNumber) {
  expect_tetrahedron(
      read("<geometry id='A'><mesh>" +
               mesh_content(
                   "A", primitive("triangles", "A", "<p>0 2 1 0 1 3 1 1 2 1 2 3 2 0 3</p>")) +
               "</mesh></geometry>",
           kShowA),
      {"left out 1 face without area (a corner twice), at line 4"});
}

TEST_F(ColladaFile, PositionsMayLieInTwoListsAndInAnyOrderOfAxes) {
  const std::string second =
      "<source id='q'><float_array>9 0 0 5  9 1 0 5  9 0 1 5</float_array><technique_common>"
      "<accessor count='3' stride='4'><param/><param name='Y'/><param name='Z'/>"
      "<param name='X'/></accessor></technique_common></source><vertices id='w'>"
      "<input semantic='POSITION' source='#q'/></vertices><triangles>"
      "<input semantic='VERTEX' source='#w' offset='0'/><p>0 1 2</p></triangles>";
  const PolygonMesh mesh =
      read("<geometry id='A'><mesh>" +
               mesh_content("A", primitive("triangles", "A", kTriangles) + second) +
               "</mesh></geometry>",
           kShowA)
          .mesh;
  ASSERT_EQ(mesh.polygons.size(), 5U);
  EXPECT_THAT(mesh.polygons[4], ElementsAre(4, 5, 6));
  EXPECT_EQ(mesh.positions[5], (Point3{5, 1, 0}));
}

TEST_F(ColladaFile, AFileWithoutASceneShowsItsFirst) {
  const auto nodes = "<node><translate>5 0 0</translate><instance_geometry url='#A'/></node>";
  const std::string text = "<COLLADA><library_geometries>" + geometry("A") +
                           "</library_geometries><library_visual_scenes><visual_scene>" +
                           nodes + "</visual_scene></library_visual_scenes></COLLADA>";
  EXPECT_EQ(box_of(read_mesh(write("a.dae", text)).mesh), (Box{{{5, 0, 0}, {6, 1, 1}}}));
}

TEST_F(ColladaFile, WhatIsNotReadIsNamed) {
  EXPECT_THAT(fault_of(write("a.dae", "<COLLADA version='1.3.1'><library/></COLLADA>")),
              HasSubstr("is COLLADA '1.3.1', which is not read"));
  EXPECT_THAT(fault_of(file(geometry("A"), "<node><instance_controller url='#c'/></node>")),
              HasSubstr("skins and morphs of COLLADA are not read"));
  std::string holes = geometry("A");
  holes = "<geometry id='A'><mesh>" +
          mesh_content("A", primitive("polygons", "A", "<ph><p>0 1 2</p><h>3 0 1</h></ph>")) +
          "</mesh></geometry>";
  EXPECT_THAT(fault_of(file(holes, kShowA)), HasSubstr("polygons with holes are not read"));
}

}  // namespace
}  // namespace meshgrade
