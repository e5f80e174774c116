#include "grader/judge/remesh_lengths.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/judge/findings.h"
#include "grader/judge/point_compare.h"
#include "grader/operations/picked_element.h"
#include "grader/operations/remesh_steps.h"

namespace meshgrade {
namespace {

/// Positions to ask for.
class Places {
 public:
  Places(std::vector<Point3> points, double allowed)
      : points_(std::move(points)), allowed_(allowed) {}

  bool hold(const Point3& p) const {
    return std::any_of(points_.begin(), points_.end(),
                       [&](const Point3& q) { return distance(p, q) <= allowed_; });
  }

 private:
  std::vector<Point3> points_;
  double allowed_;
};

Places places_of(const MeshDump& mesh, double allowed) {
  std::vector<Point3> points;
  for (const VertexRecord& v : mesh.vertices) {
    if (v.live != 0) points.push_back(v.position);
  }
  return {std::move(points), allowed};
}

Places places_of(const FaceLists& lists, double allowed) {
  const std::vector<bool> in_use = labels_in_use(lists);
  std::vector<Point3> points;
  for (Label label = 0; label < in_use.size(); ++label) {
    if (in_use[label]) points.push_back(lists.positions[label]);
  }
  return {std::move(points), allowed};
}

/// What became of an edge, and what had to.
struct EdgeFate {
  double share;    ///< its length as a part of the mean
  bool was_split;  ///< its ends and its middle are there
  bool must_split;
  bool was_collapsed;  ///< its middle is there, and no end
  bool must_collapse;
};

struct FateWords {
  const char* rule;
  bool (*applies)(const EdgeFate& fate);
  const char* meaning;
  const char* done;  ///< what was done with the edge
  const char* must;  ///< what has to be done
  const char* look_at;
};

/// What is done without need comes first: it may be why something else is missing.
const std::vector<FateWords>& all_fates() {
  static const std::vector<FateWords> fates{
      {"split-needless", [](const EdgeFate& f) { return f.was_split && !f.must_split; },
       "no edge is split that is not longer than longerFactor L", "was split", "stays",
       "the limit: longerFactor times the mean length of all edges"},
      {"collapse-needless",
       [](const EdgeFate& f) { return f.was_collapsed && !f.must_collapse; },
       "no edge is collapsed that is not shorter than shorterFactor L", "was collapsed",
       "stays", "the limit: shorterFactor times the mean length of all edges"},
      {"split-missing", [](const EdgeFate& f) { return f.must_split && !f.was_split; },
       "every edge longer than longerFactor L is split", "was not split", "is split",
       "the loop that splits: does it visit every edge that was there when it began, and "
       "compare "
       "with longerFactor times the mean length?"},
      {"collapse-missing",
       [](const EdgeFate& f) { return f.must_collapse && !f.was_collapsed; },
       "every edge shorter than shorterFactor L is collapsed", "was not collapsed",
       "is collapsed",
       "the loop that collapses: does it visit every edge that is still there, does its "
       "condition ask what it should, and does it go on after a collapse?"}};
  return fates;
}

Finding other_vertices(const Resizing& right, const MeshDump& mesh) {
  const Places expected = places_of(right.after, right.allowed);
  const std::vector<bool> in_use = labels_in_use(right.after);
  const auto n = static_cast<std::size_t>(std::count(in_use.begin(), in_use.end(), true));
  Finding finding = make_finding(
      "vertices", "the vertices are those that the splits and collapses leave", "", "the mesh",
      std::to_string(n) + " vertices", std::to_string(count(mesh).vertices) + " vertices",
      "which edges are split, which are collapsed, and that nothing else moves a vertex");
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].live == 0 || expected.hold(mesh.vertices[v].position)) continue;
    finding.element = vertex_name(v);
    finding.expected += ", none at " + point_text(mesh.vertices[v].position);
    finding.actual += "; " + vertex_name(v) + " lies there";
    break;
  }
  return finding;
}

}  // namespace

std::vector<bool> labels_in_use(const FaceLists& lists) {
  std::vector<bool> in_use(lists.positions.size(), false);
  for (const Corners& face : lists.faces) {
    for (const Label label : face)
      in_use[label] = true;
  }
  return in_use;
}

std::optional<std::vector<Label>> labels_by_place(const MeshDump& mesh, const FaceLists& lists,
                                                  double allowed) {
  std::vector<bool> is_free = labels_in_use(lists);
  std::vector<Label> labels(mesh.vertices.size(), 0);
  for (Ref v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].live == 0) continue;
    double least = allowed;
    bool found = false;
    for (Label label = 0; label < is_free.size(); ++label) {
      const double off = distance(mesh.vertices[v].position, lists.positions[label]);
      if (!is_free[label] || !(off <= least)) continue;
      least = off;
      labels[v] = label;
      found = true;
    }
    if (!found) return std::nullopt;
    is_free[labels[v]] = false;
  }
  const bool all = std::find(is_free.begin(), is_free.end(), true) == is_free.end();
  return all ? std::optional(labels) : std::nullopt;
}

Finding wrong_resizing(const Resizing& right, const MeshDump& mesh) {
  const Places expected = places_of(right.after, right.allowed);
  const Places there = places_of(mesh, right.allowed);
  const double mean = mean_edge_length(right.before);
  Finding finding = other_vertices(right, mesh);
  const auto tell = [&](const FateWords& words, const EdgeEnds& edge, const EdgeFate& fate) {
    const std::string name = vertex_name(edge.first) + "-" + vertex_name(edge.second);
    const std::string length = " has the length " + number_text(fate.share, 4) + " L";
    finding =
        make_finding(words.rule, words.meaning, "", name, name + length + ": it " + words.must,
                     "it " + std::string(words.done), words.look_at);
  };
  const std::vector<EdgeEnds> edges = edges_of(right.before);
  for (const FateWords& words : all_fates()) {
    for (const EdgeEnds& edge : edges) {
      const Point3& a = right.before.positions[edge.first];
      const Point3& b = right.before.positions[edge.second];
      const Point3 mid = middle(right.before, {edge.first, edge.second});
      const auto split = [&](const Places& places) {
        return places.hold(mid) && places.hold(a) && places.hold(b);
      };
      const auto collapsed = [&](const Places& places) {
        return places.hold(mid) && !places.hold(a) && !places.hold(b);
      };
      const EdgeFate fate{edge_length(right.before, edge) / mean, split(there), split(expected),
                          collapsed(there), collapsed(expected)};
      if (!words.applies(fate)) continue;
      tell(words, edge, fate);
      return finding;
    }
  }
  return finding;
}

}  // namespace meshgrade
