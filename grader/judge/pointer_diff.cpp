#include "grader/judge/pointer_diff.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "grader/base/text.h"
#include "grader/judge/correspondence.h"

namespace meshgrade {
namespace {

/// Whether the code led a pointer elsewhere. One whose element was deleted still leads there.
bool was_changed(Ref was, Ref have) {
  return have != was && have != (was | kDeletedBit);
}

class Differ {
 public:
  Differ(const MeshDump& before, const MeshDump& after, const MeshDump& expected, Ref edge,
         Ref split_vertex)
      : before_(before),
        after_(after),
        expected_(expected),
        edge_(edge),
        split_vertex_(split_vertex),
        diamond_(diamond_of(before, edge)),
        match_(find_correspondence(before, after, expected, edge, split_vertex)) {
    letters_ = {{diamond_.a, "a"},
                {diamond_.b, "b"},
                {diamond_.c, "c"},
                {diamond_.d, "d"},
                {split_vertex, "m"}};
    letters_.erase(kUnsetRef);
    for (Ref h = 0; h < match_.halfedges.size(); ++h) {
      if (match_.halfedges[h] != kUnsetRef) stands_for_[match_.halfedges[h]] = h;
    }
  }

  PointerDiff diff() {
    diff_.corners = corners_text();
    if (split_vertex_ != kUnsetRef) diff_.new_vertex = match_.vertices[split_vertex_];
    add_halfedges();
    add_vertices();
    add_edges();
    add_faces();
    count_elements(expected_.halfedges.size(), match_.halfedges, after_.halfedges);
    count_elements(expected_.vertices.size(), match_.vertices, after_.vertices);
    count_elements(expected_.edges.size(), match_.edges, after_.edges);
    count_elements(expected_.faces.size(), match_.faces, after_.faces);
    diff_.figure = figure_of_neighbourhood(before_, after_, expected_, match_, edge_,
                                           split_vertex_, wrong_cells_);
    return std::move(diff_);
  }

 private:
  // ---- names -----------------------------------------------------------------------------

  std::string letter(Ref vertex) const {
    const auto found = letters_.find(vertex);
    return found == letters_.end() ? "" : found->second;
  }

  std::string corners_text() const {
    std::string text = "the edge runs from b = " + vertex_name(diamond_.b) +
                       " to c = " + vertex_name(diamond_.c) +
                       "; opposite: a = " + vertex_name(diamond_.a);
    if (diamond_.d != kUnsetRef) text += ", d = " + vertex_name(diamond_.d);
    if (split_vertex_ == kUnsetRef) return text;
    const Ref mine = match_.vertices[split_vertex_];
    return text + "; m is the new vertex" + (mine == kUnsetRef ? "" : " " + vertex_name(mine));
  }

  /// "mc" for a half-edge between named corners, nothing for others.
  static std::string join_letters(const std::string& from, const std::string& to) {
    return from.empty() || to.empty() ? "" : from + to;
  }

  std::string halfedge_role(Ref expected) const {
    const HalfedgeRecord& h = expected_.halfedges[expected];
    return join_letters(letter(h.vertex), letter(expected_.halfedges[h.twin].vertex));
  }

  std::string old_halfedge_role(Ref h) const {
    const HalfedgeRecord& record = before_.halfedges[h];
    return join_letters(letter(record.vertex), letter(before_.halfedges[record.twin].vertex));
  }

  static std::string with_role(const std::string& name, const std::string& role) {
    return role.empty() ? name : name + " (" + role + ")";
  }

  /// A pointer to a half-edge as the student has it, named by what it stands for.
  std::string halfedge_text(Ref actual) const {
    const auto found = stands_for_.find(actual);
    return with_role(halfedge_name(actual),
                     found == stands_for_.end() ? "" : halfedge_role(found->second));
  }

  /// An expected half-edge, named as the student's; by its role if the student has none.
  std::string wanted_halfedge_text(Ref expected) const {
    const Ref mine = match_.halfedges[expected];
    if (mine == kUnsetRef) return "a new half-edge (" + halfedge_role(expected) + ")";
    return with_role(halfedge_name(mine), halfedge_role(expected));
  }

  std::string vertex_text(Ref actual) const {
    for (Ref v = 0; v < match_.vertices.size(); ++v) {
      if (match_.vertices[v] == actual) return with_role(vertex_name(actual), letter(v));
    }
    return vertex_name(actual);
  }

  std::string old_halfedge_text(Ref h) const {
    return with_role(halfedge_name(h), is_plain(h) ? old_halfedge_role(h) : "");
  }

  // ---- tables ----------------------------------------------------------------------------

  void begin_table(ElementKind kind, const char* name, std::vector<std::string> columns) {
    kind_ = kind;
    diff_.tables.push_back({name, std::move(columns), {}});
  }

  PointerTable& table() { return diff_.tables.back(); }

  /// A cell of the row of the expected element `ref`.
  void add_cell(PointerRow& row, Ref ref, PointerCell cell, bool was_set) {
    if (cell.wrong) {
      const std::size_t column = row.cells.size();
      const std::string owner = row.element.empty() ? "the new " + row.role : row.element;
      const WrongPointer pointer{owner + "." + table().columns[column],
                                 row.role,
                                 cell.expected,
                                 cell.yours,
                                 was_set,
                                 cell.before.empty()};
      wrong_cells_.push_back(
          {kind_, ref, column, was_set, pointer.name + " " + must_be_text(pointer)});
      diff_.wrong.push_back(pointer);
    }
    row.cells.push_back(std::move(cell));
  }

  /// Lies in one of the faces of the diamond, or took part in the operation.
  bool is_near(Ref h) const {
    if (h >= before_.halfedges.size()) return true;
    return !halfedge_role(h).empty() && !face_role(expected_.halfedges[h].face).empty();
  }

  /// "a b m" for a triangle between named corners.
  std::string face_role(Ref f) const {
    if ((f & kBoundaryBit) != 0) return "";
    const HalfedgeRecord& x = expected_.halfedges[expected_.faces[f].halfedge];
    const HalfedgeRecord& y = expected_.halfedges[x.next];
    const std::string p = letter(x.vertex);
    const std::string q = letter(y.vertex);
    const std::string r = letter(expected_.halfedges[y.next].vertex);
    return p.empty() || q.empty() || r.empty() ? "" : p + q + r;
  }

  void add_halfedges() {
    begin_table(ElementKind::kHalfedge, "half-edges",
                {"next", "twin", "vertex", "edge", "face"});
    for (Ref h = 0; h < expected_.halfedges.size(); ++h) {
      if (expected_.halfedges[h].live != 0) add_halfedge(h);
    }
  }

  static constexpr std::array<Ref HalfedgeRecord::*, 5> kMembers{
      &HalfedgeRecord::next, &HalfedgeRecord::twin, &HalfedgeRecord::vertex,
      &HalfedgeRecord::edge, &HalfedgeRecord::face};

  /// The five pointers of an expected half-edge, as the student's elements; kUnsetRef for what
  /// the student does not have.
  std::array<Ref, 5> wanted_pointers(Ref h) const {
    const HalfedgeRecord& want = expected_.halfedges[h];
    return {match_.halfedges[want.next], match_.halfedges[want.twin],
            match_.vertices[want.vertex], match_.edges[want.edge], match_.face(want.face)};
  }

  void add_halfedge(Ref h) {
    const Ref mine = match_.halfedges[h];
    const bool exists = mine < after_.halfedges.size();
    const bool old = exists && mine < before_.halfedges.size();
    const HalfedgeRecord none{kUnsetRef, kUnsetRef, kUnsetRef, kUnsetRef, kUnsetRef, 0};
    const HalfedgeRecord& have = exists ? after_.halfedges[mine] : none;
    const HalfedgeRecord& was = old ? before_.halfedges[mine] : none;
    const std::array<Ref, 5> want = wanted_pointers(h);
    std::array<bool, 5> wrong{};
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      wrong[i] = !exists || want[i] == kUnsetRef || have.*kMembers[i] != want[i];
      if (!old || was.*kMembers[i] != want[i]) ++diff_.to_change;
    }
    // Of a large mesh nearly all is far away and right.
    if (!is_near(h) && std::count(wrong.begin(), wrong.end(), true) == 0) return;
    PointerRow row{exists ? halfedge_name(mine) : "", halfedge_role(h), {}};
    const std::array<std::string, 5> before = old_texts(was);
    const std::array<std::string, 5> yours = texts_of(have);
    const std::array<std::string, 5> expected = wanted_texts(h, want);
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      add_cell(row, h, {old ? before[i] : "", exists ? yours[i] : "", expected[i], wrong[i]},
               exists && was_changed(was.*kMembers[i], have.*kMembers[i]));
    }
    table().rows.push_back(std::move(row));
  }

  std::array<std::string, 5> old_texts(const HalfedgeRecord& was) const {
    return {old_halfedge_text(was.next), old_halfedge_text(was.twin),
            with_role(vertex_name(was.vertex), letter(was.vertex)), edge_name(was.edge),
            face_name(was.face)};
  }

  std::array<std::string, 5> texts_of(const HalfedgeRecord& have) const {
    return {halfedge_text(have.next), halfedge_text(have.twin), vertex_text(have.vertex),
            edge_name(have.edge), face_name(have.face)};
  }

  std::array<std::string, 5> wanted_texts(Ref h, const std::array<Ref, 5>& mine) const {
    const HalfedgeRecord& want = expected_.halfedges[h];
    return {wanted_halfedge_text(want.next), wanted_halfedge_text(want.twin),
            wanted_text(mine[2], vertex_name, "vertex", letter(want.vertex)),
            wanted_text(mine[3], edge_name, "edge", halfedge_role(h)),
            wanted_text(mine[4], face_name, "face", face_role(want.face))};
  }

  template <class NameOf>
  static std::string wanted_text(Ref mine, NameOf name_of, const char* kind,
                                 const std::string& role) {
    if (mine == kUnsetRef) return std::string("a new ") + kind + " (" + role + ")";
    return with_role(name_of(mine), role);
  }

  /// A cell for the anchor of the expected element `ref`: right if it is any of the half-edges
  /// in `legal`, which are expected ones.
  template <class Records>
  void add_anchor(const Records& before, const Records& after, Ref ref, Ref mine,
                  const std::string& name, const std::string& role,
                  const std::vector<Ref>& legal, bool near) {
    const bool exists = mine < after.size();
    const bool old = exists && mine < before.size();
    const Ref have = exists ? after[mine].halfedge : kUnsetRef;
    const Ref was = old ? before[mine].halfedge : kUnsetRef;
    const auto is_legal = [&](Ref anchor) {
      return anchor != kUnsetRef && std::any_of(legal.begin(), legal.end(), [&](Ref h) {
               return match_.halfedges[h] == anchor;
             });
    };
    const bool right = exists && is_legal(have);
    if (!old || !is_legal(was)) ++diff_.to_change;
    if (right && !near) return;
    std::vector<std::string> choices;
    for (Ref h : legal) {
      if (choices.size() < 3) choices.push_back(wanted_halfedge_text(h));
    }
    const std::string more = legal.size() > choices.size() ? ", ..." : "";
    PointerRow row{exists ? name : "", role, {}};
    add_cell(row, ref,
             {old ? old_halfedge_text(was) : "", exists ? halfedge_text(have) : "",
              right ? halfedge_text(have) : join(choices, " or ") + more, !right},
             exists && was_changed(was, have));
    table().rows.push_back(std::move(row));
  }

  /// All half-edges that leave a vertex; of the new vertex only those along the split edge.
  std::vector<Ref> legal_anchors(Ref vertex) const {
    std::vector<Ref> legal;
    const Ref first = expected_.vertices[vertex].halfedge;
    Ref h = first;
    do {
      const Ref twin = expected_.halfedges[h].twin;
      const Ref end = expected_.halfedges[twin].vertex;
      if (vertex != split_vertex_ || end == diamond_.b || end == diamond_.c) legal.push_back(h);
      h = expected_.halfedges[twin].next;
    } while (h != first);
    // Named ones first: they are the ones that a message can show.
    std::stable_partition(legal.begin(), legal.end(),
                          [&](Ref g) { return !halfedge_role(g).empty(); });
    return legal;
  }

  void add_vertices() {
    begin_table(ElementKind::kVertex, "vertices", {"halfedge"});
    for (Ref v = 0; v < expected_.vertices.size(); ++v) {
      if (expected_.vertices[v].live == 0) continue;
      const Ref mine = match_.vertices[v];
      add_anchor(before_.vertices, after_.vertices, v, mine, vertex_name(mine), letter(v),
                 legal_anchors(v), !letter(v).empty());
    }
  }

  void add_edges() {
    begin_table(ElementKind::kEdge, "edges", {"halfedge"});
    for (Ref e = 0; e < expected_.edges.size(); ++e) {
      if (expected_.edges[e].live == 0) continue;
      const Ref h = expected_.edges[e].halfedge;
      const Ref twin = expected_.halfedges[h].twin;
      const Ref mine = match_.edges[e];
      add_anchor(before_.edges, after_.edges, e, mine, edge_name(mine), halfedge_role(h),
                 {h, twin}, is_near(h) || is_near(twin));
    }
  }

  void add_faces() {
    begin_table(ElementKind::kFace, "faces", {"halfedge"});
    for (Ref f = 0; f < expected_.faces.size(); ++f) {
      if (expected_.faces[f].live == 0) continue;
      const Ref h = expected_.faces[f].halfedge;
      const Ref next = expected_.halfedges[h].next;
      const Ref mine = match_.faces[f];
      add_anchor(before_.faces, after_.faces, f, mine, face_name(mine), face_role(f),
                 {h, next, expected_.halfedges[next].next}, !face_role(f).empty());
    }
  }

  template <class Records>
  void count_elements(std::size_t expected, const std::vector<Ref>& map,
                      const Records& records) {
    const auto live = static_cast<std::size_t>(std::count_if(
        records.begin(), records.end(), [](const auto& r) { return r.live != 0; }));
    const auto missing =
        static_cast<std::size_t>(std::count(map.begin(), map.end(), kUnsetRef));
    diff_.missing += missing;
    if (live + missing > expected) diff_.surplus += live + missing - expected;
  }

  const MeshDump& before_;
  const MeshDump& after_;
  const MeshDump& expected_;
  Ref edge_;
  Ref split_vertex_;
  Diamond diamond_;
  Correspondence match_;
  std::map<Ref, std::string> letters_;
  ElementKind kind_ = ElementKind::kHalfedge;  // of the last table
  std::map<Ref, Ref> stands_for_;              // the student's half-edge -> the expected one
  std::vector<WrongCell> wrong_cells_;
  PointerDiff diff_;
};

}  // namespace

std::string as_left(const WrongPointer& pointer) {
  if (pointer.was_set) return pointer.name + " was set to " + pointer.actual;
  return pointer.name + " is still " + pointer.actual + (pointer.is_new ? "" : ", as before");
}

std::string must_be_text(const WrongPointer& pointer) {
  std::string text = "must be " + pointer.expected;
  if (pointer.was_set) return text + ", you set " + pointer.actual;
  if (!pointer.actual.empty()) text += ", is still " + pointer.actual;
  return text + (pointer.is_new ? "" : ", as before");
}

PointerDiff diff_pointers(const MeshDump& before, const MeshDump& after,
                          const MeshDump& expected, Ref edge, Ref split_vertex) {
  return Differ(before, after, expected, edge, split_vertex).diff();
}

}  // namespace meshgrade
