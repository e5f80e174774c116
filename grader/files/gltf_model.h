#pragma once

#include <filesystem>
#include <string>

namespace tinygltf {
class Model;
}

namespace meshgrade {

/// A glTF 2.0 file as tinygltf sees it, with nothing but what a mesh is made of: no images,
/// materials or animations. All buffers are loaded, and compressed data that meshes need are
/// decoded. No index or size in it has been checked but those that tinygltf follows itself.
/// Throws UserError if the file is broken, or needs an extension that is not read.
tinygltf::Model read_gltf_model(const std::filesystem::path& file, const std::string& bytes);

}  // namespace meshgrade
