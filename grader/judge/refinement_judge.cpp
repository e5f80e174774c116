#include "grader/judge/refinement_judge.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/local_scale.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"
#include "grader/judge/unchanged_mesh.h"
#include "grader/mesh/polygons_of.h"
#include "grader/operations/picked_element.h"
#include "grader/subdivide/opensubdiv_level.h"

namespace meshgrade {
namespace {

constexpr PointKind kKinds[] = {PointKind::kFace, PointKind::kEdge, PointKind::kVertex};

constexpr UnchangedWords kComputes{
    "the function computes, and leaves the mesh as it was",
    "calls of new... and delete...: cutting the faces is not the task",
    "assignments to .position: the new place belongs into the map that is returned, and others "
    "still need the old one"};

/// How a kind of points is called.
struct KindWords {
  ElementKind element;
  const char* map;     ///< member of RefinedPositions
  const char* loop;    ///< what visits all of them
  const char* length;  ///< that errors are told by
};

const KindWords& words_of(PointKind kind) {
  static const KindWords face{ElementKind::kFace, "faces", "facesBegin() to facesEnd()",
                              "the mean length of its sides"};
  static const KindWords edge{ElementKind::kEdge, "edges", "edgesBegin() to edgesEnd()",
                              "the length of the edge"};
  static const KindWords vertex{ElementKind::kVertex, "vertices",
                                "verticesBegin() to verticesEnd()",
                                "the mean length of its edges"};
  if (kind == PointKind::kFace) return face;
  return kind == PointKind::kEdge ? edge : vertex;
}

const std::vector<PlacedElement>& entries_of(const RefinementStep& step, PointKind kind) {
  if (kind == PointKind::kFace) return step.faces;
  return kind == PointKind::kEdge ? step.edges : step.vertices;
}

/// The mean length of some edges, and what arithmetic in float may be off among these corners.
LocalScale scale_of(const SurfaceRings& rings, const std::vector<std::pair<Ref, Ref>>& edges,
                    const std::vector<Ref>& faces, double tolerance, const char* what) {
  LocalScale scale;
  scale.length = 0.0;
  std::vector<Point3> near;
  for (const auto& [a, b] : edges) {
    scale.length += distance(rings.positions[a], rings.positions[b]);
    near.push_back(rings.positions[a]);
    near.push_back(rings.positions[b]);
  }
  scale.length /= static_cast<double>(edges.size());
  for (const Ref f : faces) {
    for (const Ref corner : rings.corners[f])
      near.push_back(rings.positions[corner]);
  }
  scale.allowed = tolerance * scale.length + float_rounding(largest_coordinate(near));
  scale.what = what;
  return scale;
}

std::vector<LocalScale> scales_of(const SurfaceRings& rings, PointKind kind, double tolerance) {
  const char* what = words_of(kind).length;
  std::vector<LocalScale> scales;
  if (kind == PointKind::kFace) {
    for (Ref f = 0; f < rings.corners.size(); ++f) {
      const std::vector<Ref>& corners = rings.corners[f];
      std::vector<std::pair<Ref, Ref>> sides;
      for (std::size_t i = 0; i < corners.size(); ++i)
        sides.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
      scales.push_back(scale_of(rings, sides, {f}, tolerance, what));
    }
  } else if (kind == PointKind::kEdge) {
    for (const SurfaceRings::OfEdge& e : rings.edges)
      scales.push_back(scale_of(rings, {{e.a, e.b}}, e.faces, tolerance, what));
  } else {
    for (const SurfaceRings::OfVertex& v : rings.vertices) {
      std::vector<std::pair<Ref, Ref>> spokes;
      for (const Ref e : v.edges)
        spokes.emplace_back(rings.edges[e].a, rings.edges[e].b);
      scales.push_back(scale_of(rings, spokes, v.faces, tolerance, what));
    }
  }
  return scales;
}

/// The rule for one point, to look at.
std::string formula(RefinementScheme scheme, PointKind kind, const SurfaceRings& rings,
                    Ref element) {
  if (kind == PointKind::kFace) {
    return "the mean of the corners: their sum, divided by " +
           std::to_string(rings.corners[element].size());
  }
  const bool linear = scheme == RefinementScheme::kLinear;
  if (kind == PointKind::kEdge) {
    const SurfaceRings::OfEdge& e = rings.edges[element];
    const std::string ends = vertex_name(e.a) + " + " + vertex_name(e.b);
    if (linear) return "the middle of the edge, (" + ends + ") / 2";
    if (e.is_boundary())
      return "on a boundary it is the middle of the edge, (" + ends + ") / 2";
    return "(" + ends + " + the new vertices of " + face_name(e.faces[0]) + " and " +
           face_name(e.faces[1]) + ") / 4";
  }
  if (linear) return "an old vertex stays where it is";
  const SurfaceRings::OfVertex& v = rings.vertices[element];
  if (!v.is_boundary()) {
    return "(Q + 2 R + (n - 3) S) / n with n = " + std::to_string(v.edges.size()) +
           ", Q the mean of the new face points around, R that of the middles of its edges";
  }
  std::vector<std::string> along;
  for (const Ref e : v.edges) {
    if (rings.edges[e].is_boundary())
      along.push_back(vertex_name(rings.edges[e].other(element)));
  }
  return "on a boundary it is 3/4 " + vertex_name(element) + " + 1/8 (" + join(along, " + ") +
         "), the neighbours along the boundary";
}

/// Judges one level.
class LevelJudge {
 public:
  LevelJudge(const JudgeTask& task, RefinementScheme scheme, const MeshDump& before,
             const RefinementStep& step, std::string where, CaseJudgement& judgement)
      : task_(task),
        scheme_(scheme),
        before_(before),
        step_(step),
        where_(std::move(where)),
        judgement_(judgement),
        rings_(rings_of(before)) {}

  void judge() {
    if (const auto changed = find_change(before_, step_.after, where_, kComputes)) {
      judgement_.findings.push_back(*changed);
      return;
    }
    for (const PointKind kind : kKinds)
      judge_keys(kind);
    if (!judgement_.findings.empty()) return;
    right_ = right_points(before_, scheme_);
    if (task_.measure) measure();
    for (const PointKind kind : kKinds)
      judge_points(kind);
    if (task_.explain && !judgement_.findings.empty()) keep_scene();
  }

 private:
  Finding& report(std::string rule, std::string meaning, std::string element,
                  std::string expected, std::string actual, std::string look_at) {
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), where_,
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
    return judgement_.findings.back();
  }

  std::size_t size(PointKind kind) const {
    if (kind == PointKind::kFace) return before_.faces.size();
    return kind == PointKind::kEdge ? before_.edges.size() : before_.vertices.size();
  }

  /// Which elements have a position: all of the surface, and no other.
  void judge_keys(PointKind kind) {
    const KindWords& words = words_of(kind);
    std::vector<Point3>& points = yours_of(kind);
    points.assign(size(kind), Point3{});
    std::vector<bool> has(size(kind), false);
    for (const PlacedElement& entry : entries_of(step_, kind)) {
      if (entry.element >= points.size()) return report_stranger(kind, entry.element);
      points[entry.element] = entry.at;
      has[entry.element] = true;
    }
    const auto missing = std::count(has.begin(), has.end(), false);
    if (missing == 0) return;
    const auto first = static_cast<Ref>(std::find(has.begin(), has.end(), false) - has.begin());
    report("missing-position", "each vertex, edge and face of the surface has a position",
           element_name(words.element, first), "a position for each of " + all_text(kind),
           std::string(words.map) +
               (entries_of(step_, kind).empty()
                    ? " is empty"
                    : " has none for " + std::to_string(missing) + " of them, the first " +
                          element_name(words.element, first)),
           std::string("the loop over ") + words.map + ", from " + words.loop);
  }

  std::string all_text(PointKind kind) const {
    const KindWords& words = words_of(kind);
    if (size(kind) == 1) return std::string("the one ") + kind_name(words.element);
    return "the " + std::to_string(size(kind)) + " " + words.map;
  }

  void report_stranger(PointKind kind, Ref element) {
    const KindWords& words = words_of(kind);
    const bool is_loop =
        kind == PointKind::kFace && is_plain(element) && (element & kBoundaryBit) != 0;
    report(
        is_loop ? "boundary-position" : "foreign-position",
        is_loop ? "only faces of the surface have a position: boundary loops are none"
                : "every key is an element of the mesh that the function works on",
        element_name(words.element, element),
        std::string(words.map) + " has keys of this mesh only" +
            (is_loop ? ", and no boundary loop" : ""),
        std::string(words.map) + " has a position for: " + element_name(words.element, element),
        is_loop ? "where faces are taken from half-edges: face() of one that isBoundary() is "
                  "a boundary loop. Asking the map with [] makes an entry, too"
                : "what is put into the map, and what is asked with []: that makes an entry, "
                  "too");
  }

  void judge_points(PointKind kind) {
    const std::vector<Point3>& expected = points_of(right_, kind);
    const std::vector<Point3>& actual = yours_of(kind);
    const std::vector<LocalScale> scales = scales_of(rings_, kind, task_.tolerance);
    if (are_within(expected, actual, scales)) return;
    const RefinementRules rules(rings_, scheme_, yours_);
    // Wrong only because of wrong points that were told already.
    if (!judgement_.findings.empty() && are_within(rules.points(kind), actual, scales)) return;
    report_points(kind, expected, scales);
    if (!task_.explain) return;
    const Misconceptions& known = refinement_misconceptions(scheme_);
    Misconceptions& likely = judgement_.findings.back().likely;
    for (const Prediction<Point3>& prediction : rules.predictions(kind)) {
      const bool fits = are_within(prediction.points, actual, scales);
      if (fits && !holds(likely, prediction.misconception))
        likely.push_back(find_misconception(known, prediction.misconception));
    }
  }

  void report_points(PointKind kind, const std::vector<Point3>& expected,
                     const std::vector<LocalScale>& scales) {
    const KindWords& words = words_of(kind);
    const std::vector<Point3>& actual = yours_of(kind);
    const WorstPoint worst = worst_by_scale(expected, actual, scales);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < actual.size(); ++i)
      wrong += distance(expected[i], actual[i]) <= scales[i].allowed ? 0 : 1;
    const auto element = static_cast<Ref>(worst.index);
    const std::string rule = formula(scheme_, kind, rings_, element);
    const std::string how_many =
        wrong == 1 ? "no other is wrong"
                   : std::to_string(wrong) + " of " + all_text(kind) + " are wrong";
    if (!std::isfinite(worst.error)) {
      report("finite", std::string(rule_meaning("finite")),
             element_name(words.element, element), point_text(expected[worst.index]),
             point_text(actual[worst.index]) + "; " + how_many,
             rule + ": is something divided by 0, or never set?");
      return;
    }
    report("position",
           scheme_ == RefinementScheme::kLinear
               ? "the positions are those of linear subdivision (compared with OpenSubdiv)"
               : "the positions are those of Catmull-Clark subdivision (compared with "
                 "OpenSubdiv)",
           element_name(words.element, element), point_text(expected[worst.index]),
           point_text(actual[worst.index]) + ", off by " +
               error_text(worst.error, scales[worst.index]) + "; " + how_many,
           rule);
  }

  std::vector<Point3>& yours_of(PointKind kind) {
    if (kind == PointKind::kFace) return yours_.faces;
    return kind == PointKind::kEdge ? yours_.edges : yours_.vertices;
  }

  /// How far the vertices of the next level are off, by the numbers that build() gives them.
  void measure() {
    if (!complete_points(before_, step_)) return;
    const PolygonMesh right = refined_mesh(before_, right_);
    const MeshDump next = built_mesh(refined_mesh(before_, yours_));
    const double size = diagonal(built_mesh(right));
    if (!(size > 0.0)) return;
    judgement_.deviation =
        measure_deviation(right.positions, next, built_numbers(right), size, task_.tolerance);
    judgement_.deviation.weights = scheme_ == RefinementScheme::kLinear
                                       ? "its rules without smoothing"
                                       : "Catmull and Clark's rules";
  }

  /// For a viewer: the next level.
  void keep_scene() {
    if (4 * before_.halfedges.size() > kMostSceneHalfedges) return;
    if (!complete_points(before_, step_)) return;
    judgement_.scene = {where_.empty() ? "refine" : "refine " + where_,
                        kUnsetRef,
                        before_,
                        built_mesh(refined_mesh(before_, yours_)),
                        built_mesh(refined_mesh(before_, right_)),
                        FaceShape::kPolygons};
  }

  const JudgeTask& task_;
  RefinementScheme scheme_;
  const MeshDump& before_;
  const RefinementStep& step_;
  std::string where_;
  CaseJudgement& judgement_;
  SurfaceRings rings_;
  RefinedPoints yours_;
  RefinedPoints right_;
};

void judge_levels(const JudgeTask& task, RefinementScheme scheme, CaseJudgement& judgement) {
  const auto input = from_wire<WholeMeshInput>(task.asked.input);
  if (task.outcome.steps.size() > input.times) throw WireError("too many steps");
  PolygonMesh polygons = input.mesh;
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    const MeshDump before = built_mesh(polygons, input.anchor_turns);
    const auto step = from_wire<RefinementStep>(task.outcome.steps[i]);
    const std::string where = input.times == 1 ? ""
                                               : "at level " + std::to_string(i + 1) + " of " +
                                                     std::to_string(input.times);
    LevelJudge(task, scheme, before, step, where, judgement).judge();
    if (!judgement.findings.empty()) {
      judgement.verdict = Verdict::kFailed;
      mention_turned_anchors(input.anchor_turns, judgement);
      return;
    }
    polygons = refined_mesh(before, *complete_points(before, step));
  }
  require_all_steps(task.outcome, input.times);
}

}  // namespace

RefinedPoints right_points(const MeshDump& mesh, RefinementScheme scheme) {
  PolygonMesh polygons;
  for (const VertexRecord& v : mesh.vertices)
    polygons.positions.push_back(v.position);
  polygons.polygons = rings_of(mesh).corners;
  const SubdivisionLevel level = scheme == RefinementScheme::kLinear
                                     ? opensubdiv_bilinear(polygons)
                                     : opensubdiv_catmull_clark(polygons, CornerRule::kSmooth);
  const std::vector<Point3>& at = level.mesh.positions;
  RefinedPoints points;
  for (const std::uint32_t child : level.child_of_vertex)
    points.vertices.push_back(at[child]);
  for (const std::uint32_t child : level.child_of_face)
    points.faces.push_back(at[child]);
  std::map<std::pair<Ref, Ref>, std::uint32_t> child_of;
  for (std::size_t e = 0; e < level.edges.size(); ++e)
    child_of[std::minmax(level.edges[e][0], level.edges[e][1])] = level.child_of_edge[e];
  for (const EdgeRecord& e : mesh.edges) {
    const HalfedgeRecord& h = mesh.halfedges[e.halfedge];
    points.edges.push_back(
        at[child_of.at(std::minmax(h.vertex, mesh.halfedges[h.twin].vertex))]);
  }
  return points;
}

template <RefinementScheme kScheme>
ExerciseJudge refinement_judge(const ExerciseRubric& rubric, const std::string& function) {
  refuse_unknown_options(rubric, {});
  ExerciseJudge judge;
  judge.functions = {function};
  judge.judge_steps = [](const JudgeTask& task, Conventions& /*conventions*/,
                         CaseJudgement& judgement) { judge_levels(task, kScheme, judgement); };
  judge.misconceptions = refinement_misconceptions(kScheme);
  return judge;
}

template ExerciseJudge refinement_judge<RefinementScheme::kLinear>(const ExerciseRubric&,
                                                                   const std::string&);
template ExerciseJudge refinement_judge<RefinementScheme::kCatmullClark>(const ExerciseRubric&,
                                                                         const std::string&);

}  // namespace meshgrade
