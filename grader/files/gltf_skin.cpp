#include "grader/files/gltf_skin.h"

#include <tiny_gltf.h>

#include <tuple>

#include "grader/files/file_bytes.h"
#include "grader/files/gltf_document.h"

namespace meshgrade {
namespace {

using Path = std::filesystem::path;

constexpr int kNoParent = -1;

Transform from_columns(const double* numbers) {
  Transform transform;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c)
      transform.rows[r][c] = numbers[c * 4 + r];
  }
  return transform;
}

std::vector<int> parents_of(const tinygltf::Model& model) {
  std::vector<int> parents(model.nodes.size(), kNoParent);
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    for (const int child : model.nodes[n].children) {
      if (child >= 0 && static_cast<std::size_t>(child) < parents.size()) {
        parents[static_cast<std::size_t>(child)] = static_cast<int>(n);
      }
    }
  }
  return parents;
}

/// From a node to the scene, through all its parents.
Transform global_transform(const Path& file, const tinygltf::Model& model,
                           const std::vector<int>& parents, int node,
                           const std::string& place) {
  Transform transform;
  std::size_t depth = 0;
  for (int at = node; at != kNoParent; at = parents[static_cast<std::size_t>(at)]) {
    if (at < 0 || static_cast<std::size_t>(at) >= model.nodes.size()) {
      refuse_file(file, place,
                  "its joint is node " + std::to_string(at) + ", which is not there");
    }
    if (++depth > model.nodes.size()) refuse_file(file, place, "its joints hang in a circle");
    const auto index = static_cast<std::size_t>(at);
    transform =
        node_transform(file, model.nodes[index], gltf_place("nodes", index)) * transform;
  }
  return transform;
}

void add_weighted(Transform& sum, const Transform& transform, double weight) {
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c)
      sum.rows[r][c] += weight * transform.rows[r][c];
  }
}

/// Joints and weights of all sets, one vertex after the other: four of each for each set.
struct Influences {
  std::size_t per_vertex = 0;
  std::vector<double> joints;
  std::vector<double> weights;
};

Influences read_influences(const Path& file, const tinygltf::Primitive& primitive,
                           const GltfAccessors& accessors, std::size_t n_vertices,
                           const std::string& place) {
  std::vector<std::vector<double>> joints;
  std::vector<std::vector<double>> weights;
  for (;;) {
    const std::string set = std::to_string(joints.size());
    const auto joint = primitive.attributes.find("JOINTS_" + set);
    const auto weight = primitive.attributes.find("WEIGHTS_" + set);
    if (joint == primitive.attributes.end() || weight == primitive.attributes.end()) break;
    joints.push_back(accessors.numbers(joint->second, 4, "JOINTS_" + set, place));
    weights.push_back(accessors.numbers(weight->second, 4, "WEIGHTS_" + set, place));
    if (joints.back().size() != 4 * n_vertices || weights.back().size() != 4 * n_vertices) {
      refuse_file(file, place,
                  "JOINTS_" + set + " or WEIGHTS_" + set +
                      " has another number of vertices than POSITION");
    }
  }
  Influences influences{4 * joints.size(), {}, {}};
  for (std::size_t v = 0; v < n_vertices; ++v) {
    for (std::size_t set = 0; set < joints.size(); ++set) {
      for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) {
        influences.joints.push_back(joints[set][k]);
        influences.weights.push_back(weights[set][k]);
      }
    }
  }
  return influences;
}

/// Weights are to sum up to 1; quantised ones do so nearly. Without any, the first joint moves
/// the vertex.
Transform blended(const Path& file, const std::string& place, const Influences& influences,
                  std::size_t vertex, const std::vector<Transform>& joints) {
  Transform sum;
  sum.rows = {};
  double total = 0;
  const std::size_t begin = vertex * influences.per_vertex;
  for (std::size_t k = begin; k < begin + influences.per_vertex; ++k) {
    const double weight = influences.weights[k];
    if (weight == 0) continue;
    const auto joint = static_cast<std::size_t>(influences.joints[k]);
    if (influences.joints[k] < 0 || joint >= joints.size()) {
      refuse_file(file, place,
                  "vertex v" + std::to_string(vertex) + " follows joint " +
                      std::to_string(joint) + ", but its skin has " +
                      std::to_string(joints.size()));
    }
    add_weighted(sum, joints[joint], weight);
    total += weight;
  }
  if (total == 0) return joints.empty() ? Transform() : joints.front();
  Transform mean;
  mean.rows = {};
  add_weighted(mean, sum, 1 / total);
  return mean;
}

}  // namespace

Transform node_transform(const Path& file, const tinygltf::Node& node,
                         const std::string& place) {
  if (node.matrix.size() == 16) return from_columns(node.matrix.data());
  Transform transform;
  const auto& [t, r, s] = std::tie(node.translation, node.rotation, node.scale);
  if (t.size() == 3) transform = transform * translation({t[0], t[1], t[2]});
  if (r.size() == 4) {
    if (r[0] == 0 && r[1] == 0 && r[2] == 0 && r[3] == 0) {
      refuse_file(file, place, "its rotation is zero; a quaternion has length 1");
    }
    transform = transform * rotation(std::array<double, 4>{r[0], r[1], r[2], r[3]});
  }
  if (s.size() == 3) transform = transform * scaling({s[0], s[1], s[2]});
  return transform;
}

std::vector<Transform> joint_transforms(const Path& file, const tinygltf::Model& model,
                                        const GltfAccessors& accessors, int skin_index,
                                        const std::string& node_place) {
  if (skin_index < 0 || static_cast<std::size_t>(skin_index) >= model.skins.size()) {
    refuse_file(file, node_place, "skin " + std::to_string(skin_index) + " does not exist");
  }
  const auto& skin = model.skins[static_cast<std::size_t>(skin_index)];
  const std::string place = gltf_place("skins", static_cast<std::size_t>(skin_index));
  std::vector<double> inverse_binds;
  if (skin.inverseBindMatrices >= 0) {
    inverse_binds =
        accessors.numbers(skin.inverseBindMatrices, 16, "inverse bind matrices", place);
    if (inverse_binds.size() < 16 * skin.joints.size()) {
      refuse_file(file, place, "has fewer inverse bind matrices than joints");
    }
  }
  const std::vector<int> parents = parents_of(model);
  std::vector<Transform> transforms;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    Transform transform = global_transform(file, model, parents, skin.joints[j], place);
    if (!inverse_binds.empty()) {
      transform = transform * from_columns(inverse_binds.data() + 16 * j);
    }
    transforms.push_back(transform);
  }
  return transforms;
}

bool is_skinned(const tinygltf::Primitive& primitive) {
  return primitive.attributes.contains("JOINTS_0") &&
         primitive.attributes.contains("WEIGHTS_0");
}

bool apply_skin(const Path& file, const tinygltf::Primitive& primitive,
                const GltfAccessors& accessors, const std::vector<Transform>& joints,
                std::vector<Point3>& positions, const std::string& place) {
  const Influences influences =
      read_influences(file, primitive, accessors, positions.size(), place);
  std::size_t n_turned = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Transform transform = blended(file, place, influences, v, joints);
    positions[v] = transform(positions[v]);
    n_turned += transform.is_mirror() ? 1 : 0;
  }
  return 2 * n_turned > positions.size();
}

}  // namespace meshgrade
