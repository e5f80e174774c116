#include "grader/submission/dialect.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <string_view>

#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

/// The course's own files, by their names without ending.
const std::set<std::string>& course_files() {
  static const std::set<std::string> names{
      "bez",           "bezierCurve", "bezierPatch",          "halfEdgeMesh", "main",
      "mergeVertices", "meshEdit",    "mutablePriorityQueue", "png",          "shaderUtils"};
  return names;
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text without space, but for one between two words.
std::string squeeze(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_space(text[i])) continue;
    const bool after_space = i > 0 && is_space(text[i - 1]);
    if (after_space && !result.empty() && is_word(result.back()) && is_word(text[i])) {
      result += ' ';
    }
    result += text[i];
  }
  return result;
}

std::string all_code(const Submission& submission) {
  std::string code;
  for (const auto* files : {&submission.sources, &submission.headers}) {
    for (const SourceFile& file : *files)
      code += squeeze(code_only(file.text)) + "\n";
  }
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
    if (end == code.size() || !is_word(code[end])) return true;
  }
  return false;
}

bool includes_student_code(const SourceFile& file) {
  const std::vector<std::string> lines = split_lines(file.text);
  return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    const std::string words = squeeze(line);
    return words.rfind("#include\"student_code.h\"", 0) == 0 ||
           words.rfind("#include<student_code.h>", 0) == 0;
  });
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
      break;
  }
  return "2020 or later";
}

/// Moves the course's own files from `files` to `taken`.
void take_course_files(std::vector<SourceFile>& files, std::vector<SourceFile>& taken) {
  const auto is_own = [](const SourceFile& file) {
    return course_files().count(file.name.substr(0, file.name.rfind('.'))) == 0;
  };
  const auto first = std::stable_partition(files.begin(), files.end(), is_own);
  taken.assign(std::make_move_iterator(first), std::make_move_iterator(files.end()));
  files.erase(first, files.end());
}

void note_left_out(Submission& submission, const std::vector<SourceFile>& files,
                   const std::string& why) {
  if (files.empty()) return;
  std::vector<std::string> names;
  for (const SourceFile& file : files)
    names.push_back(file.name);
  submission.notes.push_back(join(names, ", ") + (names.size() == 1 ? " is" : " are") +
                             " left out: " + why);
}

}  // namespace

Dialect recognise(const Submission& submission) {
  const std::string code = all_code(submission);
  const auto& sources = submission.sources;
  if (!names_course_namespace(code) &&
      std::none_of(sources.begin(), sources.end(), includes_student_code)) {
    return Dialect::kMeshedit;
  }
  if (has(code, "BezierPatch::preprocess(") || has(code, "BezierPatch::add2mesh(")) {
    return Dialect::kCourse2016;
  }
  const bool steps_on_levels =
      has(code, "BezierCurve::evaluateStep()") || has(code, "BezierCurve::evaluateStep(void)");
  return steps_on_levels || takes_points_by_value(code) ? Dialect::kCourse2017
                                                        : Dialect::kCourse2020;
}

void settle_dialect(Submission& submission) {
  submission.dialect = recognise(submission);
  if (submission.dialect == Dialect::kMeshedit) return;
  submission.notes.push_back(
      std::string("recognised: homework for Berkeley's skeleton (namespace CGL), ") +
      describe(submission.dialect));
  std::vector<SourceFile> programs;
  take_course_files(submission.sources, programs);
  take_course_files(submission.headers, submission.course_headers);
  note_left_out(submission, programs, "the course's own program");
  note_left_out(submission, submission.course_headers,
                "the grader has its own in place of the course's headers");
}

}  // namespace meshgrade
