// GitHub Actions and GitHub Classroom.
//
// Annotations are commands that a step prints: "::error file=F,line=L,title=T::message", with
// %, CR and LF escaped, and : and , as well in the properties. GitHub shows ten of a kind for a
// step. Nothing that a student wrote stands at the beginning of a line.
//
// The `result` of a Classroom grader is base64 of {"version": 1, "status", "max_score",
// "tests":
// [{"name", "status", "score", "message", ...}]}. max_score is read as a whole number.

#include <cmath>
#include <nlohmann/json.hpp>

#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"
#include "grader/exports/graded_groups.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostAnnotations = 10;

std::string escape_command(const std::string& text, bool is_property) {
  std::string escaped;
  for (char c : printable(text)) {
    switch (c) {
      case '%':
        escaped += "%25";
        break;
      case '\r':
        escaped += "%0D";
        break;
      case '\n':
        escaped += "%0A";
        break;
      case ':':
        escaped += is_property ? "%3A" : ":";
        break;
      case ',':
        escaped += is_property ? "%2C" : ",";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string annotation(const std::string& kind, const CodePlace& place,
                       const std::string& title, const std::string& message) {
  std::string text = "::" + kind + " ";
  if (!place.file.empty()) {
    text += "file=" + escape_command(place.file, true) + ",";
    if (place.line > 0) text += "line=" + std::to_string(place.line) + ",";
  }
  return text + "title=" + escape_command(title, true) + "::" + escape_command(message, false) +
         "\n";
}

/// Where in the student's code the failure shows, if that is known.
CodePlace place_of(const CaseReport& failure) {
  for (const FindingReport& finding : failure.findings) {
    if (!finding.places.empty()) return finding.places[0];
  }
  return {};
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group =
          group << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j <= bytes.size() ? kDigits[group >> (18U - 6U * j) & 63U] : '=';
  }
  return text;
}

Json to_autograding_test(const GradedGroup& graded) {
  const CodePlace place = graded.failure == nullptr ? CodePlace() : place_of(*graded.failure);
  return {{"name", graded.number + " " + graded.name},
          {"status", graded.passed() ? "pass" : "fail"},
          {"score", graded.group->points},
          {"message", cut_off(graded.text, 4000)},
          {"test_code", ""},
          {"filename", place.file},
          {"line_no", place.line},
          {"duration", 0}};
}

}  // namespace

std::string write_github_annotations(const StudentResult& result,
                                     const ExportOptions& /*options*/) {
  if (result.report == nullptr) {
    return annotation("error", {}, status_name(result.status), result.reason);
  }
  std::string text;
  std::size_t errors = 0;
  for (const FileReport& file : result.report->files) {
    if (file.compiled || ++errors > kMostAnnotations) continue;
    text += annotation("error", {"", file.name, 0, ""}, file.name + " does not compile",
                       cut_off(file.messages, 4000));
  }
  for (const GradedGroup& graded : graded_groups(*result.report)) {
    if (graded.failure == nullptr || ++errors > kMostAnnotations) continue;
    text +=
        annotation("error", place_of(*graded.failure), graded.name, cut_off(graded.text, 4000));
  }
  return text + annotation("notice", {}, result.report->assignment,
                           number_text(result.report->points) + " of " +
                               number_text(result.report->max_points) + " points");
}

std::string write_github_result(const StudentResult& result, const ExportOptions& /*options*/) {
  Json value{{"version", 1}, {"status", "error"}, {"max_score", 0}};
  value["tests"] = Json::array();
  if (result.report == nullptr) {
    value["tests"].push_back({{"name", "grading"},
                              {"status", "error"},
                              {"score", 0},
                              {"message", std::string(status_name(result.status)) + ": " +
                                              printable(result.reason)}});
  } else {
    const Report& report = *result.report;
    value["status"] = report.points >= report.max_points ? "pass" : "fail";
    value["max_score"] = static_cast<std::int64_t>(std::ceil(report.max_points));
    for (const GradedGroup& graded : graded_groups(report))
      value["tests"].push_back(to_autograding_test(graded));
  }
  return base64(value.dump(-1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace meshgrade
