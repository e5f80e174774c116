#include "grader/view/student_program.h"

#include <algorithm>

#include "grader/base/errors.h"
#include "grader/cases/view_input.h"
#include "grader/run/run.h"

namespace meshgrade {
namespace {

constexpr std::uint32_t kPatienceMs = 4000;

bool all_compiled(const std::vector<BuiltFile>& files) {
  return std::all_of(files.begin(), files.end(),
                     [](const BuiltFile& file) { return file.ok && file.left_out.empty(); });
}

}  // namespace

StudentProgram::StudentProgram(const Assignment& assignment, Home home,
                               std::filesystem::path submission)
    : assignment_(assignment),
      home_(std::move(home)),
      submission_(std::move(submission)),
      name_(find_submission(submission_, assignment_.submission).name) {}

bool StudentProgram::rebuild() {
  Submission sources = find_submission(submission_, assignment_.submission);
  Build built = build_submission(sources, home_, assignment_.limits);
  ++builds_;
  files_ = built.files;
  compiled_ = all_compiled(files_);
  if (!compiled_ && build_) return false;
  build_.reset();
  build_.emplace(std::move(built));
  sources_ = std::move(sources);
  return true;
}

std::vector<Outcome> StudentProgram::run(const std::vector<Case>& asked) const {
  if (!build_) throw UserError("there is no program yet");
  Limits limits = assignment_.limits;
  limits.case_cpu_ms = std::min(limits.case_cpu_ms, kPatienceMs);
  limits.case_wall_ms = std::min(limits.case_wall_ms, 2 * kPatienceMs);
  return run_cases(*build_, pointers_to(asked), limits, Company::kTogether);
}

CaseReport StudentProgram::tell(const std::string& exercise, const std::string& title,
                                CaseJudgement judgement, const Outcome& outcome) const {
  ExerciseRubric rubric;
  rubric.name = exercise;
  JudgedExercise told;
  told.rubric = &rubric;
  JudgedCase judged;
  judged.asked.exercise = exercise;
  judged.asked.group = kViewTask;
  judged.asked.title = title;
  judged.judgement = std::move(judgement);
  judged.output = outcome.output;
  judged.output_bytes = outcome.output_bytes;
  told.cases.push_back(std::move(judged));
  return make_report(assignment_, *sources_, *build_, {told}).exercises[0].cases[0];
}

}  // namespace meshgrade
