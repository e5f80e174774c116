#pragma once

#include <string>
#include <vector>

#include "grader/cases/placement_input.h"
#include "grader/judge/judge.h"
#include "grader/judge/misconception.h"

namespace meshgrade {

/// What a corner's place depends on.
struct PlacedCorner {
  Point3 start;  ///< where it begins
  Point3 mean;   ///< of where all corners of the face begin
  Point3 outer;  ///< the vertex outside of the face that an edge joins it to
};

/// Where a corner lies.
using PlacementFormula = Point3 (*)(const PlacedCorner& corner, const Placement& asked);

/// A formula that is wrong, and what to say where the numbers are those that it gives.
struct PlacementMistake {
  PlacementFormula place;
  Misconception misconception;
};

struct PlacementRules {
  std::string function;  ///< "PolyMesh::placeExtruded"
  PlacementFormula right;
  std::vector<PlacementMistake> mistakes;
};

/// All that judge_placements() can name with these rules.
Misconceptions placement_misconceptions(const PlacementRules& rules);

/// Judges the places after each call, and that nothing else has changed.
void judge_placements(const JudgeTask& task, const PlacementRules& rules,
                      CaseJudgement& judgement);

}  // namespace meshgrade
