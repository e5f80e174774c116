#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/options.h"
#include "grader/judge/unchanged_mesh.h"
#include "grader/mesh/mesh_rules.h"
#include "grader/operations/face_lists.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {
namespace {

/// A side of a face, by its edge and where it starts: two edges may have the same ends.
using Side = std::pair<Ref, Ref>;
using Sides = std::set<Side>;

std::string corners_text(const MeshDump& mesh, Ref face) {
  std::vector<std::string> names;
  for (const Label corner : corners_of(mesh, ElementKind::kFace, face).corners)
    names.push_back(vertex_name(corner));
  return join(names, "-");
}

/// The sides of each live face.
std::map<Ref, Sides> sides_of_faces(const MeshDump& mesh) {
  std::map<Ref, Sides> sides;
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0 && (h.face & kBoundaryBit) == 0) sides[h.face].insert({h.edge, h.vertex});
  }
  return sides;
}

/// The triangles of a mesh, joined over all edges that were not there before.
class Patches {
 public:
  /// @param mesh       keeps all mesh rules
  /// @param old_edges  edges with smaller numbers were there before
  Patches(const MeshDump& mesh, std::size_t old_edges)
      : mesh_(mesh), patch_(mesh.faces.size()) {
    std::iota(patch_.begin(), patch_.end(), 0U);
    for (const HalfedgeRecord& h : mesh.halfedges) {
      if (h.live == 0 || h.edge < old_edges) continue;
      const Ref other = mesh.halfedges[h.twin].face;
      // A new edge on a boundary: its numbers are wrong, which was told.
      if (((h.face | other) & kBoundaryBit) == 0) patch_[root(h.face)] = root(other);
    }
    for (const HalfedgeRecord& h : mesh.halfedges) {
      if (h.live == 0 || (h.face & kBoundaryBit) != 0 || h.edge >= old_edges) continue;
      const Side side{h.edge, h.vertex};
      face_at_[side] = h.face;
      sides_[root(h.face)].insert(side);
    }
  }

  /// The old sides of the triangles that are joined with the one at this side; empty if there
  /// is none.
  const Sides& around(const Side& side) {
    static const Sides none;
    const auto face = face_at_.find(side);
    return face == face_at_.end() ? none : sides_[root(face->second)];
  }

  /// "v0-v1-v2, v0-v2-v3": the triangles that are joined with the one at this side.
  std::string triangles_at(const Side& side) {
    constexpr std::size_t kMost = 4;
    const auto face = face_at_.find(side);
    if (face == face_at_.end()) return "no triangle";
    std::vector<std::string> texts;
    for (Ref f = 0; f < mesh_.faces.size(); ++f) {
      if (mesh_.faces[f].live == 0 || root(f) != root(face->second)) continue;
      texts.push_back(texts.size() < kMost ? corners_text(mesh_, f) : "...");
      if (texts.size() > kMost) break;
    }
    return join(texts, ", ");
  }

 private:
  Ref root(Ref face) {
    while (patch_[face] != face)
      face = patch_[face] = patch_[patch_[face]];
    return face;
  }

  const MeshDump& mesh_;
  std::vector<Ref> patch_;  ///< each face leads to another one of its patch, or to itself
  std::map<Side, Ref> face_at_;
  std::map<Ref, Sides> sides_;  ///< by the root
};

/// Judges one call, from a mesh that keeps all rules.
class TriangulationJudge {
 public:
  TriangulationJudge(const JudgeTask& task, const MeshDump& before, const MeshDump& after,
                     std::string where, CaseJudgement& judgement)
      : task_(task),
        before_(before),
        after_(after),
        where_(std::move(where)),
        judgement_(judgement),
        broken_(find_broken_rules(after, FaceShape::kDegeneratePolygons)) {}

  void judge() {
    // A face that is left alone makes the numbers wrong, too, and says more.
    const bool is_sound = broken_.empty() && has_only_triangles();
    const bool is_counted = judgement_.findings.empty() && has_counts();
    if (!broken_.empty()) {
      for (const RuleBreak& rule_break : broken_)
        judgement_.findings.push_back(to_finding(rule_break, where_));
    } else if (is_sound && is_counted && keeps_vertices() && keeps_edges()) {
      judge_patches();
    }
    if (task_.explain && !judgement_.findings.empty()) keep_scene();
  }

 private:
  void report(std::string rule, std::string meaning, std::string element, std::string expected,
              std::string actual, std::string look_at) {
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), where_,
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
  }

  bool has_only_triangles() {
    std::size_t others = 0;
    Ref first = kUnsetRef;
    for (Ref f = 0; f < after_.faces.size(); ++f) {
      if (after_.faces[f].live == 0) continue;
      if (corners_of(after_, ElementKind::kFace, f).corners.size() == 3) continue;
      if (others++ == 0) first = f;
    }
    if (others == 0) return true;
    const std::string corners = corners_text(after_, first);
    const auto n = corners_of(after_, ElementKind::kFace, first).corners.size();
    const bool is_old = first < before_.faces.size() && before_.faces[first].live != 0 &&
                        corners_text(before_, first) == corners;
    report("triangles", "every face is a triangle afterwards", face_name(first),
           face_name(first) + " has 3 corners",
           face_name(first) + " has " + std::to_string(n) + ": " + corners +
               (is_old ? ", as before" : "") +
               (others > 1 ? "; " + plural(others, "face") + " in all have more than 3" : ""),
           is_old ? "which faces the loop visits: all that were there when it began"
                  : "how often a face is cut: n corners need n - 3 cuts");
    return false;
  }

  Counts counts_wanted() const {
    Counts want = count(before_);
    for (const auto& [face, sides] : sides_of_faces(before_)) {
      want.faces += sides.size() - 3;
      want.edges += sides.size() - 3;
      want.halfedges += 2 * (sides.size() - 3);
    }
    return want;
  }

  bool has_counts() {
    const Counts want = counts_wanted();
    if (want == count(after_)) return true;
    report("counts", std::string(rule_meaning("counts")), "the mesh", counts_text(want),
           counts_text(count(after_)),
           "a face with n corners becomes n - 2 triangles by n - 3 new edges: one of them may "
           "keep the old face, or it is deleted");
    return false;
  }

  bool keeps_vertices() {
    for (Ref v = 0; v < before_.vertices.size(); ++v) {
      const VertexRecord& old = before_.vertices[v];
      if (old.live == 0) continue;
      const bool is_there = v < after_.vertices.size() && after_.vertices[v].live != 0;
      if (is_there && after_.vertices[v].position == old.position) continue;
      report("position", "all vertices stay, in their places", vertex_name(v),
             point_text(old.position),
             is_there ? point_text(after_.vertices[v].position)
                      : vertex_name(v) + " was deleted, and another one was made",
             is_there ? vertex_name(v) + ".position" : "calls of deleteVertex");
      return false;
    }
    return true;
  }

  static std::pair<Ref, Ref> ends_of(const MeshDump& mesh, Ref edge) {
    const HalfedgeRecord& h = mesh.halfedges[mesh.edges[edge].halfedge];
    return std::minmax(h.vertex, Ref{mesh.halfedges[h.twin].vertex});
  }

  bool keeps_edges() {
    for (Ref e = 0; e < before_.edges.size(); ++e) {
      if (before_.edges[e].live == 0) continue;
      const auto [a, b] = ends_of(before_, e);
      const bool is_there = e < after_.edges.size() && after_.edges[e].live != 0;
      if (is_there && ends_of(after_, e) == std::pair(a, b)) continue;
      const std::string ends = vertex_name(a) + "-" + vertex_name(b);
      report("identity", "all old edges stay where they are", edge_name(e),
             edge_name(e) + " joins " + ends,
             is_there ? edge_name(e) + " joins " + vertex_name(ends_of(after_, e).first) + "-" +
                            vertex_name(ends_of(after_, e).second)
                      : edge_name(e) + " was deleted",
             "which half-edges get a new .edge: only those of the cuts");
      return false;
    }
    return true;
  }

  /// The triangles that are joined over new edges have together the sides of one old face each.
  /// A face visits no vertex twice: so their order follows, and the numbers are right already.
  void judge_patches() {
    Patches patches(after_, before_.edges.size());
    const std::map<Ref, Sides> faces = sides_of_faces(before_);
    const auto wrong = std::find_if(faces.begin(), faces.end(), [&](const auto& face) {
      return patches.around(*face.second.begin()) != face.second;
    });
    if (wrong == faces.end()) return;
    const bool all_turned = std::all_of(faces.begin(), faces.end(), [&](const auto& face) {
      const Sides sides = turned(face.second);
      return patches.around(*sides.begin()) == sides;
    });
    if (all_turned) {
      report("orientation", std::string(rule_meaning("orientation")), "the mesh",
             "triangles wound like the faces that they are in",
             "all triangles are wound the other way", "the order of next around the triangles");
      return;
    }
    const auto& [face, sides] = *wrong;
    report(
        "surface", "the triangles of a face have its corners, and its sides around them",
        face_name(face),
        "triangles with the sides of " + face_name(face) + ": " + corners_text(before_, face),
        "triangles " + patches.triangles_at(*sides.begin()),
        "from which corners the cuts of this face start and where they end");
  }

  Sides turned(const Sides& sides) const {
    Sides turned;
    for (const auto& [edge, start] : sides) {
      const auto [a, b] = ends_of(before_, edge);
      turned.insert({edge, start == a ? b : a});
    }
    return turned;
  }

  /// For a viewer, with one of the right meshes: all triangles of a face at its first corner.
  void keep_scene() {
    if (after_.halfedges.size() > kMostSceneHalfedges) return;
    FaceLists fans = face_lists_of(before_);
    std::vector<Corners> triangles;
    for (const Corners& face : fans.faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        triangles.push_back({face[0], face[i], face[i + 1]});
    }
    fans.faces = std::move(triangles);
    // Two of the cuts may join the same corners.
    const bool is_simple = trouble_of(fans).empty();
    judgement_.scene = {"triangulate",
                        kUnsetRef,
                        before_,
                        after_,
                        is_simple ? mesh_of(fans) : before_,
                        FaceShape::kDegeneratePolygons};
  }

  const JudgeTask& task_;
  const MeshDump& before_;
  const MeshDump& after_;
  std::string where_;
  CaseJudgement& judgement_;
  std::vector<RuleBreak> broken_;
};

void judge_triangulations(const JudgeTask& task, Conventions& /*conventions*/,
                          CaseJudgement& judgement) {
  const auto input = from_wire<WholeMeshInput>(task.asked.input);
  if (task.outcome.steps.size() > input.times) throw WireError("too many steps");
  MeshDump before = built_mesh(input.mesh, input.anchor_turns);
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    auto after = from_wire<MeshDump>(task.outcome.steps[i]);
    const std::string where = input.times == 1 ? ""
                                               : "after call " + std::to_string(i + 1) +
                                                     " of " + std::to_string(input.times);
    TriangulationJudge(task, before, after, where, judgement).judge();
    if (!judgement.findings.empty()) {
      judgement.verdict = Verdict::kFailed;
      mention_turned_anchors(input.anchor_turns, judgement);
      return;
    }
    before = std::move(after);
  }
  require_all_steps(task.outcome, input.times);
}

}  // namespace

ExerciseJudge triangulation_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  ExerciseJudge judge;
  judge.functions = {"PolyMesh::triangulate"};
  judge.judge_steps = judge_triangulations;
  return judge;
}

}  // namespace meshgrade
