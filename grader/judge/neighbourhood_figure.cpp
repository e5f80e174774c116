#include "grader/judge/neighbourhood_figure.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "grader/judge/operation_model.h"

namespace meshgrade {
namespace {

using Kind = ElementKind;
constexpr Kind kKinds[] = {Kind::kHalfedge, Kind::kVertex, Kind::kEdge, Kind::kFace};

enum class Presence { kNever, kDeleted, kLive };

Presence presence(const MeshDump& mesh, Kind kind, Ref ref) {
  const auto in = [ref](const auto& records) {
    if (ref >= records.size()) return Presence::kNever;
    return records[ref].live != 0 ? Presence::kLive : Presence::kDeleted;
  };
  if (kind == Kind::kHalfedge) return in(mesh.halfedges);
  if (kind == Kind::kVertex) return in(mesh.vertices);
  if (kind == Kind::kEdge) return in(mesh.edges);
  const FaceRecord* face = find_face(mesh, ref);
  if (face == nullptr) return Presence::kNever;
  return face->live != 0 ? Presence::kLive : Presence::kDeleted;
}

bool exists(const MeshDump& mesh, Kind kind, Ref ref) {
  return presence(mesh, kind, ref) == Presence::kLive;
}

std::vector<Ref> pointers_of(const MeshDump& mesh, Kind kind, Ref ref) {
  if (kind == Kind::kVertex) return {mesh.vertices[ref].halfedge};
  if (kind == Kind::kEdge) return {mesh.edges[ref].halfedge};
  if (kind == Kind::kFace) return {find_face(mesh, ref)->halfedge};
  const HalfedgeRecord& h = mesh.halfedges[ref];
  return {h.next, h.twin, h.vertex, h.edge, h.face};
}

using Letters = std::map<Ref, char>;

/// Empty if two corners are the same vertex.
Letters letters_of(const MeshDump& before, Ref edge, Ref split_vertex) {
  const Diamond diamond = diamond_of(before, edge);
  Letters letters;
  for (const auto& [vertex, letter] :
       {std::pair{diamond.a, 'a'}, std::pair{diamond.b, 'b'}, std::pair{diamond.c, 'c'},
        std::pair{diamond.d, 'd'}, std::pair{split_vertex, 'm'}}) {
    if (vertex == kUnsetRef) continue;
    if (!letters.emplace(vertex, letter).second) return {};
  }
  return letters;
}

/// The elements of a mesh that are in a panel, by their numbers. The mesh keeps all rules.
class Cast {
 public:
  /// The triangles on both sides of `edge`, or around `split_vertex` if it is set; and of the
  /// boundary loop what runs along the edge, with one half-edge before and one after.
  Cast(const MeshDump& mesh, const Letters& letters, Ref edge, Ref split_vertex)
      : mesh_(mesh), letters_(letters) {
    const std::vector<Ref> spokes =
        split_vertex == kUnsetRef ? both_sides(edge) : halfedges_from(split_vertex);
    std::vector<Ref> along;
    for (Ref h : spokes) {
      if (!is_beyond(h)) add_triangle(h);
      for (Ref g : {h, record(h).twin}) {
        if (is_beyond(g)) along.push_back(g);
      }
    }
    for (Ref h : along)
      add_outside(h);
    for (Ref h : along) {
      add_outside(record(h).next);
      add_outside(previous(h));
    }
    for (const auto& [vertex, letter] : letters) {
      if (letter != 'm' || vertex == split_vertex) add(Kind::kVertex, vertex);
    }
  }

  const std::vector<Ref>& members(Kind kind) const {
    return members_[static_cast<std::size_t>(kind)];
  }

  std::size_t place(Kind kind, Ref ref) const {
    const auto found = std::find(members(kind).begin(), members(kind).end(), ref);
    return found == members(kind).end()
               ? kNotPictured
               : static_cast<std::size_t>(found - members(kind).begin());
  }

  /// Also shows a half-edge on the far side of an outer edge.
  void add_far_side(Ref h) {
    if (h < mesh_.halfedges.size() && has(Kind::kHalfedge, record(h).twin)) {
      add(Kind::kHalfedge, h);
    }
  }

  bool is_outside(Kind kind, Ref ref) const {
    if (kind == Kind::kFace) return (ref & kBoundaryBit) != 0;
    return kind == Kind::kHalfedge && (is_beyond(ref) || !has(Kind::kFace, record(ref).face));
  }

  std::string corners(Kind kind, Ref ref) const {
    if (kind == Kind::kVertex) return {letter(ref)};
    if (kind == Kind::kEdge) return ends(mesh_.edges[ref].halfedge);
    if (kind == Kind::kHalfedge) return ends_in_picture(ref);
    if ((ref & kBoundaryBit) != 0) return "";
    const Ref h = mesh_.faces[ref].halfedge;
    const Ref next = record(h).next;
    return {letter(record(h).vertex), letter(record(next).vertex),
            letter(record(record(next).next).vertex)};
  }

 private:
  const HalfedgeRecord& record(Ref h) const { return mesh_.halfedges[h]; }
  bool is_beyond(Ref h) const { return (record(h).face & kBoundaryBit) != 0; }
  bool has(Kind kind, Ref ref) const { return place(kind, ref) != kNotPictured; }

  void add(Kind kind, Ref ref) {
    if (!has(kind, ref)) members_[static_cast<std::size_t>(kind)].push_back(ref);
  }

  void add_triangle(Ref h) {
    add(Kind::kFace, record(h).face);
    for (int i = 0; i < 3; ++i) {
      add(Kind::kHalfedge, h);
      add(Kind::kEdge, record(h).edge);
      h = record(h).next;
    }
  }

  void add_outside(Ref h) {
    add(Kind::kHalfedge, h);
    add(Kind::kFace, record(h).face);
  }

  std::vector<Ref> both_sides(Ref edge) const {
    const Ref h = mesh_.edges[edge].halfedge;
    return {h, record(h).twin};
  }

  std::vector<Ref> halfedges_from(Ref vertex) const {
    std::vector<Ref> list;
    Ref h = mesh_.vertices[vertex].halfedge;
    do {
      list.push_back(h);
      h = record(record(h).twin).next;
    } while (h != list.front());
    return list;
  }

  Ref previous(Ref h) const {
    Ref g = h;
    while (record(g).next != h)
      g = record(g).next;
    return g;
  }

  char letter(Ref vertex) const {
    const auto found = letters_.find(vertex);
    return found == letters_.end() ? '-' : found->second;
  }

  std::string ends(Ref h) const {
    return {letter(record(h).vertex), letter(record(record(h).twin).vertex)};
  }

  /// A half-edge whose edge is not in the picture touches it with one end only, even if it
  /// comes back to another corner.
  std::string ends_in_picture(Ref h) const {
    std::string text = ends(h);
    if (has(Kind::kEdge, record(h).edge)) return text;
    const bool comes = has(Kind::kHalfedge, record(h).next) && text[1] != '-';
    text[comes ? 0 : 1] = '-';
    return text;
  }

  const MeshDump& mesh_;
  const Letters& letters_;
  std::array<std::vector<Ref>, 4> members_;
};

/// A panel of a mesh that keeps all rules, under its own names.
FigurePanel own_panel(const MeshDump& mesh, const Cast& cast) {
  FigurePanel panel;
  for (Kind kind : kKinds) {
    for (Ref ref : cast.members(kind)) {
      FigureElement element{
          element_name(kind, ref), cast.corners(kind, ref), cast.is_outside(kind, ref), {}};
      for (Ref target : pointers_of(mesh, kind, ref)) {
        const Kind other = target_kind(kind, element.pointers.size());
        element.pointers.push_back({cast.place(other, target), element_name(other, target)});
      }
      panel.elements[static_cast<std::size_t>(kind)].push_back(std::move(element));
    }
  }
  return panel;
}

/// The student's element that stands for an expected one; kUnsetRef if there is none.
Ref counterpart(const Correspondence& match, Kind kind, Ref ref) {
  switch (kind) {
    case Kind::kHalfedge:
      return match.halfedges[ref];
    case Kind::kVertex:
      return match.vertices[ref];
    case Kind::kEdge:
      return match.edges[ref];
    default:
      return match.face(ref);
  }
}

/// Every old element stands for itself, and nothing for what is new.
Correspondence match_of_nothing_done(const MeshDump& before, const MeshDump& expected) {
  const auto identity = [](std::size_t old, std::size_t all) {
    std::vector<Ref> map(all, kUnsetRef);
    std::iota(map.begin(), map.begin() + static_cast<std::ptrdiff_t>(old), Ref{0});
    return map;
  };
  return {identity(before.halfedges.size(), expected.halfedges.size()),
          identity(before.vertices.size(), expected.vertices.size()),
          identity(before.edges.size(), expected.edges.size()),
          identity(before.faces.size(), expected.faces.size())};
}

/// Draws what a student has made of an expected mesh.
class Comparison {
 public:
  Comparison(const MeshDump& after, const MeshDump& expected, const Correspondence& match,
             const Cast& cast)
      : after_(after), expected_(expected), match_(match), cast_(cast) {}

  FigurePanel yours() const {
    return panel([&](FigureElement& element, Kind kind, Ref ref) {
      const Ref own = mine(kind, ref);
      if (!exists(after_, kind, own)) return;
      for (Ref target : pointers_of(after_, kind, own)) {
        const Kind other = target_kind(kind, element.pointers.size());
        element.pointers.push_back({place_of_mine(other, target), element_name(other, target)});
      }
    });
  }

  FigurePanel expected() const {
    return panel([&](FigureElement& element, Kind kind, Ref ref) {
      for (Ref target : pointers_of(expected_, kind, ref)) {
        const Kind other = target_kind(kind, element.pointers.size());
        element.pointers.push_back({cast_.place(other, target), name(other, target)});
      }
    });
  }

 private:
  template <class AddPointers>
  FigurePanel panel(AddPointers add_pointers) const {
    FigurePanel panel;
    for (Kind kind : kKinds) {
      for (Ref ref : cast_.members(kind)) {
        FigureElement element{
            name(kind, ref), cast_.corners(kind, ref), cast_.is_outside(kind, ref), {}};
        add_pointers(element, kind, ref);
        panel.elements[static_cast<std::size_t>(kind)].push_back(std::move(element));
      }
    }
    return panel;
  }

  Ref mine(Kind kind, Ref ref) const { return counterpart(match_, kind, ref); }

  std::string name(Kind kind, Ref ref) const {
    const Ref own = mine(kind, ref);
    return presence(after_, kind, own) != Presence::kNever ? element_name(kind, own) : "";
  }

  std::size_t place_of_mine(Kind kind, Ref own) const {
    if (!exists(after_, kind, own)) return kNotPictured;
    const std::vector<Ref>& members = cast_.members(kind);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (mine(kind, members[i]) == own) return i;
    }
    return kNotPictured;
  }

  const MeshDump& after_;
  const MeshDump& expected_;
  const Correspondence& match_;
  const Cast& cast_;
};

template <class Records>
void add_surplus(Kind kind, const Records& before, const Records& after,
                 const std::vector<Ref>& matched, std::vector<std::string>& names) {
  for (Ref i = static_cast<Ref>(before.size()); i < after.size(); ++i) {
    const bool used = std::find(matched.begin(), matched.end(), i) != matched.end();
    if (after[i].live != 0 && !used) names.push_back(element_name(kind, i));
  }
}

std::vector<std::string> shortened(std::vector<std::string> names) {
  constexpr std::size_t kMostNames = 12;
  if (names.size() <= kMostNames) return names;
  const std::size_t more = names.size() - kMostNames;
  names.resize(kMostNames);
  names.push_back("and " + std::to_string(more) + " more");
  return names;
}

/// New elements that stand for no expected one.
std::vector<std::string> surplus_names(const MeshDump& before, const MeshDump& after,
                                       const Correspondence& match) {
  std::vector<std::string> names;
  add_surplus(Kind::kHalfedge, before.halfedges, after.halfedges, match.halfedges, names);
  add_surplus(Kind::kVertex, before.vertices, after.vertices, match.vertices, names);
  add_surplus(Kind::kEdge, before.edges, after.edges, match.edges, names);
  add_surplus(Kind::kFace, before.faces, after.faces, match.faces, names);
  return shortened(std::move(names));
}

/// Old elements that are gone.
std::vector<std::string> deleted_names(const MeshDump& before, const MeshDump& after) {
  std::vector<std::string> names;
  const auto add = [&](Kind kind, std::size_t size, Ref bit = 0) {
    for (Ref i = 0; i < size; ++i) {
      if (exists(before, kind, i | bit) && !exists(after, kind, i | bit)) {
        names.push_back(element_name(kind, i | bit));
      }
    }
  };
  add(Kind::kHalfedge, before.halfedges.size());
  add(Kind::kVertex, before.vertices.size());
  add(Kind::kEdge, before.edges.size());
  add(Kind::kFace, before.faces.size());
  add(Kind::kFace, before.boundaries.size(), kBoundaryBit);
  return shortened(std::move(names));
}

/// A half-edge on the far side of an outer edge is shown if something about it is wrong, or a
/// wrong pointer leads to it.
void add_far_sides(const MeshDump& after, const MeshDump& expected, const Correspondence& match,
                   const std::vector<WrongCell>& wrong, Cast& cast) {
  for (const WrongCell& cell : wrong) {
    if (cell.kind == Kind::kHalfedge) cast.add_far_side(cell.element);
  }
  for (const WrongCell& cell : wrong) {
    const bool to_halfedge = target_kind(cell.kind, cell.pointer) == Kind::kHalfedge;
    if (!to_halfedge || cast.place(cell.kind, cell.element) == kNotPictured) continue;
    cast.add_far_side(pointers_of(expected, cell.kind, cell.element)[cell.pointer]);
    const Ref own = counterpart(match, cell.kind, cell.element);
    if (!exists(after, cell.kind, own)) continue;
    const Ref target = pointers_of(after, cell.kind, own)[cell.pointer];
    const auto part = std::find(match.halfedges.begin(), match.halfedges.end(), target);
    if (part != match.halfedges.end() && exists(after, Kind::kHalfedge, target)) {
      cast.add_far_side(static_cast<Ref>(part - match.halfedges.begin()));
    }
  }
}

}  // namespace

ElementKind target_kind(ElementKind kind, std::size_t pointer) {
  constexpr Kind kTargets[] = {Kind::kHalfedge, Kind::kHalfedge, Kind::kVertex, Kind::kEdge,
                               Kind::kFace};
  return kind == Kind::kHalfedge ? kTargets[pointer] : Kind::kHalfedge;
}

const char* pointer_name(ElementKind kind, std::size_t pointer) {
  constexpr const char* kNames[] = {"next", "twin", "vertex", "edge", "face"};
  return kind == Kind::kHalfedge ? kNames[pointer] : "halfedge";
}

NeighbourhoodFigure figure_of_neighbourhood(const MeshDump& before, const MeshDump& after,
                                            const MeshDump& expected,
                                            const Correspondence& match, Ref edge,
                                            Ref split_vertex,
                                            const std::vector<WrongCell>& wrong) {
  const Letters letters = letters_of(before, edge, split_vertex);
  if (letters.empty()) return {};
  Cast cast(expected, letters, edge, split_vertex);
  add_far_sides(after, expected, match, wrong, cast);
  const Comparison comparison(after, expected, match, cast);
  NeighbourhoodFigure figure{own_panel(before, Cast(before, letters, edge, kUnsetRef)),
                             comparison.yours(),
                             comparison.expected(),
                             {},
                             surplus_names(before, after, match),
                             deleted_names(before, after)};
  for (bool was_set : {true, false}) {
    for (const WrongCell& cell : wrong) {
      if (cell.was_set != was_set) continue;
      const std::size_t place = cast.place(cell.kind, cell.element);
      const bool is_there =
          place == kNotPictured || !figure.yours.of(cell.kind)[place].pointers.empty();
      // What does not exist is shown as missing; its pointers are no further news.
      if (is_there) {
        figure.faults.push_back({cell.kind, place, cell.pointer, was_set, cell.text});
      }
    }
  }
  return figure;
}

NeighbourhoodFigure figure_of_nothing_done(const MeshDump& before, const MeshDump& expected,
                                           Ref edge, Ref split_vertex) {
  const Letters letters = letters_of(before, edge, split_vertex);
  if (letters.empty()) return {};
  const FigurePanel panel = own_panel(before, Cast(before, letters, edge, kUnsetRef));
  const Correspondence match = match_of_nothing_done(before, expected);
  const Cast cast(expected, letters, edge, split_vertex);
  return {panel, panel, Comparison(before, expected, match, cast).expected(), {}, {}, {}};
}

}  // namespace meshgrade
