#include "grader/grade/source_hints.h"

#include <algorithm>
#include <functional>
#include <set>

#include "grader/base/pattern.h"
#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostShown = 80;  ///< characters of a variable

/// What comes from whole numbers only.
bool is_of_whole_numbers(const Misconception& m) {
  static const std::set<std::string> names{"integer-division", "integer-weight",
                                           "integer-three-sixteenths"};
  return names.count(m.name) != 0;
}

bool holds_any(const std::string& text, const std::vector<std::string>& functions) {
  return std::any_of(functions.begin(), functions.end(), [&](const std::string& function) {
    return text.find(function) != std::string::npos;
  });
}

void keep_one_kind(bool whole_numbers, Misconceptions& likely) {
  const auto fits = [&](const Misconception& m) {
    return is_of_whole_numbers(m) == whole_numbers;
  };
  if (std::none_of(likely.begin(), likely.end(), fits)) return;
  likely.erase(std::remove_if(likely.begin(), likely.end(), std::not_fn(fits)), likely.end());
}

int line_of(const std::string& text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(),
                                         text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// The place after the parenthesis that closes the one at `open`.
std::size_t after_parentheses(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && --depth == 0) return at + 1;
  }
  return text.size();
}

}  // namespace

// std::regex goes one call deeper with each repetition: none of these may repeat as often as a
// student's file has characters.

bool divides_whole_numbers(const std::string& source) {
  static const Pattern division(
      R"((^|[^\w.])\d{1,9}\s{0,9}/\s{0,9}(\d{1,9}(?![\w.])|\([^().]{0,80}\)|[A-Za-z_]))");
  return division.is_in(code_only(source));
}

std::string find_static_variable(const std::string& source) {
  static const Pattern variable(R"(^\s{0,80}static\s{1,9}(?!const|inline))");
  const std::vector<std::string> lines = split_lines(code_only(source));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t name_end = lines[i].find_first_of("=;()");
    const bool is_variable = name_end != std::string::npos &&
                             (lines[i][name_end] == '=' || lines[i][name_end] == ';');
    if (!is_variable || !variable.is_in(lines[i])) continue;
    const std::size_t begin = lines[i].find_first_not_of(" \t");
    const std::size_t size = std::min(lines[i].find(';') - begin, kMostShown);
    const std::string text = lines[i].substr(begin, size);
    return "line " + std::to_string(i + 1) + ": " + printable(text);
  }
  return {};
}

int find_free_function(const std::string& source, const std::string& name) {
  if (source.find(name) == std::string::npos) return 0;  // most files: much quicker than below
  const std::string text = code_only(source);
  const Pattern call("\\b" + name + "\\s{0,9}\\(");
  static const Pattern body(R"(^\s*(const\b\s*)?\{)");
  for (const auto& [at, size] : call.places_in(text)) {
    const std::size_t before = text.find_last_not_of(" \t\n", at == 0 ? 0 : at - 1);
    if (at == 0 || before == std::string::npos || text[before] == ':') continue;
    const std::size_t after = after_parentheses(text, at + size - 1);
    const std::string rest = text.substr(after, 40);
    if (body.is_in(rest)) return line_of(text, at);
  }
  return 0;
}

void tell_apart_by_source(const Submission& submission,
                          const std::vector<std::string>& functions, JudgedExercise& exercise) {
  bool divides = false;
  for (const SourceFile* file : own_files(submission)) {
    divides =
        divides || (holds_any(file->text, functions) && divides_whole_numbers(file->text));
  }
  for (JudgedCase& c : exercise.cases) {
    for (Finding& finding : c.judgement.findings)
      keep_one_kind(divides, finding.likely);
  }
}

void name_static_variable(const Submission& submission,
                          const std::vector<std::string>& functions, JudgedExercise& exercise) {
  for (const SourceFile* file : own_files(submission)) {
    if (!holds_any(file->text, functions)) continue;
    const std::string variable = find_static_variable(file->text);
    if (variable.empty()) continue;
    for (JudgedCase& c : exercise.cases) {
      if (c.judgement.passes_alone)
        c.judgement.note += ". Look at " + file->name + ", " + variable;
    }
    return;
  }
}

void name_free_function(const Submission& submission, const std::vector<std::string>& functions,
                        CaseJudgement& judgement) {
  if (judgement.verdict != Verdict::kNotImplemented &&
      judgement.verdict != Verdict::kNotCompiled) {
    return;
  }
  for (const std::string& function : functions) {
    if (judgement.note.find(function) == std::string::npos) continue;
    const std::string name = function.substr(function.rfind(':') + 1);
    for (const SourceFile* file : own_files(submission)) {
      if (file->text.find(function) != std::string::npos) continue;
      const int line = find_free_function(file->text, name);
      if (line == 0) continue;
      judgement.note = file->name + ", line " + std::to_string(line) + " defines a function " +
                       name + " that belongs to no class: write " + function +
                       ", with its class, as in the skeleton";
      return;
    }
  }
}

}  // namespace meshgrade
