#pragma once

// The rules that make a half-edge mesh right, and a check of all of them.

#include <string>
#include <string_view>
#include <vector>

#include "grader/mesh/mesh_dump.h"

namespace meshgrade {

/// A rule: its short name, which is the same in messages, JSON, docs and tests, and what it
/// asks, as a sentence.
struct Rule {
  std::string_view name;
  std::string_view meaning;
};

/// All rules, in the order in which they are checked: a mesh that breaks an early one need not
/// make sense to a later one.
const std::vector<Rule>& mesh_rules();

/// The meaning of a rule by its name; empty if there is no such rule.
std::string_view rule_meaning(std::string_view name);

/// One place where a rule is broken.
struct RuleBreak {
  std::string rule;
  std::string element;   ///< where: "h12", "f3", "e5"
  std::string expected;  ///< in a few words
  std::string actual;
  std::string look_at;  ///< the pointer to look at first: "h12.next"
};

/// What the faces of a surface may be.
enum class FaceShape {
  kTriangles,
  kPolygons,
  kDegeneratePolygons,  ///< two edges may join the same vertices, two faces have the same
                        ///< corners
};

/// Checks every rule that can be checked without knowing where the mesh came from. Linear time.
/// At most a few breaks of each rule are returned, in the order of the rules. Rules whose
/// meaning depends on an earlier rule pass over the elements that break that one.
std::vector<RuleBreak> find_broken_rules(const MeshDump& mesh,
                                         FaceShape shape = FaceShape::kTriangles);

}  // namespace meshgrade
