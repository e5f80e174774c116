#include "grader/judge/operation_judge.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/judge/findings.h"
#include "grader/judge/local_scale.h"
#include "grader/judge/operation_advice.h"
#include "grader/judge/operation_model.h"
#include "grader/judge/operation_surface.h"
#include "grader/judge/pointer_diff.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {
namespace {

/// The elements that are there afterwards and were not before, "v4, e5"; empty if anything
/// else is different, too.
std::string only_new_elements(const MeshDump& before, MeshDump after) {
  std::vector<std::string> names;
  const auto cut = [&](const auto& old_list, auto& new_list, auto name) {
    for (std::size_t i = old_list.size(); i < new_list.size(); ++i) {
      if (new_list[i].live != 0) names.push_back(name(static_cast<Ref>(i)));
    }
    new_list.resize(old_list.size());
  };
  cut(before.vertices, after.vertices, vertex_name);
  cut(before.edges, after.edges, edge_name);
  cut(before.faces, after.faces, face_name);
  cut(before.halfedges, after.halfedges, halfedge_name);
  return to_wire(after) == to_wire(before) ? join(names, ", ") : "";
}

struct RightAnswer {
  MeshDump mesh;
  Ref split_vertex = kUnsetRef;
};

RightAnswer right_answer(const MeshDump& before, OperationKind kind, Ref edge) {
  RightAnswer right{before};
  if (kind == OperationKind::kSplit) {
    right.split_vertex = model_split(right.mesh, edge);
  } else if (!is_boundary_edge(before, edge)) {
    model_flip(right.mesh, edge);
  }
  return right;
}

/// Judges one operation, from a mesh that is right.
class StepJudge {
 public:
  StepJudge(const JudgeTask& task, const MeshDump& before, Operation operation,
            const OperationStep& step, std::string where, CaseJudgement& judgement)
      : task_(task),
        before_(before),
        operation_(operation),
        step_(step),
        after_(step.after),
        where_(std::move(where)),
        judgement_(judgement),
        edge_(step.edge),
        boundary_(is_boundary_edge(before, edge_)),
        diamond_(diamond_of(before, edge_)) {}

  void judge() {
    if (!keeps_old_elements()) {
      const RightAnswer right = answer();
      add_figure(right.mesh, right.split_vertex);
      return;
    }
    const std::string added = boundary_ ? only_new_elements(before_, after_) : "";
    if (same_mesh(before_)) {
      judge_untouched();
    } else if (!added.empty()) {
      report("counts", "a boundary edge that is not split or flipped leaves the mesh as it is",
             edge_text(), "no element more than before", "new, and not used: " + added,
             "calls of newVertex and the like above the check for a boundary: check first");
    } else if (operation_.kind == OperationKind::kFlip) {
      judge_flip();
    } else {
      judge_split();
    }
  }

 private:
  RightAnswer answer() const { return right_answer(before_, operation_.kind, edge_); }

  void report(std::string rule, std::string meaning, std::string element, std::string expected,
              std::string actual, std::string look_at) {
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), where_,
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
  }

  std::string edge_text() const {
    return edge_name(edge_) + " (" + edge_ends(before_, edge_) + ")";
  }

  /// Every old element is still there, so that the handles of whoever holds one stay good. A
  /// split may put new half-edges and faces, and its own edge, in place of old ones: the
  /// surface and the names of vertices and other edges are the same then.
  bool keeps_old_elements() {
    const std::size_t known = judgement_.findings.size();
    const bool may_replace =
        operation_.kind == OperationKind::kSplit && count(after_) == count(answer().mesh);
    check_kept(before_.vertices, after_.vertices, vertex_name);
    check_kept(before_.edges, after_.edges, edge_name, may_replace ? edge_ : kUnsetRef);
    if (!may_replace) {
      check_kept(before_.faces, after_.faces, face_name);
      check_kept(before_.halfedges, after_.halfedges, halfedge_name);
    }
    check_kept(before_.boundaries, after_.boundaries,
               [](Ref b) { return face_name(b | kBoundaryBit); });
    return judgement_.findings.size() == known;
  }

  static bool is_gone(const auto& old_list, const auto& new_list, Ref i) {
    return old_list[i].live != 0 && (i >= new_list.size() || new_list[i].live == 0);
  }

  void check_kept(const auto& old_list, const auto& new_list, auto name, Ref free = kUnsetRef) {
    for (Ref i = 0; i < old_list.size(); ++i) {
      if (i == free || !is_gone(old_list, new_list, i)) continue;
      report("counts", std::string(rule_meaning("counts")), name(i),
             "the old element " + name(i) + " is still in the mesh", "it was deleted",
             "calls of deleteVertex, deleteEdge, deleteFace, deleteHalfedge");
      return;
    }
  }

  /// Says which old elements a right split has put others in place of.
  void note_replaced() {
    std::vector<std::string> names;
    const auto add = [&](const auto& old_list, const auto& new_list, auto name) {
      for (Ref i = 0; i < old_list.size(); ++i) {
        if (is_gone(old_list, new_list, i)) names.push_back(name(i));
      }
    };
    add(before_.edges, after_.edges, edge_name);
    add(before_.faces, after_.faces, face_name);
    add(before_.halfedges, after_.halfedges, halfedge_name);
    if (names.empty()) return;
    judgement_.note =
        "right, but the split deletes old elements and makes new ones in their "
        "place: whoever holds a handle to one cannot use it any more. They can "
        "be kept: only their pointers change";
  }

  /// Nothing about the surface and its elements has changed.
  bool same_mesh(const MeshDump& other) {
    return count(after_) == count(other) && find_broken_rules(after_).empty() &&
           is_right_surface(other, kUnsetRef);
  }

  void judge_untouched() {
    const bool is_flip = operation_.kind == OperationKind::kFlip;
    const bool may_refuse = boundary_ || (is_flip && would_double());
    if (may_refuse && !keeps_positions()) return;
    if (is_flip && may_refuse) return;
    if (!is_flip && boundary_) {
      if (task_.asked.group != "boundary_split") return;
      judgement_.verdict = Verdict::kNotImplemented;
      judgement_.note = "boundary edges are left as they are: allowed, but no extra credit";
      return;
    }
    report("nothing-done", is_flip ? "an inner edge is turned" : "an edge gets a new vertex",
           edge_text(),
           is_flip ? edge_name(edge_) + " joins " + vertex_name(diamond_.a) + " and " +
                         vertex_name(diamond_.d) + " afterwards"
                   : "a new vertex in the middle of " + edge_text(),
           "the mesh is the same as before",
           is_flip ? "does flipEdge return too early?" : "does splitEdge return too early?");
    if (!task_.explain) return;
    const RightAnswer right = answer();
    judgement_.findings[0].pointers.figure =
        figure_of_nothing_done(before_, right.mesh, edge_, right.split_vertex);
  }

  bool would_double() const {
    return diamond_.a == diamond_.d || find_edge(before_, diamond_.a, diamond_.d) != kUnsetRef;
  }

  void judge_flip() {
    if (boundary_) {
      report_harmed_boundary();
      return;
    }
    const bool doubled = would_double();
    const MeshDump expected = answer().mesh;
    if (!keeps_rules(doubled) || !has_counts(expected) ||
        !require_surface(expected, kUnsetRef)) {
      explain(expected, kUnsetRef);
      measure_share(expected, kUnsetRef);
      return;
    }
    if (keeps_positions() && step_.returned != edge_) {
      report("returned", "flipEdge returns the edge that it was given", edge_name(edge_),
             "the edge " + edge_name(edge_) + " is returned",
             "returned: " + edge_name(step_.returned), "the return statement of flipEdge");
    }
    add_figure(expected, kUnsetRef);
    measure_share(expected, kUnsetRef);
  }

  void judge_split() {
    const bool may_refuse = boundary_ && task_.asked.group != "boundary_split";
    const auto [expected, m] = answer();
    if (boundary_ && is_counted_as_inner()) {
      report_split_as_inner(expected, m);
      return;
    }
    if (!keeps_rules(false) || !has_counts(expected) || !require_surface(expected, edge_)) {
      explain(expected, m);
      if (may_refuse) {
        judgement_.findings[0].look_at +=
            "; or refuse boundary edges: check for one first, on both sides";
      }
      measure_share(expected, m);
      return;
    }
    const Ref mine = match_->vertex[m];
    if (judge_anchor(mine)) {
      judge_new_vertex(expected, m, mine);
      if (judgement_.findings.empty()) keeps_positions();
      if (judgement_.findings.empty()) note_replaced();
      add_figure(expected, m);
    } else {
      explain(expected, m);
    }
    measure_share(expected, m);
  }

  /// How much is right of the pointers that the operation has to change or set; another
  /// returned handle and a new vertex elsewhere count as wrong ones, too.
  void measure_share(const MeshDump& expected, Ref m) {
    if (judgement_.findings.empty() || !counts_pointers()) return;
    const PointerDiff& diff = compare(expected, m);
    // What is right only because nothing was done counts for nothing.
    const std::size_t asked = diff.to_change;
    std::size_t wrong = diff.wrong.size() + diff.surplus + (moved_vertex() ? 1 : 0);
    if (m == kUnsetRef) {
      if (step_.returned != edge_) ++wrong;
    } else {
      const Ref mine = diff.new_vertex;
      if (step_.returned != mine) ++wrong;
      if (mine == kUnsetRef || !is_midpoint(expected.vertices[m].position, mine)) ++wrong;
    }
    judgement_.right_share =
        wrong >= asked ? 0.0 : 1.0 - static_cast<double>(wrong) / static_cast<double>(asked);
  }

  bool counts_pointers() const {
    const auto& groups = task_.rubric.groups;
    return std::any_of(groups.begin(), groups.end(), [&](const Group& group) {
      return group.name == task_.asked.group && group.partial == Partial::kPointers;
    });
  }

  const PointerDiff& compare(const MeshDump& expected, Ref split_vertex) {
    if (!diff_) diff_ = diff_pointers(before_, after_, expected, edge_, split_vertex);
    return *diff_;
  }

  /// There are as many elements more as the split of an edge between two triangles makes.
  bool is_counted_as_inner() const {
    const Counts old = count(before_);
    const Counts now = count(after_);
    return now.vertices == old.vertices + 1 && now.edges == old.edges + 3 &&
           now.faces == old.faces + 2 && now.halfedges == old.halfedges + 6;
  }

  void report_split_as_inner(const MeshDump& expected, Ref m) {
    const bool may_refuse = task_.asked.group != "boundary_split";
    report("boundary-edge", "on one side of a boundary edge there is no triangle", edge_text(),
           std::string("one triangle becomes two") +
               (may_refuse ? ", or the mesh stays as it is" : ""),
           "two triangles became four: the outside was taken for one of them",
           "there is no test for a boundary, or it asks one side only: both half-edges of the "
           "edge may be the one outside");
    if (task_.explain) {
      keep_scene(expected);
      judgement_.findings[0].pointers = compare(expected, m);
    }
    keeps_rules(false);
  }

  void judge_new_vertex(const MeshDump& expected, Ref m, Ref mine) {
    if (step_.returned != mine) {
      report("returned", "splitEdge returns the new vertex", vertex_name(mine),
             "the new vertex " + vertex_name(mine) + " is returned",
             "returned: " + vertex_name(step_.returned), "the return statement of splitEdge");
      return;
    }
    judge_midpoint(expected.vertices[m].position, mine);
  }

  bool judge_anchor(Ref mine) {
    const Ref h = after_.vertices[mine].halfedge;
    const Ref end = after_.halfedges[after_.halfedges[h].twin].vertex;
    if (end == diamond_.b || end == diamond_.c) return true;
    report("along-edge", "the half-edge of the new vertex lies along the edge that was split",
           vertex_name(mine),
           vertex_name(mine) + ".halfedge leads to " + vertex_name(diamond_.b) + " or " +
               vertex_name(diamond_.c),
           vertex_name(mine) + ".halfedge is " + halfedge_name(h) + ", which leads to " +
               vertex_name(end),
           vertex_name(mine) + ".halfedge");
    judgement_.findings.back().likely = {
        find_misconception(split_misconceptions(), "anchor-on-new-edge")};
    return false;
  }

  double distance_from(const Point3& expected, Ref mine) const {
    const Point3& actual = after_.vertices[mine].position;
    return std::hypot(actual[0] - expected[0], actual[1] - expected[1],
                      actual[2] - expected[2]);
  }

  LocalScale scale() const {
    return scale_of_edge(before_.vertices[diamond_.b].position,
                         before_.vertices[diamond_.c].position, task_.tolerance);
  }

  bool is_midpoint(const Point3& expected, Ref mine) const {
    return distance_from(expected, mine) <= scale().allowed;
  }

  void judge_midpoint(const Point3& expected, Ref mine) {
    if (is_midpoint(expected, mine)) return;
    const Point3& actual = after_.vertices[mine].position;
    const double error = distance_from(expected, mine);
    const LocalScale scale = this->scale();
    report("midpoint", "the new vertex lies in the middle of the edge that was split",
           vertex_name(mine),
           "the middle of " + vertex_name(diamond_.b) + " and " + vertex_name(diamond_.c) +
               ": " + point_text(expected),
           point_text(actual) + ", off by " + error_text(error, scale),
           vertex_name(mine) + ".position");
    judgement_.findings.back().likely =
        recognize_midpoint(before_, diamond_, actual, scale.allowed);
  }

  /// Puts what is wrong pointer by pointer in front of the rules that are broken by it.
  void explain(const MeshDump& expected, Ref split_vertex) {
    if (!task_.explain) return;
    keep_scene(expected);
    const PointerDiff& diff = compare(expected, split_vertex);
    const bool counts_differ = diff.missing + diff.surplus > 0;
    if (counts_differ && judgement_.findings[0].rule != "counts") {
      has_counts(expected);
      std::rotate(judgement_.findings.begin(), judgement_.findings.end() - 1,
                  judgement_.findings.end());
    } else if (!counts_differ && !diff.wrong.empty()) {
      lead_with_pointer(diff.wrong);
      const std::string exchanged = exchange_advice(diff.wrong);
      if (!exchanged.empty()) judgement_.findings[0].look_at = exchanged;
    }
    judgement_.findings[0].pointers = diff;
  }

  /// Begins with a wrong pointer, under a rule that it breaks.
  void lead_with_pointer(const std::vector<WrongPointer>& wrong) {
    const auto& findings = judgement_.findings;
    for (const WrongPointer& pointer : wrong) {
      const auto broken = std::find_if(
          findings.begin(), findings.end(),
          [&](const Finding& finding) { return is_about(finding.rule, pointer.name); });
      if (broken != findings.end()) return lead_with(pointer, *broken);
    }
    lead_with(wrong[0], findings[0]);
  }

  void lead_with(const WrongPointer& pointer, Finding lead) {
    lead.element = pointer.role.empty() ? pointer.name : pointer.name + ", of " + pointer.role;
    lead.expected = pointer.name + " is " + pointer.expected;
    lead.actual = as_left(pointer);
    lead.look_at = pointer.name;
    judgement_.findings.insert(judgement_.findings.begin(), std::move(lead));
  }

  /// Shows the neighbourhood, if there is something to show besides wrong pointers.
  void add_figure(const MeshDump& expected, Ref split_vertex) {
    if (!task_.explain || judgement_.findings.empty()) return;
    judgement_.findings[0].pointers.figure = compare(expected, split_vertex).figure;
  }

  /// For a viewer.
  void keep_scene(const MeshDump& expected) {
    if (expected.halfedges.size() > kMostSceneHalfedges) return;
    const std::string verb = operation_.kind == OperationKind::kFlip ? "flip " : "split ";
    judgement_.scene = {verb + edge_text(), edge_, before_, after_, expected};
  }

  /// All mesh rules; `doubled` allows what a flip onto an edge that exists cannot avoid.
  bool keeps_rules(bool doubled) {
    const std::size_t known = judgement_.findings.size();
    for (const RuleBreak& rule_break : find_broken_rules(after_)) {
      if (doubled && rule_break.rule == "simple") continue;
      judgement_.findings.push_back(to_finding(rule_break, where_));
    }
    return judgement_.findings.size() == known;
  }

  bool has_counts(const MeshDump& expected) {
    const Counts want = count(expected);
    const Counts have = count(after_);
    if (want == have) return true;
    report("counts", std::string(rule_meaning("counts")), "the mesh", counts_text(want),
           counts_text(have), count_advice(want, have));
    return false;
  }

  bool is_right_surface(const MeshDump& expected, Ref free_edge) {
    match_ = match_operation({before_, after_, expected, free_edge});
    return match_.has_value();
  }

  bool require_surface(const MeshDump& expected, Ref free_edge) {
    if (is_right_surface(expected, free_edge)) return true;
    judgement_.findings.push_back(
        surface_finding({before_, after_, expected, free_edge}, where_, edge_));
    return false;
  }

  /// The first old vertex that lies elsewhere now.
  std::optional<Ref> moved_vertex() const {
    for (Ref v = 0; v < before_.vertices.size(); ++v) {
      const VertexRecord& old = before_.vertices[v];
      if (old.live != 0 && old.position != after_.vertices[v].position) return v;
    }
    return std::nullopt;
  }

  bool keeps_positions() {
    const std::optional<Ref> v = moved_vertex();
    if (!v) return true;
    report("position", "no old vertex moves", vertex_name(*v),
           point_text(before_.vertices[*v].position), point_text(after_.vertices[*v].position),
           vertex_name(*v) + ".position");
    return false;
  }

  void report_harmed_boundary() {
    report(
        "boundary-edge", "a boundary edge cannot be flipped: the mesh stays as it is",
        edge_text(), "the mesh is the same as before", "the mesh was changed",
        "there is no test for a boundary at the start of flipEdge, or it asks one side only: "
        "either of the two half-edges may be the one outside");
    if (task_.explain) {
      keep_scene(before_);
      judgement_.findings[0].pointers = compare(before_, kUnsetRef);
    }
    keeps_rules(false);
  }

  const JudgeTask& task_;
  const MeshDump& before_;
  Operation operation_;
  const OperationStep& step_;
  const MeshDump& after_;
  std::string where_;
  CaseJudgement& judgement_;
  Ref edge_;
  bool boundary_;
  Diamond diamond_;
  std::optional<SurfaceMatch> match_;
  std::optional<PointerDiff> diff_;  // with the right answer
};
}  // namespace

NeighbourhoodFigure figure_of_stop(const MeshDump& before, OperationKind kind, Ref edge,
                                   const MeshDump& stopped) {
  const RightAnswer right = right_answer(before, kind, edge);
  NeighbourhoodFigure figure =
      diff_pointers(before, stopped, right.mesh, edge, right.split_vertex).figure;
  figure.is_stopped = true;
  // What is not set yet might have been set later.
  std::erase_if(figure.faults, [](const FigureFault& fault) { return !fault.was_set; });
  return figure;
}

void judge_step(const JudgeTask& task, const MeshDump& before, Operation operation,
                const OperationStep& step, std::string where, CaseJudgement& judgement) {
  StepJudge(task, before, operation, step, std::move(where), judgement).judge();
}

void judge_operation(const JudgeTask& task, const MeshDump& before, OperationKind kind,
                     const OperationStep& step, CaseJudgement& judgement) {
  if (step.edge >= before.edges.size() || before.edges[step.edge].live == 0) {
    throw WireError("another edge");
  }
  judge_step(task, before, {kind, 0, 0}, step, "", judgement);
  if (!judgement.findings.empty()) judgement.verdict = Verdict::kFailed;
}

}  // namespace meshgrade
