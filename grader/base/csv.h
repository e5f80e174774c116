#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meshgrade {

/// A field of a CSV file and where it stands in the bytes, quotes included.
struct CsvField {
  std::string text;
  std::size_t begin = 0;
  std::size_t end = 0;
};

using CsvRecord = std::vector<CsvField>;

/// The records of a CSV text (RFC 4180). Lines may end in CR LF or LF; a byte order mark is
/// passed over; empty lines are left out. The fields are separated by `separator`.
/// @throws UserError for a quote that is never closed
std::vector<CsvRecord> read_csv(std::string_view bytes, char separator = ',');

/// ',' or ';', whichever the first line has more of.
char csv_separator(std::string_view bytes);

/// The text as a field: in quotes where it has to be.
std::string csv_field(const std::string& text, char separator = ',');

/// The same for text that a student may have chosen: a spreadsheet would take a field that
/// begins with = + - @ or a tab for a formula, and a ' in front prevents it.
std::string csv_text(const std::string& text, char separator = ',');

/// A record, with CR LF at its end.
std::string csv_line(const std::vector<std::string>& fields, char separator = ',');

}  // namespace meshgrade
