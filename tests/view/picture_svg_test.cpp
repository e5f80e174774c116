// Pictures that the grader draws by itself.

#include "grader/view/picture_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "grader/base/random.h"
#include "tests/support/sample_meshes.h"

namespace meshgrade {
namespace {

pugi::xml_document draw(const MeshDump& mesh, const PictureRequest& request,
                        const Deviation& deviation = {}) {
  pugi::xml_document document;
  const std::string svg =
      picture_svg({{"a < b", mesh, deviation}}, request, "T & t", "in words");
  EXPECT_TRUE(document.load_string(svg.c_str())) << svg;
  return document;
}

/// What is drawn of the mesh, the farthest first.
std::vector<std::string> paths(const pugi::xml_document& document) {
  std::vector<std::string> list;
  for (const auto& node : document.select_nodes("//g[@class='faces']/path"))
    list.emplace_back(node.node().attribute("d").value());
  return list;
}

std::vector<std::string> labels(const pugi::xml_document& document) {
  std::vector<std::string> list;
  for (const auto& node :
       document.select_nodes("//g[@class='ids']//text | //g[@class='face-id']//text"))
    list.emplace_back(node.node().text().get());
  return list;
}

TEST(PictureSvg, EveryFaceOfACubeIsDrawnAndTheNearestLast) {
  PictureRequest request;
  request.camera = {0.0, 0.0, 3.0};
  request.ids = true;
  MeshDump cube = sample_dump("cube.obj");
  const pugi::xml_document document = draw(cube, request);
  EXPECT_EQ(paths(document).size(), 12U);
  // From the front only the two triangles of the side z = 1 are seen.
  std::vector<std::string> faces;
  for (const std::string& label : labels(document)) {
    if (label[0] == 'f') faces.push_back(label);
  }
  EXPECT_EQ(faces.size(), 2U);
  const auto nodes = document.select_nodes("//g[@class='faces']/path");
  std::string last_fill = nodes[11].node().attribute("fill").value();
  EXPECT_EQ(last_fill, nodes[10].node().attribute("fill").value());
  EXPECT_NE(last_fill, nodes[0].node().attribute("fill").value()) << "the back is drawn first";
}

TEST(PictureSvg, ThePictureTurnsWithTheCamera) {
  PictureRequest request;
  const MeshDump mesh = sample_dump("fan.obj");
  request.camera = {20.0, 30.0, 3.0};
  const auto from_here = paths(draw(mesh, request));
  request.camera = {380.0 - 360.0, 30.0, 3.0};
  EXPECT_EQ(paths(draw(mesh, request)), from_here);
  request.camera = {110.0, 30.0, 3.0};
  EXPECT_NE(paths(draw(mesh, request)), from_here);
}

TEST(PictureSvg, ANearerCameraMakesThePictureLargerInProportion) {
  PictureRequest request;
  const MeshDump mesh = sample_dump("single_triangle.obj");
  const auto width_from = [&](double distance) {
    request.camera = {0.0, 0.0, distance};
    double low = INFINITY;
    double high = -INFINITY;
    for (const std::string& d : paths(draw(mesh, request))) {
      std::istringstream numbers(d.substr(1));
      for (double x = 0.0, y = 0.0; numbers >> x >> y; numbers.ignore(1)) {
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    return high - low;
  };
  EXPECT_NEAR(width_from(2.0), 2.0 * width_from(4.0), 0.3);
  EXPECT_GT(width_from(4.0), 10.0);
}

TEST(PictureSvg, BrokenMeshesAreDrawnWhateverTheirPointersSay) {
  Random random(7, "picture");
  PictureRequest request;
  request.ids = true;
  for (int round = 0; round < 300; ++round) {
    MeshDump mesh = sample_dump("octahedron.off");
    for (int i = 0; i < 4; ++i) {
      HalfedgeRecord& h =
          mesh.halfedges[random.below(static_cast<std::uint32_t>(mesh.halfedges.size()))];
      Ref* pointers[] = {&h.next, &h.twin, &h.vertex, &h.edge, &h.face};
      const Ref values[] = {kUnsetRef,       kPastEndRef, kForeignRef, 3,
                            3 | kDeletedBit, 1000000,     kBoundaryBit};
      *pointers[random.below(5)] = values[random.below(7)];
    }
    mesh.vertices[random.below(6)].position[1] = round % 2 == 0 ? NAN : 1e300;
    mesh.faces[0].halfedge = static_cast<Ref>(round);
    const pugi::xml_document document = draw(mesh, request);
    EXPECT_EQ(document.first_child().name(), std::string("svg"));
  }
}

TEST(PictureSvg, AnEdgeOfNoClosedFaceIsDrawnAsALine) {
  MeshDump mesh = sample_dump("single_triangle.obj");
  mesh.halfedges[mesh.faces[0].halfedge].next = kUnsetRef;
  EXPECT_EQ(paths(draw(mesh, {})).size(), 3U);
}

TEST(PictureSvg, VerticesThatAreOffAreColouredMarkedAndTold) {
  const MeshDump mesh = sample_dump("octahedron.off");
  std::vector<Point3> expected;
  std::vector<Ref> match;
  for (Ref v = 0; v < 6; ++v) {
    expected.push_back(mesh.vertices[v].position);
    match.push_back(v);
  }
  expected[2][0] += 0.25;
  Deviation deviation = measure_deviation(expected, mesh, match, 2.0, 1e-5);
  deviation.weights = "Loop's weights";
  PictureRequest request;
  request.compare = true;
  const pugi::xml_document document = draw(mesh, request, deviation);
  EXPECT_STREQ(document.select_node("//g[@class='worst']/text").node().text().get(), "v2");
  EXPECT_EQ(document.select_nodes("//g[@class='worst']/circle").size(), 1U);
  std::string legend;
  for (const auto& node : document.select_nodes("//g[@class='legend']/text"))
    legend += node.node().text().get();
  EXPECT_THAT(legend, testing::HasSubstr("OpenSubdiv by Loop's weights"));
}

TEST(PictureSvg, DarkAndLightDifferInTheirGround) {
  const MeshDump mesh = sample_dump("cube.obj");
  PictureRequest request;
  const auto ground = [&] {
    return std::string(
        draw(mesh, request).child("svg").child("rect").attribute("fill").value());
  };
  const std::string light = ground();
  request.dark = true;
  EXPECT_NE(ground(), light);
}

}  // namespace
}  // namespace meshgrade
