// No bytes make a reader crash, hang, or fail in any way but a UserError of one line.

#include <random>
#include <sstream>

#include "grader/files/bezier_file.h"
#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

const std::filesystem::path kMeshFiles = MESHGRADE_SOURCE_DIR "/meshes";

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

class HostileFile : public FilesTest {
 protected:
  void read_anything(const std::string& extension, const std::string& bytes) {
    const auto file = write("mutant" + extension, bytes);
    try {
      if (extension == ".bez") {
        read_bez(file);
      } else if (extension == ".bzc") {
        read_bzc(file);
      } else {
        read_mesh(file);
      }
    } catch (const UserError& error) {
      const std::string message = error.what();
      ASSERT_TRUE(message.starts_with(file.string() + ":")) << message;
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }

  std::vector<std::filesystem::path> seeds() {
    std::vector<std::filesystem::path> files;
    for (const std::string name : {"tetrahedron.obj", "octahedron.off", "torus.ply", "cube.stl",
                                   "tetrahedron.glb", "quad_cube.dae", "net_3x5.bez",
                                   "arch_4.bzc", "invalid/accessor_beyond_buffer.gltf"}) {
      files.push_back(kMeshFiles / name);
    }
    const PolygonMesh cube = read_mesh(kMeshFiles / "cube.obj").mesh;
    for (const std::string name : {"binary.ply", "binary.stl", "cube.gltf", "cube.glb"}) {
      write_mesh(path(name), cube);
      files.push_back(path(name));
    }
    return files;
  }
};

TEST_F(HostileFile, CutOffAnywhereIsRefusedOrRead) {
  for (const auto& seed : seeds()) {
    const std::string bytes = bytes_of(seed);
    const std::size_t step = 1 + bytes.size() / 40;
    for (std::size_t size = 0; size < bytes.size(); size += step) {
      read_anything(seed.extension(), bytes.substr(0, size));
    }
  }
}

TEST_F(HostileFile, ChangedBytesAreRefusedOrRead) {
  std::mt19937 random(20240601);
  const std::string spice = "0123456789-+.eE#/ \n\"{}[]<>\xFF";
  for (const auto& seed : seeds()) {
    const std::string bytes = bytes_of(seed);
    for (int round = 0; round < 60; ++round) {
      std::string mutant = bytes;
      for (unsigned change = 0; change <= random() % 4; ++change) {
        const std::size_t at = random() % mutant.size();
        switch (random() % 4) {
          case 0:
            mutant[at] = static_cast<char>(random());
            break;
          case 1:
            mutant[at] = spice[random() % spice.size()];
            break;
          case 2:
            mutant.erase(at, random() % 9);
            break;
          default:
            mutant.insert(at, mutant.substr(random() % mutant.size(), random() % 9));
        }
        if (mutant.empty()) mutant = "x";
      }
      read_anything(seed.extension(), mutant);
    }
  }
}

TEST_F(HostileFile, NoiseIsRefusedOrRead) {
  std::mt19937 random(7);
  for (const std::string extension :
       {".obj", ".off", ".ply", ".stl", ".gltf", ".glb", ".dae", ".bez", ".bzc"}) {
    for (int round = 0; round < 20; ++round) {
      std::string noise(1 + random() % 300, '\0');
      for (char& c : noise)
        c = static_cast<char>(random());
      read_anything(extension, noise);
    }
  }
}

TEST_F(HostileFile, HugePromisesCostNothing) {
  // Each would take gigabytes if its counts were believed.
  read_anything(".off", "OFF\n4294967295 4294967295 0\n0 0 0\n");
  read_anything(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4294967295 0 1 2\n");
  read_anything(".ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
                "property float y\nproperty float z\nelement face 4294967295\n"
                "property list uint int vertex_indices\nend_header\n"
                "000000000000\xFF\xFF\xFF\xFF");
  read_anything(".ply",
                "ply\nformat ascii 1.0\nelement junk 4294967295\nelement vertex 0\n"
                "property float x\nproperty float y\nproperty float z\n"
                "element face 4294967295\nproperty list uchar int vertex_indices\n"
                "end_header\n");
  read_anything(".gltf", R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":)"
                         R"({"POSITION":0}}]}],"accessors":[{"componentType":5126,)"
                         R"("count":4294967295,"type":"VEC3"}]})");
}

}  // namespace
}  // namespace meshgrade
