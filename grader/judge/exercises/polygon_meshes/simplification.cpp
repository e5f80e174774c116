#include <algorithm>
#include <cmath>
#include <set>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/simplification_input.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/judge/collapse_search.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"
#include "grader/judge/surface_distance.h"
#include "grader/judge/triangle_surface.h"
#include "grader/judge/unchanged_mesh.h"
#include "grader/mesh/mesh_rules.h"
#include "grader/operations/picked_element.h"
#include "grader/simplify/openmesh_decimation.h"

namespace meshgrade {
namespace {

/// How much farther from the shape than OpenMesh's a mesh with as many faces may be.
constexpr double kTimesOpenMesh = 1.5;

/// With fewer edges, it may be chance that a misconception collapses the same ones.
constexpr std::size_t kEnoughToTell = 30;

const Misconceptions& simplification_misconceptions() {
  static const Misconceptions all{
      {"offset-sign",
       "d = -n . q for a plane through q with the normal n: here it has the other sign, and "
       "the "
       "vertex lies as if mirrored at the origin"},
      {"optimum-sign",
       "the best point solves A v = -b, with b from the last column of K: here it is A v = b"},
      {"middle",
       "the vertex goes to the middle of the edge, and the cost is that of the middle; the "
       "best "
       "point is where the quadric is least"},
      {"ends-and-middle",
       "the vertex goes to an end or to the middle, whichever is best, also where A can be "
       "inverted: solve A v = -b there"},
      {"not-moved",
       "the edges are the right ones, and the vertex stays in the middle, where collapseEdge() "
       "puts it: move it to the best point afterwards"},
      {"dearest-first", "the most expensive edge is collapsed first: the order is upside down"},
      {"shortest-first", "the shortest edge is collapsed first, whatever it costs"},
      {"not-normalized",
       "the normals have not the length 1: a large triangle counts far too much"},
      {"shared-faces-once",
       "the two faces beside the edge count once: the quadric of an edge is the SUM of those "
       "of "
       "its ends, to which both faces add theirs"},
      {"quadrics-anew",
       "the new vertex has the planes of the faces that are around it now: it gets the quadric "
       "of the edge, which remembers the planes of the faces that there were at first"},
      {"costs-not-renewed",
       "the edges at the new vertex keep the costs that they had before: they must be computed "
       "anew with its quadric"},
      {"first-in-list", "the first edge of the list is collapsed, whatever it costs"},
      {"last-in-list", "the last edge of the list is collapsed, whatever it costs"}};
  return all;
}

/// The number of the edge between two vertices.
Ref edge_between(const MeshDump& mesh, const LabelPair& ends) {
  for (Ref e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.edges[e].live == 0) continue;
    const HalfedgeRecord& h = mesh.halfedges[mesh.edges[e].halfedge];
    const Ref end = mesh.halfedges[h.twin].vertex;
    if (LabelPair(std::min(h.vertex, end), std::max(h.vertex, end)) == ends) return e;
  }
  return kUnsetRef;
}

constexpr const char* kNothingToDo = "what is done before the goal is compared with nFaces()";
constexpr UnchangedWords kStays{"a mesh that has few enough faces stays as it is", kNothingToDo,
                                kNothingToDo};

/// Judges what a call has left of a mesh.
class SimplificationJudge {
 public:
  SimplificationJudge(const JudgeTask& task, const SimplificationInput& input,
                      const RefusableStep& step, Conventions& conventions,
                      CaseJudgement& judgement)
      : task_(task),
        input_(input),
        before_(built_mesh(input.mesh, input.anchor_turns)),
        after_(step.after),
        is_done_(step.done != 0),
        conventions_(conventions),
        judgement_(judgement) {}

  void judge() {
    if (input_.ratio >= 1.0) return judge_unchanged();
    if (!is_sound() || !has_topology() || !has_goal()) return;
    const FaceLists old = face_lists_of(before_);
    switch (input_.compared) {
      case SimplifiedAs::kCheapest:
        return judge_collapses(old);
      case SimplifiedAs::kSame:
        return judge_same_shape(old);
      case SimplifiedAs::kSimilar:
        return judge_similar_shape(old);
      case SimplifiedAs::kAnything:
        return;
    }
  }

 private:
  void report(std::string rule, std::string meaning, std::string element, std::string expected,
              std::string actual, std::string look_at) {
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), "",
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
  }

  void judge_unchanged() {
    if (auto change = find_change(before_, after_, "", kStays)) {
      judgement_.findings.push_back(std::move(*change));
    } else if (!is_done_) {
      report("returned", "true is returned when the goal is reached", "the mesh",
             "true: the mesh has few enough faces from the beginning", "false", kNothingToDo);
    }
  }

  bool is_sound() {
    for (const RuleBreak& broken : find_broken_rules(after_, FaceShape::kDegeneratePolygons)) {
      judgement_.findings.push_back(to_finding(broken, ""));
      if (judgement_.findings.size() == 1)
        judgement_.findings[0].look_at +=
            "; only collapseEdge() changes pointers here: is it right on its own?";
    }
    if (!judgement_.findings.empty()) return false;
    if (auto other =
            find_other_face(after_, "which functions are called besides collapseEdge()"))
      judgement_.findings.push_back(std::move(*other));
    return judgement_.findings.empty();
  }

  bool has_topology() {
    const std::string before = topology_text(before_);
    const std::string after = topology_text(after_);
    if (before == after) return true;
    report("topology", "collapses neither tear a surface nor close its holes", "the mesh",
           before, after, "collapseEdge(): which edges it must refuse");
    return false;
  }

  double goal_of(std::size_t n) const { return input_.ratio * static_cast<double>(n); }

  /// At most so many, however the goal was rounded; of edges in place of faces, too, as one
  /// course has it.
  bool is_reached() const {
    const Counts old = count(before_);
    const Counts now = count(after_);
    return static_cast<double>(now.faces) < goal_of(old.faces) + 1.0 ||
           static_cast<double>(now.edges) < goal_of(old.edges) + 1.0;
  }

  /// The last collapse takes up to two faces and three edges; one more may have been done.
  bool is_passed() const {
    const Counts old = count(before_);
    const Counts now = count(after_);
    return static_cast<double>(now.faces) < std::floor(goal_of(old.faces)) - 3.0 &&
           static_cast<double>(now.edges) < std::floor(goal_of(old.edges)) - 5.0;
  }

  bool has_goal() {
    const Counts old = count(before_);
    const Counts now = count(after_);
    const std::string goal = "at most " + number_text(goal_of(old.faces)) + " of " +
                             plural(old.faces, "face") + " (ratio " +
                             number_text(input_.ratio) + ")";
    const std::string left =
        plural(now.faces, "face") + (now.faces == old.faces ? ", as before" : "");
    constexpr const char* kMeaning =
        "edges are collapsed until at most ratio times as many faces are left";
    if (is_passed()) {
      report("goal", kMeaning, "the mesh", "the last collapse is the one that reaches " + goal,
             left,
             "the condition of the loop: compare nFaces() with the goal, which is "
             "computed once, at the beginning");
    } else if (is_reached()) {
      const bool by_all = static_cast<double>(now.faces) <= goal_of(old.faces) &&
                          static_cast<double>(now.edges) <= goal_of(old.edges);
      if (is_done_ || !by_all) return true;
      report("returned", "true is returned when the goal is reached", "the mesh",
             "true: " + goal + " are left", "false, with " + left,
             "what is returned after the loop");
    } else if (is_done_) {
      report("goal", kMeaning, "the mesh", goal, left + ", and true was returned",
             "how faces are counted: a collapse at a boundary takes one face, and one that is "
             "refused takes none. nFaces() tells how many are left");
    } else {
      return has_no_edge_left(goal, left);
    }
    return false;
  }

  /// Of a mesh with which the function has given up.
  bool has_no_edge_left(const std::string& goal, const std::string& left) {
    const CollapsingMesh mesh(face_lists_of(after_), right_collapse_ways()[0]);
    for (const LabelPair& edge : mesh.edges()) {
      if (!mesh.is_sound(edge)) continue;
      const auto& positions = mesh.lists().positions;
      const Point3 middle = middle_of(positions[edge.first], positions[edge.second]);
      if (mesh.turns_a_face(edge, middle) || mesh.turns_a_face(edge, positions[edge.first]) ||
          mesh.turns_a_face(edge, positions[edge.second])) {
        continue;
      }
      report("gave-up",
             "an edge whose collapse is refused is passed over, and the next one is tried",
             edge_name(edge_between(after_, edge)),
             goal + ": " + edge_text(edge) + " can be collapsed",
             left + ", and false was returned",
             "what happens when collapseEdge() returns std::nullopt: go on with the next edge");
      return false;
    }
    return true;
  }

  static Point3 middle_of(const Point3& p, const Point3& q) {
    return {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])};
  }

  void judge_collapses(const FaceLists& old) {
    const Counts was = count(before_);
    const Counts now = count(after_);
    const std::size_t n = was.vertices - std::min(was.vertices, now.vertices);
    // Planes across the boundary are free, and what they do to the second collapse is open.
    if (was.boundaries > 0 && n > 1) return;
    Conventions agreeing;
    CollapseFit best;
    for (const CollapseWay& way : right_collapse_ways()) {
      const CollapseFit fit = fit_collapses(old, way, n, after_);
      if (fit.fit == Fit::kFits || fit.fit == Fit::kUnknown) agreeing.insert(way.name);
      if (fit.fit == Fit::kOtherPoints && best.fit == Fit::kNone) best = fit;
    }
    Conventions kept;
    std::set_intersection(agreeing.begin(), agreeing.end(), conventions_.begin(),
                          conventions_.end(), std::inserter(kept, kept.end()));
    if (!kept.empty()) {
      conventions_ = kept;
      return;
    }
    if (!agreeing.empty()) {
      report_mixed(*agreeing.begin());
    } else if (best.fit == Fit::kOtherPoints) {
      report_point(best);
    } else {
      report_other_edges(old, n);
    }
    judgement_.findings[0].likely = likely_causes(old, n);
  }

  void report_mixed(const std::string& other) {
    report("weights", "all faces weigh the same, or each by its area, in all cases", "the mesh",
           "quadrics weighed by " + *conventions_.begin() + ", as in the cases before",
           "quadrics weighed by " + other, "the quadric of a face");
  }

  void report_point(const CollapseFit& fit) {
    report(
        "new-position", "the vertex that is left lies where the quadric of its edge is least",
        vertex_name(fit.vertex),
        point_text(fit.at) + ", where it costs " + number_text(fit.cost, 3),
        point_text(after_.vertices[fit.vertex].position) + ", where it costs " +
            number_text(fit.actual_cost, 3),
        "the best point: A v = -b, where K has A above its last row, and b beside it. Is the "
        "vertex that collapseEdge() returns moved there?");
  }

  void report_other_edges(const FaceLists& old, std::size_t n) {
    const CollapsingMesh start(old, right_collapse_ways()[0]);
    const CollapsePath path = cheapest_collapses(old, right_collapse_ways()[0], n);
    const auto gone = n == 1 ? collapsed_edge(start) : std::nullopt;
    std::vector<std::string> texts;
    for (const DoneCollapse& done : path.done)
      texts.push_back(edge_text(done.edge) + " (cost " + number_text(done.cost.most, 3) + ")");
    if (gone) {
      const EdgeCost cost = start.cost(*gone);
      report("cheapest", "the edge of the least cost is collapsed",
             edge_name(edge_between(before_, *gone)),
             texts.empty() ? "nothing is collapsed" : texts[0] + " is collapsed",
             edge_text(*gone) + " was collapsed, whose cost is " + number_text(cost.most, 3),
             "the quadrics of the vertices, and the order in which edges are taken");
    } else {
      report("cheapest",
             n == 1
                 ? "one collapse moves one vertex and leaves all others where they are"
                 : "each time the edge of the least cost is collapsed, with the costs of then",
             "the mesh",
             texts.empty() ? "a mesh that is as it was"
                           : "collapsed are " + join(texts, ", then "),
             "other edges: gone or moved are " + join(gone_or_moved(), ", "),
             n == 1 ? "what is changed besides the vertex that collapseEdge() returns"
                    : "after a collapse: the new vertex gets the quadric of its edge, and all "
                      "edges at it get new costs");
    }
  }

  /// The edge that was collapsed, if all that has changed is that.
  std::optional<LabelPair> collapsed_edge(const CollapsingMesh& start) const {
    for (const LabelPair& edge : start.edges()) {
      if (after_.vertices.size() <= edge.second) continue;
      if (after_.vertices[edge.first].live != 0 && after_.vertices[edge.second].live != 0)
        continue;
      if (match_collapsed(start.collapsed(edge, start.cost(edge).at), after_)) return edge;
    }
    return {};
  }

  std::vector<std::string> gone_or_moved() const {
    std::vector<std::string> names;
    for (Ref v = 0; v < before_.vertices.size(); ++v) {
      const bool stays = v < after_.vertices.size() && after_.vertices[v].live != 0 &&
                         after_.vertices[v].position == before_.vertices[v].position;
      if (!stays) names.push_back(vertex_name(v));
    }
    constexpr std::size_t kMost = 12;
    if (names.size() > kMost) {
      names.resize(kMost);
      names.emplace_back("...");
    }
    return names;
  }

  Misconceptions likely_causes(const FaceLists& old, std::size_t n) const {
    Misconceptions likely;
    if (!task_.explain || before_.edges.size() < kEnoughToTell) return likely;
    const auto name = [&](const char* cause) {
      likely.push_back(find_misconception(simplification_misconceptions(), cause));
    };
    const double allowed = 1e-4 * extent(input_.mesh.positions) +
                           float_rounding(largest_coordinate(input_.mesh.positions));
    for (const CollapseWay& way : wrong_collapse_ways()) {
      if (!holds(likely, way.name) &&
          is_left_by(cheapest_collapses(old, way, n), after_, allowed))
        name(way.name);
    }
    const CollapsingMesh start(old, right_collapse_ways()[0]);
    const auto gone = n == 1 && likely.empty() ? collapsed_edge(start) : std::nullopt;
    if (!gone) return likely;
    const Ref edge = edge_between(before_, *gone);
    if (edge == 0) name("first-in-list");
    if (edge + 1 == before_.edges.size()) name("last-in-list");
    return likely;
  }

  double size() const { return extent(input_.mesh.positions); }

  void judge_same_shape(const FaceLists& old) {
    const FaceLists now = face_lists_of(after_);
    const double allowed = 100.0 * task_.tolerance * size();
    const double away = farthest_corner(now, old);
    const double back = count(before_).boundaries == 0 ? farthest_corner(old, now) : 0.0;
    if (std::max(away, back) <= allowed) return;
    report("shape",
           "what is flat or straight costs nothing: so the shape stays as it is down to this "
           "number of faces",
           "the mesh", "all vertices on the old surface, and the old ones on the new surface",
           away > allowed
               ? "a vertex is " + number_text(away, 3) + " away from the old surface"
               : "an old vertex is " + number_text(back, 3) + " away from what is left",
           "costs of edges that lie in a plane or along a straight crease are 0: is A tested "
           "for being singular there, and a point of the edge taken?");
  }

  void judge_similar_shape(const FaceLists& old) {
    const PolygonMesh other = openmesh_decimation(input_.mesh, count(after_).faces);
    FaceLists others{other.positions, other.polygons};
    const double limit = kTimesOpenMesh * surface_distance(others, old);
    const double distance = surface_distance(face_lists_of(after_), old);
    if (distance <= limit + task_.tolerance * size()) return;
    report(
        "shape", "the mesh stays close to the shape that it had", "the mesh",
        "at most " + number_text(limit, 3) +
            " away in the mean: 1.5 times as far as what "
            "OpenMesh makes with as many faces",
        number_text(distance, 3) + " away",
        "what happens after a collapse: the new vertex gets the quadric of its edge, and the "
        "edges at it get new costs");
  }

  const JudgeTask& task_;
  const SimplificationInput& input_;
  MeshDump before_;
  const MeshDump& after_;
  bool is_done_;
  Conventions& conventions_;
  CaseJudgement& judgement_;
};

void judge_simplification(const JudgeTask& task, Conventions& conventions,
                          CaseJudgement& judgement) {
  const auto input = from_wire<SimplificationInput>(task.asked.input);
  if (task.outcome.steps.size() > 1) throw WireError("too many steps");
  require_all_steps(task.outcome, 1);
  for (const std::string& bytes : task.outcome.steps) {
    const auto step = from_wire<RefusableStep>(bytes);
    SimplificationJudge(task, input, step, conventions, judgement).judge();
  }
  if (judgement.findings.empty()) return;
  judgement.verdict = Verdict::kFailed;
  mention_turned_anchors(input.anchor_turns, judgement);
}

}  // namespace

ExerciseJudge simplification_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  ExerciseJudge judge;
  judge.functions = {"PolyMesh::simplify"};
  for (const CollapseWay& way : right_collapse_ways())
    judge.conventions.insert(way.name);
  judge.judge_steps = judge_simplification;
  judge.misconceptions = simplification_misconceptions();
  return judge;
}

}  // namespace meshgrade
