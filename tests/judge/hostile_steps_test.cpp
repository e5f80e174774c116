// Whatever a submission leaves behind, the judge gives a verdict.

#include <gtest/gtest.h>

#include "grader/base/random.h"
#include "grader/judge/judge.h"
#include "tests/support/right_answers.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

void damage_bytes(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  const auto size = static_cast<std::uint32_t>(bytes.size());
  switch (random.below(5)) {
    case 0:
      bytes.resize(random.below(size));
      break;
    case 1:
      bytes += "xyz";
      break;
    default:
      for (std::uint32_t i = 1 + random.below(6); i > 0; --i)
        bytes[random.below(size)] = static_cast<char>(random.below(256));
  }
}

/// Another number in a place where a mesh keeps one: what a wrong solution does.
void damage_numbers(std::string& bytes, Random& random) {
  for (std::uint32_t i = 1 + random.below(4); i > 0 && bytes.size() >= 4; --i) {
    const std::uint32_t value =
        random.below(8) == 0 ? kUnsetRef - random.below(3) : random.below(24);
    const std::uint32_t place = 4 * random.below(static_cast<std::uint32_t>(bytes.size() / 4));
    std::memcpy(bytes.data() + place, &value, sizeof value);
  }
}

void damage(Outcome& outcome, Random& random) {
  const auto count = static_cast<std::uint32_t>(outcome.steps.size());
  switch (random.below(8)) {
    case 0:
      outcome.steps.resize(random.below(count + 3));
      break;
    case 1:
      std::swap(outcome.steps[random.below(count)], outcome.steps[random.below(count)]);
      break;
    case 2:
    case 3:
      damage_bytes(outcome.steps[random.below(count)], random);
      break;
    default:
      damage_numbers(outcome.steps[random.below(count)], random);
  }
  outcome.ending = static_cast<Ending>(random.below(kLastEnding + 1));
  if (random.below(2) == 0) outcome.ending = Ending::kDone;
  outcome.fault_kind = random.below(9);
  if (outcome.ending != Ending::kFault || count == 0) return;
  outcome.interrupted = outcome.steps.empty() ? "xyz" : outcome.steps.back();
  if (!outcome.steps.empty()) outcome.steps.pop_back();
  damage_numbers(outcome.interrupted, random);
}

class HostileSteps : public testing::TestWithParam<std::string> {};

TEST_P(HostileSteps, AlwaysGetAVerdict) {
  const ExerciseRubric& rubric = rubric_of(GetParam());
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Random random(9, GetParam());
  std::map<Verdict, int> verdicts;
  // The exercises about one operation have one judge in common, and hundreds of cases each.
#ifdef __SANITIZE_ADDRESS__
  const int rounds = find_local_operation(GetParam()) != nullptr ? 1 : 15;
#else
  const int rounds = find_local_operation(GetParam()) != nullptr ? 2 : 15;
#endif
  Conventions conventions = judge.conventions;
  for (const Case& c : standard_cases(GetParam())) {
    if (c.input.size() > 20'000 || takes_minutes_when_sanitized(c)) continue;
    const Outcome right = right_outcome(c);
    for (int round = 0; round < rounds; ++round) {
      Outcome outcome = right;
      damage(outcome, random);
      const CaseJudgement judgement =
          judge_case(judge, {c, outcome, rubric, 1e-5}, conventions);
      ++verdicts[judgement.verdict];
      const bool told = !judgement.findings.empty() || !judgement.note.empty();
      EXPECT_EQ(judgement.verdict != Verdict::kPassed, told) << c.id();
    }
  }
  EXPECT_GT(verdicts[Verdict::kFailed], 50);
  EXPECT_GT(verdicts[Verdict::kCrashed], 5);
}

TEST_P(HostileSteps, OfAnotherExerciseAreMalformed) {
  const ExerciseRubric& rubric = rubric_of(GetParam());
  const ExerciseJudge judge = find_exercise_judge(rubric);
  const Case& c = standard_cases(GetParam())[0];
  for (const std::string& bytes :
       std::vector<std::string>{"", "xxx", to_wire(std::string("?"))}) {
    Outcome outcome;
    outcome.steps = {bytes};
    Conventions conventions = judge.conventions;
    const CaseJudgement judgement = judge_case(judge, {c, outcome, rubric, 1e-5}, conventions);
    EXPECT_EQ(judgement.verdict, Verdict::kFailed);
    ASSERT_EQ(judgement.findings.size(), 1U);
    EXPECT_EQ(judgement.findings[0].rule, "malformed");
  }
}

INSTANTIATE_TEST_SUITE_P(, HostileSteps, testing::ValuesIn(all_exercises()),
                         [](const auto& parameter) { return parameter.param; });

// A forged history can lead to a mesh that does not have the edge that is asked for next.
TEST(HostileHistory, EdgeThatIsNotThereIsMalformed) {
  const ExerciseRubric& rubric = *standard_rubric().find("edge_split");
  OperationsInput input;
  input.mesh = sample_polygons("octahedron.off");
  input.operations = {{OperationKind::kSplit, 0, 0}};
  const Case c{"edge_split", "basic", 1, "", to_wire(input), 1000};
  OperationStep step;
  step.after = sample_dump("octahedron.off");
  Outcome outcome;
  outcome.steps = {to_wire(step)};  // step.edge is unset, as it must be for no edge
  const ExerciseJudge judge = find_exercise_judge(rubric);
  Conventions conventions;
  const CaseJudgement judgement = judge_case(judge, {c, outcome, rubric, 1e-5}, conventions);
  ASSERT_FALSE(judgement.findings.empty());
  EXPECT_EQ(judgement.findings[0].rule, "malformed");
}

}  // namespace
}  // namespace meshgrade
