#include "grader/report/terminal_report.h"

#include <algorithm>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostMessageLines = 12;

std::string pad(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string pad_left(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string points_text(double points, double max_points) {
  return number_text(points) + " / " + number_text(max_points);
}

bool is_failure(const CaseReport& c) {
  return c.verdict != Verdict::kPassed;
}

class TerminalReport {
 public:
  TerminalReport(const Report& report, const TerminalStyle& style)
      : report_(report), style_(style) {}

  std::string render() {
    out_ = paint("1", report_.assignment) + "\nsubmission: " + report_.submission + "\n";
    for (const std::string& note : report_.notes)
      out_ += "note: " + note + "\n";
    if (style_.verbose) {
      out_ += "sandbox: " + layer_name(report_.sandbox.layer) + "; " +
              layer_promise(report_.sandbox.layer) + "\n";
    }
    out_ += "\n";
    add_table();
    for (const FileReport& file : report_.files)
      add_file(file);
    for (const ExerciseReport& exercise : report_.exercises)
      add_exercise(exercise);
    return std::move(out_);
  }

  std::string render_cases() {
    for (const FileReport& file : report_.files)
      add_file(file);
    for (const ExerciseReport& exercise : report_.exercises) {
      for (const CaseReport& c : exercise.cases)
        add_case(c);
    }
    return std::move(out_);
  }

 private:
  std::string paint(const std::string& code, const std::string& text) const {
    return style_.color ? "\033[" + code + "m" + text + "\033[0m" : text;
  }

  std::string paint_verdict(Verdict verdict, std::size_t width) const {
    const char* code = verdict == Verdict::kPassed ? "32"
                       : verdict == Verdict::kNotImplemented || verdict == Verdict::kNotJudged
                           ? "33"
                           : "31";
    return paint(code, pad(verdict_name(verdict), width));
  }

  static std::string extra_text(double points, double max_points) {
    return max_points > 0.0 ? "   extra " + points_text(points, max_points) : "";
  }

  void add_table() {
    for (const ExerciseReport& e : report_.exercises) {
      out_ += "  " + pad(e.name, 20) + paint_verdict(e.verdict, 18) +
              pad_left(points_text(e.points, e.max_points), 12) +
              extra_text(e.extra_points, e.max_extra_points) + "\n";
    }
    out_ += "  " + pad("total", 38) +
            paint("1", pad_left(points_text(report_.points, report_.max_points), 12)) +
            extra_text(report_.extra_points, report_.max_extra_points) + "\n";
    add_not_judged();
  }

  void add_not_judged() {
    if (report_.points_not_judged() <= 0.0) return;
    std::vector<std::string> names;
    for (const ExerciseReport& e : report_.exercises) {
      if (e.verdict == Verdict::kNotJudged) names.push_back(e.name);
    }
    out_ += "  " +
            paint("33", number_text(report_.points_not_judged()) +
                            " of the missing points were not judged (" + join(names, ", ") +
                            "): the notes say why, and a person has to decide") +
            "\n";
  }

  void add_file(const FileReport& file) {
    if (file.compiled) return;
    out_ += "\n" + paint("1", file.name) +
            (file.linked ? " does not compile:\n" : " does not link:\n");
    const std::vector<std::string> lines = split_lines(file.messages);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i == kMostMessageLines && !style_.verbose) {
        out_ += "    ... " + plural(lines.size() - i, "more line") + "; " +
                style_.all_shown_by + "\n";
        break;
      }
      out_ += "    " + lines[i] + "\n";
    }
  }

  void add_exercise(const ExerciseReport& exercise) {
    const bool lost = exercise.points < exercise.max_points ||
                      exercise.extra_points < exercise.max_extra_points ||
                      exercise.verdict != Verdict::kPassed;
    if (!lost && exercise.stand_ins.empty() && !style_.verbose) return;
    out_ += "\n" + paint("1", exercise.name) + ": " + paint_verdict(exercise.verdict, 0) +
            ", " + number_text(exercise.points) + " of " + number_text(exercise.max_points) +
            " points" + extra_text(exercise.extra_points, exercise.max_extra_points) + "\n";
    for (const GroupReport& group : exercise.groups)
      add_group(group);
    for (const std::string& note : exercise.notes)
      out_ += "  note: " + note + "\n";
    if (style_.verbose) {
      for (const CaseReport& c : exercise.cases)
        add_case(c);
    } else {
      add_first_failure(exercise);
    }
  }

  void add_group(const GroupReport& group) {
    out_ += "    " + pad(group.name, 16) +
            pad_left(points_text(group.points, group.max_points), 8) +
            (group.extra_credit ? "  extra, " : "  ") + group.title + ": " +
            std::to_string(group.passed) + " of " + plural(group.cases, "case") + " passed";
    if (group.judged < group.cases) {
      out_ += ", " + std::to_string(group.cases - group.judged) + " not judged";
    }
    if (!group.why.empty()) out_ += "; " + group.why;
    out_ += "\n";
  }

  void add_first_failure(const ExerciseReport& exercise) {
    const CaseReport* first = first_failure(exercise);
    if (first == nullptr) return;
    if (first->verdict == Verdict::kNotImplemented && first->findings.empty()) {
      out_ += "  " + first->note + "\n";
      return;
    }
    const auto count = std::count_if(exercise.cases.begin(), exercise.cases.end(), is_failure);
    // Whoever has not done the extra credit has done nothing wrong.
    out_ +=
        exercise.verdict == Verdict::kPassed
            ? "  all that is asked is right; for extra credit, the first case that does not "
              "pass, of " +
                  std::to_string(count) + ":\n"
            : "  the first failure, of " + std::to_string(count) + ":\n";
    add_case(*first);
  }

  void add_case(const CaseReport& c) {
    out_ +=
        "  " + paint("36", c.id) + ": " + c.title + ": " + paint_verdict(c.verdict, 0) + "\n";
    if (!c.shrunk_from.empty()) add_field("", "made smaller from: " + c.shrunk_from);
    const std::size_t shown = style_.verbose ? c.findings.size() : 1;
    for (std::size_t i = 0; i < std::min(shown, c.findings.size()); ++i) {
      add_finding(c.findings[i]);
    }
    if (shown < c.findings.size()) {
      out_ += "    " + pad("and", 10) + plural(c.findings.size() - shown, "more finding") +
              " in this case; " + style_.all_shown_by + "\n";
    }
    add_field("note", c.note);
    if (!c.figure.empty()) add_field("picture", style_.figures + "/" + c.figure);
    if (!c.output.empty() && (style_.verbose || is_failure(c))) add_output(c);
    // A case that passes alone would only puzzle who replays it.
    if (style_.again && is_failure(c) && !c.passes_alone)
      add_field("again", style_.again(c.id));
  }

  void add_field(const std::string& name, const std::string& text) {
    if (!text.empty()) out_ += "    " + paint("2", pad(name, 10)) + text + "\n";
  }

  void add_finding(const FindingReport& report) {
    const Finding& f = report.finding;
    add_field("", f.where);
    add_field("rule", paint("1", f.rule) + (f.meaning.empty() ? "" : ": " + f.meaning));
    add_field("at", f.element);
    add_field("expected", f.expected);
    add_field("yours", f.actual);
    for (const Misconception& m : f.likely) {
      add_field(&m == f.likely.data() ? "probably" : "or", m.advice);
    }
    add_field("look at", f.look_at);
    add_places(report.places);
    add_pointers(f.pointers);
  }

  /// The call stack. What calls itself is shown once.
  void add_places(const std::vector<CodePlace>& places) {
    for (std::size_t i = 0, same = 1; i < places.size(); i += same) {
      const CodePlace& place = places[i];
      same = 1;
      while (i + same < places.size() && is_same(places[i + same], place))
        ++same;
      add_field(i == 0 ? "in" : "called by",
                place.file + ":" + std::to_string(place.line) + ", " + place.function +
                    (same > 1 ? ", which calls itself again and again" : ""));
      add_field("", place.code.empty() ? "" : "  | " + place.code);
    }
  }

  static bool is_same(const CodePlace& a, const CodePlace& b) {
    return a.file == b.file && a.line == b.line && a.function == b.function;
  }

  void add_pointers(const PointerDiff& diff) {
    if (diff.tables.empty()) return;
    add_field("names", diff.corners);
    std::vector<std::string> wrong;
    std::vector<std::string> not_set;
    for (const WrongPointer& pointer : diff.wrong) {
      (pointer.was_set ? wrong : not_set)
          .push_back(pad(pointer.name, 15) + " " + must_be_text(pointer));
    }
    add_list("set, but wrong:", wrong);
    add_list("not changed, but must be:", not_set);
    for (const PointerTable& table : diff.tables)
      add_pointer_table(table);
  }

  void add_list(const std::string& title, const std::vector<std::string>& lines) {
    if (lines.empty()) return;
    out_ += "\n    " + paint("1", title) + "\n";
    for (const std::string& line : lines)
      out_ += "      " + line + "\n";
  }

  /// A table of before, yours and expected, one line for each pointer. Rows without a mistake
  /// are left out unless all is asked for.
  void add_pointer_table(const PointerTable& table) {
    std::string lines;
    for (const PointerRow& row : table.rows) {
      for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const PointerCell& cell = row.cells[i];
        const bool row_wrong = std::any_of(row.cells.begin(), row.cells.end(),
                                           [](const PointerCell& c) { return c.wrong; });
        if (!row_wrong && !style_.verbose) continue;
        const std::string name = (row.element.empty() ? "-" : row.element) +
                                 (row.role.empty() ? "" : " (" + row.role + ")");
        lines += (cell.wrong ? "    > " : "      ") + pad(i == 0 ? name : "", 14) +
                 pad(table.columns[i], 10) + pad(cell.before, 12) +
                 (cell.wrong ? paint("31", pad(cell.yours, 14)) : pad(cell.yours, 14)) +
                 cell.expected + "\n";
      }
    }
    if (lines.empty()) return;
    out_ += "\n      " +
            paint("2", pad(table.kind, 14) + pad("pointer", 10) + pad("before", 12) +
                           pad("yours", 14) + "expected") +
            "\n" + lines;
  }

  void add_output(const CaseReport& c) {
    add_field("printed", plural(c.output_bytes, "byte") +
                             (c.output_bytes > c.output.size() ? ", cut off here:" : ":"));
    std::size_t shown = 0;
    for (const std::string& line : split_lines(c.output)) {
      if (++shown > kMostMessageLines && !style_.verbose) break;
      out_ += "      > " + line + "\n";
    }
  }

  const Report& report_;
  const TerminalStyle& style_;
  std::string out_;
};

}  // namespace

std::string to_terminal(const Report& report, const TerminalStyle& style) {
  return TerminalReport(report, style).render();
}

std::string cases_to_terminal(const Report& report, const TerminalStyle& style) {
  return TerminalReport(report, style).render_cases();
}

const CaseReport* first_failure(const ExerciseReport& exercise) {
  const CaseReport* without_finding = nullptr;
  for (bool extra : {false, true}) {
    for (const GroupReport& group : exercise.groups) {
      if (group.extra_credit != extra) continue;
      for (const CaseReport& c : exercise.cases) {
        if (c.group != group.name || !is_failure(c)) continue;
        if (!c.findings.empty()) return &c;
        if (without_finding == nullptr) without_finding = &c;
      }
    }
    if (without_finding != nullptr) return without_finding;
  }
  return without_finding;
}

}  // namespace meshgrade
