#include "grader/base/csv.h"

#include <gtest/gtest.h>

#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

std::vector<std::vector<std::string>> texts(std::string_view bytes, char separator = ',') {
  std::vector<std::vector<std::string>> all;
  for (const CsvRecord& record : read_csv(bytes, separator)) {
    auto& row = all.emplace_back();
    for (const CsvField& field : record)
      row.push_back(field.text);
  }
  return all;
}

using Rows = std::vector<std::vector<std::string>>;

TEST(Csv, EveryTextComesBack) {
  const std::vector<std::string> hard{"",           "plain", "a,b", "say \"no\"",
                                      "two\nlines", " x ",   ";"};
  for (const char separator : {',', ';'}) {
    std::vector<std::string> fields;
    for (const std::string& text : hard)
      fields.push_back(csv_field(text, separator));
    EXPECT_EQ(texts(csv_line(fields, separator), separator), Rows{hard});
  }
}

TEST(Csv, LinesMayEndInAnyWay) {
  const Rows expected{{"a", "b"}, {"c", ""}};
  EXPECT_EQ(texts("a,b\r\nc,\r\n"), expected);
  EXPECT_EQ(texts("a,b\nc,"), expected);
  EXPECT_EQ(texts("\xEF\xBB\xBF"
                  "a,b\n\n\nc,\n\n"),
            expected);
}

TEST(Csv, FieldsKnowTheirPlace) {
  const std::string bytes = "\xEF\xBB\xBFid,\"na\"\"me\"\r\n7,x\r\n";
  for (const CsvRecord& record : read_csv(bytes)) {
    for (const CsvField& field : record) {
      EXPECT_EQ(bytes.substr(field.begin, field.end - field.begin), csv_field(field.text));
    }
  }
}

TEST(Csv, AnOpenQuoteIsRefusedWithItsLine) {
  EXPECT_EQ(user_error([] { read_csv("a,b\n1,\"x\n"); }), "line 2: a quote is never closed");
}

TEST(Csv, NoTextBecomesAFormula) {
  for (const std::string text : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1"}) {
    EXPECT_EQ(csv_text(text), "'" + text);
  }
  EXPECT_EQ(csv_text("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
  EXPECT_EQ(csv_text("M\xC3\xBCller-Lee"), "M\xC3\xBCller-Lee");
  EXPECT_EQ(csv_text("a\033[31m"), "a?[31m");
}

TEST(Csv, SeparatorIsTheOneOfTheFirstLine) {
  EXPECT_EQ(csv_separator("a,b,c\n"), ',');
  EXPECT_EQ(csv_separator("a;b;c, d\n1;2;3"), ';');
}

}  // namespace
}  // namespace meshgrade
