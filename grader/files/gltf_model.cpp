#include "grader/files/gltf_model.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "grader/base/text.h"
#include "grader/files/file_bytes.h"
#include "grader/files/gltf_accessor.h"
#include "grader/files/gltf_document.h"
#include "grader/files/meshopt_views.h"

namespace meshgrade {
namespace {

using Json = nlohmann::json;
using Path = std::filesystem::path;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// What a mesh is made of. tinygltf would follow the rest, images for example, unchecked.
constexpr std::array<std::string_view, 10> kKept = {
    "asset",       "scene",          "scenes",
    "nodes",       "meshes",         "accessors",
    "bufferViews", "extensionsUsed", "extensionsRequired",
    "skins"};

/// Extensions that are read, or that leave the shape alone.
constexpr std::array<std::string_view, 21> kFineExtensions = {"KHR_mesh_quantization",
                                                              "EXT_meshopt_compression",
                                                              "KHR_meshopt_compression",
                                                              "EXT_mesh_gpu_instancing",
                                                              "KHR_animation_pointer",
                                                              "KHR_techniques_webgl",
                                                              "KHR_xmp",
                                                              "KHR_xmp_json_ld",
                                                              "EXT_mesh_features",
                                                              "EXT_structural_metadata",
                                                              "EXT_instance_features",
                                                              "CESIUM_primitive_outline",
                                                              "FB_geometry_metadata",
                                                              "MSFT_texture_dds",
                                                              "MSFT_lod",
                                                              "VRM",
                                                              "KHR_implicit_shapes",
                                                              "KHR_interactivity",
                                                              "KHR_node_hoverability",
                                                              "KHR_node_selectability",
                                                              "EXT_feature_metadata"};
constexpr std::array<std::string_view, 14> kFineFamilies = {
    "KHR_materials_", "KHR_texture_",     "KHR_lights_",   "EXT_texture_",  "EXT_lights_",
    "EXT_materials_", "ADOBE_materials_", "NV_materials_", "MSFT_packing_", "VRMC_",
    "KHR_audio",      "MSFT_audio_",      "OMI_",          "KHR_physics_"};

void check_extensions(const Path& file, Json& json) {
  for (const Json& entry : gltf_array(json, "extensionsRequired")) {
    if (!entry.is_string()) continue;
    const auto& name = entry.get_ref<const std::string&>();
    const bool is_fine =
        std::find(kFineExtensions.begin(), kFineExtensions.end(), name) !=
            kFineExtensions.end() ||
        std::any_of(kFineFamilies.begin(), kFineFamilies.end(),
                    [&](std::string_view family) { return name.starts_with(family); });
    if (is_fine) continue;
    if (name == kDraco) {
      refuse_file(file, "extensionsRequired",
                  "is compressed by Draco (KHR_draco_mesh_compression), which is not read; "
                  "export without compression");
    }
    refuse_file(file, "extensionsRequired",
                "needs the extension " + in_quotes(name, 60) +
                    ", of which it is not known whether it changes the shape; export without");
  }
}

/// The index that a member of an object holds; `none` if it holds none.
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
std::size_t index_in(const Json& object, const char* name) {
  if (!object.is_object()) return kNone;
  const auto found = object.find(name);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::size_t>()
                                                              : kNone;
}

/// Calls `visit(primitive, place)` for each primitive of each mesh.
template <typename Visit>
void for_each_primitive(const Path& file, Json& json, Visit visit) {
  auto& meshes = gltf_array(json, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (!meshes[m].is_object()) refuse_file(file, gltf_place("meshes", m), "is no object");
    auto& primitives = gltf_array(meshes[m], "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const std::string place = gltf_place("meshes", m) + "." + gltf_place("primitives", p);
      if (!primitives[p].is_object()) refuse_file(file, place, "is no object");
      visit(primitives[p], place);
    }
  }
}

/// tinygltf drops primitives whose attributes it cannot read.
void check_attributes(const Path& file, const Json& primitive, const std::string& place) {
  const auto attributes = primitive.find("attributes");
  const bool fits = attributes != primitive.end() && attributes->is_object() &&
                    std::all_of(attributes->begin(), attributes->end(),
                                [](const Json& value) { return value.is_number_integer(); });
  if (!fits) refuse_file(file, place, "has no attributes that are accessors");
}

void check_draco(const Path& file, Json& json, const Json& primitive,
                 const std::string& place) {
  const auto extensions = primitive.find("extensions");
  if (extensions == primitive.end() || !extensions->is_object() ||
      !extensions->contains(kDraco)) {
    return;
  }
  // The plain data may be there, too.
  const auto& accessors = gltf_array(json, "accessors");
  const std::size_t position = index_in(primitive["attributes"], "POSITION");
  if (position < accessors.size() && index_in(accessors[position], "bufferView") != kNone) {
    return;
  }
  refuse_file(file, place,
              "is compressed by Draco (KHR_draco_mesh_compression), which is not read; export "
              "without compression");
}

/// The accessors that make a mesh.
std::set<std::size_t> needed_accessors(const Path& file, Json& json) {
  std::set<std::size_t> needed;
  const auto need_all = [&](const Json& attributes) {
    if (!attributes.is_object()) return;
    for (const auto& [name, value] : attributes.items()) {
      if (name == "POSITION" || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) {
        needed.insert(index_in(attributes, name.c_str()));
      }
    }
  };
  for_each_primitive(file, json, [&](Json& primitive, const std::string& place) {
    check_attributes(file, primitive, place);
    check_draco(file, json, primitive, place);
    need_all(primitive["attributes"]);
    needed.insert(index_in(primitive, "indices"));
    for (const Json& target : gltf_array(primitive, "targets"))
      need_all(target);
  });
  for (const Json& skin : gltf_array(json, "skins"))
    needed.insert(index_in(skin, "inverseBindMatrices"));
  for (const Json& node : gltf_array(json, "nodes")) {
    const auto attributes =
        Json::json_pointer("/extensions/EXT_mesh_gpu_instancing/attributes");
    if (!node.is_object() || !node.contains(attributes)) continue;
    for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
      needed.insert(index_in(node[attributes], name));
  }
  needed.erase(kNone);
  return needed;
}

void decode_needed_views(const Path& file, GltfDocument& document,
                         const std::set<std::size_t>& accessors) {
  std::set<std::size_t> views;
  auto& all = gltf_array(document.json, "accessors");
  for (const std::size_t a : accessors) {
    if (a >= all.size() || !all[a].is_object()) continue;
    views.insert(index_in(all[a], "bufferView"));
    const auto sparse = all[a].find("sparse");
    if (sparse == all[a].end() || !sparse->is_object()) continue;
    for (const char* part : {"indices", "values"}) {
      if (sparse->contains(part)) views.insert(index_in((*sparse)[part], "bufferView"));
    }
  }
  for (const std::size_t view : views)
    decode_meshopt_view(file, document, view);
}

/// tinygltf demands a buffer view of indices. Those that have none are zeros, of which a sparse
/// part replaces some.
void store_zero_indices(const Path& file, GltfDocument& document) {
  auto& accessors = gltf_array(document.json, "accessors");
  auto& views = gltf_array(document.json, "bufferViews");
  for_each_primitive(file, document.json, [&](Json& primitive, const std::string& place) {
    const std::size_t a = index_in(primitive, "indices");
    if (a >= accessors.size() || !accessors[a].is_object() ||
        accessors[a].contains("bufferView")) {
      return;
    }
    const std::size_t count = index_in(accessors[a], "count");
    if (count > kMostUnstoredElements) {
      refuse_file(file, place, "has a million elements and no data");
    }
    constexpr std::size_t kLargestIndex = 4;
    views.push_back(
        {{"buffer", document.buffers.size()}, {"byteLength", kLargestIndex * count}});
    accessors[a]["bufferView"] = views.size() - 1;
    document.buffers.emplace_back(kLargestIndex * count);
  });
}

tinygltf::Model parse_plain(const Path& file, const Json& json) {
  Json plain = Json::object();
  for (const std::string_view name : kKept) {
    const auto found = json.find(name);
    if (found != json.end()) plain[std::string(name)] = *found;
  }
  const std::string text = plain.dump();
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  bool ok = false;
  try {
    ok = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                    static_cast<unsigned int>(text.size()), "");
  } catch (const std::exception& fault) {
    error = fault.what();
  }
  if (ok) return model;
  constexpr std::size_t kLongestReason = 300;
  error = error.substr(0, std::min(error.find('\n'), kLongestReason));
  refuse_file(file, "", "is not a valid glTF file: " + printable(error));
}

}  // namespace

tinygltf::Model read_gltf_model(const Path& file, const std::string& bytes) {
  GltfDocument document = read_gltf_document(file, bytes);
  check_extensions(file, document.json);
  decode_needed_views(file, document, needed_accessors(file, document.json));
  store_zero_indices(file, document);
  tinygltf::Model model = parse_plain(file, document.json);
  model.buffers.resize(document.buffers.size());
  for (std::size_t b = 0; b < document.buffers.size(); ++b)
    model.buffers[b].data = std::move(document.buffers[b]);
  return model;
}

}  // namespace meshgrade
