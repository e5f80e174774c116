#include "grader/files/gltf_accessor.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

template <typename Number>
double number_at(const unsigned char* data) {
  Number number;
  std::memcpy(&number, data, sizeof(number));
  return static_cast<double>(number);
}

double component_at(const unsigned char* data, int component) {
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return number_at<std::int8_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_at<std::uint8_t>(data);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return number_at<std::int16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_at<std::uint16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_at<std::uint32_t>(data);
    default:
      return number_at<float>(data);
  }
}

/// In bytes; 0 for a type that glTF does not have.
std::size_t component_size(int component) {
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

bool is_unsigned(int component) {
  return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::size_t components_of(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;
  }
}

/// glTF 2.0, 3.6.2.2: the largest whole number stands for 1.
void normalize(std::vector<double>& values, int component) {
  double largest = 0;
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      largest = std::numeric_limits<std::int8_t>::max();
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      largest = std::numeric_limits<std::uint8_t>::max();
      break;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      largest = std::numeric_limits<std::int16_t>::max();
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      largest = std::numeric_limits<std::uint16_t>::max();
      break;
    default:
      return;
  }
  for (double& value : values)
    value = std::max(value / largest, -1.0);
}

}  // namespace

GltfAccessors::GltfAccessors(const std::filesystem::path& file, const tinygltf::Model& model)
    : file_(file), model_(model) {
  for (const auto* names : {&model.extensionsUsed, &model.extensionsRequired}) {
    has_quantization_ |=
        std::find(names->begin(), names->end(), "KHR_mesh_quantization") != names->end();
  }
}

std::vector<Point3> GltfAccessors::positions(int index, const std::string& place) const {
  const std::vector<double> values = numbers(index, 3, "positions", place);
  const int component = checked_accessor(index, place).componentType;
  if (component != TINYGLTF_COMPONENT_TYPE_FLOAT && !has_quantization_) {
    refuse_file(file_, place,
                "positions must be floats; for others, the file must name the extension "
                "KHR_mesh_quantization");
  }
  std::vector<Point3> points(values.size() / 3);
  for (std::size_t v = 0; v < points.size(); ++v) {
    points[v] = {values[3 * v], values[3 * v + 1], values[3 * v + 2]};
    if (std::isfinite(points[v][0]) && std::isfinite(points[v][1]) &&
        std::isfinite(points[v][2])) {
      continue;
    }
    refuse_file(
        file_, place,
        "vertex v" + std::to_string(v) + " has a coordinate that is not a finite number");
  }
  return points;
}

std::vector<std::uint32_t> GltfAccessors::indices(int index, const std::string& place) const {
  const auto& accessor = checked_accessor(index, place);
  if (accessor.type != TINYGLTF_TYPE_SCALAR || !is_unsigned(accessor.componentType)) {
    refuse_file(file_, place, "indices must be unsigned whole numbers, one each");
  }
  const std::vector<double> values = elements(accessor, place);
  return {values.begin(), values.end()};
}

std::vector<double> GltfAccessors::numbers(int index, std::size_t components,
                                           const std::string& what,
                                           const std::string& place) const {
  const auto& accessor = checked_accessor(index, place);
  if (components_of(accessor.type) != components) {
    refuse_file(file_, place,
                what + " must be " + std::to_string(components) + " numbers each");
  }
  std::vector<double> values = elements(accessor, place);
  if (accessor.normalized) normalize(values, accessor.componentType);
  return values;
}

const tinygltf::Accessor& GltfAccessors::checked_accessor(int index,
                                                          const std::string& place) const {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) {
    refuse_file(file_, place, "accessor " + std::to_string(index) + " does not exist");
  }
  return model_.accessors[static_cast<std::size_t>(index)];
}

const unsigned char* GltfAccessors::checked_data(int view_index, std::size_t offset,
                                                 std::size_t count, std::size_t size,
                                                 std::size_t& stride,
                                                 const std::string& place) const {
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size()) {
    refuse_file(file_, place, "bufferView " + std::to_string(view_index) + " does not exist");
  }
  const auto& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size()) {
    refuse_file(file_, place, "buffer " + std::to_string(view.buffer) + " does not exist");
  }
  const auto& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
  stride = view.byteStride == 0 ? size : view.byteStride;
  const bool view_fits =
      view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
  const bool elements_fit =
      count == 0 || (offset <= view.byteLength && size <= view.byteLength - offset &&
                     stride >= size && count - 1 <= (view.byteLength - offset - size) / stride);
  if (!view_fits || !elements_fit) {
    refuse_file(file_, place, "its data reach beyond the end of the buffer");
  }
  return data.data() + view.byteOffset + offset;
}

std::vector<double> GltfAccessors::stored(int view, std::size_t offset, std::size_t count,
                                          int component, std::size_t components,
                                          const std::string& place) const {
  const std::size_t size = component_size(component);
  if (size == 0 || components == 0) {
    refuse_file(file_, place,
                "its accessor has a type of numbers that glTF does not have here");
  }
  std::size_t stride = 0;
  const unsigned char* data =
      checked_data(view, offset, count, size * components, stride, place);
  std::vector<double> values(count * components);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t c = 0; c < components; ++c)
      values[k * components + c] = component_at(data + k * stride + c * size, component);
  }
  return values;
}

/// An accessor without a view is all zeros; a sparse one replaces some elements.
std::vector<double> GltfAccessors::elements(const tinygltf::Accessor& accessor,
                                            const std::string& place) const {
  const std::size_t components = components_of(accessor.type);
  if (accessor.bufferView < 0 && accessor.count > kMostUnstoredElements) {
    refuse_file(file_, place, "has a million elements and no data");
  }
  std::vector<double> values =
      accessor.bufferView < 0 ? std::vector<double>(accessor.count * components)
                              : stored(accessor.bufferView, accessor.byteOffset, accessor.count,
                                       accessor.componentType, components, place);
  if (accessor.sparse.isSparse) replace_sparse(accessor, components, values, place);
  return values;
}

void GltfAccessors::replace_sparse(const tinygltf::Accessor& accessor, std::size_t components,
                                   std::vector<double>& values,
                                   const std::string& place) const {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    refuse_file(file_, place, "has a negative size in its sparse part");
  }
  if (!is_unsigned(sparse.indices.componentType)) {
    refuse_file(file_, place, "the indices of its sparse part must be unsigned whole numbers");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::vector<double> where =
      stored(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
             count, sparse.indices.componentType, 1, place);
  const std::vector<double> what =
      stored(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
             count, accessor.componentType, components, place);
  for (std::size_t k = 0; k < count; ++k) {
    const auto element = static_cast<std::size_t>(where[k]);
    if (element >= accessor.count) {
      refuse_file(file_, place,
                  "replaces element " + std::to_string(element) + " of " +
                      std::to_string(accessor.count));
    }
    std::copy_n(what.begin() + static_cast<std::ptrdiff_t>(k * components), components,
                values.begin() + static_cast<std::ptrdiff_t>(element * components));
  }
}

}  // namespace meshgrade
