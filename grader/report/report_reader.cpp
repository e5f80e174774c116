#include "grader/report/report_reader.h"

#include <nlohmann/json.hpp>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

using Json = nlohmann::json;

void read(const Json& value, std::string& text) {
  text = value.get<std::string>();
}

// read_list() below has to know them all.
void read(const Json& value, PointerCell& to);
void read(const Json& value, PointerRow& to);
void read(const Json& value, PointerTable& to);
void read(const Json& value, WrongPointer& to);
void read(const Json& value, Misconception& to);
void read(const Json& value, CodePlace& to);
void read(const Json& value, FindingReport& to);
void read(const Json& value, GroupReport& to);
void read(const Json& value, CaseReport& to);
void read(const Json& value, FileReport& to);
void read(const Json& value, ExerciseReport& to);

/// One value for each entry of the list under `key`.
template <class T>
std::vector<T> read_list(const Json& value, const char* key) {
  std::vector<T> list;
  for (const Json& entry : value.at(key))
    read(entry, list.emplace_back());
  return list;
}

void read(const Json& value, PointerCell& cell) {
  cell = {value.at("before"), value.at("yours"), value.at("expected"), value.at("wrong")};
}

void read(const Json& value, PointerRow& row) {
  row = {value.at("element"), value.at("role"), read_list<PointerCell>(value, "cells")};
}

void read(const Json& value, PointerTable& table) {
  table = {value.at("kind"), read_list<std::string>(value, "columns"),
           read_list<PointerRow>(value, "rows")};
}

void read(const Json& value, WrongPointer& pointer) {
  pointer = {value.at("pointer"), value.at("role"),    value.at("expected"),
             value.at("actual"),  value.at("was_set"), value.at("is_new")};
}

void read(const Json& value, PointerDiff& diff) {
  diff.corners = value.at("corners");
  diff.tables = read_list<PointerTable>(value, "tables");
  diff.wrong = read_list<WrongPointer>(value, "wrong");
  diff.missing = value.at("missing");
  diff.surplus = value.at("surplus");
}

void read(const Json& value, Misconception& misconception) {
  misconception = {value.at("name"), value.at("advice")};
}

void read(const Json& value, CodePlace& place) {
  place = {value.at("function"), value.at("file"), value.at("line"), value.at("code")};
}

void read(const Json& value, FindingReport& report) {
  Finding& finding = report.finding;
  finding.rule = value.at("rule");
  finding.meaning = value.at("meaning");
  finding.where = value.at("where");
  finding.element = value.at("element");
  finding.expected = value.at("expected");
  finding.actual = value.at("actual");
  finding.look_at = value.at("look_at");
  finding.likely = read_list<Misconception>(value, "likely");
  report.places = read_list<CodePlace>(value, "stack");
  if (value.contains("pointers")) read(value.at("pointers"), finding.pointers);
}

Verdict read_verdict(const Json& value) {
  const std::string name = value.at("verdict");
  const std::optional<Verdict> verdict = find_verdict(name);
  if (!verdict) throw UserError("the report has an unknown verdict: " + name);
  return *verdict;
}

void read(const Json& value, CaseReport& report) {
  report.id = value.at("id");
  report.group = value.at("group");
  report.title = value.at("title");
  report.figure = value.value("figure", "");
  report.verdict = read_verdict(value);
  report.note = value.at("note");
  report.excused = value.value("excused", false);
  report.passes_alone = value.value("passes_alone", false);
  report.hidden = value.value("hidden", false);
  report.shrunk_from = value.value("shrunk_from", "");
  report.output = value.at("output");
  report.output_bytes = value.at("output_bytes");
  report.findings = read_list<FindingReport>(value, "findings");
}

void read(const Json& value, GroupReport& group) {
  group = {value.at("name"),   value.at("title"),      value.at("extra_credit"),
           value.at("points"), value.at("max_points"), value.at("passed"),
           value.at("judged"), value.at("cases"),      value.value("why", "")};
}

/// The four sums of points that the report and each exercise have.
template <class T>
void read_points(const Json& value, T& sums) {
  sums.points = value.at("points");
  sums.max_points = value.at("max_points");
  sums.extra_points = value.at("extra_points");
  sums.max_extra_points = value.at("max_extra_points");
}

void read(const Json& value, ExerciseReport& report) {
  report.name = value.at("name");
  report.title = value.at("title");
  report.verdict = read_verdict(value);
  read_points(value, report);
  report.notes = read_list<std::string>(value, "notes");
  report.stand_ins = read_list<std::string>(value, "stand_ins");
  report.groups = read_list<GroupReport>(value, "groups");
  report.cases = read_list<CaseReport>(value, "cases");
}

void read(const Json& value, FileReport& file) {
  file = {value.at("name"), value.at("compiled"), value.at("messages")};
}

/// Only what a report says of it.
void read(const Json& value, Sandbox& sandbox) {
  const int layer = value.at("layer");
  if (layer < static_cast<int>(Layer::kNamespaces) || layer > static_cast<int>(Layer::kNone)) {
    throw UserError("the report names a sandbox that does not exist");
  }
  sandbox.layer = Layer{layer};
  sandbox.bounds_files = value.at("bounds_files");
  sandbox.filters_calls = value.at("filters_calls");
}

void read(const Json& value, Report& report) {
  const std::string schema = value.at("schema");
  if (schema != kReportSchema) throw UserError("the report is of another form: " + schema);
  report.assignment = value.at("assignment");
  report.submission = value.at("submission");
  report.seed = value.at("seed");
  const std::string show = value.value("hidden_show", "all");
  report.hidden_show = show == "all"    ? HiddenShow::kAll
                       : show == "rule" ? HiddenShow::kRule
                                        : HiddenShow::kName;
  read_points(value, report);
  read(value.at("sandbox"), report.sandbox);
  report.notes = read_list<std::string>(value, "notes");
  report.files = read_list<FileReport>(value, "files");
  report.exercises = read_list<ExerciseReport>(value, "exercises");
}

}  // namespace

Report read_report(const std::string& json) {
  Report report;
  try {
    read(Json::parse(json), report);
  } catch (const Json::exception& error) {
    throw UserError(std::string("the report cannot be read: ") + error.what());
  }
  return report;
}

}  // namespace meshgrade
