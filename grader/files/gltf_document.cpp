#include "grader/files/gltf_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "grader/files/data_uri.h"
#include "grader/files/file_bytes.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

using Json = nlohmann::json;
using Path = std::filesystem::path;

constexpr std::size_t kDeepestNesting = 200;
constexpr std::size_t kLongestError = 300;
constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// The texts and data of a file, still in its bytes.
struct Container {
  std::string_view json;
  std::string_view binary;
  bool has_binary = false;
};

/// The JSON is walked by recursion later.
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

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

[[noreturn]] void refuse_version(const Path& file, const std::string& place,
                                 const std::string& version) {
  refuse_file(file, place, "is glTF " + version + ", which is not read; export as glTF 2.0");
}

/// Chunks of other kinds than JSON and binary are nobody's but their makers'.
Container split_binary(const Path& file, std::string_view bytes) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  if (bytes.size() < kHeader + kChunkHeader) {
    refuse_file(file, "byte " + std::to_string(bytes.size()),
                "the file ends within its header; it is cut off");
  }
  if (word_at(bytes, 4) == 1) refuse_version(file, "byte 4", "1.0");
  const std::size_t total = word_at(bytes, 8);
  if (total > bytes.size()) {
    refuse_file(file, "byte " + std::to_string(bytes.size()),
                "the file is shorter than its header says; it is cut off");
  }
  Container container;
  for (std::size_t at = kHeader; at + kChunkHeader <= total;) {
    const std::size_t length = word_at(bytes, at);
    const std::uint32_t kind = word_at(bytes, at + 4);
    const std::string place = "byte " + std::to_string(at);
    at += kChunkHeader;
    if (length > total - at) {
      refuse_file(file, place, "this chunk is longer than the file; it is cut off");
    }
    const std::string_view chunk = bytes.substr(at, length);
    if (at == kHeader + kChunkHeader) {
      if (kind != kJsonChunk) refuse_file(file, place, "its first chunk is not JSON");
      container.json = chunk;
    } else if (kind == kBinaryChunk && !container.has_binary) {
      container.binary = chunk;
      container.has_binary = true;
    }
    at += length;
  }
  return container;
}

Json parse_json(const Path& file, std::string_view text) {
  refuse_deep_nesting(file, text);
  std::string error = "its JSON is no object";
  try {
    Json json = Json::parse(text);
    if (json.is_object()) return json;
  } catch (const Json::exception& fault) {
    // The parser may repeat the file, which may be one line, in what it says.
    error = fault.what();
    error = error.substr(0, error.find('\n'));
    if (error.size() > kLongestError) error.replace(kLongestError, error.npos, "...");
    std::replace_if(
        error.begin(), error.end(), [](unsigned char c) { return c < ' '; }, '?');
  }
  refuse_file(file, "", "is not a valid glTF file: " + error);
}

/// Some programs write whole numbers as 42.0.
void make_whole(Json& json) {
  constexpr double kLargest = 4294967296.0;
  if (json.is_structured()) {
    for (Json& part : json)
      make_whole(part);
  } else if (json.is_number_float()) {
    const double number = json.get<double>();
    if (std::trunc(number) == number && std::abs(number) <= kLargest) {
      json = number < 0 ? Json(static_cast<std::int64_t>(number))
                        : Json(static_cast<std::uint64_t>(number));
    }
  }
}

void check_version(const Path& file, const Json& json) {
  const auto asset = json.find("asset");
  std::string version;
  if (asset != json.end() && asset->is_object() && asset->contains("version")) {
    const Json& value = (*asset)["version"];
    version = value.is_string() ? value.get<std::string>() : value.dump();
  }
  // In glTF 1.0, collections have names and not numbers.
  const auto meshes = json.find("meshes");
  const bool has_named = meshes != json.end() && meshes->is_object();
  if (has_named || version.starts_with("1")) refuse_version(file, "asset", "1.0");
  if (version.empty()) {
    refuse_file(file, "asset", "is not a valid glTF file: it does not say its version");
  }
  if (!version.starts_with("2")) {
    refuse_version(file, "asset", in_quotes(version));
  }
}

/// Only plain files at or below the folder of the glTF file are read.
GltfBytes read_neighbour(const Path& file, const std::string& place, const std::string& uri) {
  std::error_code failed;
  const Path folder = std::filesystem::weakly_canonical(
      file.parent_path().empty() ? "." : file.parent_path(), failed);
  const Path wanted =
      std::filesystem::weakly_canonical(folder / Path(percent_decoded(uri)), failed);
  const Path relative = wanted.lexically_relative(folder);
  if (failed || relative.empty() || *relative.begin() == "..") {
    refuse_file(
        file, place,
        "its file " + in_quotes(uri) +
            " does not lie in the folder of the glTF file, or below; others are not read");
  }
  const std::string bytes = read_bytes(wanted);
  return {bytes.begin(), bytes.end()};
}

/// Whether the data are only a replacement for programs that cannot decompress.
bool is_fallback(const Json& buffer) {
  const auto extensions = buffer.find("extensions");
  if (extensions == buffer.end() || !extensions->is_object()) return false;
  return extensions->contains("EXT_meshopt_compression") ||
         extensions->contains("KHR_meshopt_compression");
}

GltfBytes load_buffer(const Path& file, const Json& buffer, std::size_t index,
                      const Container& container) {
  const std::string place = gltf_place("buffers", index);
  const auto length = buffer.find("byteLength");
  if (length == buffer.end() || !length->is_number_unsigned()) {
    refuse_file(file, place, "has no byteLength");
  }
  const auto uri = buffer.find("uri");
  GltfBytes data;
  if (uri != buffer.end() && uri->is_string()) {
    const auto& text = uri->get_ref<const std::string&>();
    if (!is_data_uri(text)) {
      data = read_neighbour(file, place, text);
    } else if (auto decoded = decode_data_uri(text)) {
      data = std::move(*decoded);
    } else {
      refuse_file(file, place, "its data are no base64");
    }
  } else if (index == 0 && container.has_binary) {
    data.assign(container.binary.begin(), container.binary.end());
  } else if (is_fallback(buffer)) {
    return data;
  } else if (length->get<std::size_t>() > 0) {
    refuse_file(file, place, "has no uri, and the file no binary chunk for it");
  }
  if (data.size() < length->get<std::size_t>()) {
    refuse_file(file, place,
                "promises " + length->dump() + " bytes and holds " +
                    std::to_string(data.size()) + "; it is cut off");
  }
  data.resize(length->get<std::size_t>());
  return data;
}

}  // namespace

std::string gltf_place(const std::string& name, std::size_t index) {
  return name + "[" + std::to_string(index) + "]";
}

Json::array_t& gltf_array(Json& json, const char* name) {
  Json& array = json[name];
  if (!array.is_array()) array = Json::array();
  return array.get_ref<Json::array_t&>();
}

GltfDocument read_gltf_document(const Path& file, const std::string& bytes) {
  const Utf8Text text(bytes);
  Container container;
  if (bytes.starts_with(kMagic)) {
    container = split_binary(file, bytes);
  } else if (lower_extension(file) == ".glb" && text.view().find('{') != 0) {
    refuse_file(file, "byte 0", "is not a binary glTF file (it does not start with glTF)");
  } else {
    container.json = text.view();
  }
  GltfDocument document{parse_json(file, container.json), {}};
  check_version(file, document.json);
  make_whole(document.json);
  for (const Json& buffer : gltf_array(document.json, "buffers")) {
    const std::size_t index = document.buffers.size();
    if (!buffer.is_object()) refuse_file(file, gltf_place("buffers", index), "is no object");
    document.buffers.push_back(load_buffer(file, buffer, index, container));
  }
  return document;
}

}  // namespace meshgrade
