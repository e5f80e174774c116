#include "grader/files/gltf_mesh.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "grader/files/file_bytes.h"
#include "grader/files/gltf_document.h"
#include "grader/files/gltf_skin.h"
#include "grader/files/triangle_strip.h"

namespace meshgrade {
namespace {

/// Counts a primitive that is no surface. False if it is one.
bool count_other_primitive(const std::filesystem::path& file, int mode,
                           const std::string& place, ReadingNotes& notes) {
  if (mode >= TINYGLTF_MODE_TRIANGLES && mode <= TINYGLTF_MODE_TRIANGLE_FAN) return false;
  if (mode == TINYGLTF_MODE_POINTS) {
    notes.left_out("primitive of points", "primitives of points", place);
  } else if (mode >= TINYGLTF_MODE_LINE && mode <= TINYGLTF_MODE_LINE_STRIP) {
    notes.left_out("primitive of lines", "primitives of lines", place);
  } else {
    refuse_file(file, place, "mode " + std::to_string(mode) + " is none of glTF");
  }
  return true;
}

}  // namespace

PosedMesh GltfMeshReader::read(int index, const GltfPose& pose, const std::string& node_place) {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.meshes.size()) {
    refuse_file(file_, node_place, "mesh " + std::to_string(index) + " does not exist");
  }
  const auto& mesh = model_.meshes[static_cast<std::size_t>(index)];
  const std::vector<double>& weights =
      pose.morph_weights.empty() ? mesh.weights : pose.morph_weights;
  PosedMesh posed;
  ReadingNotes notes;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const std::string place = gltf_place("meshes", static_cast<std::size_t>(index)) + "." +
                              gltf_place("primitives", p);
    read_primitive(mesh.primitives[p], weights, pose, place, notes, posed);
  }
  if (known_.insert(index).second) notes_.add(notes);
  return posed;
}

ReadingNotes GltfMeshReader::notes() const {
  ReadingNotes notes = notes_;
  std::size_t n_unused = 0;
  for (const auto& [accessor, is_used] : is_used_) {
    n_unused += static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
  }
  notes.left_out("vertex that belongs to no face", "vertices that belong to no face", "",
                 n_unused);
  return notes;
}

void GltfMeshReader::read_primitive(const tinygltf::Primitive& primitive,
                                    const std::vector<double>& weights, const GltfPose& pose,
                                    const std::string& place, ReadingNotes& notes,
                                    PosedMesh& posed) {
  const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (count_other_primitive(file_, mode, place, notes)) return;
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) {
    notes.left_out("primitive without positions", "primitives without positions", place);
    return;
  }
  PolygonMesh part;
  part.positions = accessors_.positions(position->second, place);
  apply_morphs(primitive, weights, place, notes, part.positions);
  const std::size_t n_vertices = part.positions.size();
  for (auto& triangle : triangles(primitive, n_vertices, place, notes)) {
    if (admit_polygon(file_, place, part.polygons.size(), triangle, n_vertices, 0, notes)) {
      part.polygons.push_back(std::move(triangle));
    }
  }
  const bool has_skin = pose.joints != nullptr && is_skinned(primitive);
  if (has_skin &&
      apply_skin(file_, primitive, accessors_, *pose.joints, part.positions, place)) {
    for (auto& triangle : part.polygons)
      std::swap(triangle[1], triangle[2]);
  }
  keep_used(part, position->second);
  append_part(has_skin ? posed.in_scene : posed.in_node, part, {}, file_, place);
}

std::vector<std::vector<std::uint32_t>> GltfMeshReader::triangles(
    const tinygltf::Primitive& primitive, std::size_t n_vertices, const std::string& place,
    ReadingNotes& notes) const {
  std::vector<std::uint32_t> list;
  if (primitive.indices >= 0) {
    list = accessors_.indices(primitive.indices, place);
  } else {
    list.resize(n_vertices);
    std::iota(list.begin(), list.end(), 0U);
  }
  if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) return cut_strips(list);
  if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) return cut_fan(list);
  notes.left_out("corner behind the last whole triangle",
                 "corners behind the last whole triangle", place, list.size() % 3);
  std::vector<std::vector<std::uint32_t>> triangles;
  for (std::size_t k = 0; k + 2 < list.size(); k += 3)
    triangles.push_back({list[k], list[k + 1], list[k + 2]});
  return triangles;
}

void GltfMeshReader::apply_morphs(const tinygltf::Primitive& primitive,
                                  const std::vector<double>& weights, const std::string& place,
                                  ReadingNotes& notes, std::vector<Point3>& positions) const {
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
    const double weight = t < weights.size() ? weights[t] : 0;
    const auto position = primitive.targets[t].find("POSITION");
    if (position == primitive.targets[t].end()) continue;
    if (weight == 0) {
      notes.left_out("morph target of weight 0", "morph targets of weight 0",
                     place + "." + gltf_place("targets", t));
      continue;
    }
    const std::vector<double> moves =
        accessors_.numbers(position->second, 3, "morph targets", place);
    if (moves.size() != 3 * positions.size()) {
      refuse_file(file_, place + "." + gltf_place("targets", t),
                  "has another number of vertices than the mesh");
    }
    for (std::size_t k = 0; k < moves.size(); ++k)
      positions[k / 3][k % 3] += weight * moves[k];
  }
}

/// Primitives may share positions: each takes its own, and what nobody takes is counted.
void GltfMeshReader::keep_used(PolygonMesh& part, int accessor) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<bool>& is_used = is_used_[accessor];
  is_used.resize(part.positions.size(), false);
  std::vector<std::uint32_t> new_index(part.positions.size(), kUnused);
  std::vector<Point3> positions;
  for (auto& triangle : part.polygons) {
    for (std::uint32_t& v : triangle) {
      if (new_index[v] == kUnused) {
        new_index[v] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(part.positions[v]);
        is_used[v] = true;
      }
      v = new_index[v];
    }
  }
  part.positions = std::move(positions);
}

}  // namespace meshgrade
