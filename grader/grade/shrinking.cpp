#include "grader/grade/shrinking.h"

#include <algorithm>

#include "grader/cases/case_list.h"
#include "grader/judge/judge.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

constexpr std::size_t kTogether = 64;  ///< questions that one worker is asked
constexpr std::size_t kMost = 1000;    ///< questions in all

/// Looks for smaller questions with the same verdict, step by step: from each one found it goes
/// on, until none of the next smaller ones fails.
class Shrinker {
 public:
  Shrinker(const Assignment& assignment, const Home& home, const Candidate& candidate,
           const ExerciseRubric& rubric, const std::vector<Case>& all)
      : assignment_(assignment),
        home_(home),
        candidate_(candidate),
        rubric_(rubric),
        asked_(all),
        judge_(find_exercise_judge(rubric)) {}

  std::optional<JudgedCase> run(const JudgedCase& failed) {
    verdict_ = failed.judgement.verdict;
    std::optional<JudgedCase> smallest;
    while (auto next = one_smaller(smallest ? smallest->asked : failed.asked)) {
      smallest = std::move(next);
      smallest->shrunk_from = failed.asked.title;
      smallest->judgement.excused = failed.judgement.excused;
    }
    return smallest;
  }

 private:
  std::optional<JudgedCase> one_smaller(const Case& failed) {
    std::vector<Case> smaller = make_smaller_cases(assignment_, rubric_, home_.meshes, failed);
    smaller.erase(std::remove_if(smaller.begin(), smaller.end(),
                                 [&](const Case& c) { return is_asked_anyway(c); }),
                  smaller.end());
    for (std::size_t begin = 0; begin < smaller.size() && tried_ < kMost; begin += kTogether) {
      const std::size_t end = std::min(smaller.size(), begin + kTogether);
      if (auto found = first_failing({smaller.begin() + static_cast<std::ptrdiff_t>(begin),
                                      smaller.begin() + static_cast<std::ptrdiff_t>(end)})) {
        return found;
      }
    }
    return std::nullopt;
  }

  bool is_asked_anyway(const Case& smaller) const {
    return std::any_of(asked_.begin(), asked_.end(),
                       [&](const Case& c) { return c.input == smaller.input; });
  }

  std::optional<JudgedCase> first_failing(const std::vector<Case>& cases) {
    tried_ += cases.size();
    const std::vector<Outcome> outcomes =
        run_cases(candidate_.build, pointers_to(cases), assignment_.limits, Company::kTogether);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      // Lost with the others' results: that tells nothing about this one.
      if (outcomes[i].lost) continue;
      if (judge(cases[i], outcomes[i], false).judgement.verdict != verdict_) continue;
      // Once more alone: what one question leaves behind may spoil the next one.
      const std::vector<Outcome> alone =
          run_cases(candidate_.build, {&cases[i]}, assignment_.limits, Company::kAlone);
      JudgedCase judged = judge(cases[i], alone[0], true);
      if (judged.judgement.verdict == verdict_) return judged;
    }
    return std::nullopt;
  }

  JudgedCase judge(const Case& c, const Outcome& outcome, bool explain) const {
    Conventions conventions = judge_.conventions;
    return {
        c,
        judge_case(judge_, {c, outcome, rubric_, assignment_.tolerance, explain}, conventions),
        outcome.output, outcome.output_bytes, ""};
  }

  const Assignment& assignment_;
  const Home& home_;
  const Candidate& candidate_;
  const ExerciseRubric& rubric_;
  const std::vector<Case>& asked_;
  ExerciseJudge judge_;
  Verdict verdict_ = Verdict::kFailed;
  std::size_t tried_ = 0;
};

}  // namespace

std::optional<JudgedCase> shrink(const Assignment& assignment, const Home& home,
                                 const Candidate& candidate, const ExerciseRubric& rubric,
                                 const std::vector<Case>& all, const JudgedCase& failed) {
  return Shrinker(assignment, home, candidate, rubric, all).run(failed);
}

}  // namespace meshgrade
