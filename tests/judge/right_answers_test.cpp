// Answers that are made without half-edge code are right in every case of the assignment.

#include <gtest/gtest.h>

#include "grader/judge/judge.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

/// Under the sanitizers, a large mesh of polygons, and three of four others: the operations
/// have one judge in common and hundreds of cases each. The tests of the release build have all
/// of them.
bool takes_minutes([[maybe_unused]] const Case& c) {
#ifdef __SANITIZE_ADDRESS__
  return assignment_with(c.exercise).folder == "polygon_meshes" &&
         (c.input.size() > 100'000 || c.number % 4 != 0);
#else
  return false;
#endif
}

class RightAnswers : public testing::TestWithParam<std::string> {};

TEST_P(RightAnswers, PassEveryCase) {
  const ExerciseRubric& rubric = rubric_of(GetParam());
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions = judge.conventions;
  for (const Case& c : standard_cases(GetParam())) {
    if (takes_minutes(c) || takes_minutes_when_sanitized(c)) continue;
    const Outcome outcome = right_outcome(c);
    const CaseJudgement judgement = judge_case(judge, {c, outcome, rubric, 1e-9}, conventions);
    EXPECT_EQ(judgement.verdict, Verdict::kPassed)
        << c.id() << " " << c.title << ": "
        << (judgement.findings.empty() ? judgement.note : judgement.findings[0].actual);
    EXPECT_TRUE(judgement.findings.empty());
  }
}

TEST_P(RightAnswers, WithAStepMissingAreNotBelieved) {
  const ExerciseRubric& rubric = rubric_of(GetParam());
  const ExerciseJudge judge = find_exercise_judge(rubric);
  for (const Case& c : standard_cases(GetParam())) {
    if (c.input.size() > 100'000 || takes_minutes_when_sanitized(c)) continue;
    Outcome outcome = right_outcome(c);
    outcome.steps.pop_back();
    Conventions conventions = judge.conventions;
    const CaseJudgement judgement = judge_case(judge, {c, outcome, rubric, 1e-5}, conventions);
    EXPECT_EQ(judgement.verdict, Verdict::kFailed) << c.id();
    ASSERT_FALSE(judgement.findings.empty()) << c.id();
    EXPECT_EQ(judgement.findings[0].rule, "malformed") << c.id();
  }
}

INSTANTIATE_TEST_SUITE_P(, RightAnswers, testing::ValuesIn(all_exercises()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace meshgrade
