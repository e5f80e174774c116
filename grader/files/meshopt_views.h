#pragma once

#include <filesystem>

#include "grader/files/gltf_document.h"

namespace meshgrade {

/// Whether this build can decode what EXT_meshopt_compression compresses.
bool can_decode_meshopt();

/// Decodes a buffer view with the extension EXT_meshopt_compression (or its younger name
/// KHR_meshopt_compression) into a new buffer, to which it points from then on. Views without
/// it stay as they are. Throws UserError "<file>:bufferViews[<index>]: ..." if the data are
/// broken, or if this build has no decoder and the file no uncompressed data.
void decode_meshopt_view(const std::filesystem::path& file, GltfDocument& document,
                         std::size_t index);

}  // namespace meshgrade
