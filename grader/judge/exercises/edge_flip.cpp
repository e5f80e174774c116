#include "grader/judge/operations_judge.h"
#include "grader/judge/options.h"

namespace meshgrade {

ExerciseJudge edge_flip_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  return {{"HalfedgeMesh::flipEdge"},
          {},
          [](const JudgeTask& task, Conventions& /*conventions*/, CaseJudgement& judgement) {
            judge_operations(task, judgement);
          },
          {},
          show_stopped_operation,
          true};
}

}  // namespace meshgrade
