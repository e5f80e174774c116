#include "grader/judge/refinement_judge.h"

namespace meshgrade {

ExerciseJudge catmull_clark_judge(const ExerciseRubric& rubric) {
  return refinement_judge<RefinementScheme::kCatmullClark>(rubric,
                                                           "PolyMesh::catmullClarkPositions");
}

}  // namespace meshgrade
