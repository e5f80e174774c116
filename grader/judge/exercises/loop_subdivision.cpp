#include <algorithm>
#include <map>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/cases/mesh_input.h"
#include "grader/judge/bezier_forms.h"
#include "grader/judge/findings.h"
#include "grader/judge/judge.h"
#include "grader/judge/local_scale.h"
#include "grader/judge/loop_match.h"
#include "grader/judge/loop_misconceptions.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/mesh/mesh_rules.h"
#include "grader/subdivide/opensubdiv_level.h"

namespace meshgrade {
namespace {

/// One of the published choices of weights.
struct Variant {
  const char* name;
  VertexRule vertex_rule;
  CornerRule corner_rule;
};

constexpr Variant kVariants[] = {
    {"Warren's weights", VertexRule::kWarren, CornerRule::kSmooth},
    {"Loop's weights", VertexRule::kLoop, CornerRule::kSmooth},
    {"Warren's weights, fixed corners", VertexRule::kWarren, CornerRule::kCorner},
    {"Loop's weights, fixed corners", VertexRule::kLoop, CornerRule::kCorner},
};

constexpr const char* kConnectivity =
    "old vertices keep their number of edges; new ones have 6 inside and 4 on a boundary";
constexpr const char* kWhichEdges =
    "which new edges are flipped: those, and only those, that join an old vertex and a new one "
    "and do not lie along an old edge";

Level refine(const std::map<std::string, PolygonMesh>& meshes) {
  Level level;
  for (const Variant& variant : kVariants) {
    const auto mesh = meshes.find(variant.name);
    if (mesh == meshes.end()) continue;
    SubdivisionLevel refined =
        opensubdiv_loop(mesh->second, variant.vertex_rule, variant.corner_rule);
    if (level.origins.empty()) {
      level.origins.resize(refined.mesh.positions.size());
      for (std::uint32_t v = 0; v < refined.child_of_vertex.size(); ++v) {
        level.origins[refined.child_of_vertex[v]] = {v, v};
      }
      for (std::size_t e = 0; e < refined.edges.size(); ++e) {
        level.origins[refined.child_of_edge[e]] = {refined.edges[e][0], refined.edges[e][1]};
      }
    }
    level.by_variant[variant.name] = std::move(refined.mesh);
  }
  return level;
}

/// The half-edges of a surface, with vertex i of the dump being vertex i of the polygons.
MeshDump to_surface(const PolygonMesh& polygons) {
  meshedit::HalfedgeMesh mesh;
  build_mesh(polygons, mesh);
  MeshDump dump = dump_mesh(mesh);
  // The built mesh numbers vertices in the order of the polygons: give them back their own.
  std::vector<Ref> own;
  std::vector<bool> seen(polygons.positions.size(), false);
  for (const auto& polygon : polygons.polygons) {
    for (std::uint32_t corner : polygon) {
      if (!seen[corner]) own.push_back(corner);
      seen[corner] = true;
    }
  }
  std::vector<VertexRecord> vertices(dump.vertices.size());
  for (std::size_t v = 0; v < own.size(); ++v)
    vertices[own[v]] = dump.vertices[v];
  dump.vertices = std::move(vertices);
  for (HalfedgeRecord& h : dump.halfedges)
    h.vertex = own[h.vertex];
  return dump;
}

Conventions allowed_variants(const ExerciseRubric& rubric) {
  const std::string vertex = choose_option(rubric, "vertex_rule", {"either", "loop", "warren"});
  const std::string corner =
      choose_option(rubric, "corner_rule", {"either", "smooth", "corner"});
  Conventions allowed;
  for (const Variant& variant : kVariants) {
    const bool is_loop = variant.vertex_rule == VertexRule::kLoop;
    const bool is_smooth = variant.corner_rule == CornerRule::kSmooth;
    if (vertex != "either" && (vertex == "loop") != is_loop) continue;
    if (corner != "either" && (corner == "smooth") != is_smooth) continue;
    allowed.insert(variant.name);
  }
  return allowed;
}

const Variant& find_variant(const std::string& name) {
  for (const Variant& variant : kVariants) {
    if (name == variant.name) return variant;
  }
  throw GraderError("no weights are called \"" + name + "\"");
}

/// The weights of a point, to look at.
std::string position_formula(bool old, bool on_boundary) {
  if (on_boundary) {
    return old ? "3/4 v + 1/8 (a + b), with the neighbours a and b along the boundary"
               : "1/2 (a + b), the middle of the edge a-b on the boundary";
  }
  if (!old)
    return "3/8 (a + b) + 1/8 (c + d), with the ends a, b and the vertices opposite c, d";
  return "(1 - n u) v + u (sum of the n neighbours), with u = 3/16 for n = 3, else 3/(8 n); "
         "or, "
         "by Loop, u = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n";
}

std::vector<bool> on_boundary(const MeshDump& mesh) {
  std::vector<bool> marked(mesh.vertices.size(), false);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0 && (h.face & kBoundaryBit) != 0) marked[h.vertex] = true;
  }
  return marked;
}

class LevelsJudge {
 public:
  LevelsJudge(const JudgeTask& task, Conventions& conventions, CaseJudgement& judgement)
      : task_(task), conventions_(conventions), judgement_(judgement) {}

  void judge() {
    const auto input = from_wire<SubdivisionInput>(task_.asked.input);
    const auto& steps = task_.outcome.steps;
    if (steps.size() > input.levels) throw WireError("too many steps");
    std::map<std::string, PolygonMesh> meshes;
    for (const std::string& name : conventions_)
      meshes[name] = input.mesh;
    old_ = input.mesh;
    first_marked_ = static_cast<Ref>(old_.positions.size());
    before_ = to_surface(input.mesh);
    std::vector<Ref> old_to_mine(input.mesh.positions.size());
    for (Ref v = 0; v < old_to_mine.size(); ++v)
      old_to_mine[v] = v;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (input.levels > 1) {
        where_ = "after level " + std::to_string(i + 1) + " of " + std::to_string(input.levels);
      }
      const auto mesh = from_wire<MeshDump>(steps[i]);
      Level level = refine(meshes);
      level.surface = to_surface(level.by_variant.begin()->second);
      scales_ = scales_of_level(old_, level.origins, task_.tolerance);
      if (!keeps_rules(mesh) || !has_counts(level, old_to_mine, mesh) ||
          !has_surface(level, old_to_mine, mesh) || !has_positions(level, mesh)) {
        keep_scene(level, mesh);
        mention_anchoring(input.anchoring, judgement_);
        return;
      }
      meshes = std::move(level.by_variant);
      // Weights that this level rules out must not come back at the next one.
      std::erase_if(meshes, [&](const auto& m) { return conventions_.count(m.first) == 0; });
      old_to_mine = match_;
      old_ = meshes.begin()->second;
      before_ = mesh;
    }
    require_all_steps(task_.outcome, input.levels);
  }

 private:
  void report(std::string rule, std::string meaning, std::string element, std::string expected,
              std::string actual, std::string look_at) {
    judgement_.verdict = Verdict::kFailed;
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), where_,
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
  }

  bool keeps_rules(const MeshDump& mesh) {
    bool all_live = true;
    for (const RuleBreak& rule_break : find_broken_rules(mesh)) {
      all_live = all_live && rule_break.rule != "live-pointer";
      judgement_.findings.push_back(to_finding(rule_break, where_));
      judgement_.verdict = Verdict::kFailed;
    }
    if (judgement_.findings.empty()) return true;
    Finding& first = judgement_.findings[0];
    if (first.rule == "finite") {
      first.look_at += ": is something divided by 0? ";
      first.look_at += before_.boundaries.empty()
                           ? "For example by a valence that is not computed yet"
                           : "At a boundary, a vertex has fewer faces than edges";
    } else if (all_live && task_.explain) {
      lead_with(recognize_connectivity(before_, mesh, first_marked_));
    }
    return false;
  }

  /// One cause explains all rules that are broken: it is told in their place.
  void lead_with(Misconceptions likely) {
    if (likely.empty()) return;
    const std::vector<Finding> broken = std::move(judgement_.findings);
    judgement_.findings.clear();
    report("connectivity", kConnectivity, "the mesh", "every old triangle is cut into four",
           "other edges are flipped than those that must be; that breaks the mesh in " +
               plural(broken.size(), "place") + ": " + broken[0].rule +
               (broken[0].element.empty() ? "" : " at " + broken[0].element) +
               (broken.size() > 1 ? ", and others" : ""),
           kWhichEdges);
    judgement_.findings[0].likely = std::move(likely);
  }

  /// For a viewer.
  void keep_scene(const Level& level, const MeshDump& mesh) {
    if (!task_.explain || level.surface.halfedges.size() > kMostSceneHalfedges) return;
    const std::string which = where_.empty() ? "" : " " + where_;
    judgement_.scene = {"subdivide" + which, kUnsetRef, before_, mesh, placed(level)};
  }

  /// The right surface in its right place, by the weights that were tried first.
  static MeshDump placed(const Level& level) {
    MeshDump surface = level.surface;
    const std::vector<Point3>& points = level.by_variant.begin()->second.positions;
    for (std::size_t v = 0; v < points.size(); ++v)
      surface.vertices[v].position = points[v];
    return surface;
  }

  bool has_counts(const Level& level, const std::vector<Ref>& old_to_mine,
                  const MeshDump& mesh) {
    const Counts want = count(level.surface);
    const Counts have = count(mesh);
    if (want == have) return true;
    const auto text = [](const Counts& c) {
      return std::to_string(c.vertices) + " vertices, " + plural(c.edges, "edge") + ", " +
             plural(c.faces, "face") + ", " + plural(c.boundaries, "boundary loop");
    };
    std::string advice = "how often each edge of the old mesh is split";
    const Misconceptions likely = recognize_counts(old_, count(before_), have);
    if (have.faces < want.faces && likely.empty())
      advice += ": some edges are not split at all";
    if (have.faces > want.faces && likely.empty())
      advice += ": some edges that are new are split again";
    report("counts", "every triangle becomes four: each old edge gets one new vertex",
           "the mesh", text(want), text(have), advice);
    judgement_.findings.back().likely = likely;
    show_valences(level, old_to_mine, mesh);
    return false;
  }

  /// A picture of the mesh with the old vertices that have a wrong number of edges.
  void show_valences(const Level& level, const std::vector<Ref>& old_to_mine,
                     const MeshDump& mesh) {
    if (!task_.explain) return;
    std::vector<Ref> match;
    for (const Origin& origin : level.origins)
      match.push_back(origin.is_old() ? old_to_mine[origin.a] : kUnsetRef);
    judgement_.findings.back().surface = figure_of_connectivity(level.surface, mesh, match);
  }

  bool has_surface(const Level& level, const std::vector<Ref>& old_to_mine,
                   const MeshDump& mesh) {
    match_ = match_level(level, old_to_mine, mesh, scales_);
    if (!match_.empty()) return true;
    report_other_surface(level, old_to_mine, mesh);
    show_valences(level, old_to_mine, mesh);
    if (task_.explain) {
      judgement_.findings.back().likely = recognize_connectivity(before_, mesh, first_marked_);
    }
    return false;
  }

  /// The first vertex with another number of edges than it should have.
  void report_other_surface(const Level& level, const std::vector<Ref>& old_to_mine,
                            const MeshDump& mesh) {
    const std::vector<std::size_t> want = valences(level.surface);
    const std::vector<std::size_t> have = valences(mesh);
    for (std::size_t v = 0; v < level.origins.size(); ++v) {
      const Origin& origin = level.origins[v];
      if (!origin.is_old()) continue;
      const Ref mine = old_to_mine[origin.a];
      if (mine >= have.size() || have[mine] == want[v]) continue;
      report("connectivity", kConnectivity, vertex_name(mine),
             "the old vertex " + vertex_name(mine) + " has " + plural(want[v], "edge"),
             plural(have[mine], "edge"), kWhichEdges);
      return;
    }
    report("connectivity", kConnectivity, "the mesh", "every old triangle is cut into four",
           "the triangles are joined in another way",
           "which new edges are flipped, and whether they are marked with isNew");
  }

  std::string origin_text(const Level& level, std::size_t v) const {
    const Origin& origin = level.origins[v];
    if (origin.is_old()) return "an old vertex";
    return "the new vertex of an old edge";
  }

  bool has_positions(const Level& level, const MeshDump& mesh) {
    const std::vector<Point3> actual = matched_points(match_, mesh);
    const std::string& nearest = nearest_variant(level, actual);
    const std::vector<Point3>& expected = level.by_variant.at(nearest).positions;
    if (task_.measure) {
      const double size = extent(level.by_variant.begin()->second.positions);
      judgement_.deviation = measure_deviation(expected, mesh, match_, size, task_.tolerance);
      judgement_.deviation.weights = nearest;
    }
    Conventions agreeing;
    for (const auto& [name, polygons] : level.by_variant) {
      if (are_within(polygons.positions, actual, scales_)) agreeing.insert(name);
    }
    if (!agreeing.empty()) {
      conventions_ = keep_agreeing(agreeing);
      return true;
    }
    report_position(level, actual, worst_by_scale(expected, actual, scales_), nearest);
    if (task_.explain) {
      Finding& finding = judgement_.findings.back();
      finding.likely = likely_positions(level, actual);
      const Misconceptions left_out = not_copied(level.origins, expected, actual, mesh);
      finding.likely.insert(finding.likely.end(), left_out.begin(), left_out.end());
      finding.surface = figure_of_positions(level.surface, expected, mesh, match_, scales_);
    }
    return false;
  }

  /// The allowed weights by which the fewest vertices are wrong; of these, the least wrong.
  const std::string& nearest_variant(const Level& level,
                                     const std::vector<Point3>& actual) const {
    std::map<std::pair<std::size_t, double>, const std::string*> ranked;
    for (const auto& [name, polygons] : level.by_variant) {
      ranked.emplace(std::pair(count_wrong(polygons, actual, scales_),
                               worst_point(polygons.positions, actual).error),
                     &name);
    }
    return *ranked.begin()->second;
  }

  /// " at valence 4, 5": the valences of inner old vertices at which the rules differ.
  static std::string telling_valences(const Level& level) {
    const std::vector<std::size_t> all = valences(level.surface);
    const std::vector<bool> boundary = on_boundary(level.surface);
    std::set<std::size_t> telling;
    for (std::size_t v = 0; v < level.origins.size(); ++v) {
      const bool agree = all[v] == 3 || all[v] == 6;
      if (level.origins[v].is_old() && !agree && !boundary[v]) {
        telling.insert(all[v]);
      }
    }
    std::vector<std::string> texts;
    for (std::size_t n : telling)
      texts.push_back(std::to_string(n));
    return texts.empty() ? "" : " at valence " + join(texts, ", ");
  }

  /// Published rules that the assignment, or the cases before, rule out.
  std::vector<OtherRule> other_rules(const Level& level) const {
    const Conventions asked = allowed_variants(task_.rubric);
    const std::string used = level.by_variant.begin()->first;
    std::vector<OtherRule> others;
    for (const Variant& variant : kVariants) {
      if (level.by_variant.count(variant.name) != 0) continue;
      const bool mixed = asked.count(variant.name) != 0;
      others.push_back(
          {mixed ? "rules-mixed" : "other-rule",
           std::string("these are ") + variant.name + telling_valences(level) +
               (mixed ? ", but the cases before have " + used + ": use one rule everywhere"
                      : "; asked are " + used),
           {variant.vertex_rule,
            opensubdiv_loop(old_, variant.vertex_rule, variant.corner_rule).mesh.positions}});
    }
    return others;
  }

  Misconceptions likely_positions(const Level& level, const std::vector<Point3>& actual) const {
    RefinedStep step{old_, level.origins, {}, other_rules(level)};
    for (const auto& [name, polygons] : level.by_variant) {
      step.right.push_back({find_variant(name).vertex_rule, polygons.positions});
    }
    const auto strictest = std::min_element(
        scales_.begin(), scales_.end(),
        [](const LocalScale& x, const LocalScale& y) { return x.allowed < y.allowed; });
    return recognize_positions(step, actual, strictest->allowed);
  }

  /// Names the first or the last vertex of the student's list, if it alone is where the splits
  /// have left it.
  Misconceptions not_copied(const std::vector<Origin>& origins,
                            const std::vector<Point3>& expected,
                            const std::vector<Point3>& actual, const MeshDump& mesh) const {
    std::vector<std::size_t> wrong;
    for (std::size_t v = 0; v < actual.size(); ++v) {
      if (!(distance(expected[v], actual[v]) <= scales_[v].allowed)) wrong.push_back(v);
    }
    if (wrong.size() != 1) return {};
    const Origin& origin = origins[wrong[0]];
    const Point3 left = blend(old_.positions[origin.a], old_.positions[origin.b], 0.5);
    if (!(distance(left, actual[wrong[0]]) <= scales_[wrong[0]].allowed)) return {};
    const auto is_live = [](const VertexRecord& v) { return v.live != 0; };
    const auto& vertices = mesh.vertices;
    const auto first = std::find_if(vertices.begin(), vertices.end(), is_live);
    const auto last = std::find_if(vertices.rbegin(), vertices.rend(), is_live);
    const Ref mine = match_[wrong[0]];
    if (mine == static_cast<Ref>(first - vertices.begin()))
      return {find_misconception(loop_misconceptions(), "first-not-copied")};
    if (mine + 1 == static_cast<Ref>(vertices.rend() - last))
      return {find_misconception(loop_misconceptions(), "last-not-copied")};
    return {};
  }

  Conventions keep_agreeing(const Conventions& agreeing) const {
    Conventions kept;
    std::set_intersection(conventions_.begin(), conventions_.end(), agreeing.begin(),
                          agreeing.end(), std::inserter(kept, kept.end()));
    return kept;
  }

  /// By which rule a position is the expected one; empty for edge points, which have one rule.
  std::string rule_text(const Level& level, std::size_t index,
                        const std::string& variant) const {
    if (!level.origins[index].is_old()) return {};
    const Point3& expected = level.by_variant.at(variant).positions[index];
    std::set<VertexRule> rules;
    for (const auto& [name, polygons] : level.by_variant) {
      const double other = distance(polygons.positions[index], expected);
      if (other > scales_[index].allowed) return " by " + variant;
      rules.insert(find_variant(name).vertex_rule);
    }
    return rules.size() > 1 ? " by either rule's weights" : " by " + variant;
  }

  void report_position(const Level& level, const std::vector<Point3>& actual, WorstPoint worst,
                       const std::string& variant) {
    const std::size_t valence = valences(level.surface)[worst.index];
    const bool old = level.origins[worst.index].is_old();
    const std::string mine = vertex_name(match_[worst.index]);
    report("position", "the positions are those of Loop subdivision (compared with OpenSubdiv)",
           mine + ", " + origin_text(level, worst.index) +
               (old ? " with " + plural(valence, "edge") : ""),
           point_text(level.by_variant.at(variant).positions[worst.index]) +
               rule_text(level, worst.index, variant),
           point_text(actual[worst.index]) + ", off by " +
               error_text(worst.error, scales_[worst.index]),
           std::string(old ? "the weights of old vertices" : "the weights of edge points") +
               ", from positions before the step: " +
               position_formula(old, on_boundary(level.surface)[worst.index]));
  }

  const JudgeTask& task_;
  Conventions& conventions_;
  CaseJudgement& judgement_;
  std::string where_;
  PolygonMesh old_;       ///< the mesh before the step, expected vertices
  MeshDump before_;       ///< the same as the student has it
  Ref first_marked_ = 0;  ///< vertices from here on did not exist before the first level
  std::vector<LocalScale> scales_;  ///< of the expected vertices
  std::vector<Ref> match_;          ///< expected vertex -> the student's
};

}  // namespace

ExerciseJudge loop_subdivision_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {"vertex_rule", "corner_rule"});
  return {{"MeshResampler::upsample"},
          allowed_variants(rubric),
          [](const JudgeTask& task, Conventions& conventions, CaseJudgement& judgement) {
            LevelsJudge(task, conventions, judgement).judge();
          },
          loop_misconceptions()};
}

}  // namespace meshgrade
