// results.json of PrairieLearn's external grading. `score` goes from 0 to 1. With `gradable`
// false no attempt is spent, and `format_errors` says why: right for what cannot be graded, and
// for a fault of the grader. If one test lacks points or max_points, none is shown. The file
// may have 1 MiB at most.

#include <nlohmann/json.hpp>

#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"
#include "grader/exports/graded_groups.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1U << 20U;

Json to_value(const Report& report, const ExportOptions& options, std::size_t most_output) {
  Json value{{"gradable", true},
             {"score", share_of_points(report, options.extra_credit)},
             {"message", report.assignment},
             {"output", cut_off(general_text(report), most_output)}};
  value["tests"] = Json::array();
  for (const GradedGroup& graded : graded_groups(report)) {
    value["tests"].push_back({{"name", graded.name},
                              {"points", graded.group->points},
                              {"max_points", graded.group->max_points},
                              {"output", cut_off(graded.text, most_output)}});
  }
  return value;
}

}  // namespace

std::string write_prairielearn(const StudentResult& result, const ExportOptions& options) {
  const auto dump = [](const Json& value) {
    return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  };
  if (result.report == nullptr) {
    return dump(
        {{"gradable", false},
         {"format_errors",
          {std::string(status_name(result.status)) + ": " + printable(result.reason)}}});
  }
  // Control characters and quotes take more room in JSON than their own.
  for (std::size_t most_output = 16'384;; most_output /= 2) {
    std::string text = dump(to_value(*result.report, options, most_output));
    if (text.size() <= kMostBytes || most_output < 64) return text;
  }
}

}  // namespace meshgrade
