#include "grader/exports/exports.h"

#include <cmath>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"

namespace meshgrade {
namespace {

template <class Export>
const Export* find_by_name(const std::vector<Export>& all, const std::string& name) {
  for (const Export& known : all) {
    if (known.name == name) return &known;
  }
  return nullptr;
}

}  // namespace

const std::vector<ClassExport>& class_exports() {
  static const std::vector<ClassExport> all{
      {"csv", "a table with a line for each person", "grades.csv", false, write_csv},
      {"canvas", "a file to import in the gradebook of Canvas", "canvas.csv", true,
       write_canvas},
      {"moodle", "Moodle's grading worksheet, filled in", "moodle.csv", true, write_moodle},
  };
  return all;
}

const std::vector<StudentExport>& student_exports() {
  static const std::vector<StudentExport> all{
      {"gradescope", "results.json of a Gradescope autograder", "results.json",
       write_gradescope},
      {"autolab", "what an Autolab autograder prints", "autolab.txt", write_autolab},
      {"prairielearn", "results.json of a PrairieLearn grader", "results.json",
       write_prairielearn},
      {"github-annotations", "remarks for GitHub Actions, to be printed", "annotations.txt",
       write_github_annotations},
      {"github-result", "the `result` output of a GitHub Classroom grader", "result.txt",
       write_github_result},
      {"junit", "JUnit XML, for Jenkins, GitLab and CodeGrade", "junit.xml", write_junit},
      {"markdown", "a page in Markdown, also for $GITHUB_STEP_SUMMARY", "report.md",
       write_markdown},
  };
  return all;
}

const ClassExport* find_class_export(const std::string& name) {
  return find_by_name(class_exports(), name);
}

const StudentExport* find_student_export(const std::string& name) {
  return find_by_name(student_exports(), name);
}

std::vector<std::string> export_names() {
  std::vector<std::string> names;
  for (const ClassExport& known : class_exports())
    names.emplace_back(known.name);
  for (const StudentExport& known : student_exports())
    names.emplace_back(known.name);
  return names;
}

std::vector<std::string> gradebook_formats() {
  std::vector<std::string> names;
  for (const ClassExport& known : class_exports()) {
    if (known.for_gradebook) names.emplace_back(known.name);
  }
  return names;
}

double full_points(const ClassResults& results, const ExportOptions& options) {
  return options.out_of > 0.0 ? options.out_of : results.max_points;
}

double gradebook_number(std::string text) {
  static const Pattern form("[0-9]+([.,][0-9]+)?");
  if (!form.matches(text)) return std::nan("");
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos) text[comma] = '.';
  return std::stod(text);
}

void note_exceptions(const ClassResults& results,
                     const std::function<bool(const ClassRow&)>& was_found,
                     const std::string& in_words, std::vector<std::string>& notes) {
  for (const ClassRow& row : results.rows) {
    if (!was_found(row)) {
      notes.push_back(row.key + " is not in the " + in_words + ": no grade is written");
    } else if (!row.has_points()) {
      notes.push_back(row.key + " has no grade (" + status_name(row.status) +
                      "): none is written to the " + in_words);
    } else if (row.status == ResultStatus::kUngradable) {
      notes.push_back(row.key + " gets 0 points (ungradable: " + row.reason + ")");
    }
    if (row.late) notes.push_back(row.key + " is late: " + late_text(row));
  }
}

std::string points_to_enter(const ClassRow& row, const ClassResults& results,
                            const ExportOptions& options) {
  double points = row.points + (options.extra_credit ? row.extra_points : 0.0);
  if (results.max_points > 0.0) points *= full_points(results, options) / results.max_points;
  return number_text(std::round(points * 100.0) / 100.0, 10);
}

}  // namespace meshgrade
