// Reports of whole submissions: by the schema, the same every time, and safe to look at.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "grader/base/errors.h"
#include "grader/commands/figure_files.h"
#include "grader/grade/grading.h"
#include "grader/report/json_report.h"
#include "grader/report/report_reader.h"
#include "grader/report/terminal_report.h"
#include "tests/support/scratch_files.h"
#include "tests/support/standard_assignment.h"
#include "tests/support/submissions.h"

namespace meshgrade {
namespace {

Report grade_submission(const Submission& submission,
                        const std::vector<std::string>& exercises = {}) {
  return grade(standard_rubric(), submission, test_home(), exercises, [](const auto&) {});
}

Submission folder_submission(const std::string& name) {
  return find_submission(std::filesystem::path(MESHGRADE_SOURCE_DIR) / name, SubmissionRules{});
}

/// A submission that tries to spoil whatever shows its text.
Submission hostile_submission() {
  const std::string junk = "\\033[2J\\r\\xff\\xe2\\x80\\xae\\\",\\n}]";
  const std::string raw = "\033[31m \xFF \xE2\x80\xAE";
  Submission submission = submission_of(
      {normal_file("  std::cout << \"" + junk + "\";\n  throw std::runtime_error(\"" + junk +
                       "\");  // " + raw,
                   "#include <iostream>\n#include <stdexcept>"),
       {"flip.cpp", "#error " + raw + " \"}],\n"}});
  submission.name = "mueller \033[31m\n\"";
  return submission;
}

/// What the schema's validator has against these reports; empty if nothing.
std::string schema_faults(const std::vector<std::string>& reports) {
  const ScratchFolder folder;
  Command command;
  command.arguments = {"python3", MESHGRADE_SOURCE_DIR "/tests/report/validate_json.py",
                       MESHGRADE_SOURCE_DIR "/docs/report.schema.json"};
  for (std::size_t i = 0; i < reports.size(); ++i) {
    command.arguments.push_back(
        write_file(folder.path() / (std::to_string(i) + ".json"), reports[i]).string());
  }
  const ProcessResult result = run_process(command);
  return result.ok() ? "" : "the validator says: " + result.output;
}

/// The text without the colors that the grader itself paints with.
std::string without_paint(const std::string& text) {
  return std::regex_replace(text, std::regex("\033\\[[0-9;]*m"), "");
}

bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
  });
}

TEST(WholeReport, ReferenceHasEveryPointByTheSchema) {
  const Report report = grade_submission(folder_submission("reference"));
  EXPECT_EQ(report.points, 100.0);
  EXPECT_EQ(report.max_points, 100.0);
  EXPECT_EQ(report.extra_points, 10.0);
  EXPECT_FALSE(report.has_grader_error());
  EXPECT_EQ(schema_faults({to_json(report)}), "");
}

TEST(WholeReport, SkeletonHasNoPointByTheSchema) {
  const Report report = grade_submission(folder_submission("student_skeleton"));
  EXPECT_EQ(report.points, 0.0);
  EXPECT_EQ(report.extra_points, 0.0);
  for (const ExerciseReport& exercise : report.exercises)
    EXPECT_EQ(exercise.verdict, Verdict::kNotImplemented);
  EXPECT_EQ(schema_faults({to_json(report)}), "");
}

TEST(WholeReport, BrokenSubmissionsAreReportedByTheSchema) {
  Submission flip =
      submission_of({{"flip.cpp",
                      "#include \"meshedit/meshedit.h\"\n"
                      "namespace meshedit {\n"
                      "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) {\n"
                      "  e->halfedge()->next() = e->halfedge()->twin();\n"
                      "  return e;\n"
                      "}\n"
                      "VertexIter HalfedgeMesh::splitEdge(EdgeIter) { return newVertex(); }\n"
                      "}\n"}});
  Report pointers = grade_submission(flip, {"edge_flip", "edge_split"});
  EXPECT_EQ(pointers.points, 0.0);
  const ScratchFolder folder;
  EXPECT_GT(write_figures(pointers, folder.path()), 0U);
  EXPECT_NE(to_json(pointers).find("\"figure\": \"edge_flip_basic_1.svg\""), std::string::npos);
  const Report hostile = grade_submission(hostile_submission(), {"vertex_normal", "edge_flip"});
  EXPECT_EQ(hostile.points, 0.0);
  EXPECT_EQ(schema_faults({to_json(pointers), to_json(hostile)}), "");
}

TEST(WholeReport, ValidatorSeesWhatIsWrong) {
  auto json = nlohmann::json::parse(to_json(Report{}));
  EXPECT_EQ(schema_faults({json.dump()}), "");
  json["surprise"] = 1;
  EXPECT_NE(schema_faults({json.dump()}), "");
  EXPECT_NE(schema_faults({"{"}), "");
}

TEST(WholeReport, TheSameSubmissionTwiceGivesTheSameBytes) {
  const Submission submission = hostile_submission();
  EXPECT_EQ(to_json(grade_submission(submission, {"vertex_normal"})),
            to_json(grade_submission(submission, {"vertex_normal"})));
}

TEST(WholeReport, NothingOfTheStudentsBreaksTheJson) {
  const std::string text =
      to_json(grade_submission(hostile_submission(), {"vertex_normal", "edge_flip"}));
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("exercises").size(), 2U);
  EXPECT_EQ(json.at("files").at(1).at("compiled"), false);
  EXPECT_FALSE(has_control_characters(text));
  const auto& first = json.at("exercises").at(0).at("cases").at(0);
  EXPECT_NE(first.at("output").get<std::string>().find("\","), std::string::npos);
  EXPECT_FALSE(has_control_characters(first.dump()));
}

TEST(WholeReport, IsReadBackFromItsJson) {
  const Submission hostile = hostile_submission();
  for (const Report& report :
       {Report{}, grade_submission(hostile, {"vertex_normal", "edge_flip"}),
        grade_submission(folder_submission("tests/submissions/wrong/edge_split/one_side_only"),
                         {"edge_split"})}) {
    const Report back = read_report(to_json(report));
    EXPECT_EQ(to_json(back), to_json(report));
    EXPECT_EQ(to_terminal(back, {false, true}), to_terminal(report, {false, true}));
  }
}

/// The reversed normals fail everywhere; the case of another seed is hidden.
Report report_with_hidden_cases(HiddenShow show) {
  Assignment assignment = standard_rubric();
  assignment.hidden = HiddenCases{"", 4711, show};
  const Submission submission = submission_of({normal_file(
      "  std::cout << \"I saw it\";\n  return Vector3D(1, 0, 0);", "#include <iostream>")});
  return grade(assignment, submission, test_home(), {"vertex_normal"}, [](const auto&) {});
}

TEST(WholeReport, OfHiddenCasesStudentsSeeWhatTheAssignmentAllows) {
  for (const HiddenShow show : {HiddenShow::kName, HiddenShow::kRule, HiddenShow::kAll}) {
    const Report whole = read_report(to_json(report_with_hidden_cases(show)));
    const Report seen = student_view(whole);
    std::size_t hidden = 0;
    const auto& cases = seen.exercises.at(0).cases;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const CaseReport& before = whole.exercises[0].cases[i];
      EXPECT_EQ(cases[i].verdict, before.verdict);
      if (!cases[i].hidden || show == HiddenShow::kAll) {
        EXPECT_EQ(cases[i].title, before.title);
        EXPECT_EQ(cases[i].findings.size(), before.findings.size());
        continue;
      }
      ++hidden;
      EXPECT_EQ(cases[i].title, "a hidden case");
      EXPECT_EQ(cases[i].output, "");
      EXPECT_EQ(cases[i].findings.size(), show == HiddenShow::kRule ? 1U : 0U);
      for (const FindingReport& finding : cases[i].findings)
        EXPECT_EQ(finding.finding.actual + finding.finding.expected, "");
    }
    EXPECT_EQ(hidden > 0, show != HiddenShow::kAll);
    EXPECT_EQ(schema_faults({to_json(whole), to_json(seen)}), "");
    EXPECT_EQ(to_json(whole).find("4711"), std::string::npos) << "the seed must not be told";
    EXPECT_EQ(seen.points, whole.points);
  }
}

TEST(WholeReport, DamagedJsonIsRefused) {
  const std::string whole = to_json(grade_submission(hostile_submission(), {"vertex_normal"}));
  EXPECT_THROW(read_report(whole.substr(0, whole.size() / 2)), UserError);
  EXPECT_THROW(read_report("{}"), UserError);
  EXPECT_THROW(read_report(""), UserError);
  std::string other = whole;
  other.replace(other.find("meshgrade-report/1"), 18, "meshgrade-report/9");
  EXPECT_THROW(read_report(other), UserError);
}

TEST(WholeReport, TerminalShowsNoControlCharactersOfTheStudents) {
  const Report report = grade_submission(hostile_submission(), {"vertex_normal", "edge_flip"});
  TerminalStyle plain;
  plain.verbose = true;
  EXPECT_FALSE(has_control_characters(to_terminal(report, plain)));
  TerminalStyle colored = plain;
  colored.color = true;
  const std::string text = to_terminal(report, colored);
  EXPECT_NE(text.find('\033'), std::string::npos);
  EXPECT_FALSE(has_control_characters(without_paint(text)));
  EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos);
}

}  // namespace
}  // namespace meshgrade
