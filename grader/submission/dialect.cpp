#include "grader/submission/dialect.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>

#include "grader/base/text.h"
#include "grader/submission/code_only.h"
#include "grader/submission/course_files.h"
#include "grader/submission/header_definitions.h"
#include "grader/submission/scotty3d_files.h"

namespace meshgrade {
namespace {

using Files = std::vector<SourceFile>;
using IsOfCourse = std::function<bool(const SourceFile&)>;

std::string all_code(const Files& files) {
  std::string code;
  for (const SourceFile& file : files)
    code += squeeze(code_only(file.text)) + "\n";
  return code;
}

bool has(const std::string& code, const char* part) {
  return code.find(part) != std::string::npos;
}

bool names_course_namespace(const std::string& code) {
  const std::string words = "namespace CGL";
  for (std::size_t at = code.find(words); at != std::string::npos;
       at = code.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if (end == code.size() || !is_word_character(code[end])) return true;
  }
  return false;
}

/// Whether evaluate1D takes its points as a copy.
bool takes_points_by_value(const std::string& code) {
  const std::string head = "BezierPatch::evaluate1D(";
  const std::size_t at = code.find(head);
  if (at == std::string::npos) return false;
  const std::size_t begin = at + head.size();
  return code.substr(begin, code.find(',', begin) - begin).find('&') == std::string::npos;
}

const char* describe(Dialect dialect) {
  switch (dialect) {
    case Dialect::kCourse2016:
      return "2016; its Bezier functions are of another form and are not graded here, the mesh "
             "functions are";
    case Dialect::kCourse2017:
      return "2017 to 2019";
    case Dialect::kCourse2020:
    case Dialect::kMeshedit:
    case Dialect::kScotty3d:
    case Dialect::kScotty3d2020:
      break;
  }
  return "2020 or later";
}

/// Moves the course's own files from `files` to the end of `taken`.
void take_course_files(Files& files, Files& taken, const IsOfCourse& is_of_course) {
  const auto first = std::stable_partition(
      files.begin(), files.end(), [&](const SourceFile& file) { return !is_of_course(file); });
  std::move(first, files.end(), std::back_inserter(taken));
  files.erase(first, files.end());
}

void note_left_out(Submission& submission, const Files& files, const std::string& why) {
  constexpr std::size_t kMostNamed = 4;
  if (files.empty()) return;
  std::vector<std::string> names;
  for (const SourceFile& file : files)
    names.push_back(file.name);
  if (names.size() > kMostNamed) {
    const std::size_t more = names.size() - (kMostNamed - 1);
    names.resize(kMostNamed - 1);
    names.push_back(std::to_string(more) + " more");
  }
  submission.notes.push_back(join(names, ", ") + (files.size() == 1 ? " is" : " are") +
                             " left out: " + why);
}

bool is_course_homework(const Files& files) {
  return names_course_namespace(all_code(files)) ||
         std::any_of(files.begin(), files.end(), [](const SourceFile& file) {
           return is_source_name(file.name) && includes(file.text, "student_code.h");
         });
}

/// The year that the student's own files are written for.
Dialect year_of(const Files& own) {
  const std::string code = all_code(own);
  if (has(code, "BezierPatch::preprocess(") || has(code, "BezierPatch::add2mesh(")) {
    return Dialect::kCourse2016;
  }
  const bool steps_on_levels =
      has(code, "BezierCurve::evaluateStep()") || has(code, "BezierCurve::evaluateStep(void)");
  return steps_on_levels || takes_points_by_value(code) ? Dialect::kCourse2017
                                                        : Dialect::kCourse2020;
}

Files files_of(const Submission& submission) {
  Files files = submission.sources;
  files.insert(files.end(), submission.headers.begin(), submission.headers.end());
  return files;
}

void take_all_course_files(Submission& submission, const IsOfCourse& is_of_course) {
  take_course_files(submission.sources, submission.course_sources, is_of_course);
  take_course_files(submission.headers, submission.course_headers, is_of_course);
}

void note_course_files(Submission& submission) {
  note_left_out(submission, submission.course_sources, "the course's own program");
  note_left_out(submission, submission.course_headers,
                "the grader has its own in place of the course's headers");
}

void settle_scotty3d(Submission& submission, Dialect years) {
  submission.dialect = years;
  take_all_course_files(
      submission, [&](const SourceFile& file) { return is_scotty3d_course_file(file, years); });
  submission.notes.emplace_back(
      years == Dialect::kScotty3d
          ? "recognised: homework for Carnegie Mellon's Scotty3D (Halfedge_Mesh), Fall 2022 or "
            "later"
          : "recognised: homework for Carnegie Mellon's Scotty3D (Halfedge_Mesh), Fall 2020 to "
            "Spring 2022, or Stanford's Cardinal3D; what these years did not ask for is not "
            "asked here");
  note_course_files(submission);
}

}  // namespace

void settle_dialect(Submission& submission) {
  submission.dialect = Dialect::kMeshedit;
  if (!is_course_homework(files_of(submission))) {
    if (const auto years = scotty3d_years_of(submission.sources))
      settle_scotty3d(submission, *years);
    return;
  }
  take_all_course_files(submission, is_course_file);
  const Files moved = sources_from_headers(submission.course_headers, files_of(submission));
  submission.sources.insert(submission.sources.end(), moved.begin(), moved.end());
  submission.dialect = year_of(files_of(submission));
  submission.notes.push_back(
      std::string("recognised: homework for Berkeley's skeleton (namespace CGL), ") +
      describe(submission.dialect));
  note_course_files(submission);
  for (const SourceFile& source : moved) {
    submission.notes.push_back("functions that are graded stand in " +
                               source.name.substr(0, source.name.rfind('.')) +
                               ": they are taken over as " + source.name + ", line by line");
  }
}

}  // namespace meshgrade
