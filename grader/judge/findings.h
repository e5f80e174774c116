#pragma once

#include <string>
#include <utility>

#include "grader/cases/mesh_input.h"
#include "grader/judge/finding.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {

/// "8 vertices, 18 edges, 12 faces, 36 half-edges, 0 boundary loops"
std::string counts_text(const Counts& counts);

/// A finding about a mesh rule.
Finding to_finding(const RuleBreak& rule_break, const std::string& where);

/// A finding with a rule of the exercise's own.
inline Finding make_finding(std::string rule, std::string meaning, std::string where,
                            std::string element, std::string expected, std::string actual,
                            std::string look_at) {
  Finding finding;
  finding.rule = std::move(rule);
  finding.meaning = std::move(meaning);
  finding.where = std::move(where);
  finding.element = std::move(element);
  finding.expected = std::move(expected);
  finding.actual = std::move(actual);
  finding.look_at = std::move(look_at);
  return finding;
}

/// Adds to what to look at that the mesh had other anchors than after build(), if it had.
void mention_anchoring(Anchoring anchoring, CaseJudgement& judgement);

/// "1.2e-02 of the mesh's diagonal (allowed: 1e-05)"
std::string error_text(double error, double size, double tolerance);

}  // namespace meshgrade
