// Fuzz target of all that reads what the worker wrote: the result file, and the judges, which
// unpack the dumps in it. The first byte chooses an exercise and one of its cases; the rest is
// the result file.

#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/cases/case_list.h"
#include "grader/judge/judge.h"
#include "grader/run/result_reader.h"
#include "grader/run/run.h"
#include "tests/fuzz/targets.h"

namespace {

using namespace meshgrade;

struct Asked {
  const ExerciseRubric* rubric = nullptr;
  Case asked;
};

/// Small cases of every exercise, at most 256 in all.
struct Everything {
  Assignment assignment = read_assignment(MESHGRADE_SOURCE_DIR "/grader/assignment.toml");
  std::vector<Asked> cases;

  Everything() {
    constexpr std::size_t kSmallInput = 4096;
    for (const ExerciseRubric& rubric : assignment.exercises) {
      std::size_t taken = 0;
      for (Case& c : make_cases(assignment, rubric, MESHGRADE_SOURCE_DIR "/meshes")) {
        if (c.input.size() > kSmallInput || taken == 256 / assignment.exercises.size())
          continue;
        cases.push_back({&rubric, std::move(c)});
        ++taken;
      }
    }
  }
};

Outcome to_outcome(TaskResult result) {
  Outcome outcome;
  outcome.ending = result.ended ? result.end.ending : Ending::kExit;
  outcome.fault_kind = result.end.fault_kind;
  outcome.code = result.end.code;
  outcome.steps = std::move(result.steps);
  outcome.interrupted = std::move(result.end.interrupted);
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Everything everything;
  if (size == 0) return 0;
  const Asked& chosen = everything.cases[data[0] % everything.cases.size()];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const ExerciseJudge judge = find_exercise_judge(*chosen.rubric);
    Conventions conventions = judge.conventions;
    const Outcome outcome = to_outcome(std::move(read_results(bytes, 1).at(0)));
    judge_case(judge, {chosen.asked, outcome, *chosen.rubric, everything.assignment.tolerance},
               conventions);
  } catch (const WireError&) {
    // a forged file: nothing in it counts
  }
  return 0;
}
