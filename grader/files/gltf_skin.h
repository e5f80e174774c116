#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/files/gltf_accessor.h"
#include "grader/files/scene.h"

namespace tinygltf {
class Model;
class Node;
struct Primitive;
}  // namespace tinygltf

namespace meshgrade {

/// The transform of a node against its parent. Throws UserError for a rotation of length zero.
Transform node_transform(const std::filesystem::path& file, const tinygltf::Node& node,
                         const std::string& place);

/// The skin with this index in the pose that the nodes have in the file: for each joint the
/// map from the mesh as it was bound to the scene (glTF 2.0, 3.7.3.3). The transform of the
/// node that has the skin plays no part.
std::vector<Transform> joint_transforms(const std::filesystem::path& file,
                                        const tinygltf::Model& model,
                                        const GltfAccessors& accessors, int skin,
                                        const std::string& place);

/// Whether the primitive says which joints its vertices follow.
bool is_skinned(const tinygltf::Primitive& primitive);

/// Moves each position by the mean of its joints' transforms, as weighted by the attributes
/// JOINTS_n and WEIGHTS_n. Returns whether that turns most vertices' surroundings inside out.
bool apply_skin(const std::filesystem::path& file, const tinygltf::Primitive& primitive,
                const GltfAccessors& accessors, const std::vector<Transform>& joints,
                std::vector<Point3>& positions, const std::string& place);

}  // namespace meshgrade
