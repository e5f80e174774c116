#include "grader/judge/operation_advice.h"
#include "grader/judge/operations_judge.h"
#include "grader/judge/options.h"

namespace meshgrade {
namespace {

constexpr const char* kMarkOfTheHalf = "e1->isNew = e0->isNew;";

/// Marks are between a split and its caller. The reference gives the new half that of the old.
const std::vector<OpenChoice> kChoices{
    {kMarkOfTheHalf, "", "one that leaves isNew of both halves of the old edge alone"},
    {kMarkOfTheHalf, "e0->isNew = false;",
     "one that sets isNew of both halves of the old edge to false"},
    {kMarkOfTheHalf, "e0->isNew = true;\n  e1->isNew = true;",
     "one that sets isNew of both halves of the old edge to true"},
};

}  // namespace

ExerciseJudge edge_split_judge(const ExerciseRubric& rubric) {
  refuse_unknown_options(rubric, {});
  return {{"HalfedgeMesh::splitEdge"},
          {},
          [](const JudgeTask& task, Conventions& /*conventions*/, CaseJudgement& judgement) {
            judge_operations(task, judgement);
          },
          split_misconceptions(),
          show_stopped_operation,
          true,
          kChoices};
}

}  // namespace meshgrade
