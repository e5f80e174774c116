#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grader/batch/class_results.h"

namespace meshgrade {

/// What the person at the keyboard says about an export.
struct ExportOptions {
  std::string gradebook;     ///< the bytes of the file downloaded from the platform; or empty
  std::string column;        ///< the assignment's name in the gradebook; or empty
  bool extra_credit = true;  ///< add the extra credit to the points
  double out_of = 0.0;       ///< what full points are worth there; 0: the same as here
  std::string time;          ///< "2026-01-31T12:00:00", for formats that need one
  /// What to tell each hand-in, by its key, where the gradebook has room for it; HTML.
  std::map<std::string, std::string> feedback = {};
  std::string feedback_column = {};  ///< where; empty: as it is called in English
};

/// A file for a gradebook, and what to know before it is uploaded.
struct Exported {
  std::string text;
  std::vector<std::string> notes;
};

/// A form in which the grades of a whole class are written to one file.
struct ClassExport {
  const char* name;    ///< "canvas"
  const char* title;   ///< for --help
  const char* file;    ///< the usual name of the file
  bool for_gradebook;  ///< heeds a gradebook, a column and what full points are worth
  /// @throws UserError if the gradebook is of another form
  Exported (*write)(const ClassResults& results, const ExportOptions& options);
};

/// What is said to one student, or to a program about them.
struct StudentResult {
  std::string key;
  ResultStatus status = ResultStatus::kMissing;
  std::string reason;              ///< why there is no report
  const Report* report = nullptr;  ///< as the student may see it; if it is graded
};

/// A form in which the result of one submission is written.
struct StudentExport {
  const char* name;   ///< "gradescope"
  const char* title;  ///< for --help
  const char* file;   ///< the usual name of the file: "results.json"
  std::string (*write)(const StudentResult& result, const ExportOptions& options);
};

const std::vector<ClassExport>& class_exports();
const std::vector<StudentExport>& student_exports();

/// The export of this name, or nullptr.
const ClassExport* find_class_export(const std::string& name);
const StudentExport* find_student_export(const std::string& name);

/// Their names, for messages.
std::vector<std::string> export_names();
/// Those for gradebooks only.
std::vector<std::string> gradebook_formats();

/// What full points without extra credit are worth in the gradebook.
double full_points(const ClassResults& results, const ExportOptions& options);

/// The points to enter for a row; "87.5".
std::string points_to_enter(const ClassRow& row, const ClassResults& results,
                            const ExportOptions& options);

/// A student's report in short, as HTML without line ends: points of each exercise, and what is
/// wrong first. It begins with kFeedbackStart.
std::string feedback_html(const ClassRow& row, const ClassResults& results,
                          const Report* report);
constexpr const char* kFeedbackStart = "Points: ";

/// Notes whose grade is not written, since the gradebook does not know them or they have none,
/// and who has 0 points for what is ungradable. `in_words` is what the file is called:
/// "gradebook".
void note_exceptions(const ClassResults& results,
                     const std::function<bool(const ClassRow&)>& was_found,
                     const std::string& in_words, std::vector<std::string>& notes);

}  // namespace meshgrade
