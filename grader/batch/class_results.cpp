#include "grader/batch/class_results.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/batch/lateness.h"

namespace meshgrade {

using PlainJson = nlohmann::json;

namespace {

constexpr const char* kClassSchema = "meshgrade-class/1";

ClassRow to_row(const HandIn& hand_in, const std::vector<ExercisePoints>& exercises,
                const ResultStore& store, const Lateness& lateness) {
  const Result result = store.load(hand_in.key);
  ClassRow row{hand_in.key,
               hand_in.people,
               hand_in.submitted_at,
               lateness.late,
               result.status,
               result.reason,
               0.0,
               0.0,
               exercises};
  for (ExercisePoints& exercise : row.exercises)
    exercise.title.clear();
  row.late_note = lateness.note;
  if (!result.report) return row;
  row.points = result.report->points;
  row.extra_points = result.report->extra_points;
  for (ExercisePoints& exercise : row.exercises) {
    for (const ExerciseReport& report : result.report->exercises) {
      if (report.name != exercise.name) continue;
      exercise.verdict = verdict_name(report.verdict);
      exercise.points = report.points;
      exercise.extra_points = report.extra_points;
    }
  }
  return row;
}

}  // namespace

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Person, id, name, email)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Omission, what, why)
// A class that was graded before there were titles can still be read.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ExercisePoints, name, verdict, points,
                                                max_points, extra_points, max_extra_points,
                                                title)
NLOHMANN_JSON_SERIALIZE_ENUM(ResultStatus, {{ResultStatus::kMissing, "not graded yet"},
                                            {ResultStatus::kGraded, "graded"},
                                            {ResultStatus::kUngradable, "ungradable"},
                                            {ResultStatus::kGraderError, "grader error"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClassRow, key, people, submitted_at, late, status, reason,
                                   points, extra_points, exercises, late_deduction, late_note)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClassResults, assignment, layout, max_points,
                                   max_extra_points, exercises, rows, left_out)

ClassResults collect_results(const Roster& roster, const Assignment& assignment,
                             const std::vector<std::string>& exercises,
                             const ResultStore& store, const std::optional<LateRule>& late) {
  ClassResults results;
  results.assignment = assignment.title;
  results.layout = roster.layout;
  results.left_out = roster.left_out;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    const bool wanted = exercises.empty() || std::find(exercises.begin(), exercises.end(),
                                                       rubric.name) != exercises.end();
    if (!wanted) continue;
    results.exercises.push_back(
        {rubric.name, "", 0.0, rubric.points(), 0.0, rubric.extra_points(), rubric.title});
    results.max_points += rubric.points();
    results.max_extra_points += rubric.extra_points();
  }
  for (const HandIn& hand_in : roster.hand_ins) {
    const Lateness lateness = lateness_of(hand_in, late);
    ClassRow row = to_row(hand_in, results.exercises, store, lateness);
    if (late) {
      row.late_deduction = late_deduction(*late, lateness.days, row.points, results.max_points);
      row.points -= row.late_deduction;
    }
    results.rows.push_back(std::move(row));
  }
  return results;
}

std::string late_text(const ClassRow& row) {
  if (row.late_note.empty()) return row.late ? "late by the platform" : "";
  if (row.late_deduction <= 0.0) return row.late_note;
  return number_text(row.points_before_late()) + " - " + number_text(row.late_deduction) +
         " = " + number_text(row.points) + " points: " + row.late_note;
}

std::string to_json(const ClassResults& results) {
  PlainJson value{{"schema", kClassSchema}};
  value.update(PlainJson(results));
  return value.dump(2, ' ', false, PlainJson::error_handler_t::replace) + "\n";
}

ClassResults read_class_results(const std::string& json) {
  try {
    PlainJson value = PlainJson::parse(json);
    if (value.at("schema") != kClassSchema) {
      throw UserError("it is of another form than " + std::string(kClassSchema));
    }
    for (PlainJson& row : value.at("rows")) {  // what earlier versions did not write
      if (row.is_object()) row.emplace("late_deduction", 0.0);
      if (row.is_object()) row.emplace("late_note", "");
    }
    return value.get<ClassResults>();
  } catch (const PlainJson::exception& error) {
    throw UserError(std::string("it cannot be read: ") + error.what());
  }
}

ClassResults load_class_results(const std::filesystem::path& batch_folder) {
  const std::filesystem::path file = batch_folder / kClassFile;
  if (!std::filesystem::exists(file)) {
    throw UserError(batch_folder.string() + ": there are no results of a class here; grade " +
                    "with `meshgrade batch SUBMISSIONS -o " + batch_folder.string() +
                    "` first");
  }
  try {
    return read_class_results(read_whole_file(file));
  } catch (const UserError& error) {
    throw UserError(file.string() + ": " + error.what());
  }
}

}  // namespace meshgrade
