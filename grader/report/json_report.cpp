#include "grader/report/json_report.h"

#include <cmath>

#include "grader/report/report_value.h"

namespace meshgrade {
namespace {

using Json = nlohmann::ordered_json;

Json to_value(const PointerTable& table) {
  Json value{{"kind", table.kind}, {"columns", table.columns}};
  value["rows"] = Json::array();
  for (const PointerRow& row : table.rows) {
    Json cells = Json::array();
    for (const PointerCell& cell : row.cells) {
      cells.push_back({{"before", cell.before},
                       {"yours", cell.yours},
                       {"expected", cell.expected},
                       {"wrong", cell.wrong}});
    }
    value["rows"].push_back(
        {{"element", row.element}, {"role", row.role}, {"cells", std::move(cells)}});
  }
  return value;
}

Json to_value(const PointerDiff& diff) {
  Json value{{"corners", diff.corners}, {"missing", diff.missing}, {"surplus", diff.surplus}};
  value["wrong"] = Json::array();
  for (const WrongPointer& pointer : diff.wrong) {
    value["wrong"].push_back({{"pointer", pointer.name},
                              {"role", pointer.role},
                              {"expected", pointer.expected},
                              {"actual", pointer.actual},
                              {"was_set", pointer.was_set},
                              {"is_new", pointer.is_new}});
  }
  value["tables"] = Json::array();
  for (const PointerTable& table : diff.tables)
    value["tables"].push_back(to_value(table));
  return value;
}

Json to_value(const FindingReport& report) {
  const Finding& finding = report.finding;
  Json value{{"rule", finding.rule},         {"meaning", finding.meaning},
             {"where", finding.where},       {"element", finding.element},
             {"expected", finding.expected}, {"actual", finding.actual},
             {"look_at", finding.look_at}};
  value["likely"] = Json::array();
  for (const Misconception& m : finding.likely) {
    value["likely"].push_back({{"name", m.name}, {"advice", m.advice}});
  }
  value["stack"] = Json::array();
  for (const CodePlace& place : report.places) {
    value["stack"].push_back({{"function", place.function},
                              {"file", place.file},
                              {"line", place.line},
                              {"code", place.code}});
  }
  if (!finding.pointers.tables.empty()) value["pointers"] = to_value(finding.pointers);
  return value;
}

Json to_value(const CaseReport& report) {
  Json value{{"id", report.id},
             {"group", report.group},
             {"title", report.title},
             {"verdict", verdict_name(report.verdict)},
             {"note", report.note},
             {"output", report.output},
             {"output_bytes", report.output_bytes}};
  if (!report.shrunk_from.empty()) value["shrunk_from"] = report.shrunk_from;
  if (report.excused) value["excused"] = true;
  if (report.passes_alone) value["passes_alone"] = true;
  if (report.hidden) value["hidden"] = true;
  if (!report.figure.empty()) value["figure"] = report.figure;
  value["findings"] = Json::array();
  for (const FindingReport& finding : report.findings) {
    value["findings"].push_back(to_value(finding));
  }
  return value;
}

Json to_value(const GroupReport& group) {
  Json value{{"name", group.name},
             {"title", group.title},
             {"extra_credit", group.extra_credit},
             {"points", group.points},
             {"max_points", group.max_points},
             {"passed", group.passed},
             {"judged", group.judged},
             {"cases", group.cases}};
  if (!group.why.empty()) value["why"] = group.why;
  return value;
}

Json to_value(const ExerciseReport& report) {
  Json value{{"name", report.name},
             {"title", report.title},
             {"verdict", verdict_name(report.verdict)},
             {"points", report.points},
             {"max_points", report.max_points},
             {"extra_points", report.extra_points},
             {"max_extra_points", report.max_extra_points},
             {"notes", report.notes},
             {"stand_ins", report.stand_ins}};
  value["groups"] = Json::array();
  for (const GroupReport& group : report.groups)
    value["groups"].push_back(to_value(group));
  value["cases"] = Json::array();
  for (const CaseReport& c : report.cases)
    value["cases"].push_back(to_value(c));
  return value;
}

Json to_value(const Sandbox& sandbox) {
  return {{"layer", static_cast<int>(sandbox.layer)},
          {"name", layer_name(sandbox.layer)},
          {"bounds_files", sandbox.bounds_files},
          {"filters_calls", sandbox.filters_calls}};
}

}  // namespace

Json to_json_value(const CaseReport& report) {
  return to_value(report);
}

Json to_json_value(const Report& report) {
  Json value{{"schema", kReportSchema},
             {"assignment", report.assignment},
             {"seed", report.seed},
             {"submission", report.submission},
             {"points", report.points},
             {"max_points", report.max_points},
             {"extra_points", report.extra_points},
             {"max_extra_points", report.max_extra_points},
             {"notes", report.notes},
             {"sandbox", to_value(report.sandbox)}};
  if (report.points_not_judged() > 0.0) value["points_not_judged"] = report.points_not_judged();
  if (report.hidden_show != HiddenShow::kAll) {
    value["hidden_show"] = report.hidden_show == HiddenShow::kRule ? "rule" : "name";
  }
  value["files"] = Json::array();
  for (const FileReport& file : report.files) {
    value["files"].push_back(
        {{"name", file.name}, {"compiled", file.compiled}, {"messages", file.messages}});
  }
  value["exercises"] = Json::array();
  for (const ExerciseReport& exercise : report.exercises) {
    value["exercises"].push_back(to_value(exercise));
  }
  for (const Stage& stage : report.timing) {
    value["timing"].push_back({{"stage", stage.name},
                               {"count", stage.count},
                               {"milliseconds", std::round(stage.milliseconds)}});
  }
  return value;
}

std::string to_json(const Report& report) {
  return to_json_value(report).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace meshgrade
