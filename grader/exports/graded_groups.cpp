#include "grader/exports/graded_groups.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

const CaseReport* first_failure_of(const ExerciseReport& exercise, const GroupReport& group) {
  for (const CaseReport& c : exercise.cases) {
    if (c.group == group.name && c.verdict != Verdict::kPassed && !c.excused) return &c;
  }
  return nullptr;
}

std::string describe(const ExerciseReport& exercise, const GroupReport& group,
                     const CaseReport* failure) {
  std::string text =
      std::to_string(group.passed) + " of " + plural(group.judged, "case") + " passed\n";
  if (failure == nullptr) return text;
  for (const std::string& note : exercise.notes)
    text += "note: " + note + "\n";
  return text + explain_case(exercise, *failure);
}

}  // namespace

std::string explain_case(const ExerciseReport& exercise, const CaseReport& c) {
  Report page;
  ExerciseReport& only = page.exercises.emplace_back();
  only.name = exercise.name;
  only.title = exercise.title;
  only.cases = {c};
  return cases_to_terminal(page, {});
}

std::vector<GradedGroup> graded_groups(const Report& report) {
  std::vector<GradedGroup> all;
  for (std::size_t i = 0; i < report.exercises.size(); ++i) {
    const ExerciseReport& exercise = report.exercises[i];
    for (std::size_t j = 0; j < exercise.groups.size(); ++j) {
      const GroupReport& group = exercise.groups[j];
      GradedGroup graded;
      graded.exercise = &exercise;
      graded.group = &group;
      graded.failure = first_failure_of(exercise, group);
      graded.number = std::to_string(i + 1) + "." + std::to_string(j + 1);
      graded.name =
          exercise.title + ": " + group.title + (group.extra_credit ? " (extra credit)" : "");
      graded.text = describe(exercise, group, graded.failure);
      all.push_back(std::move(graded));
    }
  }
  return all;
}

std::string general_text(const Report& report) {
  std::string text;
  for (const std::string& note : report.notes)
    text += "note: " + printable(note) + "\n";
  for (const FileReport& file : report.files) {
    if (file.compiled) continue;
    text += file.name + " does not compile:\n" + printable(file.messages) + "\n";
  }
  return text;
}

double share_of_points(const Report& report, bool extra_credit) {
  if (report.max_points <= 0.0) return 0.0;
  const double points = report.points + (extra_credit ? report.extra_points : 0.0);
  return std::clamp(points / report.max_points, 0.0, 1.0);
}

std::string cut_off(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;
  return text.substr(0, end) + "\n... (cut off)\n";
}

}  // namespace meshgrade
