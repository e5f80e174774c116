// results.json of a Gradescope autograder (its "Autograder Specifications"). `score` stands for
// the whole; a test has score, max_score, status (passed, failed), name, number, output and
// visibility. One hidden test hides the total from the student, so hidden cases are part of
// their group's test and take no test of their own. Without a score, Gradescope reports an
// autograder that failed: just that is wanted for a fault of the grader.

#include <nlohmann/json.hpp>

#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"
#include "grader/exports/graded_groups.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostOutput = 20'000;

Json to_gradescope_test(const GradedGroup& graded) {
  return {{"number", graded.number},
          {"name", graded.name},
          {"name_format", "text"},
          {"score", graded.group->points},
          {"max_score", graded.group->extra_credit ? 0.0 : graded.group->max_points},
          {"status", graded.passed() ? "passed" : "failed"},
          {"output", cut_off(graded.text, kMostOutput)},
          {"output_format", "text"},
          {"visibility", "visible"},
          {"tags", {graded.exercise->name, graded.group->name}}};
}

}  // namespace

std::string write_gradescope(const StudentResult& result, const ExportOptions& options) {
  Json value;
  if (result.report != nullptr) {
    const Report& report = *result.report;
    value["score"] = report.points + (options.extra_credit ? report.extra_points : 0.0);
    value["output"] = cut_off(report.assignment + "\n" + general_text(report), kMostOutput);
    value["tests"] = Json::array();
    for (const GradedGroup& graded : graded_groups(report))
      value["tests"].push_back(to_gradescope_test(graded));
    value["extra_data"] = {{"schema", kReportSchema}, {"seed", report.seed}};
  } else {
    if (result.status == ResultStatus::kUngradable) value["score"] = 0.0;
    value["output"] =
        std::string(status_name(result.status)) + ": " + printable(result.reason) + "\n";
    value["tests"] = Json::array();
  }
  value["output_format"] = "text";
  value["visibility"] = "visible";
  value["stdout_visibility"] = "hidden";
  return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace meshgrade
