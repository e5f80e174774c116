#include "grader/files/gltf_file.h"

#include <tiny_gltf.h>

#include <algorithm>

#include "grader/files/file_bytes.h"
#include "grader/files/gltf_document.h"
#include "grader/files/gltf_mesh.h"
#include "grader/files/gltf_model.h"
#include "grader/files/gltf_skin.h"
#include "grader/files/scene.h"

namespace meshgrade {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kMostInstances = 1'000'000;

/// A node that is still to be visited, with the transform of its parent.
struct Visit {
  int node;
  Transform parent;
};

class GltfSceneReader {
 public:
  GltfSceneReader(const Path& file, const tinygltf::Model& model)
      : file_(file),
        model_(model),
        meshes_(file, model),
        is_shown_(model.meshes.size(), false) {}

  LoadedMesh read() {
    const std::vector<int> roots = scene_roots();
    std::vector<bool> seen(model_.nodes.size(), false);
    std::vector<Visit> to_visit;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
      to_visit.push_back({*root, {}});
    while (!to_visit.empty()) {
      const Visit visit = to_visit.back();
      to_visit.pop_back();
      const tinygltf::Node& node = checked_node(visit.node, seen);
      const Transform transform =
          visit.parent * node_transform(file_, node, place_of(visit.node));
      if (node.mesh >= 0) add_mesh(node, visit.node, transform);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        to_visit.push_back({*child, transform});
    }
    if (model_.scenes.empty() && model_.nodes.empty()) add_all_meshes();
    return {std::move(whole_), all_notes()};
  }

 private:
  static std::string place_of(int node) { return "nodes[" + std::to_string(node) + "]"; }

  /// The nodes of the default scene; without scenes, those that hang on no other.
  std::vector<int> scene_roots() const {
    if (!model_.scenes.empty()) {
      const auto scene = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
      if (scene >= model_.scenes.size()) {
        refuse_file(file_, "scene", "scene " + std::to_string(scene) + " does not exist");
      }
      return model_.scenes[scene].nodes;
    }
    std::vector<bool> has_parent(model_.nodes.size(), false);
    for (const auto& node : model_.nodes) {
      for (const int child : node.children) {
        if (child >= 0 && static_cast<std::size_t>(child) < has_parent.size()) {
          has_parent[static_cast<std::size_t>(child)] = true;
        }
      }
    }
    std::vector<int> roots;
    for (std::size_t n = 0; n < has_parent.size(); ++n) {
      if (!has_parent[n]) roots.push_back(static_cast<int>(n));
    }
    return roots;
  }

  const tinygltf::Node& checked_node(int index, std::vector<bool>& seen) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size()) {
      refuse_file(file_, place_of(index), "this node is asked for but does not exist");
    }
    const auto n = static_cast<std::size_t>(index);
    if (seen[n]) refuse_file(file_, place_of(index), "this node hangs in the scene twice");
    seen[n] = true;
    return model_.nodes[n];
  }

  void add_mesh(const tinygltf::Node& node, int index, const Transform& transform) {
    const std::string place = place_of(index);
    GltfPose pose{node.weights, nullptr};
    std::vector<Transform> joints;
    if (node.skin >= 0) {
      joints = joint_transforms(file_, model_, meshes_.accessors(), node.skin, place);
      pose.joints = &joints;
    }
    const PosedMesh posed = meshes_.read(node.mesh, pose, place);
    is_shown_[static_cast<std::size_t>(node.mesh)] = true;
    for (const Transform& instance : instances_of(node, place))
      append_part(whole_, posed.in_node, transform * instance, file_, place);
    append_part(whole_, posed.in_scene, {}, file_, place);
  }

  /// Without a scene, a file is a shelf of meshes.
  void add_all_meshes() {
    for (std::size_t m = 0; m < model_.meshes.size(); ++m) {
      const std::string place = gltf_place("meshes", m);
      append_part(whole_, meshes_.read(static_cast<int>(m), {}, place).in_node, {}, file_,
                  place);
      is_shown_[m] = true;
    }
  }

  /// The places where EXT_mesh_gpu_instancing puts the mesh of a node; else just its own.
  std::vector<Transform> instances_of(const tinygltf::Node& node,
                                      const std::string& place) const {
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end() || !extension->second.Has("attributes")) return {{}};
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    const auto numbers = [&](const char* name, std::size_t components) {
      if (!attributes.Has(name)) return std::vector<double>();
      const tinygltf::Value& accessor = attributes.Get(name);
      return meshes_.accessors().numbers(accessor.IsNumber() ? accessor.GetNumberAsInt() : -1,
                                         components, name, place);
    };
    const std::vector<double> t = numbers("TRANSLATION", 3);
    const std::vector<double> r = numbers("ROTATION", 4);
    const std::vector<double> s = numbers("SCALE", 3);
    const std::size_t count = std::max({t.size() / 3, r.size() / 4, s.size() / 3});
    const auto fits = [&](const std::vector<double>& v, std::size_t components) {
      return v.empty() || v.size() == components * count;
    };
    if (!fits(t, 3) || !fits(r, 4) || !fits(s, 3) || count > kMostInstances) {
      refuse_file(file_, place, "its instances differ in number, or are more than a million");
    }
    std::vector<Transform> instances(count);
    for (std::size_t k = 0; k < count; ++k) {
      Transform& instance = instances[k];
      if (!t.empty()) instance = translation({t[3 * k], t[3 * k + 1], t[3 * k + 2]});
      if (!r.empty()) {
        instance = instance * rotation(std::array<double, 4>{r[4 * k], r[4 * k + 1],
                                                             r[4 * k + 2], r[4 * k + 3]});
      }
      if (!s.empty()) instance = instance * scaling({s[3 * k], s[3 * k + 1], s[3 * k + 2]});
    }
    return instances;
  }

  std::vector<std::string> all_notes() const {
    ReadingNotes notes = meshes_.notes();
    for (std::size_t m = 0; m < is_shown_.size(); ++m) {
      if (is_shown_[m]) continue;
      notes.left_out("mesh that the scene does not show", "meshes that the scene does not show",
                     gltf_place("meshes", m));
    }
    return notes.all();
  }

  const Path& file_;
  const tinygltf::Model& model_;
  GltfMeshReader meshes_;
  std::vector<bool> is_shown_;
  PolygonMesh whole_;
};

}  // namespace

LoadedMesh parse_gltf(const Path& file, const std::string& bytes) {
  const tinygltf::Model model = read_gltf_model(file, bytes);
  return GltfSceneReader(file, model).read();
}

}  // namespace meshgrade
