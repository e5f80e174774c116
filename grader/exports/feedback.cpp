#include "grader/base/text.h"
#include "grader/exports/exports.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

/// On one line.
std::string escaped(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return html_text(text);
}

/// The first thing that is wrong, in a sentence.
std::string first_fault(const ExerciseReport& exercise) {
  const CaseReport* first = first_failure(exercise);
  if (first == nullptr) return {};
  if (first->findings.empty()) return first->note;
  const FindingReport& finding = first->findings[0];
  std::string text = finding.finding.meaning.empty() ? finding.finding.rule : "";
  if (text.empty()) text = "it must be that " + finding.finding.meaning;
  if (!finding.finding.actual.empty()) text += "; but: " + finding.finding.actual;
  if (!finding.places.empty() && !finding.places[0].file.empty()) {
    text += " (" + finding.places[0].file + ":" + std::to_string(finding.places[0].line) + ")";
  }
  return text;
}

std::string about(const ExerciseReport& exercise) {
  std::string text = "<br />" + escaped(exercise.title) + ": " + number_text(exercise.points) +
                     " of " + number_text(exercise.max_points);
  if (exercise.extra_points > 0.0) {
    text += " and " + number_text(exercise.extra_points) + " extra";
  }
  if (exercise.verdict == Verdict::kPassed) return text;
  text += std::string(", ") + verdict_name(exercise.verdict);
  const std::string fault = first_fault(exercise);
  return text + (fault.empty() ? "" : ": " + escaped(fault));
}

}  // namespace

std::string feedback_html(const ClassRow& row, const ClassResults& results,
                          const Report* report) {
  if (!row.has_points()) return {};
  std::string text =
      kFeedbackStart + number_text(row.points) + " of " + number_text(results.max_points);
  if (row.extra_points > 0.0) text += " and " + number_text(row.extra_points) + " extra";
  if (row.late) text += "<br />Late: " + escaped(late_text(row));
  if (report == nullptr) return text + "<br />Not graded: " + escaped(row.reason);
  for (const ExerciseReport& exercise : report->exercises)
    text += about(exercise);
  return text;
}

}  // namespace meshgrade
