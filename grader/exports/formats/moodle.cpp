// Moodle's grading worksheet ("offline grading worksheet" of an assignment). Moodle takes back
// only a worksheet with its own columns, in the language of the person who downloaded it, and
// passes over a grade that is above the maximum. So the downloaded file is filled in: every
// byte but those of the grades stays. The first column holds "Participant <id>" in some
// language.

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

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::size_t find_column(const CsvRecord& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].text == name) return i;
  }
  return kNone;
}

/// "4711" of "Participant 4711"; empty if it is something else.
std::string participant(const std::string& identifier) {
  static const Pattern form(".*?([0-9]+)");
  Pattern::Groups found;
  return form.matches(identifier, found) ? found[1] : std::string();
}

class WorksheetFilling {
 public:
  WorksheetFilling(const ClassResults& results, const ExportOptions& options)
      : results_(results), options_(options), sheet_(options.gradebook) {
    separator_ = csv_separator(sheet_);
    records_ = read_csv(sheet_, separator_);
    for (const ClassRow& row : results.rows) {
      for (const Person& person : row.people)
        people_[person.id] = &row;
    }
  }

  Exported run() {
    find_columns();
    std::size_t done = 0;
    for (std::size_t i = 1; i < records_.size(); ++i) {
      const CsvRecord& record = records_[i];
      if (record.size() <= grade_) continue;
      const std::string grade = grade_for(record);
      if (grade.empty()) continue;
      std::map<std::size_t, std::string> changes{{grade_, grade}};
      const std::string comment = comment_for(record);
      if (!comment.empty()) changes[comments_] = comment;
      for (const auto& [column, text] : changes) {
        exported_.text += sheet_.substr(done, record[column].begin - done);
        exported_.text += csv_field(text, separator_);
        done = record[column].end;
      }
    }
    exported_.text += sheet_.substr(done);
    note_exceptions(
        results_, [&](const ClassRow& row) { return used_.count(&row) != 0; }, "worksheet",
        exported_.notes);
    return std::move(exported_);
  }

 private:
  void find_columns() {
    if (records_.size() < 2 || records_[0].size() < 3 ||
        participant(records_[1][0].text).empty()) {
      throw UserError(
          "this is no grading worksheet of Moodle: its first column must hold participants; "
          "download it in the assignment under \"Download grading worksheet\"");
    }
    grade_ = find_column(records_[0], options_.column.empty() ? "Grade" : options_.column);
    if (grade_ == kNone) {
      std::vector<std::string> names;
      for (const CsvField& field : records_[0])
        names.push_back("\"" + printable(field.text) + "\"");
      throw UserError("the worksheet has no column \"" +
                      (options_.column.empty() ? "Grade" : printable(options_.column)) +
                      "\"; say with --column which one holds the grade, of " +
                      join(names, ", "));
    }
    find_comments();
    maximum_ = find_column(records_[0], "Maximum Grade");
    if (maximum_ == kNone && grade_ + 1 < records_[0].size()) maximum_ = grade_ + 1;
    for (const CsvRecord& record : records_) {
      for (const std::size_t column : {grade_, maximum_}) {
        const bool is_number =
            column < record.size() && !std::isnan(gradebook_number(record[column].text));
        comma_ = comma_ || (is_number && record[column].text.find(',') != std::string::npos);
      }
    }
  }

  void find_comments() {
    if (options_.feedback.empty()) return;
    const bool named = !options_.feedback_column.empty();
    const std::string name = named ? options_.feedback_column : "Feedback comments";
    comments_ = find_column(records_[0], name);
    if (comments_ != kNone && comments_ != grade_) return;
    throw UserError("the worksheet has no column \"" + printable(name) +
                    "\" for comments; switch on \"Feedback comments\" in the assignment's "
                    "settings before you download it" +
                    (named ? "" : ", or say with --feedback-column what it is called"));
  }

  /// The student's report in short; empty to leave the comment as it is.
  std::string comment_for(const CsvRecord& record) {
    if (comments_ >= record.size()) return {};
    const auto row = people_.find(participant(record[0].text));
    const auto found = options_.feedback.find(row->second->key);
    if (found == options_.feedback.end() || found->second.empty()) return {};
    const std::string& before = record[comments_].text;
    // One of ours, from an earlier upload, gives way.
    if (!before.empty() && before.find(kFeedbackStart) == std::string::npos) {
      exported_.notes.push_back(row->second->key +
                                " has a comment in Moodle already: it is left as it is");
      return {};
    }
    return found->second;
  }

  /// What to write into this record; empty to leave it as it is.
  std::string grade_for(const CsvRecord& record) {
    const auto found = people_.find(participant(record[0].text));
    if (found == people_.end()) return {};
    const ClassRow& row = *found->second;
    used_.insert(&row);
    if (!row.has_points()) return {};
    std::string points = points_to_enter(row, results_, options_);
    const double most =
        maximum_ < record.size() ? gradebook_number(record[maximum_].text) : std::nan("");
    if (std::stod(points) > most) {
      exported_.notes.push_back(row.key + " has " + points + " points, but the maximum in " +
                                "Moodle is " + number_text(most, 10) +
                                ": Moodle will pass over it; scale with --out-of " +
                                number_text(most, 10) + " or leave out extra credit");
    }
    const std::size_t point = points.find('.');
    if (comma_ && point != std::string::npos) points[point] = ',';
    return points;
  }

  const ClassResults& results_;
  const ExportOptions& options_;
  const std::string& sheet_;
  char separator_ = ',';
  std::vector<CsvRecord> records_;
  std::map<std::string, const ClassRow*> people_;
  std::set<const ClassRow*> used_;
  std::size_t grade_ = kNone;
  std::size_t maximum_ = kNone;
  std::size_t comments_ = kNone;
  bool comma_ = false;  ///< decimal comma
  Exported exported_;
};

}  // namespace

Exported write_moodle(const ClassResults& results, const ExportOptions& options) {
  if (options.gradebook.empty()) {
    throw UserError(
        "Moodle takes only its own worksheet: name the downloaded one with "
        "--gradebook worksheet.csv");
  }
  return WorksheetFilling(results, options).run();
}

}  // namespace meshgrade
