#include "grader/operations/face_lists.h"

#include <algorithm>

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

Surface::Surface(const FaceLists& lists) {
  for (std::size_t f = 0; f < lists.faces.size(); ++f) {
    const Corners& corners = lists.faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Label a = corners[i];
      const Label b = corners[(i + 1) % corners.size()];
      sides_[{a, b}] = f;
      neighbours_[a].insert(b);
      neighbours_[b].insert(a);
      faces_at_[a].push_back(f);
    }
  }
  for (const auto& side : sides_) {
    const auto [a, b] = side.first;
    if (sides_.count({b, a}) != 0) continue;
    boundary_.insert({a, b});
    next_outside_[b] = a;
  }
}

std::optional<std::size_t> Surface::face_with_side(Label a, Label b) const {
  const auto found = sides_.find({a, b});
  if (found == sides_.end()) return std::nullopt;
  return found->second;
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

MeshDump mesh_of(const FaceLists& lists) {
  // Only what is in use, numbered as build() does it.
  PolygonMesh polygons;
  std::map<Label, std::uint32_t> numbers;
  std::vector<Label> labels;  // by these numbers
  for (const Corners& corners : lists.faces) {
    auto& polygon = polygons.polygons.emplace_back();
    for (Label label : corners) {
      const auto [place, is_new] =
          numbers.try_emplace(label, static_cast<std::uint32_t>(labels.size()));
      if (is_new) {
        labels.push_back(label);
        polygons.positions.push_back(lists.positions[label]);
      }
      polygon.push_back(place->second);
    }
  }
  meshedit::HalfedgeMesh mesh;
  build_mesh(polygons, mesh);
  MeshDump dump = dump_mesh(mesh);
  std::vector<VertexRecord> vertices(lists.positions.size(), VertexRecord{kUnsetRef, 0, {}});
  for (std::size_t i = 0; i < labels.size(); ++i)
    vertices[labels[i]] = dump.vertices[i];
  for (HalfedgeRecord& h : dump.halfedges)
    h.vertex = labels[h.vertex];
  dump.vertices = std::move(vertices);
  return dump;
}

std::string trouble_of(const FaceLists& lists) {
  if (lists.faces.empty()) return "nothing would be left";
  try {
    mesh_of(lists);
  } catch (const meshedit::MeshError& error) {
    return error.what();
  }
  std::set<Corners> known;
  for (Corners corners : lists.faces) {
    std::sort(corners.begin(), corners.end());
    if (!known.insert(std::move(corners)).second)
      return "two faces would have the same corners";
  }
  return {};
}

}  // namespace meshgrade
