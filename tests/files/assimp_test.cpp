// What we read agrees with Assimp, which shares no code with our readers: over all mesh files
// of the project, the box around the vertices and the number of triangles.

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <assimp/Importer.hpp>

#include <cmath>
#include <map>
#include <optional>

#include "tests/files/files_test.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = MESHGRADE_SOURCE_DIR;

constexpr const char* kNoPlace = "a vertex lies at no place";
constexpr const char* kCutOff = "the last facet is not whole";
constexpr const char* kWords = "Assimp wants the lines of the common form";
constexpr const char* kNoVariant = "Assimp knows less of the format";
constexpr const char* kExtension = "Assimp does not know the extension";

/// Files of which Assimp 5.2 says something else, and why we are right.
const std::map<std::string, std::string> kStated = {
    {"meshes/invalid/infinite.off", kNoPlace},
    {"meshes/invalid/not_finite.obj", kNoPlace},
    {"meshes/invalid/truncated.stl", kCutOff},
    {"tests/fuzz/corpus/dae/convex_and_camera.dae", kNoVariant},
    {"tests/fuzz/corpus/dae/strips_and_lines.dae", kNoVariant},
    {"tests/fuzz/corpus/glb/sparse_empty_chunk.glb", "Assimp wants no empty chunk"},
    {"tests/fuzz/corpus/gltf/instances.gltf", kExtension},
    {"tests/fuzz/corpus/gltf/meshopt.gltf", kExtension},
    {"tests/fuzz/corpus/gltf/morph_and_lines.gltf",
     "Assimp gives the shape without its weights"},
    {"tests/fuzz/corpus/gltf/quantized.gltf", kExtension},
    {"tests/fuzz/corpus/gltf/skin.gltf", "Assimp gives the shape before its skin moves it"},
    {"tests/fuzz/corpus/obj/continued.obj", "Assimp does not know the word fo"},
    {"tests/fuzz/corpus/obj/not_finite.obj", kNoPlace},
    {"tests/fuzz/corpus/off/homogeneous.off", kWords},
    {"tests/fuzz/corpus/off/infinite.off", kNoPlace},
    {"tests/fuzz/corpus/off/one_line.off", kWords},
    {"tests/fuzz/corpus/off/utf16.off", kWords},
    {"tests/fuzz/corpus/ply/big_endian_faces_first.ply", "Assimp wants vertices before faces"},
    {"tests/fuzz/corpus/ply/faces_first.ply", "Assimp wants vertices before faces"},
    {"tests/fuzz/corpus/ply/strips_and_edges.ply", "Assimp ends at the first strip"},
    {"tests/fuzz/corpus/stl/binary_trailing.stl", "Assimp takes it for text"},
    {"tests/fuzz/corpus/stl/truncated.stl", kCutOff},
    {"tests/fuzz/corpus/stl/upper_without_end.stl", "Assimp wants small letters"},
};

struct Seen {
  std::array<Point3, 2> box{};
  std::size_t n_triangles = 0;
};

void include(const Point3& point, std::optional<Seen>& seen) {
  if (!seen) seen = Seen{{point, point}, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    seen->box[0][axis] = std::min(seen->box[0][axis], point[axis]);
    seen->box[1][axis] = std::max(seen->box[1][axis], point[axis]);
  }
}

std::optional<Seen> by_us(const fs::path& file) {
  std::optional<Seen> seen;
  try {
    const PolygonMesh mesh = read_mesh(file).mesh;
    for (const Point3& point : mesh.positions)
      include(point, seen);
    for (const auto& polygon : mesh.polygons)
      seen->n_triangles += polygon.size() - 2;
  } catch (const UserError&) {
    return std::nullopt;
  }
  return seen;
}

/// Adds what hangs on a node: the vertices that faces use, since others are no surface.
void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
              std::optional<Seen>& seen) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) continue;
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        const aiVector3D point = transform * mesh.mVertices[face.mIndices[k]];
        include({point.x, point.y, point.z}, seen);
      }
      seen->n_triangles += face.mNumIndices - 2;
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    add_node(scene, *node.mChildren[c], transform, seen);
}

std::optional<Seen> by_assimp(const fs::path& file) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  // Faces of one vertex or two become points and lines, which are no surface.
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_FindDegenerates | aiProcess_SortByPType);
  std::optional<Seen> seen;
  if (scene != nullptr && scene->mRootNode != nullptr) {
    add_node(*scene, *scene->mRootNode, aiMatrix4x4(), seen);
  }
  return seen;
}

bool is_mesh_file(const fs::path& file) {
  const std::string extension = file.extension().string();
  for (const char* known : {".obj", ".off", ".ply", ".stl", ".gltf", ".glb", ".dae"}) {
    if (extension == known) return true;
  }
  return false;
}

std::vector<fs::path> mesh_files() {
  std::vector<fs::path> files;
  for (const char* folder : {"meshes", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.is_regular_file() && is_mesh_file(entry.path())) {
        files.push_back(entry.path().lexically_relative(kRoot));
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string told(const std::optional<Seen>& seen) {
  if (!seen) return "refused, or nothing";
  std::ostringstream text;
  text << seen->n_triangles << " triangles in";
  for (const Point3& corner : seen->box) {
    for (const double x : corner)
      text << ' ' << x;
  }
  return text.str();
}

bool agree(const std::optional<Seen>& ours, const std::optional<Seen>& theirs) {
  if (!ours || !theirs) return !ours && !theirs;
  for (std::size_t corner = 0; corner < 2; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = ours->box[corner][axis];
      // Assimp works in single precision.
      if (!(std::abs(x - theirs->box[corner][axis]) <= 1e-5 * (1 + std::abs(x)))) return false;
    }
  }
  return ours->n_triangles == theirs->n_triangles;
}

TEST(Assimp, SeesTheSameInEveryMeshFileOfTheProject) {
  std::size_t n_compared = 0;
  for (const fs::path& file : mesh_files()) {
    if (kStated.contains(file.string())) continue;
    const std::optional<Seen> ours = by_us(kRoot / file);
    const std::optional<Seen> theirs = by_assimp(kRoot / file);
    EXPECT_TRUE(agree(ours, theirs))
        << file << ": ours " << told(ours) << "; theirs " << told(theirs);
    ++n_compared;
  }
  EXPECT_GT(n_compared, 60U);
}

TEST(Assimp, StatedDifferencesAreOfFilesThatAreThere) {
  for (const auto& [file, reason] : kStated)
    EXPECT_TRUE(fs::exists(kRoot / file)) << file << ": " << reason;
}

}  // namespace
}  // namespace meshgrade
