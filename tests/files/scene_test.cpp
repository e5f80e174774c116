// Transforms of nodes, instances and axes, in glTF and COLLADA.

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using Json = nlohmann::json;

void expect_positions(const PolygonMesh& mesh, const std::vector<Point3>& expected) {
  ASSERT_EQ(mesh.positions.size(), expected.size());
  for (std::size_t v = 0; v < expected.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mesh.positions[v][axis], expected[v][axis], 1e-12) << "v" << v;
    }
  }
}

class GltfScene : public FilesTest {
 protected:
  /// The triangle (0 0 0), (1 0 0), (0 1 0), then a fourth point (0 0 1), as floats; then the
  /// indices 0 1 2 0 2 3 as bytes; then a sparse replacement: index 1 becomes (5 0 0);
  /// then the triangle (0 0 0), (2 0 0), (0 2 0) with a 9 after each point.
  GltfScene() {
    std::string bytes;
    const auto put = [&](auto number) {
      char raw[sizeof(number)];
      std::memcpy(raw, &number, sizeof(number));
      bytes.append(raw, sizeof(number));
    };
    for (const int x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
      put(static_cast<float>(x));
    for (const int v : {0, 1, 2, 0, 2, 3, 1, 0})
      put(static_cast<char>(v));
    for (const int x : {5, 0, 0})
      put(static_cast<float>(x));
    for (const int x : {0, 0, 0, 9, 2, 0, 0, 9, 0, 2, 0, 9})
      put(static_cast<float>(x));
    write("data.bin", bytes);
    file = Json::parse(R"({
      "asset": {"version": "2.0"},
      "scene": 0,
      "scenes": [{"nodes": [0]}],
      "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}
      ],
      "bufferViews": [
        {"buffer": 0, "byteLength": 48},
        {"buffer": 0, "byteOffset": 48, "byteLength": 8},
        {"buffer": 0, "byteOffset": 56, "byteLength": 12},
        {"buffer": 0, "byteOffset": 68, "byteLength": 48, "byteStride": 16}
      ],
      "buffers": [{"byteLength": 116, "uri": "data.bin"}]
    })");
  }

  PolygonMesh read() const { return read_mesh(write("a.gltf", file.dump())).mesh; }
  std::string fault() const { return fault_of(write("a.gltf", file.dump())); }

  Json& primitive() { return file["meshes"][0]["primitives"][0]; }

  Json file;
};

TEST_F(GltfScene, NodesAreTranslatedRotatedAndScaledFromTheInside) {
  const double half = std::sqrt(0.5);
  file["nodes"] = Json::parse(R"([{"children": [1], "translation": [10, 0, 0]},
                                  {"mesh": 0, "scale": [2, 3, 4]}])");
  file["nodes"][1]["rotation"] = {0, 0, half, half};
  // Scaled, turned by 90 degrees around z, moved.
  expect_positions(read(), {{10, 0, 0}, {10, 2, 0}, {7, 0, 0}});
}

TEST_F(GltfScene, MatricesAreColumnMajor) {
  file["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
  expect_positions(read(), {{7, 8, 9}, {7, 9, 9}, {6, 8, 9}});
}

TEST_F(GltfScene, MirroredPartsKeepTheirOutside) {
  file["nodes"][0]["scale"] = {-1, 1, 1};
  EXPECT_EQ(read().polygons[0], (std::vector<std::uint32_t>{0, 1, 2}));
  // Numbered in the order of the reversed triangle.
  expect_positions(read(), {{0, 1, 0}, {-1, 0, 0}, {0, 0, 0}});
}

TEST_F(GltfScene, StripsAndFansAreCutIntoTriangles) {
  file["accessors"][0]["count"] = 4;
  primitive()["mode"] = 5;
  const PolygonMesh strip = read();
  ASSERT_EQ(strip.polygons.size(), 2U);
  EXPECT_EQ(strip.polygons[1], (std::vector<std::uint32_t>{2, 1, 3}));
  primitive()["mode"] = 6;
  EXPECT_EQ(read().polygons[1], (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST_F(GltfScene, SparseAccessorsReplaceElements) {
  file["accessors"][0]["sparse"] = Json::parse(
      R"({"count": 1,
          "indices": {"bufferView": 1, "byteOffset": 6, "componentType": 5121},
          "values": {"bufferView": 2}})");
  expect_positions(read(), {{0, 0, 0}, {5, 0, 0}, {0, 1, 0}});
}

TEST_F(GltfScene, StridesAreFollowed) {
  file["accessors"][0]["bufferView"] = 3;
  expect_positions(read(), {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
}

TEST_F(GltfScene, HostileSizesAndIndicesAreRefused) {
  const Json good = file;
  primitive()["indices"] = 1;
  EXPECT_NE(fault().find("asks for vertex 3"), std::string::npos);
  for (const auto& [pointer, value] : std::vector<std::pair<std::string, Json>>{
           {"/accessors/0/count", 1000},
           {"/accessors/0/count", 4294967295},
           {"/accessors/0/bufferView", 99},
           {"/accessors/0/byteOffset", 4294967290},
           {"/accessors/0/componentType", 5123},
           {"/accessors/0/type", "VEC4"},
           {"/bufferViews/0/buffer", 7},
           {"/bufferViews/0/byteOffset", 90},
           {"/bufferViews/0/byteStride", 4},
           {"/bufferViews/0/byteLength", 4294967295},
           {"/meshes/0/primitives/0/attributes/POSITION", 12},
           {"/meshes/0/primitives/0/attributes/POSITION", -5},
           {"/meshes/0/primitives/0/indices", 12},
           {"/nodes/0/mesh", 3},
           {"/nodes/0/children", Json::array({0})},
           {"/scenes/0/nodes", Json::array({9})},
           {"/scene", 4},
           {"/buffers/0/uri", "../data.bin"},
           {"/buffers/0/uri", "/etc/passwd"},
           {"/buffers/0/byteLength", 117},
           {"/extensionsRequired", Json::array({"KHR_draco_mesh_compression"})}}) {
    file = good;
    file[Json::json_pointer(pointer)] = value;
    EXPECT_TRUE(fault().starts_with("a.gltf:")) << pointer << " = " << value << fault();
    EXPECT_EQ(fault().find('\n'), std::string::npos) << fault();
  }
}

TEST_F(GltfScene, DeepNestingIsRefusedBeforeItIsWalked) {
  const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
  const auto text = R"({"asset":{"version":"2.0"},"extras":)" + deep + "}";
  EXPECT_NE(fault_of(write("deep.gltf", text)).find("nested too deeply"), std::string::npos);
}

class ColladaScene : public FilesTest {
 protected:
  /// Two geometries, `triangle` and `square`, and whatever is given for asset and scene.
  PolygonMesh read(const std::string& nodes, const std::string& up = "Y_UP") const {
    return read_mesh(file(nodes, up)).mesh;
  }

  std::filesystem::path file(const std::string& nodes, const std::string& up = "Y_UP") const {
    return write("a.dae", "<COLLADA>\n<asset><up_axis>" + up + "</up_axis></asset>\n" +
                              R"(<library_geometries>
<geometry id="triangle"><mesh>
 <source id="tp"><float_array>0 0 0 1 0 0 0 1 0</float_array></source>
 <vertices id="tv"><input semantic="POSITION" source="#tp"/></vertices>
 <triangles><input semantic="VERTEX" source="#tv" offset="1"/>
  <input semantic="NORMAL" source="#tp" offset="0"/><p>9 0 9 1 9 2</p></triangles>
</mesh></geometry>
<geometry id="square"><mesh>
 <source id="sp"><float_array>0 0 5 1 0 5 1 1 5 0 1 5</float_array></source>
 <vertices id="sv"><input semantic="POSITION" source="#sp"/></vertices>
 <polygons><input semantic="VERTEX" source="#sv" offset="0"/><p>0 1 2 3</p></polygons>
</mesh></geometry></library_geometries>
<library_nodes><node id="shared"><translate>0 0 7</translate>
 <instance_geometry url="#triangle"/></node></library_nodes>
<library_visual_scenes><visual_scene id="s">)" +
                              nodes +
                              "</visual_scene></library_visual_scenes>\n"
                              "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>");
  }
};

TEST_F(ColladaScene, TransformsApplyInTheOrderWritten) {
  const PolygonMesh mesh = read(
      "<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 3 4</scale>"
      "<instance_geometry url=\"#triangle\"/></node>");
  expect_positions(mesh, {{10, 0, 0}, {10, 2, 0}, {7, 0, 0}});
}

TEST_F(ColladaScene, MatricesAreRowMajorAndNodesNest) {
  const PolygonMesh mesh = read(
      "<node><matrix>0 -1 0 7  1 0 0 8  0 0 1 9  0 0 0 1</matrix>"
      "<node><scale>2 2 2</scale><instance_geometry url=\"#triangle\"/></node></node>");
  expect_positions(mesh, {{7, 8, 9}, {7, 10, 9}, {5, 8, 9}});
}

TEST_F(ColladaScene, SeveralGeometriesAndSharedNodesArePutTogether) {
  const PolygonMesh mesh = read(
      "<node><instance_geometry url=\"#square\"/></node>"
      "<node><instance_node url=\"#shared\"/></node>");
  ASSERT_EQ(mesh.polygons.size(), 2U);
  EXPECT_EQ(mesh.polygons[0], (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.polygons[1], (std::vector<std::uint32_t>{4, 5, 6}));
  EXPECT_EQ(mesh.positions[4], (Point3{0, 0, 7}));
}

TEST_F(ColladaScene, UpPointsAlongYInTheEnd) {
  const std::string node = "<node><instance_geometry url=\"#triangle\"/></node>";
  expect_positions(read(node, "Z_UP"), {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}});
  expect_positions(read(node, "X_UP"), {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}});
}

TEST_F(ColladaScene, CirclesOfNodesAreRefused) {
  const std::string fault = fault_of(file("<node id=\"n\"><instance_node url=\"#n\"/></node>"));
  EXPECT_NE(fault.find("in a circle"), std::string::npos) << fault;
}

TEST_F(ColladaScene, BrokenReferencesNameTheLine) {
  const std::string fault = fault_of(file("\n<node><instance_geometry url=\"#none\"/></node>"));
  EXPECT_EQ(fault, "a.dae:18: '#none' names no element of this file; only '#id' is followed");
}

}  // namespace
}  // namespace meshgrade
