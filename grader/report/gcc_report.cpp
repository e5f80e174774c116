#include "grader/report/gcc_report.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include "grader/base/text.h"
#include "grader/judge/judge.h"
#include "grader/report/terminal_report.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Lines and columns count from 1.
struct Place {
  std::string file;
  std::size_t line = 1;
  std::size_t column = 1;
};

std::string on_one_line(std::string text) {
  text = printable(text);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Place place_at(const SourceFile& source, std::size_t offset) {
  const std::string before = source.text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;  // 0 if there is none
  const auto lines = std::count(before.begin(), before.end(), '\n');
  return {source.name, static_cast<std::size_t>(lines) + 1, offset - line_start + 1};
}

/// Of the text on that line, without the space before it.
Place place_on(const SourceFile& source, std::size_t line) {
  const std::vector<std::string> lines = split_lines(source.text);
  const std::size_t space =
      line <= lines.size() ? lines[line - 1].find_first_not_of(" \t") : std::string::npos;
  return {source.name, line, space == std::string::npos ? 1 : space + 1};
}

/// "evaluate1D" of "BezierPatch::evaluate1D".
std::string without_class(const std::string& function) {
  return function.substr(function.rfind(':') + 1);
}

bool is_word_in(const std::string& text, const std::string& word) {
  const auto is_part = [&](std::size_t at) {
    return at < text.size() && is_word_character(text[at]);
  };
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) {
    if ((at == 0 || !is_part(at - 1)) && !is_part(at + word.size())) return true;
  }
  return false;
}

class GccReport {
 public:
  GccReport(const Report& report, const Submission& submission, const Assignment& assignment)
      : report_(report), submission_(submission), assignment_(assignment) {}

  std::string render() {
    for (const FileReport& file : report_.files) {
      if (!file.compiled) add_messages(file);
    }
    for (const ExerciseReport& exercise : report_.exercises)
      add_exercise(exercise);
    out_ += on_one_line(report_.submission) + ": " + number_text(report_.points) + " of " +
            number_text(report_.max_points) + " points\n";
    return std::move(out_);
  }

 private:
  const SourceFile* find(const std::string& name) const {
    for (const auto* files : {&submission_.sources, &submission_.headers}) {
      for (const SourceFile& file : *files) {
        if (file.name == name) return &file;
      }
    }
    return nullptr;
  }

  std::string path_of(const std::string& name) const {
    std::error_code error;
    const fs::path path = (submission_.folder / name).lexically_normal();
    return printable(fs::exists(path, error) ? path.string() : name);
  }

  /// The compiler names files as they lie in its own folder.
  void add_messages(const FileReport& file) {
    for (std::string line : split_lines(file.messages)) {
      if (line.rfind("./", 0) == 0) line.erase(0, 2);
      const std::string name = line.substr(0, line.find(':'));
      if (find(name) != nullptr) line.replace(0, name.size(), path_of(name));
      out_ += line + "\n";
    }
  }

  std::optional<Place> place_of_function(const std::string& function) const {
    for (const SourceFile& source : submission_.sources) {
      for (const FunctionExtent& extent : find_functions(source.text)) {
        const std::size_t before = extent.name.size() - function.size();  // its namespace
        if (extent.name == function ||
            (extent.name.size() > function.size() &&
             extent.name.compare(before, std::string::npos, function) == 0 &&
             extent.name[before - 1] == ':'))
          return place_at(source, extent.begin);
      }
    }
    return {};
  }

  /// The exercise's functions, those that the case is about first.
  std::vector<std::string> functions_of(const ExerciseReport& exercise,
                                        const CaseReport& c) const {
    for (const ExerciseRubric& rubric : assignment_.exercises) {
      if (rubric.name != exercise.name) continue;
      std::vector<std::string> functions = find_exercise_judge(rubric).functions;
      const std::string about = c.title + " " + c.note + " " +
                                (c.findings.empty() ? "" : c.findings.front().finding.look_at);
      std::stable_partition(functions.begin(), functions.end(), [&](const std::string& name) {
        return is_word_in(about, without_class(name));
      });
      return functions;
    }
    return {};
  }

  std::optional<Place> place_of(const ExerciseReport& exercise, const CaseReport& c) const {
    if (!c.findings.empty() && !c.findings.front().places.empty()) {
      const CodePlace& inner = c.findings.front().places.front();
      const SourceFile* source = find(inner.file);
      if (source != nullptr && inner.line > 0)
        return place_on(*source, static_cast<std::size_t>(inner.line));
    }
    for (const std::string& function : functions_of(exercise, c)) {
      if (std::optional<Place> place = place_of_function(function)) return place;
    }
    return {};
  }

  void add_line(const std::optional<Place>& place, const std::string& kind,
                const std::string& text) {
    out_ += (place ? path_of(place->file) + ":" + std::to_string(place->line) + ":" +
                         std::to_string(place->column)
                   : "meshgrade") +
            ": " + kind + ": " + on_one_line(text) + "\n";
  }

  /// Files that do not compile have said so themselves.
  void add_exercise(const ExerciseReport& exercise) {
    const CaseReport* c = first_failure(exercise);
    if (c == nullptr || c->verdict == Verdict::kNotCompiled) return;
    const std::optional<Place> place = place_of(exercise, *c);
    const bool is_lost = exercise.points < exercise.max_points &&
                         c->verdict != Verdict::kNotImplemented &&
                         c->verdict != Verdict::kNotJudged;
    add_line(place, is_lost ? "error" : "warning", exercise.name + ": " + summary_of(*c));
    if (c->findings.empty()) return;
    const Finding& finding = c->findings.front().finding;
    for (const Misconception& m : finding.likely)
      add_line(place, "note", "probably " + m.advice);
    if (!finding.look_at.empty()) add_line(place, "note", "look at " + finding.look_at);
    add_line(place, "note", "the case is " + c->id + ": " + c->title);
  }

  /// "at h3.next, of ad: expected h3.next is h5 (dc), yours: h3.next is still h4 (bd) [rule]"
  static std::string summary_of(const CaseReport& c) {
    if (c.findings.empty()) return c.note.empty() ? verdict_name(c.verdict) : c.note;
    const Finding& finding = c.findings.front().finding;
    std::vector<std::string> parts;
    if (!finding.where.empty()) parts.push_back(finding.where);
    if (!finding.element.empty()) parts.push_back("at " + finding.element);
    if (!finding.expected.empty()) parts.push_back("expected: " + finding.expected);
    if (!finding.actual.empty()) parts.push_back("yours: " + finding.actual);
    if (parts.empty()) parts.emplace_back(verdict_name(c.verdict));
    return join(parts, "; ") + (finding.rule.empty() ? "" : " [" + finding.rule + "]");
  }

  const Report& report_;
  const Submission& submission_;
  const Assignment& assignment_;
  std::string out_;
};

}  // namespace

std::string to_gcc(const Report& report, const Submission& submission,
                   const Assignment& assignment) {
  return GccReport(report, submission, assignment).render();
}

}  // namespace meshgrade
