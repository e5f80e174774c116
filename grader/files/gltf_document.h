#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace meshgrade {

using GltfBytes = std::vector<unsigned char>;

/// A glTF 2.0 file, taken out of its container.
struct GltfDocument {
  nlohmann::json json;
  /// By index, each of its promised length. Empty where the file says that the data are only
  /// there in compressed form.
  std::vector<GltfBytes> buffers;
};

/// Takes a .gltf or .glb apart, told by its first bytes, and loads its buffers: embedded ones,
/// the binary chunk, and files in the folder of `file` or below. Throws UserError for what is
/// no glTF 2.0 or lacks data.
GltfDocument read_gltf_document(const std::filesystem::path& file, const std::string& bytes);

/// The array of this name; an empty one if there is none.
nlohmann::json::array_t& gltf_array(nlohmann::json& json, const char* name);

/// "meshes[3]"
std::string gltf_place(const std::string& name, std::size_t index);

}  // namespace meshgrade
