// What glTF 2.0 and its extensions may hold besides plain triangles. Places, transforms and
// hostile numbers are in scene_test.cpp.

#include <gmock/gmock.h>

#include <cstring>
#include <nlohmann/json.hpp>

#ifdef MESHGRADE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;
using Box = std::array<Point3, 2>;

std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t bits = 0;
    for (std::size_t i = k; i < k + 3; ++i)
      bits = bits << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += k + i > bytes.size() ? '=' : digits[bits >> (18 - 6 * i) & 63U];
  }
  return text;
}

/// Numbers as bytes, each as a `Number`.
template <typename Number>
std::string packed(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double number : numbers) {
    const auto value = static_cast<Number>(number);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  return bytes;
}

const std::vector<double> kPoints = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<double> kCorners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
constexpr int kByte = 5120;
constexpr int kUnsignedByte = 5121;
constexpr int kShort = 5122;
constexpr int kUnsignedShort = 5123;
constexpr int kFloat = 5126;

class GltfFile : public FilesTest {
 protected:
  /// The tetrahedron as mesh 0 of node 0 of scene 0, its points as accessor 0, its corners
  /// as 1.
  GltfFile() {
    file = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
      "accessors": [], "bufferViews": [], "buffers": []})");
    add(packed<float>(kPoints), kFloat, 4, "VEC3");
    add(packed<std::uint16_t>(kCorners), kUnsignedShort, 12, "SCALAR");
  }

  /// A buffer of its own, a view of all of it and an accessor; returns the accessor.
  int add(const std::string& bytes, int component, std::size_t count, const std::string& type) {
    file["accessors"].push_back({{"bufferView", add_view(bytes)},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return static_cast<int>(file["accessors"].size()) - 1;
  }
  std::size_t add_view(const std::string& bytes) {
    file["bufferViews"].push_back(
        {{"buffer", file["buffers"].size()}, {"byteLength", bytes.size()}});
    file["buffers"].push_back(
        {{"byteLength", bytes.size()},
         {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
    return file["bufferViews"].size() - 1;
  }

  LoadedMesh read() const { return read_mesh(write("a.gltf", file.dump())); }
  std::string fault() const { return fault_of(write("a.gltf", file.dump())); }
  Json& primitive() { return file["meshes"][0]["primitives"][0]; }

  Json file;
};

TEST_F(GltfFile, BuffersMayBeLongerThanTheySayAndHaveParameters) {
  expect_tetrahedron(read());
  Json& buffer = file["buffers"][1];
  const std::string data = base64(packed<std::uint16_t>(kCorners) + "more");
  for (const std::string header :
       {"data:application/octet-stream;base64,",
        "data:application/octet-stream;charset=utf-8;base64,", "data:;base64,",
        "data:application/gltf-buffer;base64,", "data:image/png;base64,"}) {
    buffer["uri"] = header + data;
    expect_tetrahedron(read());
  }
  buffer["uri"] =
      "data:application/octet-stream,%00%00%02%00%01%00%00%00%01%00%03%00"
      "%01%00%02%00%03%00%02%00%00%00%03%00";
  expect_tetrahedron(read());
  buffer["uri"] = "data:;base64," + base64("short");
  EXPECT_EQ(fault(), "a.gltf:buffers[1]: promises 24 bytes and holds 5; it is cut off");
}

TEST_F(GltfFile, WholeNumbersMayHaveAPoint) {
  file["buffers"][0]["byteLength"] = 48.0;
  file["accessors"][0]["count"] = 4.0;
  file["accessors"][1]["bufferView"] = 1.0;
  primitive()["indices"] = 1.0;
  expect_tetrahedron(read());
  file["buffers"][0]["byteLength"] = 48.5;
  EXPECT_THAT(fault(), StartsWith("a.gltf:buffers[0]: has no byteLength"));
}

TEST_F(GltfFile, BuffersMayBeFilesBelowTheFolder) {
  std::filesystem::create_directory(path("my data"));
  write("my data/points.bin", packed<float>(kPoints) + "more");
  file["buffers"][0]["uri"] = "my%20data/points.bin";
  expect_tetrahedron(read());
  file["buffers"][0]["uri"] = "my data/../../points.bin";
  EXPECT_THAT(fault(), HasSubstr("does not lie in the folder"));
}

std::string glb(const std::string& json,
                const std::vector<std::pair<std::string, std::string>>& chunks) {
  std::string body;
  const auto add = [&](const std::string& kind, std::string data, char filler) {
    data.resize((data.size() + 3) / 4 * 4, filler);
    body += packed<std::uint32_t>({static_cast<double>(data.size())}) + kind + data;
  };
  add("JSON", json, ' ');
  for (const auto& [kind, data] : chunks)
    add(kind, data, '\0');
  return "glTF" + packed<std::uint32_t>({2, static_cast<double>(12 + body.size())}) + body;
}

TEST_F(GltfFile, ChunksMayBeEmptyForeignOrLonger) {
  const std::string bin("BIN\0", 4);
  expect_tetrahedron(read_mesh(write("a.glb", glb(file.dump(), {{bin, ""}}))));
  expect_tetrahedron(read_mesh(write("a.glb", glb(file.dump(), {}))));
  file["buffers"][0].erase("uri");
  expect_tetrahedron(read_mesh(write(
      "a.glb", glb(file.dump(), {{bin, packed<float>(kPoints) + "more"}, {"MINE", "x"}}))));
  expect_tetrahedron(
      read_mesh(write("named.gltf", glb(file.dump(), {{bin, packed<float>(kPoints)}}))));
  EXPECT_THAT(fault_of(write("a.glb", glb(file.dump(), {}))),
              StartsWith("a.glb:buffers[0]: has no uri"));
}

TEST_F(GltfFile, QuantizedPositionsAreRead) {
  file["extensionsUsed"] = file["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto quantized = [&](const std::string& bytes, int component, bool normalized) {
    Json& accessor = file["accessors"][0];
    accessor["bufferView"] = add_view(bytes);
    accessor["componentType"] = component;
    accessor["normalized"] = normalized;
    file["bufferViews"].back()["byteStride"] = bytes.size() / 4;
  };
  const auto scaled = [](double by) {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < kPoints.size(); ++k) {
      numbers.push_back(by * kPoints[k]);
      if (k % 3 == 2) numbers.push_back(0);  // each element fills a multiple of four bytes
    }
    return numbers;
  };
  quantized(packed<std::int16_t>(scaled(32767)), kShort, true);
  expect_tetrahedron(read());
  quantized(packed<std::uint8_t>(scaled(255)), kUnsignedByte, true);
  expect_tetrahedron(read());
  quantized(packed<std::int8_t>(scaled(127)), kByte, true);
  expect_tetrahedron(read());
  quantized(packed<std::uint16_t>(scaled(1000)), kUnsignedShort, false);
  file["nodes"][0]["scale"] = {0.001, 0.001, 0.001};
  EXPECT_NEAR(box_of(read().mesh)[1][2], 1, 1e-12);
  file.erase("extensionsUsed");
  file.erase("extensionsRequired");
  EXPECT_THAT(fault(), HasSubstr("must name the extension KHR_mesh_quantization"));
}

TEST_F(GltfFile, SparseIndicesReplaceCorners) {
  std::vector<double> wrong = kCorners;
  wrong[2] = 3;
  primitive()["indices"] = add(packed<std::uint16_t>(wrong), kUnsignedShort, 12, "SCALAR");
  const auto where = add_view(packed<std::uint8_t>({2}));
  const auto what = add_view(packed<std::uint16_t>({1}));
  file["accessors"][2]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", where}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", what}}}};
  expect_tetrahedron(read());
  // Without any data but the sparse ones, the rest is zeros.
  const auto all = add_view(packed<std::uint8_t>({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  const auto corners = add_view(packed<std::uint16_t>(kCorners));
  file["accessors"][2].erase("bufferView");
  file["accessors"][2]["sparse"]["count"] = 12;
  file["accessors"][2]["sparse"]["indices"]["bufferView"] = all;
  file["accessors"][2]["sparse"]["values"]["bufferView"] = corners;
  expect_tetrahedron(read());
}

TEST_F(GltfFile, MorphTargetsMoveByTheirWeights) {
  const int up = add(packed<float>({0, 0, 5, 0, 0, 5, 0, 0, 5, 0, 0, 5}), kFloat, 4, "VEC3");
  const int aside = add(packed<float>({2, 0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0}), kFloat, 4, "VEC3");
  primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", aside}}};
  file["meshes"][0]["weights"] = {1, 0.5};
  EXPECT_EQ(box_of(read().mesh), (Box{{{1, 0, 5}, {2, 1, 6}}}));
  EXPECT_TRUE(read().notes.empty());
  file["nodes"][0]["weights"] = {0, -1};  // a node's own weights come first
  const LoadedMesh loaded = read();
  EXPECT_EQ(box_of(loaded.mesh), (Box{{{-2, 0, 0}, {-1, 1, 1}}}));
  EXPECT_EQ(loaded.notes, (std::vector<std::string>{"left out 1 morph target of weight 0, at "
                                                    "meshes[0].primitives[0].targets[0]"}));
  file["accessors"][static_cast<std::size_t>(aside)]["count"] = 3;
  EXPECT_THAT(fault(), StartsWith("a.gltf:meshes[0].primitives[0].targets[1]: has another"));
}

TEST_F(GltfFile, SkinsFollowTheirJointsAndNotTheirNode) {
  const std::vector<double> one = {0, 0, 0, 0};
  std::vector<double> joints;
  std::vector<double> weights;
  for (int v = 0; v < 4; ++v) {
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1, 0, 0, 0});
  }
  primitive()["attributes"]["JOINTS_0"] =
      add(packed<std::uint8_t>(joints), kUnsignedByte, 4, "VEC4");
  primitive()["attributes"]["WEIGHTS_0"] = add(packed<float>(weights), kFloat, 4, "VEC4");
  file["scenes"][0]["nodes"] = {0, 1};
  file["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0, "scale": [100, 100, 100]},
    {"translation": [10, 0, 0], "children": [2]}, {"translation": [0, 20, 0]}])");
  file["skins"] = Json::parse(R"([{"joints": [1, 2]}])");
  EXPECT_EQ(box_of(read().mesh), (Box{{{10, 0, 0}, {11, 1, 1}}}));

  // Half and half between the joints at (10 0 0) and (10 20 0).
  for (std::size_t v = 0; v < 4; ++v)
    weights[4 * v] = weights[4 * v + 1] = 0.5;
  primitive()["attributes"]["WEIGHTS_0"] = add(packed<float>(weights), kFloat, 4, "VEC4");
  EXPECT_EQ(box_of(read().mesh), (Box{{{10, 10, 0}, {11, 11, 1}}}));

  // Weights as bytes, whose sum is not quite 1, and bound to joints that then stood elsewhere.
  for (double& weight : weights)
    weight *= 254;
  primitive()["attributes"]["WEIGHTS_0"] =
      add(packed<std::uint8_t>(weights), kUnsignedByte, 4, "VEC4");
  file["accessors"].back()["normalized"] = true;
  const std::vector<double> bind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -10, -10, 0, 1};
  std::vector<double> binds = bind;
  binds.insert(binds.end(), bind.begin(), bind.end());
  file["skins"][0]["inverseBindMatrices"] = add(packed<float>(binds), kFloat, 2, "MAT4");
  expect_tetrahedron(read());

  file["skins"][0]["joints"] = {1};
  EXPECT_THAT(fault(), HasSubstr("follows joint 1, but its skin has 1"));
  file["skins"][0]["joints"] = {1, 9};
  EXPECT_THAT(fault(), StartsWith("a.gltf:skins[0]: its joint is node 9"));
  file["skins"][0]["joints"] = {1, 2};
  file["nodes"][2]["children"] = {1};
  EXPECT_THAT(fault(), StartsWith("a.gltf:skins[0]: its joints hang in a circle"));
}

TEST_F(GltfFile, MirroredSkinsKeepTheirOutside) {
  primitive()["attributes"]["JOINTS_0"] =
      add(packed<std::uint8_t>(std::vector<double>(16, 0)), kUnsignedByte, 4, "VEC4");
  primitive()["attributes"]["WEIGHTS_0"] =
      add(packed<float>(std::vector<double>(16, 0.25)), kFloat, 4, "VEC4");
  file["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0}, {"scale": [-1, 1, 1]}])");
  file["skins"] = Json::parse(R"([{"joints": [1]}])");
  const PolygonMesh mesh = read().mesh;
  EXPECT_EQ(box_of(mesh), (Box{{{-1, 0, 0}, {0, 1, 1}}}));
  // The face of the points without z looks down: to -z.
  const auto& face = mesh.polygons[0];
  const Point3& a = mesh.positions[face[0]];
  const Point3& b = mesh.positions[face[1]];
  const Point3& c = mesh.positions[face[2]];
  EXPECT_LT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0);
}

TEST_F(GltfFile, InstancesAreAllPutIn) {
  const int t = add(packed<float>({0, 0, 0, 5, 0, 0}), kFloat, 2, "VEC3");
  const int s = add(packed<float>({1, 1, 1, 2, 2, 2}), kFloat, 2, "VEC3");
  file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", t},
                                                                             {"SCALE", s}};
  const LoadedMesh loaded = read();
  EXPECT_EQ(loaded.mesh.polygons.size(), 8U);
  EXPECT_EQ(box_of(loaded.mesh), (Box{{{0, 0, 0}, {7, 2, 2}}}));
}

TEST_F(GltfFile, ExtensionsThatLeaveTheShapeAloneMayBeRequired) {
  for (const std::string name :
       {"EXT_texture_webp", "KHR_texture_basisu", "KHR_texture_transform",
        "KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness", "KHR_lights_punctual",
        "MSFT_texture_dds", "VRM"}) {
    file["extensionsRequired"] = {name};
    expect_tetrahedron(read());
  }
  file["extensionsRequired"] = {"ACME_inflates"};
  EXPECT_THAT(fault(), StartsWith("a.gltf:extensionsRequired: needs the extension "
                                  "'ACME_inflates'"));
}

TEST_F(GltfFile, DracoAndOlderVersionsAreRefusedByName) {
  primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  expect_tetrahedron(read());  // the plain data are there, too
  for (std::size_t a : {0U, 1U})
    file["accessors"][a].erase("bufferView");
  EXPECT_THAT(fault(), HasSubstr("meshes[0].primitives[0]: is compressed by Draco"));
  file["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  EXPECT_THAT(fault(), HasSubstr("is compressed by Draco"));

  const std::string older = "is glTF 1.0, which is not read; export as glTF 2.0";
  EXPECT_THAT(fault_of(write("a.gltf", R"({"asset": {"version": "1.0"}, "meshes": {}})")),
              HasSubstr(older));
  EXPECT_THAT(fault_of(write("a.gltf", R"({"meshes": {"m": {}}, "scenes": {}})")),
              HasSubstr(older));
  std::string bytes = glb(file.dump(), {});
  bytes[4] = 1;
  EXPECT_THAT(fault_of(write("a.glb", bytes)), HasSubstr(older));
  EXPECT_THAT(fault_of(write("a.gltf", R"({"meshes": []})")),
              HasSubstr("does not say its version"));
}

TEST_F(GltfFile, NothingOfTheSceneGoesWithoutAWord) {
  file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 3}});
  file["meshes"].push_back(file["meshes"][0]);
  expect_tetrahedron(read(), {"left out 1 primitive of points, at meshes[0].primitives[1]",
                              "left out 2 primitives of lines, the first at "
                              "meshes[0].primitives[2]",
                              "left out 1 mesh that the scene does not show, at meshes[1]"});
}

TEST_F(GltfFile, PrimitivesMayShareTheirPositions) {
  // One face each, and a point of no face.
  std::vector<double> points = kPoints;
  points.insert(points.end(), {9, 9, 9});
  file["meshes"][0]["primitives"] = Json::array();
  const int shared = add(packed<float>(points), kFloat, 5, "VEC3");
  for (std::size_t f = 0; f < 4; ++f) {
    const std::vector<double> face(kCorners.begin() + static_cast<std::ptrdiff_t>(3 * f),
                                   kCorners.begin() + static_cast<std::ptrdiff_t>(3 * f + 3));
    const int corners = add(packed<std::uint16_t>(face), kUnsignedShort, 3, "SCALAR");
    file["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", shared}}}, {"indices", corners}});
  }
  expect_tetrahedron(read(), {"left out 1 vertex that belongs to no face",
                              "welded 12 corners into 4 vertices"});
}

TEST_F(GltfFile, FacesWithoutAreaAreLeftOutWithTheirNumber) {
  std::vector<double> corners = kCorners;
  corners.insert(corners.end(), {1, 1, 2});
  primitive()["indices"] = add(packed<std::uint16_t>(corners), kUnsignedShort, 15, "SCALAR");
  expect_tetrahedron(read(), {"left out 1 face without area (a corner twice), at "
                              "meshes[0].primitives[0]"});
  // Two vertices at one point are one after welding.
  std::vector<double> points = kPoints;
  points.insert(points.end(), {1, 0, 0});
  primitive()["attributes"]["POSITION"] = add(packed<float>(points), kFloat, 5, "VEC3");
  corners = kCorners;
  corners.insert(corners.end(), {1, 4, 2});
  primitive()["indices"] = add(packed<std::uint16_t>(corners), kUnsignedShort, 15, "SCALAR");
  expect_tetrahedron(read(), {"left out 1 face without area (a corner twice)",
                              "welded 15 corners into 4 vertices"});
}

TEST_F(GltfFile, ASceneLessFileShowsItsNodes) {
  file.erase("scene");
  file.erase("scenes");
  file["nodes"] = Json::parse(R"([{"mesh": 0}, {"children": [0], "translation": [5, 0, 0]}])");
  EXPECT_EQ(box_of(read().mesh), (Box{{{5, 0, 0}, {6, 1, 1}}}));
  file.erase("nodes");
  expect_tetrahedron(read());
}

#ifdef MESHGRADE_MESHOPTIMIZER

class MeshoptFile : public GltfFile {
 protected:
  /// Puts compressed data in place of what a view holds, whose buffer is not there any more.
  void compress(std::size_t view, const std::string& mode, std::size_t count,
                std::size_t stride, const std::string& data, const std::string& name) {
    const std::size_t raw = add_view(data);
    file["extensionsUsed"] = file["extensionsRequired"] = {name};
    Json& buffer = file["buffers"][view];
    buffer.erase("uri");
    buffer["extensions"][name]["fallback"] = true;
    file["bufferViews"][view]["extensions"][name] = {
        {"buffer", file["bufferViews"][raw]["buffer"]},
        {"byteLength", data.size()},
        {"byteStride", stride},
        {"count", count},
        {"mode", mode}};
  }
  Json& extension(std::size_t view) { return *file["bufferViews"][view]["extensions"].begin(); }
};

std::string encoded_points() {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
  const std::string points = packed<float>(kPoints);
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), points.data(), 4, 12));
  return {bytes.begin(), bytes.end()};
}

std::string encoded_corners(bool as_triangles) {
  const std::vector<unsigned int> corners(kCorners.begin(), kCorners.end());
  std::vector<unsigned char> bytes(as_triangles
                                       ? meshopt_encodeIndexBufferBound(corners.size(), 4)
                                       : meshopt_encodeIndexSequenceBound(corners.size(), 4));
  bytes.resize(as_triangles ? meshopt_encodeIndexBuffer(bytes.data(), bytes.size(),
                                                        corners.data(), corners.size())
                            : meshopt_encodeIndexSequence(bytes.data(), bytes.size(),
                                                          corners.data(), corners.size()));
  return {bytes.begin(), bytes.end()};
}

TEST_F(MeshoptFile, CompressedDataAreDecoded) {
  for (const std::string name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    compress(0, "ATTRIBUTES", 4, 12, encoded_points(), name);
    compress(1, "TRIANGLES", 12, 2, encoded_corners(true), name);
    expect_tetrahedron(read());
    compress(1, "INDICES", 12, 2, encoded_corners(false), name);
    expect_tetrahedron(read());
    file["bufferViews"][0].erase("extensions");
    file["bufferViews"][1].erase("extensions");
  }
}

TEST_F(MeshoptFile, ExponentialFilterIsUndone) {
  std::vector<unsigned char> filtered(48);
  const std::vector<float> points(kPoints.begin(), kPoints.end());
#if MESHOPTIMIZER_VERSION >= 190  // the function was experimental, and got one argument more
  meshopt_encodeFilterExp(filtered.data(), 4, 12, 15, points.data(), meshopt_EncodeExpSeparate);
#else
  meshopt_encodeFilterExp(filtered.data(), 4, 12, 15, points.data());
#endif
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), filtered.data(), 4, 12));
  compress(0, "ATTRIBUTES", 4, 12, {bytes.begin(), bytes.end()}, "EXT_meshopt_compression");
  extension(0)["filter"] = "EXPONENTIAL";
  expect_tetrahedron(read());
  extension(0)["filter"] = "SOAP";
  EXPECT_THAT(fault(), StartsWith("a.gltf:bufferViews[0]: its filter 'SOAP' is not known"));
}

TEST_F(MeshoptFile, HostileSizesAreRefused) {
  compress(0, "ATTRIBUTES", 4, 12, encoded_points(), "EXT_meshopt_compression");
  const Json good = file;
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, Json>>{{"buffer", 99},
                                                 {"byteOffset", 5000},
                                                 {"byteLength", 4294967295},
                                                 {"byteLength", 3},
                                                 {"count", 4294967295},
                                                 {"byteStride", 0},
                                                 {"byteStride", 13},
                                                 {"byteStride", 260},
                                                 {"mode", "TRIANGLES"},
                                                 {"mode", 7},
                                                 {"count", "x"},
                                                 {"count", 900}}) {
    file = good;
    extension(0)[name] = value;
    EXPECT_THAT(fault(), StartsWith("a.gltf:bufferViews[0]: ")) << name << " = " << value;
  }
}

#endif

}  // namespace
}  // namespace meshgrade
