// A page in Markdown (CommonMark with GitHub's tables). All text that a student may have chosen
// stands in a code block, where neither Markdown nor HTML nor @mentions mean anything, or is
// escaped.

#include <algorithm>

#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"
#include "grader/exports/graded_groups.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostComment = 8000;

/// Every character that means something is escaped; none of it is a link or a mention.
std::string escape_markdown(const std::string& text) {
  std::string escaped;
  for (char c : printable(text)) {
    if (c == '\n' || c == '\t') {
      escaped += ' ';
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '&') {
      escaped += "&amp;";
    } else if (c == '@') {
      escaped += "&#64;";
    } else if (c == ':') {
      escaped += "&#58;";  // of https:
    } else {
      if (std::string("\\`*_{}[]()#+-.!|~^$").find(c) != std::string::npos) escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

/// A code block whose fence is longer than any run of backticks in the text.
std::string code_block(const std::string& text) {
  std::size_t longest = 2;
  std::size_t run = 0;
  for (char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  const std::string body = cut_off(printable(text), kMostComment);
  return fence + "text\n" + body + (body.empty() || body.back() != '\n' ? "\n" : "") + fence +
         "\n";
}

std::string of(double points, double max_points) {
  return number_text(points) + " / " + number_text(max_points);
}

std::string table(const Report& report) {
  std::string text = "| exercise | verdict | points | extra credit |\n|---|---|---:|---:|\n";
  for (const ExerciseReport& e : report.exercises) {
    text += "| " + escape_markdown(e.title) + " | " + verdict_name(e.verdict) + " | " +
            of(e.points, e.max_points) + " | " +
            (e.max_extra_points > 0.0 ? of(e.extra_points, e.max_extra_points) : "") + " |\n";
  }
  return text + "| **total** | | **" + of(report.points, report.max_points) + "** | **" +
         of(report.extra_points, report.max_extra_points) + "** |\n";
}

}  // namespace

std::string write_markdown(const StudentResult& result, const ExportOptions& /*options*/) {
  if (result.report == nullptr) {
    return "# " + escape_markdown(result.key) + "\n\n**" + status_name(result.status) +
           "**\n\n" + code_block(result.reason);
  }
  const Report& report = *result.report;
  std::string text = "# " + escape_markdown(report.assignment) +
                     "\n\nSubmission: " + escape_markdown(report.submission) + "\n\n" +
                     table(report);
  const std::string general = general_text(report);
  if (!general.empty()) text += "\n" + code_block(general);
  for (const GradedGroup& graded : graded_groups(report)) {
    if (graded.failure == nullptr) continue;
    text += "\n## " + graded.number + " " + escape_markdown(graded.name) + "\n\n" +
            of(graded.group->points, graded.group->max_points) + " points\n\n" +
            code_block(graded.text);
  }
  return text;
}

}  // namespace meshgrade
