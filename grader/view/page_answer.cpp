#include "grader/view/page_answer.h"

#include <bit>
#include <nlohmann/json.hpp>

#include "grader/view/view_json.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "arrays are sent as they are");
static_assert(sizeof(HalfedgeRecord) == 6 * sizeof(Ref) &&
              sizeof(EdgeRecord) == 2 * sizeof(Ref) && sizeof(FaceRecord) == 3 * sizeof(Ref));

/// Arrays of meshes, one after the other.
class MeshArrays {
 public:
  /// Appends a mesh. @return what stands for it in the JSON
  Json add(const MeshDump& mesh) {
    const std::size_t at = bytes_.size();
    for (const VertexRecord& v : mesh.vertices)
      append(&v.position, sizeof v.position);
    append_all(mesh.halfedges);
    for (const VertexRecord& v : mesh.vertices) {
      append(&v.halfedge, sizeof v.halfedge);
      append(&v.live, sizeof v.live);
    }
    append_all(mesh.edges);
    append_all(mesh.faces);
    append_all(mesh.boundaries);
    bytes_.resize((bytes_.size() + 7) / 8 * 8);
    return {{"at", at},
            {"h", mesh.halfedges.size()},
            {"v", mesh.vertices.size()},
            {"e", mesh.edges.size()},
            {"f", mesh.faces.size()},
            {"b", mesh.boundaries.size()}};
  }

  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }
  template <class Record>
  void append_all(const std::vector<Record>& records) {
    if (!records.empty()) append(records.data(), records.size() * sizeof(Record));
  }

  std::string bytes_;
};

std::string to_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

PageAnswer answer_for_page(const MeshSession& session) {
  const MeshDump& shown = session.states().at(session.position()).mesh;
  if (shown.halfedges.size() <= kMostHalfedgesAsJson) {
    return {to_text(to_json_value(session)), "application/json"};
  }
  MeshArrays arrays;
  std::string text =
      to_text(to_json_value(session, [&](const MeshDump& mesh) { return arrays.add(mesh); }));
  text.resize((text.size() + 7) / 8 * 8, ' ');
  const auto size = static_cast<std::uint32_t>(text.size());
  std::string body = "MGM1";
  body.append(reinterpret_cast<const char*>(&size), sizeof size);
  body.reserve(body.size() + text.size() + arrays.bytes().size());
  body += text;
  body += arrays.bytes();
  return {std::move(body), "application/octet-stream"};
}

}  // namespace meshgrade
