// Autolab reads the last line that is not blank: {"scores": {"<problem>": <number>}}. The names
// must be those of the site's problems: here the exercises, and "extra_credit". The line before
// is the semantic form of the feedback. Each of the two is one line; what comes before them is
// shown to the student as text, and is indented, so that none of it can pass for one of them.

#include <nlohmann/json.hpp>

#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"
#include "grader/exports/graded_groups.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFeedback = 20'000;

std::string indented(const std::string& text) {
  std::string all;
  for (const std::string& line : split_lines(text))
    all += "  " + line + "\n";
  return all;
}

std::string one_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json feedback(const std::vector<GradedGroup>& groups) {
  Json value{{"_presentation", "semantic"}, {"stages", Json::array()}};
  for (const GradedGroup& graded : groups) {
    const std::string& stage = graded.exercise->title;
    if (!value.contains(stage)) value["stages"].push_back(stage);
    Json entry{{"passed", graded.passed()}};
    if (graded.failure != nullptr) entry["hint"] = cut_off(graded.failure->title, 300);
    value[stage][graded.group->title] = std::move(entry);
  }
  return value;
}

}  // namespace

std::string write_autolab(const StudentResult& result, const ExportOptions& options) {
  if (result.report == nullptr) {
    // Without the last line Autolab gives no scores, which is right for a fault of the grader.
    const std::string text =
        indented(std::string(status_name(result.status)) + ": " + printable(result.reason));
    const bool is_zero = result.status == ResultStatus::kUngradable;
    return text + (is_zero ? one_line({{"scores", Json::object()}}) : "");
  }
  const Report& report = *result.report;
  const std::vector<GradedGroup> groups = graded_groups(report);
  std::string text = report.assignment + "\n" + indented(general_text(report));
  for (const GradedGroup& graded : groups) {
    text += graded.number + " " + graded.name + ": " + number_text(graded.group->points) +
            " of " + number_text(graded.group->max_points) + "\n" + indented(graded.text);
  }
  Json scores = Json::object();
  for (const ExerciseReport& exercise : report.exercises)
    scores[exercise.name] = exercise.points;
  if (options.extra_credit && report.max_extra_points > 0.0) {
    scores["extra_credit"] = report.extra_points;
  }
  return cut_off(text, kMostFeedback) + one_line(feedback(groups)) +
         one_line({{"scores", scores}});
}

}  // namespace meshgrade
