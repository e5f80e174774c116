#include "grader/operations/face_lists.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {

Label FaceLists::add(const Point3& position) {
  positions.push_back(position);
  return static_cast<Label>(positions.size() - 1);
}

void FaceLists::replace(const Corners& face, const std::vector<Corners>& others) {
  const Corners wanted = canonical(face);
  const auto place = std::find_if(faces.begin(), faces.end(), [&](const Corners& corners) {
    return canonical(corners) == wanted;
  });
  faces.insert(faces.erase(place), others.begin(), others.end());
}

FaceLists face_lists_of(const MeshDump& mesh) {
  FaceLists lists;
  for (const VertexRecord& vertex : mesh.vertices)
    lists.positions.push_back(vertex.position);
  for (const FaceRecord& face : mesh.faces) {
    if (face.live == 0) continue;
    Corners& corners = lists.faces.emplace_back();
    Ref h = face.halfedge;
    do {
      corners.push_back(mesh.halfedges[h].vertex);
      h = mesh.halfedges[h].next;
    } while (h != face.halfedge);
  }
  return lists;
}

Corners canonical(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::optional<std::size_t> place_of(const Corners& corners, Label label) {
  const auto found = std::find(corners.begin(), corners.end(), label);
  if (found == corners.end()) return std::nullopt;
  return static_cast<std::size_t>(found - corners.begin());
}

Corners beginning_with(const Corners& corners, Label first) {
  Corners turned = corners;
  std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), first), turned.end());
  return turned;
}

FaceLists merged(const FaceLists& before, const Corners& corners, Label left) {
  FaceLists after;
  after.positions = before.positions;
  for (const Corners& face : before.faces) {
    Corners now;
    for (Label corner : face) {
      const Label label = place_of(corners, corner) ? left : corner;
      if (now.empty() || now.back() != label) now.push_back(label);
    }
    if (now.size() > 1 && now.front() == now.back()) now.pop_back();
    if (now.size() >= 3) after.faces.push_back(std::move(now));
  }
  return after;
}

Corners round_of(const std::map<Label, Label>& next) {
  Corners corners{next.begin()->first};
  for (auto step = next.begin(); step != next.end(); step = next.find(corners.back())) {
    if (step->second == corners[0] || corners.size() > next.size()) break;
    corners.push_back(step->second);
  }
  return corners;
}

namespace {

/// From how many there are of each label to where each begins.
void add_up(std::vector<std::size_t>& begins) {
  std::size_t sum = 0;
  for (std::size_t& begin : begins)
    begin = std::exchange(sum, sum + begin);
}

}  // namespace

Surface::Surface(const FaceLists& lists) {
  for (const Corners& corners : lists.faces) {
    for (const Label corner : corners)
      n_labels_ = std::max(n_labels_, std::size_t{corner} + 1);
  }
  find_sides(lists);
  find_neighbours(lists);
  find_boundary();
}

void Surface::find_sides(const FaceLists& lists) {
  sides_begin_.assign(n_labels_ + 1, 0);
  std::size_t n_sides = 0;
  for (const Corners& corners : lists.faces) {
    for (const Label corner : corners)
      ++sides_begin_[corner];
    n_sides += corners.size();
  }
  add_up(sides_begin_);
  ends_.resize(n_sides);
  faces_.resize(n_sides);
  Begins next = sides_begin_;
  for (std::size_t f = 0; f < lists.faces.size(); ++f) {
    const Corners& corners = lists.faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t side = next[corners[i]]++;
      ends_[side] = corners[i + 1 == corners.size() ? 0 : i + 1];
      faces_[side] = f;
    }
  }
}

void Surface::find_neighbours(const FaceLists& lists) {
  std::vector<std::pair<Label, Label>> pairs;
  pairs.reserve(2 * ends_.size());
  for (const Corners& corners : lists.faces) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Label a = corners[i];
      const Label b = corners[i + 1 == corners.size() ? 0 : i + 1];
      pairs.emplace_back(a, b);
      pairs.emplace_back(b, a);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  neighbours_begin_.assign(n_labels_ + 1, 0);
  for (const auto& [label, neighbour] : pairs) {
    ++neighbours_begin_[label];
    neighbours_.push_back(neighbour);
  }
  add_up(neighbours_begin_);
}

void Surface::find_boundary() {
  is_boundary_.assign(n_labels_, false);
  next_outside_.assign(n_labels_, 0);
  for (Label a = 0; a < n_labels_; ++a) {
    for (std::size_t side = sides_begin_[a]; side < sides_begin_[a + 1]; ++side) {
      const Label b = ends_[side];
      if (face_with_side(b, a)) continue;
      is_boundary_[a] = is_boundary_[b] = true;
      next_outside_[b] = a;
    }
  }
}

template <typename T>
std::span<const T> Surface::row_of(const Begins& begins, const std::vector<T>& all,
                                   Label label) {
  if (label + std::size_t{1} >= begins.size() || begins[label] == begins[label + 1])
    throw std::out_of_range("no face has the corner " + std::to_string(label));
  return std::span(all).subspan(begins[label], begins[label + 1] - begins[label]);
}

bool Surface::is_boundary(Label vertex) const {
  return vertex < n_labels_ && is_boundary_[vertex];
}

std::span<const Label> Surface::neighbours(Label vertex) const {
  return row_of(neighbours_begin_, neighbours_, vertex);
}

bool Surface::are_neighbours(Label a, Label b) const {
  const std::span<const Label> of_a = neighbours(a);
  return std::binary_search(of_a.begin(), of_a.end(), b);
}

std::span<const std::size_t> Surface::faces_at(Label vertex) const {
  return row_of(sides_begin_, faces_, vertex);
}

std::optional<std::size_t> Surface::face_with_side(Label a, Label b) const {
  if (a >= n_labels_) return std::nullopt;
  for (std::size_t side = sides_begin_[a + 1]; side-- > sides_begin_[a];) {
    if (ends_[side] == b) return faces_[side];
  }
  return std::nullopt;
}

bool Surface::is_edge(Label a, Label b) const {
  return face_with_side(a, b) || face_with_side(b, a);
}

bool Surface::is_boundary_edge(Label a, Label b) const {
  return face_with_side(a, b).has_value() != face_with_side(b, a).has_value();
}

Corners Surface::loop_of(Label a, Label b) const {
  Corners loop{a};
  for (Label at = b; at != a; at = next_outside_.at(at))
    loop.push_back(at);
  return loop;
}

bool Surface::is_outside(Label a, Label b) const {
  return !face_with_side(a, b) && face_with_side(b, a);
}

namespace {

/// A half-edge mesh of the faces of some lists, whose vertices are those in use.
struct NumberedMesh {
  meshedit::HalfedgeMesh mesh;
  std::vector<Label> labels;  ///< by the numbers of its vertices
};

/// Numbers the vertices as build() does it.
void build_numbered(const FaceLists& lists, NumberedMesh& built) {
  constexpr std::uint32_t kUnused = kUnsetRef;
  PolygonMesh polygons;
  polygons.polygons.reserve(lists.faces.size());
  std::vector<std::uint32_t> numbers(lists.positions.size(), kUnused);
  for (const Corners& corners : lists.faces) {
    auto& polygon = polygons.polygons.emplace_back();
    for (const Label label : corners) {
      if (numbers[label] == kUnused) {
        numbers[label] = static_cast<std::uint32_t>(built.labels.size());
        built.labels.push_back(label);
        polygons.positions.push_back(lists.positions[label]);
      }
      polygon.push_back(numbers[label]);
    }
  }
  build_mesh(polygons, built.mesh);
}

bool has_two_faces_of_the_same_corners(const FaceLists& lists) {
  std::vector<Corners> sorted = lists.faces;
  for (Corners& corners : sorted)
    std::sort(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

}  // namespace

MeshDump mesh_of(const FaceLists& lists) {
  NumberedMesh built;
  build_numbered(lists, built);
  MeshDump dump = dump_mesh(built.mesh);
  std::vector<VertexRecord> vertices(lists.positions.size(), VertexRecord{kUnsetRef, 0, {}});
  for (std::size_t i = 0; i < built.labels.size(); ++i)
    vertices[built.labels[i]] = dump.vertices[i];
  for (HalfedgeRecord& h : dump.halfedges)
    h.vertex = built.labels[h.vertex];
  dump.vertices = std::move(vertices);
  return dump;
}

std::string trouble_of(const FaceLists& lists) {
  if (lists.faces.empty()) return "nothing would be left";
  try {
    NumberedMesh built;
    build_numbered(lists, built);
  } catch (const meshedit::MeshError& error) {
    return error.what();
  }
  if (has_two_faces_of_the_same_corners(lists)) return "two faces would have the same corners";
  return {};
}

}  // namespace meshgrade
