// Every export of one student keeps the rules of its format, whatever the student wrote.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "grader/base/process.h"
#include "grader/exports/exports.h"
#include "tests/exports/made_up_report.h"
#include "tests/support/scratch_files.h"

namespace meshgrade {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string write(const std::string& format, const Report* report,
                  ResultStatus status = ResultStatus::kGraded,
                  const ExportOptions& options = {}) {
  return find_student_export(format)->write({"ann", status, hostile_text(), report}, options);
}

std::string graded(const std::string& format) {
  const Report report = made_up_report();
  return write(format, &report);
}

std::set<std::string> keys_of(const json& value) {
  std::set<std::string> keys;
  for (const auto& [key, entry] : value.items())
    keys.insert(key);
  return keys;
}

void expect_known(const json& value, const std::set<std::string>& known) {
  for (const std::string& key : keys_of(value))
    EXPECT_EQ(known.count(key), 1U) << key;
}

bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
  });
}

TEST(StudentExports, NoneHasControlCharacters) {
  const Report report = made_up_report();
  for (const StudentExport& format : student_exports()) {
    for (const Report* given : {&report, static_cast<const Report*>(nullptr)}) {
      const std::string text =
          write(format.name, given, given ? ResultStatus::kGraded : ResultStatus::kUngradable);
      EXPECT_FALSE(has_control_characters(text)) << format.name;
      EXPECT_NE(text, "") << format.name;
    }
  }
}

TEST(Gradescope, KeepsTheRules) {
  const json value = json::parse(graded("gradescope"));
  expect_known(value, {"score", "execution_time", "output", "output_format",
                       "test_output_format", "test_name_format", "visibility",
                       "stdout_visibility", "extra_data", "tests", "leaderboard"});
  EXPECT_EQ(value.at("score"), 16.5);
  const std::set<std::string> formats{"text", "html", "simple_format", "md", "ansi"};
  EXPECT_EQ(formats.count(value.at("output_format")), 1U);
  ASSERT_EQ(value.at("tests").size(), 3U);
  for (const json& test : value.at("tests")) {
    expect_known(test, {"score", "max_score", "status", "name", "name_format", "number",
                        "output", "output_format", "tags", "visibility", "extra_data"});
    EXPECT_TRUE(test.at("status") == "passed" || test.at("status") == "failed");
    EXPECT_TRUE(test.at("number").is_string());
    EXPECT_EQ(test.at("visibility"), "visible") << "a hidden test hides the total";
    EXPECT_EQ(test.at("output_format"), "text") << "a student's text is no HTML";
  }
  EXPECT_EQ(value.at("tests").at(1).at("score"), 0.0);
  EXPECT_EQ(value.at("tests").at(1).at("max_score"), 6.0);
  EXPECT_EQ(value.at("stdout_visibility"), "hidden");
}

TEST(Gradescope, AFaultOfTheGraderGivesNoScore) {
  EXPECT_FALSE(
      json::parse(write("gradescope", nullptr, ResultStatus::kGraderError)).contains("score"));
  EXPECT_EQ(json::parse(write("gradescope", nullptr, ResultStatus::kUngradable)).at("score"),
            0.0);
}

TEST(Gradescope, ExtraCreditMayStayOut) {
  const Report report = made_up_report();
  ExportOptions options;
  options.extra_credit = false;
  EXPECT_EQ(
      json::parse(write("gradescope", &report, ResultStatus::kGraded, options)).at("score"),
      14.0);
}

TEST(Autolab, TheLastLineHoldsTheScoresAndNothingElseDoes) {
  const std::vector<std::string> lines = split_lines(graded("autolab"));
  ASSERT_GT(lines.size(), 3U);
  const json scores = json::parse(lines.back());
  EXPECT_EQ(scores.dump(), R"({"scores":{"edge_flip":14.0,"extra_credit":2.5}})");
  const json feedback = json::parse(lines[lines.size() - 2]);
  EXPECT_EQ(feedback.at("_presentation"), "semantic");
  for (const json& stage : feedback.at("stages")) {
    for (const auto& [name, entry] : feedback.at(stage.get<std::string>()).items())
      EXPECT_TRUE(entry.at("passed").is_boolean()) << name;
  }
  for (std::size_t i = 0; i + 2 < lines.size(); ++i)
    EXPECT_THAT(lines[i], Not(StartsWith("{"))) << "a student's line may not pass for scores";
}

TEST(Autolab, AFaultOfTheGraderGivesNoScores) {
  EXPECT_THAT(write("autolab", nullptr, ResultStatus::kGraderError), StartsWith("  "));
  EXPECT_THAT(write("autolab", nullptr, ResultStatus::kGraderError),
              Not(HasSubstr("\n{\"scores\"")));
}

TEST(PrairieLearn, KeepsTheRules) {
  const json value = json::parse(graded("prairielearn"));
  expect_known(value, {"gradable", "score", "message", "output", "images", "tests"});
  EXPECT_DOUBLE_EQ(value.at("score"), 16.5 / 20.0);
  for (const json& test : value.at("tests")) {
    expect_known(test, {"name", "description", "points", "max_points", "message", "output"});
    EXPECT_TRUE(test.at("points").is_number());
    EXPECT_TRUE(test.at("max_points").is_number());
  }
}

TEST(PrairieLearn, TheScoreNeverPassesOne) {
  Report report = made_up_report();
  report.points = 20.0;
  EXPECT_EQ(json::parse(write("prairielearn", &report)).at("score"), 1.0);
}

TEST(PrairieLearn, WhatIsNotGradedSpendsNoAttempt) {
  for (const ResultStatus status : {ResultStatus::kUngradable, ResultStatus::kGraderError}) {
    const json value = json::parse(write("prairielearn", nullptr, status));
    EXPECT_EQ(value.at("gradable"), false);
    EXPECT_TRUE(value.at("format_errors").is_array());
    EXPECT_FALSE(value.contains("score"));
  }
}

TEST(PrairieLearn, TheFileStaysBelowItsLimit) {
  Report report = made_up_report();
  report.files[1].messages = std::string(5U << 20U, '"');
  for (int i = 0; i < 200; ++i) {
    GroupReport group = report.exercises[0].groups[1];
    group.title += std::to_string(i);
    report.exercises[0].groups.push_back(group);
  }
  report.exercises[0].cases[3].note = std::string(100'000, '\\');
  const std::string text = write("prairielearn", &report);
  EXPECT_LE(text.size(), 1U << 20U);
  EXPECT_EQ(json::parse(text).at("tests").size(), 203U);
}

TEST(GitHubAnnotations, EveryLineIsACommandOfOurs) {
  const std::vector<std::string> lines = split_lines(graded("github-annotations"));
  ASSERT_GE(lines.size(), 3U);
  EXPECT_LE(lines.size(), 11U) << "GitHub shows ten errors, and the notice";
  for (const std::string& line : lines) {
    EXPECT_TRUE(line.rfind("::error ", 0) == 0 || line.rfind("::notice ", 0) == 0) << line;
    const std::string properties = line.substr(2, line.find("::", 2) - 2);
    EXPECT_EQ(properties.find(':'), std::string::npos) << properties;
  }
  EXPECT_THAT(
      graded("github-annotations"),
      HasSubstr("file=my%3Aflip%2C%25.cpp,line=12,title=Edge flip%3A boundary edges::"));
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (char c : text) {
    const auto digit = digits.find(c);
    if (digit == std::string::npos) continue;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
  }
  return bytes;
}

TEST(GitHubResult, IsWhatTheReporterReads) {
  const std::string text = graded("github-result");
  EXPECT_EQ((text.size() - 1) % 4, 0U);
  const json value = json::parse(from_base64(text));
  EXPECT_EQ(value.at("version"), 1);
  EXPECT_EQ(value.at("status"), "fail");
  EXPECT_EQ(value.at("max_score"), 20);
  EXPECT_TRUE(value.at("max_score").is_number_integer());
  double sum = 0.0;
  for (const json& test : value.at("tests")) {
    sum += test.at("score").get<double>();
    EXPECT_TRUE(test.at("line_no").is_number_integer());
  }
  EXPECT_EQ(sum, 16.5) << "partial credit is kept";
}

TEST(JUnit, KeepsTheSchema) {
  const ScratchFolder folder;
  const Report report = made_up_report();
  Command command;
  command.arguments = {"xmllint", "--noout", "--schema",
                       MESHGRADE_SOURCE_DIR "/tests/exports/junit.xsd"};
  ExportOptions options;
  options.time = "2026-01-31T12:00:00";
  command.arguments.push_back(
      write_file(folder.path() / "a.xml",
                 write("junit", &report, ResultStatus::kGraded, options))
          .string());
  command.arguments.push_back(
      write_file(folder.path() / "b.xml", write("junit", nullptr, ResultStatus::kGraderError))
          .string());
  const ProcessResult valid = run_process(command);
  EXPECT_TRUE(valid.ok()) << valid.output;
  command.arguments.back() =
      write_file(folder.path() / "c.xml", "<testsuites><x/></testsuites>").string();
  EXPECT_FALSE(run_process(command).ok()) << "the schema must refuse something";
}

TEST(JUnit, CountsWhatIsThere) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(graded("junit").c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  const auto count = [&](const char* kind) {
    int sum = 0;
    for (const pugi::xml_node test : suite.children("testcase"))
      sum += test.child(kind) ? 1 : 0;
    return sum;
  };
  EXPECT_EQ(suite.attribute("tests").as_int(), 12);
  EXPECT_EQ(suite.attribute("failures").as_int(), count("failure"));
  EXPECT_EQ(suite.attribute("errors").as_int(), count("error"));
  EXPECT_EQ(suite.attribute("skipped").as_int(), count("skipped"));
  EXPECT_EQ(count("failure"), 3);
  EXPECT_EQ(count("skipped"), 1);
  EXPECT_STREQ(suite.child("properties").child("property").attribute("value").value(), "14");
}

/// The page without its code blocks.
std::string outside_code(const std::string& page) {
  std::string rest;
  std::string fence;
  for (const std::string& line : split_lines(page)) {
    const std::size_t ticks = line.find_first_not_of('`');
    const std::string run = line.substr(0, ticks == std::string::npos ? line.size() : ticks);
    if (fence.empty() && run.size() >= 3) {
      fence = run;
    } else if (!fence.empty() && line == fence) {
      fence.clear();
    } else if (fence.empty()) {
      rest += line + "\n";
    }
  }
  EXPECT_EQ(fence, "") << "a code block is never closed";
  return rest;
}

TEST(Markdown, WhatAStudentWroteStaysInCode) {
  const std::string rest = outside_code(graded("markdown"));
  EXPECT_THAT(rest, HasSubstr("| Edge flip | failed | 14 / 20 | 2.5 / 5 |"));
  EXPECT_THAT(rest, Not(HasSubstr("<")));
  EXPECT_THAT(rest, Not(HasSubstr("](")));
  EXPECT_THAT(rest, Not(HasSubstr("@")));
  EXPECT_THAT(rest, Not(HasSubstr("http:")));
  EXPECT_THAT(outside_code(write("markdown", nullptr, ResultStatus::kUngradable)),
              Not(HasSubstr("<")));
}

}  // namespace
}  // namespace meshgrade
