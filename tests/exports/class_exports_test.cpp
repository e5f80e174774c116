// Every export of a class keeps the rules of its gradebook, and changes nobody else's grade.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/base/csv.h"
#include "grader/exports/exports.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ClassRow row_of(const std::string& key, std::vector<Person> people, double points,
                double extra = 0.0) {
  ClassRow row;
  row.key = key;
  row.people = std::move(people);
  row.status = ResultStatus::kGraded;
  row.points = points;
  row.extra_points = extra;
  row.exercises = {{"edge_flip", "failed", points, 100.0, extra, 10.0}};
  return row;
}

ClassResults made_up_class() {
  ClassResults results;
  results.assignment = "Meshes";
  results.layout = "canvas";
  results.max_points = 100.0;
  results.max_extra_points = 10.0;
  results.exercises = {{"edge_flip", "", 0.0, 100.0, 0.0, 10.0}};
  results.rows = {
      row_of("ann", {{"101", "Ann", "ann@x.edu"}}, 87.5),
      row_of("team", {{"102", "Bob", ""}, {"103", "=cmd|' /C calc'!A0", ""}}, 100, 5)};
  ClassRow broken = row_of("cem", {{"104", "Cem", ""}}, 0.0);
  broken.status = ResultStatus::kGraderError;
  broken.reason = "=its, \"process\"\ndied";
  ClassRow empty = row_of("dan", {{"105", "Dan", ""}}, 0.0);
  empty.status = ResultStatus::kUngradable;
  empty.reason = "no sources";
  results.rows.push_back(broken);
  results.rows.push_back(empty);
  return results;
}

std::vector<std::vector<std::string>> rows(const std::string& csv, char separator = ',') {
  std::vector<std::vector<std::string>> all;
  for (const CsvRecord& record : read_csv(csv, separator)) {
    auto& row = all.emplace_back();
    for (const CsvField& field : record)
      row.push_back(field.text);
  }
  return all;
}

Exported write(const std::string& format, const ExportOptions& options) {
  return find_class_export(format)->write(made_up_class(), options);
}

ExportOptions with_gradebook(const std::string& gradebook, const std::string& column = "") {
  ExportOptions options;
  options.gradebook = gradebook;
  options.column = column;
  return options;
}

TEST(CsvExport, HasALineForEachPerson) {
  const auto all = rows(write("csv", {}).text);
  ASSERT_EQ(all.size(), 6U);
  for (const auto& row : all)
    EXPECT_EQ(row.size(), all[0].size());
  EXPECT_EQ(all[0][0], "id");
  EXPECT_EQ(all[1][7], "87.5");
  EXPECT_EQ(all[2][3], "team");
  EXPECT_EQ(all[3][3], "team");
}

TEST(CsvExport, NoTextBecomesAFormula) {
  for (const auto& row : rows(write("csv", {}).text)) {
    for (const std::string& field : row)
      EXPECT_TRUE(field.empty() || std::string("=+-@").find(field[0]) == std::string::npos);
  }
}

TEST(CsvExport, AFaultOfTheGraderIsNobodysZero) {
  const auto all = rows(write("csv", {}).text);
  EXPECT_EQ(all[4][6], "grader error");
  EXPECT_EQ(all[4][7], "");
  EXPECT_EQ(all[5][6], "ungradable");
  EXPECT_EQ(all[5][7], "0");
}

const char* const kCanvasGradebook =
    "\xEF\xBB\xBFStudent,ID,SIS User ID,SIS Login ID,Section,Essay (1),Meshes (22),"
    "Final Score\r\n"
    "    Points Possible,,,,,10,100,(read only)\r\n"
    "\"Lee, Ann\",101,u1,ann,S1,9,,90\r\n"
    "\"Ross, Bob\",102,u2,bob,S1,8,3,80\r\n"
    "\"Oz, Cem\",104,u4,cem,S1,7,4,70\r\n"
    "\"Dor, Dan\",999,u5,105,S1,6,,60\r\n"
    "\"Way, A\",998,u9,away,S1,5,55,50\r\n";

TEST(CanvasExport, FillsOneColumnOfTheGradebook) {
  const Exported exported = write("canvas", with_gradebook(kCanvasGradebook, "Meshes"));
  EXPECT_THAT(rows(exported.text),
              ElementsAre(ElementsAre("Student", "ID", "SIS User ID", "SIS Login ID", "Section",
                                      "Meshes (22)"),
                          ElementsAre("    Points Possible", "", "", "", "", "100"),
                          ElementsAre("Lee, Ann", "101", "u1", "ann", "S1", "87.5"),
                          ElementsAre("Ross, Bob", "102", "u2", "bob", "S1", "105"),
                          ElementsAre("Oz, Cem", "104", "u4", "cem", "S1", ""),
                          ElementsAre("Dor, Dan", "999", "u5", "105", "S1", "0"),
                          ElementsAre("Way, A", "998", "u9", "away", "S1", "")));
  EXPECT_THAT(exported.notes,
              ElementsAre("cem has no grade (grader error): none is written to the gradebook",
                          "dan gets 0 points (ungradable: no sources)"));
}

TEST(CanvasExport, FullPointsThatCanvasDoesNotExpectAreNoted) {
  std::string gradebook = kCanvasGradebook;
  gradebook.replace(gradebook.find("10,100,"), 7, "10,80.00,");
  ExportOptions options = with_gradebook(gradebook, "Meshes");
  const std::string note =
      "full points are 100 here, but 80 points are possible in Canvas; scale with --out-of 80";
  EXPECT_THAT(write("canvas", options).notes, testing::Contains(note));
  options.out_of = 80.0;
  EXPECT_THAT(write("canvas", options).notes, testing::Not(testing::Contains(note)));
}

TEST(CanvasExport, TheColumnIsFoundByTitleOrNumberOrAsked) {
  for (const char* name : {"Meshes", "Meshes (22)", "22"})
    EXPECT_THAT(write("canvas", with_gradebook(kCanvasGradebook, name)).text,
                HasSubstr("Meshes (22)"));
  EXPECT_EQ(
      user_error([] { write("canvas", with_gradebook(kCanvasGradebook)); }),
      "the gradebook has several assignments: choose one with --column, of \"Essay (1)\", "
      "\"Meshes (22)\"");
  EXPECT_THAT(user_error([] { write("canvas", with_gradebook(kCanvasGradebook, "Mesh")); }),
              HasSubstr("the gradebook has no such assignment"));
  EXPECT_THAT(user_error([] { write("canvas", with_gradebook("a,b,c\r\n1,2,3\r\n")); }),
              HasSubstr("not one that Canvas exports"));
}

TEST(CanvasExport, WithoutAGradebookTheIdsMatch) {
  const Exported exported = write("canvas", {});
  const auto all = rows(exported.text);
  EXPECT_THAT(all[0],
              ElementsAre("Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Meshes"));
  EXPECT_THAT(all[1], ElementsAre("Ann", "101", "", "", "", "87.5"));
  EXPECT_EQ(all[3][0][0], '\'');
  EXPECT_THAT(exported.notes, ElementsAre(HasSubstr("Canvas offers to create")));
}

const char* const kWorksheet =
    "\xEF\xBB\xBFIdentifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\","
    "\"Last modified (grade)\",\"Feedback comments\"\r\n"
    "\"Participant 101\",Ann,ann@x.edu,\"Submitted, graded\",,110.00,-,\"=1+1\"\r\n"
    "\"Participant 102\",\"Bob \"\"B\"\"\",b@x.edu,x,\"12,5\",110.00,-,\"two\r\nlines\"\r\n"
    "Participant 999,Zoe,z@x.edu,x,33,110.00,-,\r\n"
    "Participant 104,Cem,c@x.edu,x,44,110.00,-,";

TEST(MoodleExport, ChangesOnlyTheGrades) {
  std::string sheet = kWorksheet;
  const std::string before = "\"12,5\"";
  sheet.replace(sheet.find(before), before.size(), "12.5");
  const Exported exported = write("moodle", with_gradebook(sheet));
  std::string expected = sheet;
  expected.replace(expected.find("graded\",,"), 9, "graded\",87.5,");
  expected.replace(expected.find(",12.5,"), 6, ",105,");
  EXPECT_EQ(exported.text, expected);
  EXPECT_THAT(exported.notes,
              ElementsAre("cem has no grade (grader error): none is written to the worksheet",
                          "dan is not in the worksheet: no grade is written"));
}

TEST(MoodleExport, KeepsADecimalComma) {
  EXPECT_THAT(write("moodle", with_gradebook(kWorksheet)).text,
              HasSubstr("graded\",\"87,5\",110.00"));
  std::string german = "ID;Name;Bewertung;Bestwertung\nTeilnehmer/in101;Ann;;100,00\n";
  EXPECT_EQ(write("moodle", with_gradebook(german, "Bewertung")).text,
            "ID;Name;Bewertung;Bestwertung\nTeilnehmer/in101;Ann;87,5;100,00\n");
}

TEST(MoodleExport, SaysWhatMoodleWouldPassOver) {
  std::string sheet = "Identifier,Grade,Maximum Grade\nParticipant 101,,10.00\n";
  EXPECT_THAT(
      write("moodle", with_gradebook(sheet)).notes,
      testing::Contains(HasSubstr("ann has 87.5 points, but the maximum in Moodle is 10")));
  ExportOptions scaled = with_gradebook(sheet);
  scaled.out_of = 10.0;
  EXPECT_THAT(write("moodle", scaled).text, HasSubstr("Participant 101,8.75,10.00"));
}

TEST(MoodleExport, RefusesWhatIsNoWorksheet) {
  EXPECT_THAT(user_error([] { write("moodle", {}); }), HasSubstr("--gradebook"));
  EXPECT_THAT(user_error([] { write("moodle", with_gradebook("a,b,c\nx,y,z\n")); }),
              HasSubstr("this is no grading worksheet"));
  EXPECT_THAT(
      user_error([] { write("moodle", with_gradebook("ID,Name,Note\nParticipant 1,x,\n")); }),
      HasSubstr("the worksheet has no column \"Grade\"; say with --column which one"));
}

TEST(Exports, AllHaveNamesOfTheirOwn) {
  std::vector<std::string> names = export_names();
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_EQ(find_class_export("gradescope"), nullptr);
  EXPECT_EQ(find_student_export("canvas"), nullptr);
}

}  // namespace
}  // namespace meshgrade
