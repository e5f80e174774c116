#include "grader/judge/refinement_judge.h"

namespace meshgrade {

ExerciseJudge linear_subdivision_judge(const ExerciseRubric& rubric) {
  return refinement_judge<RefinementScheme::kLinear>(rubric, "PolyMesh::linearPositions");
}

}  // namespace meshgrade
