#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/files/gltf_accessor.h"
#include "grader/files/reading_notes.h"
#include "grader/files/scene.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace meshgrade {

/// How a node wants a mesh.
struct GltfPose {
  std::vector<double> morph_weights;               // of the node; empty: those of the mesh
  const std::vector<Transform>* joints = nullptr;  // of its skin, if it has one
};

/// The triangles of a mesh. Those that a skin has moved are already in the scene's space.
struct PosedMesh {
  PolygonMesh in_node;
  PolygonMesh in_scene;
};

/// Reads the meshes of a glTF model, and counts what is left out of them, each once.
class GltfMeshReader {
 public:
  /// Both must live as long as this.
  GltfMeshReader(const std::filesystem::path& file, const tinygltf::Model& model)
      : file_(file), model_(model), accessors_(file, model) {}

  /// Throws UserError at `place` if there is no such mesh.
  PosedMesh read(int mesh, const GltfPose& pose, const std::string& place);

  const GltfAccessors& accessors() const { return accessors_; }
  /// After the last mesh has been read.
  ReadingNotes notes() const;

 private:
  void read_primitive(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                      const GltfPose& pose, const std::string& place, ReadingNotes& notes,
                      PosedMesh& posed);
  std::vector<std::vector<std::uint32_t>> triangles(const tinygltf::Primitive& primitive,
                                                    std::size_t n_vertices,
                                                    const std::string& place,
                                                    ReadingNotes& notes) const;
  void apply_morphs(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                    const std::string& place, ReadingNotes& notes,
                    std::vector<Point3>& positions) const;
  void keep_used(PolygonMesh& part, int accessor);

  const std::filesystem::path& file_;
  const tinygltf::Model& model_;
  GltfAccessors accessors_;
  ReadingNotes notes_;
  std::set<int> known_;                       // meshes that have been read
  std::map<int, std::vector<bool>> is_used_;  // vertices, by accessor of positions
};

}  // namespace meshgrade
