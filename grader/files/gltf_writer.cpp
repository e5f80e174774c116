#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <sstream>

#include "grader/files/file_bytes.h"
#include "grader/files/gltf_file.h"

namespace meshgrade {
namespace {

/// Puts the raw numbers into the buffer and returns the index of their new view.
template <typename Number>
int add_view(tinygltf::Model& model, const std::vector<Number>& numbers, int target) {
  auto& data = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = numbers.size() * sizeof(Number);
  view.target = target;
  data.resize(data.size() + view.byteLength);
  std::memcpy(data.data() + view.byteOffset, numbers.data(), view.byteLength);
  model.bufferViews.push_back(view);
  return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_positions(tinygltf::Model& model, const PolygonMesh& mesh) {
  std::vector<float> numbers;
  tinygltf::Accessor accessor;
  accessor.minValues.assign(3, std::numeric_limits<double>::max());
  accessor.maxValues.assign(3, std::numeric_limits<double>::lowest());
  for (const Point3& point : mesh.positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto number = static_cast<float>(point[axis]);
      numbers.push_back(number);
      accessor.minValues[axis] = std::min<double>(accessor.minValues[axis], number);
      accessor.maxValues[axis] = std::max<double>(accessor.maxValues[axis], number);
    }
  }
  accessor.bufferView = add_view(model, numbers, TINYGLTF_TARGET_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = TINYGLTF_TYPE_VEC3;
  accessor.count = mesh.positions.size();
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

int add_indices(tinygltf::Model& model, const PolygonMesh& mesh) {
  std::vector<std::uint32_t> numbers;
  for (const auto& polygon : mesh.polygons) {
    numbers.insert(numbers.end(), polygon.begin(), polygon.end());
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(model, numbers, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.count = numbers.size();
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

}  // namespace

std::string format_gltf(const PolygonMesh& mesh, bool as_binary) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "meshgrade";
  model.buffers.emplace_back();
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.attributes["POSITION"] = add_positions(model, mesh);
  primitive.indices = add_indices(model, mesh);
  model.meshes.emplace_back();
  model.meshes[0].primitives.push_back(primitive);
  model.nodes.emplace_back();
  model.nodes[0].mesh = 0;
  model.scenes.emplace_back();
  model.scenes[0].nodes.push_back(0);
  model.defaultScene = 0;

  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, stream, !as_binary, as_binary)) {
    refuse_file("glTF", "", "the mesh could not be encoded");
  }
  return std::move(stream).str();
}

}  // namespace meshgrade
