#include <algorithm>
#include <numeric>
#include <set>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/remesh_input.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/local_scale.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"
#include "grader/judge/remesh_lengths.h"
#include "grader/judge/remesh_quality.h"
#include "grader/judge/remesh_smoothing.h"
#include "grader/judge/surface_distance.h"
#include "grader/judge/triangle_surface.h"
#include "grader/judge/unchanged_mesh.h"
#include "grader/mesh/mesh_rules.h"
#include "grader/operations/picked_element.h"
#include "grader/operations/remesh_steps.h"

namespace meshgrade {
namespace {

/// How far vertices may end up from the surface that they come from, in mean edge lengths.
constexpr double kFarthest = 1.0;

constexpr UnchangedWords kNoRounds{
    "with outerIterations = 0 there is no round, and the mesh stays as it was",
    "the loop over the rounds: it runs outerIterations times",
    "the loop over the rounds: it runs outerIterations times"};

/// Which weights of normals fit all cases so far; the first is what is asked.
const std::vector<std::pair<std::string, NormalWeight>>& known_weights() {
  static const std::vector<std::pair<std::string, NormalWeight>> known{
      {"vertex normals weighted by areas", NormalWeight::kArea},
      {"vertex normals weighted by angles", NormalWeight::kAngle},
      {"vertex normals that are the mean of unit normals", NormalWeight::kEqual}};
  return known;
}

/// The edges of a mesh by the labels of their ends, in order; each as often as it is there.
std::vector<EdgeEnds> labelled_edges(const MeshDump& mesh, const std::vector<Label>& labels) {
  std::vector<EdgeEnds> edges;
  for (const EdgeRecord& e : mesh.edges) {
    if (e.live == 0) continue;
    const HalfedgeRecord& h = mesh.halfedges[e.halfedge];
    const Label a = labels[h.vertex];
    const Label b = labels[mesh.halfedges[h.twin].vertex];
    edges.push_back(std::minmax(a, b));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<EdgeEnds> without(const std::vector<EdgeEnds>& some,
                              const std::vector<EdgeEnds>& others) {
  std::vector<EdgeEnds> left;
  std::set_difference(some.begin(), some.end(), others.begin(), others.end(),
                      std::back_inserter(left));
  return left;
}

int deviation_of(const std::vector<EdgeEnds>& edges) {
  std::map<Label, int> valences;
  for (const auto& [a, b] : edges) {
    ++valences[a];
    ++valences[b];
  }
  int sum = 0;
  for (const auto& [label, valence] : valences)
    sum += std::abs(valence - 6);
  return sum;
}

class RemeshJudge {
 public:
  RemeshJudge(const JudgeTask& task, const RemeshInput& input, const MeshDump& after,
              Conventions& conventions, CaseJudgement& judgement)
      : task_(task),
        input_(input),
        settings_(input.settings),
        start_(built_mesh(input.mesh, input.anchor_turns)),
        lists_(face_lists_of(start_)),
        after_(after),
        conventions_(conventions),
        judgement_(judgement) {
    const double size = largest_coordinate(lists_.positions);
    allowed_ = task.tolerance * mean_edge_length(lists_) + float_rounding(size);
  }

  void judge() {
    if (!is_sound()) return;
    if (settings_.outer == 0) {
      if (const auto change = find_change(start_, after_, "", kNoRounds))
        judgement_.findings.push_back(*change);
      return;
    }
    if (!settings_.resizes()) {
      judge_same_vertices();
    } else if (settings_.outer == 1) {
      judge_resized();
    }
    if (input_.improves != 0 && judgement_.findings.empty()) judge_whole();
  }

 private:
  Finding& report(std::string rule, std::string meaning, std::string element,
                  std::string expected, std::string actual, std::string look_at) {
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), "",
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
    return judgement_.findings.back();
  }

  /// Whether it is a mesh of triangles, and of the same kind as before.
  bool is_sound() {
    for (const RuleBreak& broken : find_broken_rules(after_, FaceShape::kDegeneratePolygons))
      judgement_.findings.push_back(to_finding(broken, ""));
    if (!judgement_.findings.empty()) return false;
    constexpr const char* kBesides =
        "what is done besides calls of splitEdge, collapseEdge and flipEdge";
    if (auto other = find_other_face(after_, kBesides)) {
      judgement_.findings.push_back(std::move(*other));
      return false;
    }
    const std::string before = topology_text(start_);
    const std::string now = topology_text(after_);
    if (before == now) return true;
    report("topology",
           "remeshing makes other triangles, and leaves the surface what it is: as many parts, "
           "handles and boundary loops",
           "the mesh", before, now, kBesides);
    return false;
  }

  /// No edge may be split or collapsed: vertices are known by their numbers.
  void judge_same_vertices() {
    const bool same = after_.vertices.size() == start_.vertices.size() &&
                      count(after_).vertices == start_.vertices.size();
    if (!same) {
      report(
          "vertices",
          "no edge is longer than longerFactor L or shorter than shorterFactor L: vertices "
          "neither come nor go",
          "the mesh", counts_text(count(start_)), counts_text(count(after_)),
          "the two limits: the factors of the parameters, times the mean length of all edges");
      return;
    }
    std::vector<Label> labels(after_.vertices.size());
    std::iota(labels.begin(), labels.end(), 0U);
    const auto flipped = surely_flipped(lists_);
    if (judge_flips(lists_, flipped, labels)) judge_places(flipped.has_value(), labels);
  }

  void judge_resized() {
    const auto resized = surely_resized(lists_, settings_.longer, settings_.shorter);
    if (!resized) return;
    const auto flipped = surely_flipped(*resized);
    FaceLists expected = flipped.value_or(*resized);
    if (settings_.smoothing > 0) {
      if (!flipped) return;
      const MeshDump mesh = mesh_of(expected);
      std::vector<Label> same(mesh.vertices.size());
      std::iota(same.begin(), same.end(), 0U);
      const TriangleRings rings = triangle_rings(mesh, same, same.size());
      if (judge_resized_and_smoothed(rings, expected)) return;
    }
    const auto labels = labels_by_place(after_, *resized, allowed_);
    if (!labels) {
      judgement_.findings.push_back(
          wrong_resizing({lists_, settings_, *resized, allowed_}, after_));
    } else {
      judge_flips(*resized, flipped, *labels);
    }
  }

  /// All steps of one round, each of them sure.
  bool judge_resized_and_smoothed(const TriangleRings& rings, const FaceLists& flipped) {
    const auto fits = [&](NormalWeight weight) {
      FaceLists expected = flipped;
      expected.positions =
          smoothed(rings, flipped.positions, settings_.step, settings_.smoothing, weight);
      const auto labels = labels_by_place(after_, expected, allowed_);
      return labels && without(edges_of(expected), labelled_edges(after_, *labels)).empty();
    };
    if (keep_conventions(fits)) return true;
    report("round",
           "after one round the vertices lie where the four steps lead, one after the other",
           "the mesh", "splits, collapses and flips as they must be, and then smoothing",
           "other vertices, or other edges",
           "the order of the steps; what each of them does alone is asked in other cases");
    return true;
  }

  /// @return whether the edges are such as flips that pay can lead to
  bool judge_flips(const FaceLists& before, const std::optional<FaceLists>& sure,
                   const std::vector<Label>& labels) {
    const std::vector<EdgeEnds> old_edges = edges_of(before);
    const std::vector<EdgeEnds> edges = labelled_edges(after_, labels);
    const std::vector<EdgeEnds> turned = without(edges, old_edges);
    if (!is_closed(before)) return true;  // what is right at a boundary, nobody says
    const int was = deviation_of(old_edges);
    const int is = deviation_of(edges);
    if (static_cast<int>(2 * turned.size()) > was - is) {
      report_needless(turned, was, is);
      return false;
    }
    const Surface surface(before);
    const FaceLists wanted = sure.value_or(before);
    const std::vector<EdgeEnds> left = without(old_edges, edges_of(wanted));
    for (const EdgeEnds& edge : old_edges) {
      const auto place = flip_place(surface, before, edge);
      const bool pays = flip_gain(surface, *place) > 0 && !surface.is_edge(place->c, place->d);
      const bool stays = std::binary_search(edges.begin(), edges.end(), edge);
      const bool must =
          sure ? std::binary_search(left.begin(), left.end(), edge) : turned.empty();
      if (!pays || !stays || !must) continue;
      report_missing(edge, flip_gain(surface, *place));
      return false;
    }
    return judge_last_flips();
  }

  void report_needless(const std::vector<EdgeEnds>& turned, int was, int is) {
    report(
        "flip-needless",
        "an edge is flipped only where that lowers the sum of |n - 6| over its four vertices",
        edge_text(turned[0]),
        "each of the " + plural(turned.size(), "edge") + " that " +
            (turned.size() == 1 ? "is" : "are") +
            " new lowers the sum over all vertices by 2 "
            "or more",
        "the sum went from " + std::to_string(was) + " to " + std::to_string(is) + "; " +
            edge_text(turned[0]) + " is new",
        "what is compared: the sum of |n - 6| now, and that after the flip, when the two "
        "ends have one edge less and the two vertices opposite one more; both times the "
        "absolute values");
  }

  void report_missing(const EdgeEnds& edge, int gain) {
    report("flip-missing",
           "every edge is flipped where that lowers the sum of |n - 6| over its four vertices",
           edge_text(edge),
           "the flip of " + edge_text(edge) + " lowers the sum by " + std::to_string(gain),
           edge_text(edge) + " is still there",
           "the two vertices opposite: of a half-edge h, h->next()->next()->vertex(); "
           "h->next()->vertex() is an end of the edge. And whether the loop visits every edge");
  }

  /// After so many rounds that one of them had nothing to flip, nothing is left: each round
  /// before it has lowered the sum by 2 or more.
  bool judge_last_flips() {
    const bool is_final = !settings_.resizes() &&
                          static_cast<int>(2 * settings_.outer) > valence_deviation(lists_);
    const FaceLists now = face_lists_of(after_);
    // Lists of corners cannot keep two edges with the same ends apart.
    if (!is_final || !trouble_of(now).empty() || edges_of(now).size() != count(after_).edges)
      return true;
    const Surface surface(now);
    for (const EdgeEnds& edge : edges_of(now)) {
      const auto place = flip_place(surface, now, edge);
      if (!place || flip_gain(surface, *place) <= 0) continue;
      if (surface.is_edge(place->c, place->d)) continue;
      report_missing(edge, flip_gain(surface, *place));
      judgement_.findings.back().expected +=
          ", in the mesh that is left after " + plural(settings_.outer, "round");
      return false;
    }
    return true;
  }

  /// Where the vertices lie that no split or collapse has touched.
  void judge_places(bool sure_flips, const std::vector<Label>& labels) {
    const std::uint32_t all = settings_.outer * settings_.smoothing;
    if (all > 0 && settings_.outer > 1 && !sure_flips) return;
    const TriangleRings rings = triangle_rings(after_, labels, labels.size());
    if (!rings.is_closed() && all > 1) return;
    std::vector<Point3> actual;
    for (const VertexRecord& v : after_.vertices)
      actual.push_back(v.position);
    const std::vector<LocalScale> scales = scales_around(rings);
    const auto right = [&](NormalWeight weight) {
      return with_free_boundary(rings, actual,
                                smoothed(rings, lists_.positions, settings_.step, all, weight));
    };
    const auto fits = [&](NormalWeight weight) {
      return are_within(right(weight), actual, scales);
    };
    if (keep_conventions(fits)) return;
    report_places(right(NormalWeight::kArea), actual, scales);
    if (!task_.explain || all == 0) return;
    Misconceptions& likely = judgement_.findings.back().likely;
    for (const auto& [name, points] : predict_smoothing(rings, lists_.positions, settings_)) {
      const auto predicted = with_free_boundary(rings, actual, points);
      if (are_within(predicted, actual, scales) && !holds(likely, name))
        likely.push_back(find_misconception(smoothing_misconceptions(), name));
    }
  }

  /// Vertices on a boundary may be smoothed to anywhere.
  std::vector<Point3> with_free_boundary(const TriangleRings& rings,
                                         const std::vector<Point3>& actual,
                                         std::vector<Point3> points) const {
    for (Label v = 0; v < points.size() && settings_.smoothing > 0; ++v) {
      if (rings.on_boundary[v]) points[v] = actual[v];
    }
    return points;
  }

  void report_places(const std::vector<Point3>& expected, const std::vector<Point3>& actual,
                     const std::vector<LocalScale>& scales) {
    const WorstPoint worst = worst_by_scale(expected, actual, scales);
    const bool unmoved = actual == lists_.positions;
    const std::string name = vertex_name(static_cast<Ref>(worst.index));
    if (settings_.smoothing == 0) {
      report("position", "with smoothingIterations = 0 vertices stay where they are", name,
             point_text(expected[worst.index]), point_text(actual[worst.index]),
             "the loop that smooths: it runs smoothingIterations times");
      return;
    }
    report(
        "position",
        "smoothing moves each vertex p to p + s (u - (u . N) N), all of them at the same time",
        name, point_text(expected[worst.index]),
        unmoved ? name + " and all others are where they were"
                : point_text(actual[worst.index]) + ", off by " +
                      error_text(worst.error, scales[worst.index]),
        unmoved ? "whether the new positions are written back"
                : "u, from p to the mean of its neighbours; N, the unit normal at p; and from "
                  "which positions they come");
  }

  /// Of each vertex, by the mean length of its edges at the start.
  std::vector<LocalScale> scales_around(const TriangleRings& rings) const {
    std::vector<LocalScale> scales;
    const std::vector<Point3>& at = lists_.positions;
    for (Label v = 0; v < at.size(); ++v) {
      LocalScale scale;
      scale.length = 0.0;
      std::vector<Point3> near{at[v]};
      for (const Label neighbour : rings.neighbours[v]) {
        scale.length +=
            distance(at[v], at[neighbour]) / static_cast<double>(rings.neighbours[v].size());
        near.push_back(at[neighbour]);
      }
      scale.what = "the mean length of its edges";
      scale.allowed = task_.tolerance * scale.length + float_rounding(largest_coordinate(near));
      if (settings_.smoothing == 0) scale.allowed = 0.0;
      scales.push_back(scale);
    }
    return scales;
  }

  /// Keeps the weights of normals that fit this case, if one does.
  template <class Fits>
  bool keep_conventions(Fits fits) {
    Conventions kept;
    for (const auto& [name, weight] : known_weights()) {
      if (conventions_.count(name) != 0 && fits(weight)) kept.insert(name);
    }
    if (kept.empty()) return false;
    conventions_ = kept;
    return true;
  }

  /// What can be said whatever choices were made: the triangles are no worse than before, and
  /// lie where the surface was.
  void judge_whole() {
    const MeshQuality before = quality_of(start_);
    const MeshQuality now = quality_of(after_);
    if (now.variation > before.variation) {
      report("even-lengths", "the lengths of edges differ no more than before", "the mesh",
             "a standard deviation of at most " + number_text(before.variation, 4) +
                 " of their mean",
             number_text(now.variation, 4) + " of it",
             "the four steps alone, in the other groups, and then their order");
    } else if (now.deviation > before.deviation) {
      report("even-valences", "the numbers of edges are no farther from 6 than before",
             "the mesh", "a mean of |n - 6| of at most " + number_text(before.deviation, 4),
             number_text(now.deviation, 4), "the flips: do they come after the collapses?");
    } else {
      judge_distance(before.mean_length);
    }
  }

  void judge_distance(double mean) {
    for (Ref v = 0; v < after_.vertices.size(); ++v) {
      if (after_.vertices[v].live == 0) continue;
      const double off = distance_from(after_.vertices[v].position, lists_);
      if (off <= kFarthest * mean) continue;
      report("near-the-surface", "the new vertices lie where the surface was", vertex_name(v),
             "at most " + number_text(kFarthest, 2) + " L away from it",
             number_text(off / mean, 3) + " L",
             "whether the mesh shrinks while it is smoothed");
      return;
    }
  }

  const JudgeTask& task_;
  const RemeshInput& input_;
  const RemeshSettings& settings_;
  MeshDump start_;
  FaceLists lists_;
  const MeshDump& after_;
  Conventions& conventions_;
  CaseJudgement& judgement_;
  double allowed_ = 0.0;
};

void judge_remeshing(const JudgeTask& task, Conventions& conventions,
                     CaseJudgement& judgement) {
  const auto input = from_wire<RemeshInput>(task.asked.input);
  if (task.outcome.steps.size() > 1) throw WireError("too many steps");
  require_all_steps(task.outcome, 1);
  for (const std::string& step : task.outcome.steps)
    RemeshJudge(task, input, from_wire<MeshDump>(step), conventions, judgement).judge();
  if (judgement.findings.empty()) return;
  judgement.verdict = Verdict::kFailed;
  mention_turned_anchors(input.anchor_turns, judgement);
}

}  // namespace

ExerciseJudge isotropic_remeshing_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  ExerciseJudge judge;
  judge.functions = {"PolyMesh::isotropicRemesh"};
  for (const auto& [name, weight] : known_weights())
    judge.conventions.insert(name);
  judge.judge_steps = judge_remeshing;
  judge.misconceptions = smoothing_misconceptions();
  return judge;
}

}  // namespace meshgrade
