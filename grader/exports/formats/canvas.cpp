// Canvas's gradebook import. The first columns say who it is ("Student", or "LastName" and
// "FirstName" where an account shows names so; then "ID", maybe "SIS User ID", "SIS Login ID",
// ..., the last of them "Section"); assignments follow as "Title (id)". A score of "EX" is an
// excuse. An unknown title makes Canvas offer to create an assignment. An empty score changes
// nothing. From a downloaded gradebook, only the columns of the students and of this one
// assignment are written, so that no other grade can change.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "grader/base/csv.h"
#include "grader/base/errors.h"
#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"

namespace meshgrade {
namespace {

/// Rows by what a gradebook may know their people by.
class RowsOfPeople {
 public:
  explicit RowsOfPeople(const ClassResults& results) {
    for (const ClassRow& row : results.rows) {
      for (const Person& person : row.people) {
        people_.emplace(person.id, &row);
        if (!person.email.empty()) people_.emplace(person.email, &row);
      }
    }
  }

  const ClassRow* find(const std::string& id) {
    const auto found = people_.find(id);
    if (id.empty() || found == people_.end()) return nullptr;
    used_.insert(found->second);
    return found->second;
  }

  bool was_used(const ClassRow& row) const { return used_.count(&row) != 0; }

 private:
  std::map<std::string, const ClassRow*> people_;
  std::set<const ClassRow*> used_;
};

std::string text_at(const CsvRecord& record, std::size_t column) {
  return column < record.size() ? record[column].text : std::string();
}

/// Where a gradebook tells who it is.
struct WhoColumns {
  std::size_t id = 1;
  std::size_t section = 0;  ///< the last of them: what follows are assignments
};

WhoColumns find_who(const CsvRecord& header) {
  const auto holds = [&](std::size_t column, const char* name) {
    return column < header.size() && header[column].text.find(name) != std::string::npos;
  };
  const bool one_name = holds(0, "Student") && holds(1, "ID");
  const bool two_names = holds(0, "LastName") && holds(1, "FirstName") && holds(2, "ID");
  const std::size_t id = two_names ? 2 : 1;
  for (std::size_t i = id + 1; (one_name || two_names) && i < header.size(); ++i) {
    if (holds(i, "Section")) return {id, i};
  }
  throw UserError(
      "the gradebook is not one that Canvas exports: its first columns must be Student (or "
      "LastName, FirstName), ID, ..., Section; download it in Canvas under Grades, Export");
}

bool is_excused(std::string score) {
  score.erase(std::remove(score.begin(), score.end(), ' '), score.end());
  return score == "EX" || score == "ex" || score == "Ex";
}

bool is_called(const std::string& column, const std::string& name) {
  static const Pattern form("(.*) \\(([0-9]+)\\)");
  Pattern::Groups found;
  if (column == name) return true;
  return form.matches(column, found) && (found[1] == name || found[2] == name);
}

std::size_t find_assignment_column(const CsvRecord& header, std::size_t section,
                                   const std::string& name) {
  static const Pattern assignment(".* \\([0-9]+\\)");
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t i = section + 1; i < header.size(); ++i) {
    if (!assignment.matches(header[i].text)) continue;
    names.push_back("\"" + header[i].text + "\"");
    if (name.empty() || is_called(header[i].text, name)) found.push_back(i);
  }
  if (found.size() == 1) return found[0];
  throw UserError((found.empty() ? "the gradebook has no such assignment"
                                 : "the gradebook has several assignments") +
                  std::string(": choose one with --column, of ") +
                  printable(join(names, ", ")));
}

bool is_points_possible(const CsvRecord& record) {
  return text_at(record, 0).find("Points Possible") != std::string::npos;
}

/// Canvas writes rows that are no students: points possible, manual posting.
bool is_student(const CsvRecord& record, const WhoColumns& who) {
  return !text_at(record, who.id).empty() && !is_points_possible(record);
}

class GradebookFilling {
 public:
  GradebookFilling(const ClassResults& results, const ExportOptions& options)
      : results_(results), options_(options), rows_(results) {}

  Exported run() {
    const char separator = csv_separator(options_.gradebook);
    const std::vector<CsvRecord> records = read_csv(options_.gradebook, separator);
    if (records.empty()) throw UserError("the gradebook is empty");
    const WhoColumns who = find_who(records[0]);
    const std::size_t column = find_assignment_column(records[0], who.section, options_.column);
    for (std::size_t i = 0; i < records.size(); ++i) {
      std::vector<std::string> fields;
      for (std::size_t j = 0; j <= who.section; ++j)
        fields.push_back(csv_field(text_at(records[i], j), separator));
      const bool other = i == 0 || !is_student(records[i], who);
      if (is_points_possible(records[i])) note_scale(text_at(records[i], column));
      fields.push_back(csv_field(
          other ? text_at(records[i], column) : score(records[i], records[0], who, column),
          separator));
      exported_.text += csv_line(fields, separator);
    }
    note_exceptions(
        results_, [&](const ClassRow& row) { return rows_.was_used(row); }, "gradebook",
        exported_.notes);
    return std::move(exported_);
  }

 private:
  /// Canvas takes any points; nothing there says that full points are less than they should be.
  void note_scale(const std::string& possible) {
    const double there = gradebook_number(possible);
    const double here = full_points(results_, options_);
    if (std::isnan(there) || std::abs(there - here) < 1e-9) return;
    exported_.notes.push_back(
        "full points are " + number_text(here, 10) + " here, but " + number_text(there, 10) +
        " points are possible in Canvas" +
        (there > 0.0 ? "; scale with --out-of " + number_text(there, 10) : std::string()));
  }

  /// Canvas itself looks for the ID first, then for the ids of the school.
  std::string score(const CsvRecord& record, const CsvRecord& header, const WhoColumns& who,
                    std::size_t column) {
    const ClassRow* row = rows_.find(record[who.id].text);
    for (std::size_t j = who.id + 1; row == nullptr && j < who.section; ++j) {
      if (header[j].text.rfind("SIS", 0) == 0) row = rows_.find(text_at(record, j));
    }
    std::string before = text_at(record, column);
    if (is_excused(before)) {
      exported_.notes.push_back((row == nullptr ? text_at(record, who.id) : row->key) +
                                " is excused in Canvas (" + before + "): left as it is");
      return before;
    }
    return row == nullptr || !row->has_points() ? ""
                                                : points_to_enter(*row, results_, options_);
  }

  const ClassResults& results_;
  const ExportOptions& options_;
  RowsOfPeople rows_;
  Exported exported_;
};

/// A file of our own, where there is no gradebook to begin with.
Exported write_without_gradebook(const ClassResults& results, const ExportOptions& options) {
  Exported exported;
  const bool ids_are_of_canvas = results.layout == "canvas";
  const std::string column = options.column.empty() ? results.assignment : options.column;
  exported.text =
      csv_line({"Student", "ID", "SIS User ID", "SIS Login ID", "Section", csv_text(column)});
  for (const ClassRow& row : results.rows) {
    for (const Person& person : row.people) {
      const std::string id = csv_text(person.id);
      exported.text +=
          csv_line({csv_text(person.name.empty() ? person.id : person.name),
                    ids_are_of_canvas ? id : "", "", ids_are_of_canvas ? "" : id, "",
                    row.has_points() ? points_to_enter(row, results, options) : ""});
    }
  }
  exported.notes.push_back(
      "Canvas offers to create an assignment \"" + printable(column) +
      "\" unless there is one of this name; with --gradebook the right column is found");
  return exported;
}

}  // namespace

Exported write_canvas(const ClassResults& results, const ExportOptions& options) {
  if (options.gradebook.empty()) return write_without_gradebook(results, options);
  return GradebookFilling(results, options).run();
}

}  // namespace meshgrade
