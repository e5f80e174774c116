#include "grader/judge/operation_advice.h"
#include "grader/judge/operations_judge.h"
#include "grader/judge/options.h"

namespace meshgrade {

ExerciseJudge edge_split_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  return {{"HalfedgeMesh::splitEdge"},
          {},
          [](const JudgeTask& task, Conventions& /*conventions*/, CaseJudgement& judgement) {
            judge_operations(task, judgement);
          },
          split_misconceptions(),
          show_stopped_operation,
          true};
}

}  // namespace meshgrade
