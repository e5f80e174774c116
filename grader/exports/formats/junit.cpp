// JUnit XML by the schema of Ant's reports: testsuites, in it a testsuite for each exercise
// with its properties, then its test cases, then system-out and system-err, in this order. A
// test case has at most one of skipped, error and failure. The format knows no points: they are
// properties.

#include <pugixml.hpp>

#include <sstream>

#include "grader/base/text.h"
#include "grader/exports/formats/formats.h"
#include "grader/exports/graded_groups.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostText = 20'000;

/// pugixml escapes what has to be; what XML cannot hold at all is replaced before.
std::string xml_text(const std::string& text) {
  std::string clean = printable(text);
  for (const char* never : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
    for (auto at = clean.find(never); at != std::string::npos; at = clean.find(never))
      clean.replace(at, 3, "?");
  }
  return clean;
}

enum class Kind { kPassed, kFailure, kError, kSkipped };

/// A failure is an answer that is wrong; an error is a program that came to no answer.
Kind kind_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPassed:
      return Kind::kPassed;
    case Verdict::kFailed:
    case Verdict::kNotImplemented:
      return Kind::kFailure;
    case Verdict::kNotJudged:
      return Kind::kSkipped;
    default:
      return Kind::kError;
  }
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(xml_text(value).c_str());
}

void add_property(pugi::xml_node properties, const std::string& name, double value) {
  pugi::xml_node property = properties.append_child("property");
  set(property, "name", name);
  set(property, "value", number_text(value, 10));
}

void add_case(pugi::xml_node suite, const ExerciseReport& exercise, const CaseReport& c) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "name", c.id + " " + c.title);
  set(test, "classname", exercise.name + "." + c.group);
  set(test, "time", "0");
  const Kind kind = kind_of(c.verdict);
  if (kind == Kind::kPassed) return;
  if (kind == Kind::kSkipped) {
    test.append_child("skipped");
    return;
  }
  pugi::xml_node fault = test.append_child(kind == Kind::kFailure ? "failure" : "error");
  set(fault, "type", verdict_name(c.verdict));
  set(fault, "message", c.findings.empty() ? c.note : c.findings[0].finding.meaning);
  const std::string text = cut_off(explain_case(exercise, c), kMostText);
  fault.append_child(pugi::node_pcdata).set_value(xml_text(text).c_str());
}

std::size_t count(const ExerciseReport& exercise, Kind kind) {
  std::size_t sum = 0;
  for (const CaseReport& c : exercise.cases)
    sum += kind_of(c.verdict) == kind ? 1 : 0;
  return sum;
}

pugi::xml_node add_suite(pugi::xml_node suites, const StudentResult& result,
                         const std::string& name, const ExportOptions& options) {
  pugi::xml_node suite = suites.append_child("testsuite");
  set(suite, "package", result.key.empty() ? "submission" : result.key);
  set(suite, "id", std::to_string(std::distance(suites.begin(), suites.end()) - 1));
  set(suite, "name", name);
  set(suite, "timestamp", options.time.empty() ? "1970-01-01T00:00:00" : options.time);
  set(suite, "hostname", "localhost");
  return suite;
}

void set_counts(pugi::xml_node suite, std::size_t tests, std::size_t failures,
                std::size_t errors, std::size_t skipped) {
  set(suite, "tests", std::to_string(tests));
  set(suite, "failures", std::to_string(failures));
  set(suite, "errors", std::to_string(errors));
  set(suite, "skipped", std::to_string(skipped));
  set(suite, "time", "0");
}

void add_exercise(pugi::xml_node suites, const StudentResult& result,
                  const ExerciseReport& exercise, const ExportOptions& options) {
  pugi::xml_node suite = add_suite(suites, result, exercise.name, options);
  set_counts(suite, exercise.cases.size(), count(exercise, Kind::kFailure),
             count(exercise, Kind::kError), count(exercise, Kind::kSkipped));
  pugi::xml_node properties = suite.append_child("properties");
  add_property(properties, "points", exercise.points);
  add_property(properties, "max_points", exercise.max_points);
  add_property(properties, "extra_points", exercise.extra_points);
  add_property(properties, "max_extra_points", exercise.max_extra_points);
  for (const CaseReport& c : exercise.cases)
    add_case(suite, exercise, c);
  suite.append_child("system-out");
  suite.append_child("system-err");
}

/// A submission that is not graded is a single test without an answer.
void add_nothing(pugi::xml_node suites, const StudentResult& result,
                 const ExportOptions& options) {
  pugi::xml_node suite = add_suite(suites, result, "grading", options);
  set_counts(suite, 1, 0, 1, 0);
  suite.append_child("properties");
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "name", "grading");
  set(test, "classname", "grading");
  set(test, "time", "0");
  pugi::xml_node fault = test.append_child("error");
  set(fault, "type", status_name(result.status));
  set(fault, "message", result.reason);
  suite.append_child("system-out");
  suite.append_child("system-err");
}

}  // namespace

std::string write_junit(const StudentResult& result, const ExportOptions& options) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  if (result.report == nullptr) {
    add_nothing(suites, result, options);
  } else {
    for (const ExerciseReport& exercise : result.report->exercises)
      add_exercise(suites, result, exercise, options);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace meshgrade
