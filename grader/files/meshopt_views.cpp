#include "grader/files/meshopt_views.h"

#ifdef MESHGRADE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

using Json = nlohmann::json;
using Path = std::filesystem::path;

/// The extension's object in a buffer view; nullptr if there is none.
const Json* extension_of(const Json& view) {
  const auto extensions = view.find("extensions");
  if (extensions == view.end() || !extensions->is_object()) return nullptr;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const auto found = extensions->find(name);
    if (found != extensions->end() && found->is_object()) return &*found;
  }
  return nullptr;
}

#ifdef MESHGRADE_MESHOPTIMIZER

/// The best that the codecs do: a quarter of a bit for a byte.
constexpr std::size_t kBestRatio = 64;
constexpr std::size_t kSmall = 65536;

/// One compressed view, its numbers checked.
struct Compressed {
  const unsigned char* data = nullptr;
  std::size_t length = 0;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;
};

std::size_t number_of(const Path& file, const std::string& place, const Json& extension,
                      const char* name, std::size_t otherwise) {
  const auto found = extension.find(name);
  if (found == extension.end()) return otherwise;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > UINT32_MAX) {
    refuse_file(file, place, std::string("its compressed form has no whole number ") + name);
  }
  return found->get<std::size_t>();
}

std::string word_of(const Json& extension, const char* name, const std::string& otherwise) {
  const auto found = extension.find(name);
  return found != extension.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

Compressed read_extension(const Path& file, const std::string& place,
                          const GltfDocument& document, const Json& extension) {
  const auto number = [&](const char* name, std::size_t otherwise) {
    return number_of(file, place, extension, name, otherwise);
  };
  const std::size_t buffer = number("buffer", document.buffers.size());
  const std::size_t offset = number("byteOffset", 0);
  Compressed view;
  view.length = number("byteLength", 0);
  view.count = number("count", 0);
  view.stride = number("byteStride", 0);
  view.mode = word_of(extension, "mode", "");
  view.filter = word_of(extension, "filter", "NONE");
  if (buffer >= document.buffers.size() || offset > document.buffers[buffer].size() ||
      view.length > document.buffers[buffer].size() - offset) {
    refuse_file(file, place, "its compressed data reach beyond the end of the buffer");
  }
  view.data = document.buffers[buffer].data() + offset;
  const bool is_attribute = view.mode == "ATTRIBUTES";
  const bool stride_fits = is_attribute
                               ? view.stride > 0 && view.stride % 4 == 0 && view.stride <= 256
                               : view.stride == 2 || view.stride == 4;
  const bool count_fits = view.mode != "TRIANGLES" || view.count % 3 == 0;
  if (!stride_fits || !count_fits) {
    refuse_file(file, place, "its compressed form has a count or byteStride that do not fit");
  }
  if (view.count * view.stride > kBestRatio * view.length + kSmall) {
    refuse_file(file, place,
                "promises " + std::to_string(view.count) + " elements in " +
                    std::to_string(view.length) + " compressed bytes, which cannot be");
  }
  return view;
}

int decode(const Compressed& view, GltfBytes& out) {
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, view.data,
                                      view.length);
  }
  if (view.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, view.data,
                                     view.length);
  }
  if (view.mode == "INDICES") {
    return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, view.data,
                                       view.length);
  }
  return -1;
}

/// False for a filter that is not known, or not of such elements.
bool undo_filter(const Compressed& view, GltfBytes& out) {
  if (view.filter == "NONE") return true;
  if (view.mode != "ATTRIBUTES") return false;
  if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) {
    meshopt_decodeFilterOct(out.data(), view.count, view.stride);
    return true;
  }
  if (view.filter == "QUATERNION" && view.stride == 8) {
    meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
    return true;
  }
  if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(out.data(), view.count, view.stride);
    return true;
  }
  return false;
}

GltfBytes decoded(const Path& file, const std::string& place, const GltfDocument& document,
                  const Json& extension) {
  const Compressed view = read_extension(file, place, document, extension);
  GltfBytes out(view.count * view.stride);
  if (view.count == 0) return out;
  if (decode(view, out) != 0) {
    refuse_file(file, place,
                "its meshopt compression cannot be decoded: broken, or of a newer kind than "
                "meshoptimizer " +
                    std::to_string(MESHOPTIMIZER_VERSION / 1000) + "." +
                    std::to_string(MESHOPTIMIZER_VERSION / 10 % 100) + " knows");
  }
  if (!undo_filter(view, out)) {
    refuse_file(file, place, "its filter " + in_quotes(view.filter) + " is not known here");
  }
  return out;
}

#endif

}  // namespace

bool can_decode_meshopt() {
#ifdef MESHGRADE_MESHOPTIMIZER
  return true;
#else
  return false;
#endif
}

void decode_meshopt_view(const Path& file, GltfDocument& document, std::size_t index) {
  auto& views = gltf_array(document.json, "bufferViews");
  if (index >= views.size() || !views[index].is_object()) return;
  Json& view = views[index];
  const Json* extension = extension_of(view);
  if (extension == nullptr) return;
#ifdef MESHGRADE_MESHOPTIMIZER
  const std::string place = gltf_place("bufferViews", index);
  GltfBytes out = decoded(file, place, document, *extension);
  Json plain = {{"buffer", document.buffers.size()}, {"byteLength", out.size()}};
  if (word_of(*extension, "mode", "") == "ATTRIBUTES") {
    plain["byteStride"] = (*extension)["byteStride"];
  }
  document.buffers.push_back(std::move(out));
  view = std::move(plain);
#else
  // The plain data may be there, too.
  const auto buffer = view.find("buffer");
  if (buffer != view.end() && buffer->is_number_unsigned() &&
      buffer->get<std::size_t>() < document.buffers.size() &&
      !document.buffers[buffer->get<std::size_t>()].empty()) {
    return;
  }
  refuse_file(file, gltf_place("bufferViews", index),
              "is compressed by EXT_meshopt_compression, and Meshgrade was built without "
              "meshoptimizer; install it and build again, or export without compression");
#endif
}

}  // namespace meshgrade
