// A table for spreadsheets, by RFC 4180: one line for each person.

#include "grader/base/csv.h"
#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"

namespace meshgrade {
namespace {

std::vector<std::string> header(const ClassResults& results) {
  std::vector<std::string> fields{"id",           "name",         "email",           "hand_in",
                                  "submitted_at", "late",         "status",          "points",
                                  "max_points",   "extra_points", "max_extra_points"};
  for (const ExercisePoints& exercise : results.exercises) {
    fields.push_back(exercise.name);
    if (exercise.max_extra_points > 0.0) fields.push_back(exercise.name + "_extra");
    fields.push_back(exercise.name + "_verdict");
  }
  fields.insert(fields.end(), {"reason", "points_before_late", "late_deduction", "late_note"});
  return fields;
}

std::vector<std::string> line_of(const ClassResults& results, const ClassRow& row,
                                 const Person& person) {
  const auto number = [&](double value) {
    return row.has_points() ? number_text(value, 10) : std::string();
  };
  std::vector<std::string> fields{csv_text(person.id),
                                  csv_text(person.name),
                                  csv_text(person.email),
                                  csv_text(row.key),
                                  csv_text(row.submitted_at),
                                  row.late ? "yes" : "",
                                  status_name(row.status),
                                  number(row.points),
                                  number_text(results.max_points, 10),
                                  number(row.extra_points),
                                  number_text(results.max_extra_points, 10)};
  for (const ExercisePoints& exercise : row.exercises) {
    fields.push_back(number(exercise.points));
    if (exercise.max_extra_points > 0.0) fields.push_back(number(exercise.extra_points));
    fields.push_back(csv_text(exercise.verdict));
  }
  fields.push_back(csv_text(row.reason));
  fields.push_back(number(row.points_before_late()));
  fields.push_back(number(row.late_deduction));
  fields.push_back(csv_text(row.late_note));
  return fields;
}

}  // namespace

Exported write_csv(const ClassResults& results, const ExportOptions& /*options*/) {
  std::string text = csv_line(header(results));
  for (const ClassRow& row : results.rows) {
    for (const Person& person : row.people)
      text += csv_line(line_of(results, row, person));
  }
  return {text, {}};
}

}  // namespace meshgrade
