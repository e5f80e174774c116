#include "grader/files/mesh_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

using MeshFile = FilesTest;

const std::string kMeshes = MESHGRADE_SOURCE_DIR "/meshes/";

/// The corners of all faces as points: what every format keeps, however it numbers vertices.
std::vector<Point3> corner_points(const PolygonMesh& mesh, bool as_floats) {
  std::vector<Point3> points;
  for (const auto& polygon : mesh.polygons) {
    for (const std::uint32_t v : polygon) {
      Point3 point = mesh.positions[v];
      for (double& x : point)
        x = as_floats ? static_cast<float>(x) : x;
      points.push_back(point);
    }
  }
  return points;
}

TEST_F(MeshFile, EveryFormatGivesTheSameSurfaceBack) {
  for (const std::string extension :
       {".obj", ".off", ".ply", ".stl", ".gltf", ".glb", ".dae", ".OBJ"}) {
    for (const std::string name : {"icosahedron.obj", "grid_hole.off", "double_torus.obj"}) {
      SCOPED_TRACE(name + " as " + extension);
      const PolygonMesh mesh = read_mesh(kMeshes + name).mesh;
      write_mesh(path("copy" + extension), mesh);
      const PolygonMesh copy = read_mesh(path("copy" + extension)).mesh;
      EXPECT_EQ(copy.positions.size(), mesh.positions.size());
      EXPECT_EQ(copy.polygons.size(), mesh.polygons.size());
      const bool as_floats = extension != ".dae";
      EXPECT_EQ(corner_points(copy, as_floats), corner_points(mesh, as_floats));
    }
  }
}

TEST_F(MeshFile, FacesThatAreNoManifoldAreKept) {
  for (const std::string name :
       {"three_faces_on_an_edge.obj", "bow_tie.obj", "moebius_strip.obj"}) {
    const PolygonMesh mesh = read_mesh(kMeshes + "invalid/" + name).mesh;
    for (const std::string extension : {".obj", ".off", ".ply", ".glb", ".dae"}) {
      write_mesh(path("copy" + extension), mesh);
      EXPECT_EQ(read_mesh(path("copy" + extension)).mesh.polygons.size(), mesh.polygons.size())
          << name << " as " << extension;
    }
  }
}

TEST_F(MeshFile, CoordinatesAreReadInDouble) {
  const double third = 1.0 / 3;
  const auto obj = write("a.obj", "v 0.33333333333333331 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read_mesh(obj).mesh.positions[0][0], third);
  const auto off =
      write("a.off", "OFF\n3 1 0\n0.33333333333333331 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(read_mesh(off).mesh.positions[0][0], third);
}

TEST_F(MeshFile, StlAndGltfAreWeldedAndSaySo) {
  const LoadedMesh stl = read_mesh(kMeshes + "cube.stl");
  EXPECT_EQ(stl.mesh.positions.size(), 8U);
  EXPECT_EQ(stl.notes, std::vector<std::string>{"welded 36 corners into 8 vertices"});

  PolygonMesh split;
  const PolygonMesh cube = read_mesh(kMeshes + "cube.obj").mesh;
  for (const auto& polygon : cube.polygons) {
    const auto first = static_cast<std::uint32_t>(split.positions.size());
    for (const std::uint32_t v : polygon)
      split.positions.push_back(cube.positions[v]);
    split.polygons.push_back({first, first + 1, first + 2});
  }
  write_mesh(path("split.glb"), split);
  const LoadedMesh glb = read_mesh(path("split.glb"));
  EXPECT_EQ(glb.mesh.positions.size(), 8U);
  EXPECT_EQ(glb.notes, std::vector<std::string>{"welded 36 corners into 8 vertices"});

  write_mesh(path("split.obj"), split);
  const LoadedMesh obj = read_mesh(path("split.obj"));
  EXPECT_EQ(obj.mesh.positions.size(), 36U) << "OBJ can share corners: what is split stays so";
  EXPECT_TRUE(obj.notes.empty());
}

TEST_F(MeshFile, ObjIndicesMayBeNegativeAheadOrWithTextures) {
  const auto file = write("a.obj",
                          "# comment\nmtllib /dev/zero\nvt 0 0\nf 1/1 2/1 3/1\nv 0 0 0\n"
                          "v +1 0 0\nv 0 1e0 0 # end\nv 0 0 1\nusemtl red\nf -4//1 -2 -1\n");
  const PolygonMesh mesh = read_mesh(file).mesh;
  ASSERT_EQ(mesh.polygons.size(), 2U);
  EXPECT_EQ(mesh.polygons[0], (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.polygons[1], (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST_F(MeshFile, ObjMayBeginWithAByteOrderMarkAndJoinLines) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const LoadedMesh marked =
      read_mesh(write("mark.obj", "\xEF\xBB\xBF" + corners + "f 1 2 3\n"));
  EXPECT_EQ(marked.mesh.positions.size(), 3U);
  const LoadedMesh joined =
      read_mesh(write("joined.obj", "# C:\\temp\\\n" + corners + "f 1 \\\r\n 2 \\\n3\n"));
  EXPECT_EQ(joined.mesh.positions.size(), 3U) << "a comment ends with its line";
  EXPECT_EQ(joined.mesh.polygons, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
  EXPECT_THAT(fault_of(write("wrong.obj", corners + "f 1 \\\n2 3\nf 1 2 9\n")),
              testing::StartsWith("wrong.obj:6: "))
      << "the lines after it keep their numbers";
}

TEST_F(MeshFile, PlyIsReadInEveryEncodingWithItsOtherProperties) {
  const std::string elements =
      "element vertex 3\nproperty float x\nproperty uchar red\nproperty double y\n"
      "property float z\nproperty list uchar short extra\nelement face 1\nproperty int id\n"
      "property list uint ushort vertex_index\nelement edge 1\nproperty int a\nend_header\n";
  const auto check = [&](const std::string& format, const std::string& body) {
    const PolygonMesh mesh =
        read_mesh(write("a.ply", "ply\nformat " + format + " 1.0\n" + elements + body)).mesh;
    EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}}))
        << format;
    ASSERT_EQ(mesh.polygons.size(), 1U);
    EXPECT_EQ(mesh.polygons[0], (std::vector<std::uint32_t>{0, 1, 2})) << format;
  };
  check("ascii", "0 9 0 0 0\n1 9 0 0 2 5 6\n0 9 0.1 0 0\n77 3 0 1 2\n1\n");
  for (const bool is_big : {false, true}) {
    std::string body;
    const auto put = [&](auto number) {
      char raw[sizeof(number)];
      std::memcpy(raw, &number, sizeof(number));
      if (is_big) std::reverse(raw, raw + sizeof(number));
      body.append(raw, sizeof(number));
    };
    for (const auto& [x, y] : {std::pair(0.F, 0.0), std::pair(1.F, 0.0), std::pair(0.F, 0.1)}) {
      put(x);
      put(std::uint8_t{9});
      put(y);
      put(0.F);
      put(std::uint8_t{1});
      put(std::int16_t{5});
    }
    put(std::int32_t{77});
    put(std::uint32_t{3});
    for (const int v : {0, 1, 2})
      put(static_cast<std::uint16_t>(v));
    check(is_big ? "binary_big_endian" : "binary_little_endian", body);
  }
}

TEST_F(MeshFile, UnknownFormatsAreRefusedWithTheKnownOnes) {
  EXPECT_EQ(fault_of(path("a.xyz")),
            "a.xyz: unknown mesh format '.xyz'; known are .obj .off .ply .stl .gltf .glb .dae");
}

TEST_F(MeshFile, AFolderIsCalledOneWhateverItsName) {
  std::filesystem::create_directory(path("meshes"));
  EXPECT_EQ(fault_of(path("meshes")), "meshes: is a folder; name a file in it");
}

TEST_F(MeshFile, DamagedGltfIsToldInAFewWords) {
  EXPECT_EQ(fault_of(write("cut.glb", "glTF\x02")),
            "cut.glb:byte 5: the file ends within its header; it is cut off");
  const std::string told =  // the parser repeats what it has read
      fault_of(write("long.gltf", "{\"asset\": {\"" + std::string(5000, 'x') + "\n"));
  EXPECT_THAT(told, testing::HasSubstr("is not a valid glTF file: "));
  EXPECT_LT(told.size(), 400U);
}

TEST_F(MeshFile, MissingFilesFoldersAndEmptyFilesAreToldApart) {
  EXPECT_EQ(fault_of(path("none.obj")), "none.obj: no such file; check the path");
  std::filesystem::create_directory(path("folder.obj"));
  EXPECT_EQ(fault_of(path("folder.obj")), "folder.obj: is a folder; name a file in it");
  EXPECT_EQ(fault_of(write("empty.ply", "")),
            "empty.ply: is empty; export or download it again");
}

TEST_F(MeshFile, WritingLeavesNothingHalfDone) {
  const PolygonMesh quads = read_mesh(kMeshes + "quad_cube.dae").mesh;
  write("cube.stl", "precious");
  EXPECT_THROW(write_mesh(path("cube.stl"), quads), UserError);
  EXPECT_THROW(write_mesh(path("no/such/folder.obj"), quads), UserError);
  PolygonMesh infinite = quads;
  infinite.positions[3][1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write_mesh(path("cube.obj"), infinite), UserError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  EXPECT_EQ(std::filesystem::file_size(path("cube.stl")), 8U);
}

}  // namespace
}  // namespace meshgrade
