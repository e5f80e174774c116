#pragma once

#include <string>
#include <vector>

#include "grader/cases/placement_input.h"
#include "grader/judge/judge.h"

namespace meshgrade {

/// What a corner's place depends on.
struct PlacedCorner {
  Point3 start;  ///< where it begins
  Point3 mean;   ///< of where all corners of the face begin
  Point3 outer;  ///< the vertex outside of the face that an edge joins it to
};

/// A formula for the place of a corner, and what it means if it fits a wrong answer.
struct PlacementFormula {
  Point3 (*place)(const PlacedCorner& corner, const Placement& asked);
  std::string mistake = {};  ///< "the corners shrink towards the origin, and not ..."
};

struct PlacementRules {
  std::string function;  ///< "PolyMesh::placeExtruded"
  PlacementFormula right;
  std::vector<PlacementFormula> mistakes;  ///< those that are made most often first
};

/// Judges the places after each call, and that nothing else has changed.
void judge_placements(const JudgeTask& task, const PlacementRules& rules,
                      CaseJudgement& judgement);

}  // namespace meshgrade
