#include "grader/grade/compile_warnings.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/base/text.h"
#include "grader/judge/findings.h"
#include "grader/submission/code_only.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostNotes = 4;

/// "flipEdge" of "HalfedgeMesh::flipEdge"
std::string last_part(const std::string& name) {
  const std::size_t colon = name.rfind("::");
  return colon == std::string::npos ? name : name.substr(colon + 2);
}

/// A warning with the function that it is about.
struct Located {
  CompilerWarning warning;
  std::string function;
};

/// The functions of a submission: which calls which, and which stands on a line. Told by names
/// alone, without what they belong to: a call names its object, and not the class of it.
class Functions {
 public:
  explicit Functions(const Submission& submission) {
    for (const SourceFile* file : own_files(submission))
      add(*file);
  }

  std::string at(const std::string& file, int line) const {
    const auto found = places_.find(file);
    if (found == places_.end()) return {};
    for (const Place& place : found->second) {
      if (place.first <= line && line <= place.last) return place.function;
    }
    return {};
  }

  /// The last parts of the names of a function and all that it calls, and so on.
  std::set<std::string> reached_from(const std::string& function) const {
    std::set<std::string> reached{last_part(function)};
    std::vector<std::string> waiting{last_part(function)};
    while (!waiting.empty()) {
      const auto found = calls_.find(waiting.back());
      waiting.pop_back();
      if (found == calls_.end()) continue;
      for (const std::string& called : found->second) {
        if (reached.insert(called).second) waiting.push_back(called);
      }
    }
    return reached;
  }

 private:
  struct Place {
    int first = 0;
    int last = 0;
    std::string function;
  };

  void add(const SourceFile& file) {
    const std::string code = code_only(file.text);
    const auto line_of = [&](std::size_t offset) {
      const auto end = code.begin() + static_cast<long>(std::min(offset, code.size()));
      return 1 + static_cast<int>(std::count(code.begin(), end, '\n'));
    };
    for (const FunctionExtent& function : find_functions(file.text)) {
      places_[file.name].push_back(
          {line_of(function.begin), line_of(function.end), function.name});
      add_calls(code.substr(function.body, function.end - function.body),
                calls_[last_part(function.name)]);
    }
  }

  /// Names in front of an opening parenthesis.
  static void add_calls(const std::string& body, std::set<std::string>& calls) {
    for (std::size_t open = body.find('('); open != std::string::npos;
         open = body.find('(', open + 1)) {
      std::size_t end = open;
      while (end > 0 && std::isspace(static_cast<unsigned char>(body[end - 1])) != 0)
        --end;
      std::size_t begin = end;
      while (begin > 0 && is_word_character(body[begin - 1]))
        --begin;
      if (begin < end) calls.insert(body.substr(begin, end - begin));
    }
  }

  std::map<std::string, std::vector<Place>> places_;
  std::map<std::string, std::set<std::string>> calls_;
};

std::vector<Located> locate(const Build& build, const Functions& functions) {
  std::vector<Located> located;
  for (const BuiltFile& file : build.files) {
    for (const CompilerWarning& warning : file.warnings) {
      const std::string function = functions.at(warning.file, warning.line);
      // A header's come once for each file that includes it.
      const bool known = std::any_of(located.begin(), located.end(), [&](const Located& other) {
        return other.warning.file == warning.file && other.warning.line == warning.line &&
               other.warning.text == warning.text;
      });
      if (!function.empty() && !known) located.push_back({warning, function});
    }
  }
  return located;
}

std::string place_of(const CompilerWarning& warning) {
  return warning.file + ":" + std::to_string(warning.line);
}

Finding missing_return(const Located& found) {
  Finding finding = make_finding(
      "missing-return", "a function that gives something back does so on every way through it",
      "", found.function, "a `return` on every way through " + found.function,
      "the compiler warns: " + found.warning.text + " (" + place_of(found.warning) + ")",
      "which `if` or loop can be passed without a `return` behind it? What comes out then, or "
      "which code runs, is left to chance");
  finding.stack.push_back({found.function, found.warning.file, found.warning.line});
  return finding;
}

bool failed(const CaseJudgement& judgement) {
  switch (judgement.verdict) {
    case Verdict::kPassed:
    case Verdict::kNotImplemented:
    case Verdict::kNotCompiled:
    case Verdict::kNotJudged:
    case Verdict::kGraderError:
      return false;
    default:
      return !judgement.excused;
  }
}

/// What the functions of a case may call.
std::set<std::string> reached_by(const Case& asked, const ExerciseJudge& judge,
                                 const Functions& functions) {
  if (judge.called_by != nullptr) return functions.reached_from(judge.called_by(asked));
  std::set<std::string> all;
  for (const std::string& function : judge.functions)
    all.merge(functions.reached_from(function));
  return all;
}

void add_to_case(const std::vector<Located>& warnings, const std::set<std::string>& reached,
                 CaseJudgement& judgement, std::vector<std::string>& notes) {
  std::vector<Finding> first;
  for (const Located& found : warnings) {
    if (reached.count(last_part(found.function)) == 0) continue;
    if (found.warning.option == "-Wreturn-type") {
      first.push_back(missing_return(found));
      continue;
    }
    const std::string note =
        "the compiler warns: " + place_of(found.warning) + ": " + found.warning.text;
    const bool known = std::find(notes.begin(), notes.end(), note) != notes.end();
    if (!known && notes.size() < kMostNotes) notes.push_back(note);
  }
  judgement.findings.insert(judgement.findings.begin(), first.begin(), first.end());
}

}  // namespace

void add_compiler_warnings(const Submission& submission, const Build& build,
                           const ExerciseJudge& judge, JudgedExercise& exercise) {
  const bool any = std::any_of(build.files.begin(), build.files.end(),
                               [](const BuiltFile& file) { return !file.warnings.empty(); });
  if (!any) return;
  const Functions functions(submission);
  const std::vector<Located> warnings = locate(build, functions);
  std::vector<std::string> notes;
  for (JudgedCase& c : exercise.cases) {
    if (!failed(c.judgement)) continue;
    add_to_case(warnings, reached_by(c.asked, judge, functions), c.judgement, notes);
  }
  exercise.notes.insert(exercise.notes.end(), notes.begin(), notes.end());
}

}  // namespace meshgrade
