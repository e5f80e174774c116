// Every export of a class keeps the rules of its gradebook, and changes nobody else's grade.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/base/csv.h"
#include "grader/exports/exports.h"
#include "tests/exports/made_up_report.h"
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

/// As accounts export it that show names in two columns.
TEST(CanvasExport, NamesMayStandInTwoColumns) {
  const std::string gradebook =
      "LastName,FirstName,ID,SIS User ID,SIS Login ID,Section,Bezier (55),Current Score\r\n"
      "    Points Possible,,,,,,100,(read only)\r\n"
      "Doe,Ann,101,s101,ann,A,,\r\n"
      "Roe,Bob,9,102,bob,A,5.00,\r\n"
      "Lee,Nobody,103x,s103,lee,A,,\r\n";
  const Exported exported = write("canvas", with_gradebook(gradebook));
  EXPECT_EQ(exported.text,
            "LastName,FirstName,ID,SIS User ID,SIS Login ID,Section,Bezier (55)\r\n"
            "    Points Possible,,,,,,100\r\n"
            "Doe,Ann,101,s101,ann,A,87.5\r\n"
            "Roe,Bob,9,102,bob,A,105\r\n"
            "Lee,Nobody,103x,s103,lee,A,\r\n");
  EXPECT_EQ(user_error([&] {
              write("canvas", with_gradebook("LastName,ID,Section,Bezier (55)\r\n"));
            }).substr(0, 46),
            "the gradebook is not one that Canvas exports: ");
}

TEST(CanvasExport, WhoIsExcusedStaysSoAndIsNamed) {
  const Exported exported = write("canvas", with_gradebook("Student,ID,Section,Bezier (55)\r\n"
                                                           "Ann,101,A,EX\r\n"
                                                           "Bob,102,A,3\r\n"
                                                           "Eve,999,A,ex\r\n"));
  EXPECT_EQ(exported.text,
            "Student,ID,Section,Bezier (55)\r\nAnn,101,A,EX\r\nBob,102,A,105\r\n"
            "Eve,999,A,ex\r\n");
  EXPECT_THAT(exported.notes,
              testing::IsSupersetOf({"ann is excused in Canvas (EX): left as it is",
                                     "999 is excused in Canvas (ex): left as it is"}));
}

TEST(Exports, LateWorkIsMarkedWithWhatIsTakenOff) {
  ClassResults results = made_up_class();
  results.rows[0].late = true;
  results.rows[0].points = 77.5;
  results.rows[0].late_deduction = 10.0;
  results.rows[0].late_note = "2 h after it was due";
  const Exported canvas = find_class_export("canvas")->write(
      results, with_gradebook("Student,ID,Section,Bezier (55)\r\nAnn,101,A,\r\n"));
  EXPECT_THAT(canvas.text, HasSubstr("Ann,101,A,77.5\r\n"));
  EXPECT_THAT(canvas.notes,
              testing::Contains("ann is late: 87.5 - 10 = 77.5 points: 2 h after it was due"));
  const auto all = rows(find_class_export("csv")->write(results, {}).text);
  const std::size_t columns = all[0].size();
  EXPECT_THAT(all[1][columns - 3], "87.5");
  EXPECT_THAT(all[1][columns - 2], "10");
  EXPECT_THAT(all[1][columns - 1], "2 h after it was due");
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

TEST(MoodleExport, FeedbackGoesIntoTheCommentsAndReplacesOnlyItself) {
  const std::string head =
      "Identifier,Full name,Grade,Maximum Grade,Last modified (grade),Feedback comments\r\n";
  const std::string sheet = head + "Participant 101,Ann,,110,-,\r\n" +
                            "Participant 102,Bob,,110,-,see me\r\n" +
                            "Participant 103,Eve,,110,-,\"Points: 3 of 100, earlier\"\r\n" +
                            "Participant 104,Cem,,110,-,\r\n";
  ExportOptions options = with_gradebook(sheet);
  options.feedback = {{"ann", "Points: 87.5 of 100<br />\"x\""}, {"team", "Points: 100"}};
  const Exported exported = write("moodle", options);
  EXPECT_EQ(exported.text,
            head + "Participant 101,Ann,87.5,110,-,\"Points: 87.5 of 100<br />\"\"x\"\"\"\r\n" +
                "Participant 102,Bob,105,110,-,see me\r\n" +
                "Participant 103,Eve,105,110,-,Points: 100\r\n" +
                "Participant 104,Cem,,110,-,\r\n");
  EXPECT_THAT(exported.notes, testing::Contains("team has a comment in Moodle already: it is "
                                                "left as it is"));
  options.gradebook = "Identifier,Full name,Grade\r\nParticipant 101,Ann,\r\n";
  EXPECT_THAT(user_error([&] { write("moodle", options); }),
              HasSubstr("no column \"Feedback comments\""));
  options.gradebook = "Identifier,Name,Grade,Rueckmeldung\r\nParticipant 101,Ann,,\r\n";
  options.feedback_column = "Rueckmeldung";
  EXPECT_THAT(write("moodle", options).text, HasSubstr("Ann,87.5,\"Points"));
}

TEST(Feedback, SaysPointsAndTheFirstFaultAndEscapesAllOfTheStudents) {
  const ClassResults results = made_up_class();
  const Report report = made_up_report();
  const std::string html = feedback_html(results.rows[0], results, &report);
  EXPECT_EQ(html.rfind("Points: 87.5 of 100<br />Edge flip: 14 of 20", 0), 0U) << html;
  EXPECT_THAT(html, HasSubstr("face(next(h)) = face(h)"));
  EXPECT_THAT(html, testing::Not(HasSubstr("<script")));
  EXPECT_EQ(html.find('\n'), std::string::npos);
  EXPECT_EQ(feedback_html(results.rows[3], results, nullptr),
            "Points: 0 of 100<br />Not graded: no sources");
  EXPECT_EQ(feedback_html(results.rows[2], results, nullptr), "") << "a fault of the grader";
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
