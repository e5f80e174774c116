#include <nlohmann/json.hpp>

#include "grader/batch/class_summary.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

Json to_value(const std::vector<CommonFault>& faults) {
  Json list = Json::array();
  for (const CommonFault& fault : faults) {
    list.push_back({{"name", fault.name},
                    {"exercise", fault.exercise},
                    {"meaning", fault.meaning},
                    {"count", fault.keys.size()},
                    {"hand_ins", fault.keys}});
  }
  return list;
}

Json to_value(const std::vector<Remark>& remarks) {
  Json list = Json::array();
  for (const Remark& remark : remarks)
    list.push_back({{"key", remark.key}, {"why", remark.why}});
  return list;
}

Json to_value(const std::vector<ExerciseSummary>& exercises) {
  Json list = Json::array();
  for (const ExerciseSummary& exercise : exercises) {
    list.push_back({{"name", exercise.name},
                    {"max_points", exercise.max_points},
                    {"mean_points", exercise.mean_points},
                    {"full", exercise.full},
                    {"verdicts", exercise.verdicts}});
  }
  return list;
}

}  // namespace

std::string to_json(const ClassSummary& summary) {
  Json left_out = Json::array();
  for (const Omission& omission : summary.left_out)
    left_out.push_back({{"what", omission.what}, {"why", omission.why}});
  const Json value{{"schema", "meshgrade-summary/1"},
                   {"assignment", summary.assignment},
                   {"statuses", summary.statuses},
                   {"late", summary.late},
                   {"late_ones", to_value(summary.late_ones)},
                   {"without_time", summary.without_time},
                   {"max_points", summary.max_points},
                   {"mean", summary.mean},
                   {"median", summary.median},
                   {"lowest", summary.lowest},
                   {"highest", summary.highest},
                   {"distribution", summary.distribution},
                   {"exercises", to_value(summary.exercises)},
                   {"rules", to_value(summary.rules)},
                   {"misconceptions", to_value(summary.misconceptions)},
                   {"not_graded", to_value(summary.not_graded)},
                   {"undecided", to_value(summary.undecided)},
                   {"suspicious", to_value(summary.suspicious)},
                   {"left_out", left_out}};
  return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace meshgrade
