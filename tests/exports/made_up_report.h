#pragma once

// A report with every verdict, and with text of a student who tries to break whatever shows it.

#include <string>

#include "grader/base/text.h"
#include "grader/report/report.h"

namespace meshgrade {

/// As a report holds it: printable, but full of every format's own signs.
inline std::string hostile_text() {
  return printable(
      "]]>\"'<script>alert(1)</script> & =1+1,;| ```\n````\n::error file=x::forged\n"
      "{\"scores\":{\"edge_flip\":1000}}\n![x](http://x.edu/) @everyone %0A \033[31m \x01 \xFF"
      " \xEF\xBF\xBE </failure> \\");
}

inline CaseReport made_up_case(const std::string& group, int number, Verdict verdict) {
  CaseReport c;
  c.group = group;
  c.id = "edge_flip:" + group + "/" + std::to_string(number);
  c.title = "flip v0-v" + std::to_string(number);
  c.verdict = verdict;
  if (verdict == Verdict::kPassed) return c;
  c.note = join(split_lines(hostile_text()), " ");
  FindingReport& finding = c.findings.emplace_back();
  finding.finding.rule = "next-face";
  finding.finding.meaning = "face(next(h)) = face(h)";
  finding.finding.element = "h3";
  finding.finding.expected = "f1";
  finding.finding.actual = join(split_lines(hostile_text()), " ");
  finding.places.push_back({"flip,Edge", "my:flip,%.cpp", 12, "x = `y` | z; <b>"});
  c.output = hostile_text();
  c.output_bytes = c.output.size();
  return c;
}

inline Report made_up_report() {
  Report report;
  report.assignment = "Meshes & <surfaces>";
  report.submission = join(split_lines(hostile_text()), " ");
  report.seed = 184;
  report.points = 14.0;
  report.max_points = 20.0;
  report.extra_points = 2.5;
  report.max_extra_points = 5.0;
  report.notes = {hostile_text()};
  report.files = {{"flip.cpp", true, ""}, {"broken.cpp", false, hostile_text()}};
  ExerciseReport& e = report.exercises.emplace_back();
  e.name = "edge_flip";
  e.title = "Edge flip";
  e.verdict = Verdict::kFailed;
  e.points = 14.0;
  e.max_points = 20.0;
  e.extra_points = 2.5;
  e.max_extra_points = 5.0;
  e.notes = {hostile_text()};
  e.groups = {{"basic", "inner | edges", false, 14.0, 14.0, 1, 1, 1, ""},
              {"boundary", "boundary edges", false, 0.0, 6.0, 0, 9, 9, ""},
              {"more", "split them", true, 2.5, 5.0, 1, 2, 2, ""}};
  e.cases = {made_up_case("basic", 1, Verdict::kPassed),
             made_up_case("more", 1, Verdict::kPassed),
             made_up_case("more", 2, Verdict::kFailed)};
  int number = 0;
  for (const Verdict verdict :
       {Verdict::kFailed, Verdict::kNotImplemented, Verdict::kNotCompiled, Verdict::kCrashed,
        Verdict::kOutOfTime, Verdict::kOutOfSteps, Verdict::kOutOfMemory, Verdict::kNotJudged,
        Verdict::kGraderError}) {
    e.cases.push_back(made_up_case("boundary", ++number, verdict));
  }
  return report;
}

}  // namespace meshgrade
