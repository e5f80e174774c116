#include "grader/judge/findings.h"

#include "grader/base/text.h"

namespace meshgrade {

std::string counts_text(const Counts& counts) {
  return std::to_string(counts.vertices) + " vertices, " + plural(counts.edges, "edge") + ", " +
         plural(counts.faces, "face") + ", " + plural(counts.halfedges, "half-edge") + ", " +
         plural(counts.boundaries, "boundary loop");
}

Finding to_finding(const RuleBreak& rule_break, const std::string& where) {
  return make_finding(rule_break.rule, std::string(rule_meaning(rule_break.rule)), where,
                      rule_break.element, rule_break.expected, rule_break.actual,
                      rule_break.look_at);
}

std::string error_text(double error, double size, double tolerance) {
  return number_text(error / size, 2) + " of the size (allowed: " + number_text(tolerance, 2) +
         ")";
}

void mention_anchoring(Anchoring anchoring, CaseJudgement& judgement) {
  const bool is_changed =
      anchoring == Anchoring::kElsewhere || anchoring == Anchoring::kFromEarlier;
  if (!is_changed || judgement.findings.empty()) return;
  judgement.findings[0].look_at +=
      "; does your code rely on which half-edge halfedge() of a vertex or an edge is? Here "
      "each "
      "is another than after build(), as flips and splits leave them";
}

}  // namespace meshgrade
