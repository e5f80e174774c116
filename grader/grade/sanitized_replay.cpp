#include "grader/grade/sanitized_replay.h"

#include <algorithm>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/cases/case_list.h"
#include "grader/grade/sanitizer_log.h"

namespace meshgrade {
namespace {

constexpr std::uint32_t kSanitizersSlowDown = 10;

/// The first case that a signal has ended. A stand-in of the grader's has no part in it.
CaseReport* first_crash(Report& report) {
  for (ExerciseReport& exercise : report.exercises) {
    if (!exercise.stand_ins.empty()) continue;
    for (CaseReport& c : exercise.cases) {
      if (!c.findings.empty() && c.findings[0].finding.rule == "crash") return &c;
    }
  }
  return nullptr;
}

std::string first_sentence(const std::string& log) {
  const std::string line = log.substr(0, log.find('\n'));
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

}  // namespace

SanitizedReplay replay_sanitized(Assignment assignment, const Submission& submission,
                                 const Home& home, const Case& asked) {
  Limits& limits = assignment.limits;
  limits.memory_mb = 0;  // the address sanitizer reserves terabytes
  limits.case_cpu_ms *= kSanitizersSlowDown;
  limits.case_wall_ms *= kSanitizersSlowDown;
  limits.compile_seconds *= kSanitizersSlowDown;
  const Build built = build_submission(submission, home, limits, BuildKind::kSanitized);
  set_up_sanitizers(built);
  SanitizedReplay replay{grade_case(assignment, submission, home, built, asked),
                         read_sanitizer_log(built)};
  CaseReport& judged = replay.report.exercises.at(0).cases.at(0);
  if (!replay.log.empty()) judged = with_sanitizer_finding(std::move(judged), replay.log);
  return replay;
}

void explain_first_crash(const Assignment& assignment, const Submission& submission,
                         const Home& home, const Progress& progress, Report& report) {
  CaseReport* crash = first_crash(report);
  if (crash == nullptr || crash->hidden) return;
  const StageTimer timer(home.times.get(), "run a crash under the sanitizers");
  progress(crash->id + " crashed: once more under the sanitizers");
  const Case asked = find_case(assignment, home.meshes, crash->id);
  try {
    const std::string log = replay_sanitized(assignment, submission, home, asked).log;
    if (log.empty()) return;
    Finding& finding = crash->findings[0].finding;
    finding.actual = "the program crashed: " + first_sentence(log);
  } catch (const GraderError&) {
    // This compiler has no sanitizers: the crash stays as it was told.
  }
}

}  // namespace meshgrade
