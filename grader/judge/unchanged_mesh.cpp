#include "grader/judge/unchanged_mesh.h"

#include "grader/base/text.h"
#include "grader/judge/findings.h"
#include "grader/mesh/mesh_changes.h"

namespace meshgrade {
namespace {

Finding change_finding(const std::string& where, const UnchangedWords& words,
                       const std::string& element, const std::string& expected,
                       const std::string& actual, const std::string& look_at) {
  return make_finding("mesh-changed", words.meaning, where, element, expected, actual, look_at);
}

/// The first vertex that is not where it was; nothing if there is none.
std::optional<Finding> find_moved(const MeshDump& before, const MeshDump& after,
                                  const std::string& where, const UnchangedWords& words) {
  for (Ref v = 0; v < before.vertices.size(); ++v) {
    const Point3& old = before.vertices[v].position;
    const Point3& now = after.vertices[v].position;
    if (old == now) continue;
    return change_finding(where, words, vertex_name(v),
                          vertex_name(v) + " stays at " + point_text(old),
                          vertex_name(v) + " lies at " + point_text(now), words.moved);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> find_change(const MeshDump& before, const MeshDump& after,
                                   const std::string& where, const UnchangedWords& words) {
  const bool same_slots = before.halfedges.size() == after.halfedges.size() &&
                          before.vertices.size() == after.vertices.size() &&
                          before.edges.size() == after.edges.size() &&
                          before.faces.size() == after.faces.size() &&
                          before.boundaries.size() == after.boundaries.size();
  if (!same_slots || !(count(before) == count(after))) {
    return change_finding(where, words, "the mesh", counts_text(count(before)),
                          count(before) == count(after)
                              ? "elements were created, and others deleted"
                              : counts_text(count(after)),
                          words.created);
  }
  if (auto moved = find_moved(before, after, where, words)) return moved;
  const auto changes = find_changes(before, after, 1);
  if (changes.empty()) return std::nullopt;
  const std::string pointer = changes[0].element + "." + changes[0].pointer;
  return change_finding(where, words, changes[0].element,
                        pointer + " stays " + changes[0].before,
                        pointer + " is " + changes[0].after,
                        "is a handle a reference? In HalfedgeIter& h = v->halfedge(), h = "
                        "h->next() rewires the mesh");
}

void mention_turned_anchors(std::uint32_t turns, CaseJudgement& judgement) {
  // Where the numbers tell the cause, anchors are not it.
  if (turns == 0 || judgement.findings.empty() || !judgement.findings[0].likely.empty()) return;
  judgement.findings[0].look_at +=
      "; does your code rely on which half-edge halfedge() is? Here each is another than after "
      "build(), as operations leave them";
}

}  // namespace meshgrade
