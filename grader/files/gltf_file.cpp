#include "grader/files/gltf_file.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

#include "grader/files/file_bytes.h"
#include "grader/files/scene.h"

namespace meshgrade {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kDeepestNesting = 200;
constexpr std::size_t kLongestError = 300;
constexpr std::size_t kMostUnstoredElements = 1'000'000;

/// tinygltf walks nested JSON by recursion.
void refuse_deep_nesting(const Path& file, std::string_view json) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const char c = json[k];
    if (in_string) {
      if (c == '\\') ++k;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if ((c == '}' || c == ']') && depth > 0) --depth;
    if (depth > kDeepestNesting) {
      refuse_file(file, "byte " + std::to_string(k), "the JSON is nested too deeply");
    }
  }
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

/// The JSON of a .glb. tinygltf does not count the eight bytes in front of the binary chunk and
/// would read past its end.
std::string_view checked_glb_json(const Path& file, const std::string& bytes) {
  constexpr std::size_t kJsonBegin = 20;
  if (bytes.compare(0, 4, "glTF") != 0) {
    refuse_file(file, "byte 0", "is not a binary glTF file (it does not start with glTF)");
  }
  if (bytes.size() < kJsonBegin) {
    refuse_file(file, "byte " + std::to_string(bytes.size()),
                "the file ends within its header; it is cut off");
  }
  const std::size_t total = word_at(bytes, 8);
  const std::size_t json_end = kJsonBegin + word_at(bytes, 12);
  if (total > bytes.size() || json_end > total) {
    refuse_file(file, "byte " + std::to_string(bytes.size()),
                "the file is shorter than its header says; it is cut off");
  }
  if (json_end < total &&
      (json_end + 8 > total || json_end + 8 + word_at(bytes, json_end) > total)) {
    refuse_file(file, "byte " + std::to_string(json_end),
                "the binary chunk is longer than the file; it is cut off");
  }
  return std::string_view(bytes).substr(kJsonBegin, json_end - kJsonBegin);
}

/// Only plain files in the folder of the glTF file are read.
bool read_neighbour(std::vector<unsigned char>* out, std::string* error,
                    const std::string& name, void* gltf_file) {
  const Path folder = static_cast<const Path*>(gltf_file)->parent_path();
  std::error_code failed;
  const Path wanted = std::filesystem::weakly_canonical(name, failed);
  if (failed || wanted.parent_path() !=
                    std::filesystem::weakly_canonical(folder.empty() ? "." : folder, failed)) {
    *error = "only files in the same folder are read";
    return false;
  }
  const std::string bytes = read_bytes(wanted);
  out->assign(bytes.begin(), bytes.end());
  return true;
}

/// Images play no part in a mesh.
bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int,
                const unsigned char*, int, void*) {
  return true;
}

tinygltf::Model parse_model(const Path& file, const std::string& bytes) {
  const bool is_glb = bytes.starts_with("glTF") || lower_extension(file) == ".glb";
  refuse_deep_nesting(file, is_glb ? checked_glb_json(file, bytes) : bytes);

  tinygltf::TinyGLTF loader;
  Path path = file;
  loader.SetImageLoader(skip_image, nullptr);
  tinygltf::FsCallbacks callbacks{};  // by name: later versions have more of them
  callbacks.FileExists = tinygltf::FileExists;
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = read_neighbour;
  callbacks.user_data = &path;
  loader.SetFsCallbacks(callbacks);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string folder = file.parent_path().empty() ? "." : file.parent_path().string();
  const auto size = static_cast<unsigned int>(bytes.size());
  bool ok = false;
  try {
    ok = is_glb
             ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(bytes.data()),
                                           size, folder)
             : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder);
  } catch (const std::exception& fault) {
    error = fault.what();
  }
  if (!ok) {
    // The parser may repeat the file, which may be one line, in what it says.
    std::string first_line = error.substr(0, error.find('\n'));
    if (first_line.size() > kLongestError)
      first_line.replace(kLongestError, first_line.npos, "...");
    refuse_file(file, "", "is not a valid glTF file: " + first_line);
  }
  return model;
}

void refuse_extensions(const Path& file, const tinygltf::Model& model) {
  for (const std::string& name : model.extensionsRequired) {
    if (name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_") ||
        name.starts_with("KHR_lights_")) {
      continue;
    }
    refuse_file(file, "extensionsRequired",
                "needs " + in_quotes(name) + ", which is not read; export without compression");
  }
}

/// Reads numbers of a glTF model, with every index and size checked.
class AccessorReader {
 public:
  AccessorReader(const Path& file, const tinygltf::Model& model) : file_(file), model_(model) {}

  std::vector<Point3> positions(int accessor_index, const std::string& place) const {
    const auto& accessor = checked_accessor(accessor_index, place);
    if (accessor.type != TINYGLTF_TYPE_VEC3 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      refuse_file(file_, place, "positions must be three floats each");
    }
    std::vector<std::array<float, 3>> floats = elements<std::array<float, 3>>(accessor, place);
    std::vector<Point3> points;
    points.reserve(floats.size());
    for (const auto& [x, y, z] : floats) {
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
        refuse_file(file_, place,
                    "vertex v" + std::to_string(points.size()) +
                        " has a coordinate that is not a finite number");
      }
      points.push_back({x, y, z});
    }
    return points;
  }

  std::vector<std::uint32_t> indices(int accessor_index, const std::string& place) const {
    const auto& accessor = checked_accessor(accessor_index, place);
    if (accessor.type != TINYGLTF_TYPE_SCALAR)
      refuse_file(file_, place, "indices must be scalar");
    return accessor_integers(accessor, place);
  }

 private:
  /// Where the elements of an accessor lie.
  struct Span {
    const unsigned char* begin = nullptr;
    std::size_t stride = 0;
  };

  const tinygltf::Accessor& checked_accessor(int index, const std::string& place) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) {
      refuse_file(file_, place, "accessor " + std::to_string(index) + " does not exist");
    }
    return model_.accessors[static_cast<std::size_t>(index)];
  }

  Span span(int view_index, std::size_t offset, std::size_t count, std::size_t size,
            const std::string& place) const {
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size()) {
      refuse_file(file_, place, "bufferView " + std::to_string(view_index) + " does not exist");
    }
    const auto& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size()) {
      refuse_file(file_, place, "buffer " + std::to_string(view.buffer) + " does not exist");
    }
    const auto& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    const bool view_fits =
        view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
    const bool elements_fit =
        count == 0 || (offset <= view.byteLength && size <= view.byteLength - offset &&
                       count - 1 <= (view.byteLength - offset - size) / stride);
    if (!view_fits || !elements_fit || stride < size) {
      refuse_file(file_, place, "its data reach beyond the end of the buffer");
    }
    return {data.data() + view.byteOffset + offset, stride};
  }

  template <typename Element>
  std::vector<Element> stored(int view, std::size_t offset, std::size_t count,
                              const std::string& place) const {
    const Span data = span(view, offset, count, sizeof(Element), place);
    std::vector<Element> values(count);
    for (std::size_t k = 0; k < count; ++k) {
      std::memcpy(&values[k], data.begin + k * data.stride, sizeof(Element));
    }
    return values;
  }

  std::vector<std::uint32_t> integers(int view, std::size_t offset, std::size_t count,
                                      int component, const std::string& place) const {
    const auto widened = [](const auto& values) {
      return std::vector<std::uint32_t>(values.begin(), values.end());
    };
    switch (component) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return widened(stored<std::uint8_t>(view, offset, count, place));
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return widened(stored<std::uint16_t>(view, offset, count, place));
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return stored<std::uint32_t>(view, offset, count, place);
      default:
        refuse_file(file_, place, "indices must be unsigned whole numbers");
    }
  }

  std::vector<std::uint32_t> accessor_integers(const tinygltf::Accessor& accessor,
                                               const std::string& place) const {
    if (accessor.sparse.isSparse) refuse_file(file_, place, "sparse indices are not read");
    return integers(accessor.bufferView, accessor.byteOffset, accessor.count,
                    accessor.componentType, place);
  }

  /// An accessor without a view is all zeros; a sparse one replaces some elements.
  template <typename Element>
  std::vector<Element> elements(const tinygltf::Accessor& accessor,
                                const std::string& place) const {
    if (accessor.bufferView < 0 && accessor.count > kMostUnstoredElements) {
      refuse_file(file_, place, "has a million elements and no data");
    }
    std::vector<Element> values =
        accessor.bufferView < 0
            ? std::vector<Element>(accessor.count)
            : stored<Element>(accessor.bufferView, accessor.byteOffset, accessor.count, place);
    if (!accessor.sparse.isSparse) return values;

    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
      refuse_file(file_, place, "has a negative size in its sparse part");
    }
    const auto count = static_cast<std::size_t>(sparse.count);
    const auto where =
        integers(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                 count, sparse.indices.componentType, place);
    const auto what =
        stored<Element>(sparse.values.bufferView,
                        static_cast<std::size_t>(sparse.values.byteOffset), count, place);
    for (std::size_t k = 0; k < count; ++k) {
      if (where[k] >= values.size()) {
        refuse_file(file_, place,
                    "replaces element " + std::to_string(where[k]) + " of " +
                        std::to_string(values.size()));
      }
      values[where[k]] = what[k];
    }
    return values;
  }

  const Path& file_;
  const tinygltf::Model& model_;
};

/// Cuts a list of vertices into triangles. Strips are stitched together by triangles without
/// area, which go.
std::vector<std::vector<std::uint32_t>> cut_triangles(const std::vector<std::uint32_t>& list,
                                                      int mode) {
  std::vector<std::vector<std::uint32_t>> triangles;
  const bool is_list = mode == TINYGLTF_MODE_TRIANGLES;
  for (std::size_t k = 0; k + 2 < list.size(); k += is_list ? 3 : 1) {
    std::vector<std::uint32_t> triangle = {list[k], list[k + 1], list[k + 2]};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) triangle[0] = list[0];
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      if (k % 2 == 1) std::swap(triangle[0], triangle[1]);
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
          triangle[2] == triangle[0]) {
        continue;
      }
    }
    triangles.push_back(std::move(triangle));
  }
  return triangles;
}

/// The triangles of one mesh, untransformed.
PolygonMesh mesh_triangles(const Path& file, const tinygltf::Model& model,
                           std::size_t mesh_index) {
  const AccessorReader reader(file, model);
  PolygonMesh whole;
  const auto& primitives = model.meshes[mesh_index].primitives;
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    const auto& primitive = primitives[p];
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    const auto position = primitive.attributes.find("POSITION");
    if (mode < TINYGLTF_MODE_TRIANGLES || position == primitive.attributes.end()) continue;
    const std::string place =
        "meshes[" + std::to_string(mesh_index) + "].primitives[" + std::to_string(p) + "]";
    PolygonMesh part;
    part.positions = reader.positions(position->second, place);
    std::vector<std::uint32_t> list;
    if (primitive.indices >= 0) {
      list = reader.indices(primitive.indices, place);
    } else {
      for (std::uint32_t v = 0; v < part.positions.size(); ++v)
        list.push_back(v);
    }
    if (mode == TINYGLTF_MODE_TRIANGLES && list.size() % 3 != 0) {
      refuse_file(file, place, std::to_string(list.size()) + " corners are no whole triangles");
    }
    part.polygons = cut_triangles(list, mode);
    for (std::size_t f = 0; f < part.polygons.size(); ++f) {
      check_polygon(file, place, f, part.polygons[f], part.positions.size(), 0);
    }
    append_part(whole, part, {}, file, place);
  }
  return whole;
}

Transform node_transform(const Path& file, const tinygltf::Node& node,
                         const std::string& place) {
  Transform transform;
  if (node.matrix.size() == 16) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c)
        transform.rows[r][c] = node.matrix[c * 4 + r];
    }
    return transform;
  }
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

/// A node that is still to be visited, with the transform of its parent.
struct Visit {
  int node;
  Transform parent;
};

PolygonMesh scene_triangles(const Path& file, const tinygltf::Model& model,
                            const std::vector<int>& roots) {
  PolygonMesh whole;
  std::vector<bool> seen(model.nodes.size(), false);
  std::vector<Visit> to_visit;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    to_visit.push_back({*root, {}});
  while (!to_visit.empty()) {
    const Visit visit = to_visit.back();
    to_visit.pop_back();
    const auto index = static_cast<std::size_t>(visit.node);
    const std::string place = "nodes[" + std::to_string(visit.node) + "]";
    if (visit.node < 0 || index >= model.nodes.size()) {
      refuse_file(file, place, "this node is asked for but does not exist");
    }
    if (seen[index]) refuse_file(file, place, "this node hangs in the scene twice");
    seen[index] = true;
    const tinygltf::Node& node = model.nodes[index];
    const Transform transform = visit.parent * node_transform(file, node, place);
    if (node.mesh >= 0) {
      if (static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
        refuse_file(file, place, "mesh " + std::to_string(node.mesh) + " does not exist");
      }
      append_part(whole, mesh_triangles(file, model, static_cast<std::size_t>(node.mesh)),
                  transform, file, place);
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      to_visit.push_back({*child, transform});
    }
  }
  return whole;
}

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

PolygonMesh parse_gltf(const std::filesystem::path& file, const std::string& bytes) {
  const tinygltf::Model model = parse_model(file, bytes);
  refuse_extensions(file, model);
  if (!model.scenes.empty()) {
    const auto scene = static_cast<std::size_t>(std::max(model.defaultScene, 0));
    if (scene >= model.scenes.size()) {
      refuse_file(file, "scene", "scene " + std::to_string(scene) + " does not exist");
    }
    return scene_triangles(file, model, model.scenes[scene].nodes);
  }
  PolygonMesh whole;
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    append_part(whole, mesh_triangles(file, model, m), {}, file,
                "meshes[" + std::to_string(m) + "]");
  }
  return whole;
}

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
