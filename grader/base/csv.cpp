#include "grader/base/csv.h"

#include <algorithm>

#include "grader/base/errors.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class CsvReader {
 public:
  CsvReader(std::string_view bytes, char separator) : bytes_(bytes), separator_(separator) {
    if (bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ = kByteOrderMark.size();
  }

  std::vector<CsvRecord> read() {
    std::vector<CsvRecord> records;
    while (at_ < bytes_.size()) {
      CsvRecord record = read_record();
      if (record.size() > 1 || record[0].begin != record[0].end) {
        records.push_back(std::move(record));
      }
    }
    return records;
  }

 private:
  bool at_line_end() const {
    return at_ >= bytes_.size() || bytes_[at_] == '\n' || bytes_.substr(at_, 2) == "\r\n";
  }

  CsvRecord read_record() {
    CsvRecord record;
    for (;;) {
      record.push_back(read_field());
      if (at_line_end()) break;
      ++at_;  // the separator
    }
    while (at_ < bytes_.size() && bytes_[at_++] != '\n') {
    }
    return record;
  }

  CsvField read_field() {
    CsvField field;
    field.begin = at_;
    const bool quoted = at_ < bytes_.size() && bytes_[at_] == '"';
    if (quoted) read_quoted(field.text);
    // What follows a closing quote is no CSV, but nothing is to be lost of it.
    while (!at_line_end() && bytes_[at_] != separator_)
      field.text += bytes_[at_++];
    field.end = at_;
    return field;
  }

  void read_quoted(std::string& text) {
    const std::size_t start = at_++;
    for (;; ++at_) {
      if (at_ >= bytes_.size()) {
        const auto line =
            1 + std::count(bytes_.begin(), bytes_.begin() + static_cast<long>(start), '\n');
        throw UserError("line " + std::to_string(line) + ": a quote is never closed");
      }
      if (bytes_[at_] == '"') {
        ++at_;
        if (at_ >= bytes_.size() || bytes_[at_] != '"') return;
      }
      text += bytes_[at_];
    }
  }

  std::string_view bytes_;
  char separator_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<CsvRecord> read_csv(std::string_view bytes, char separator) {
  return CsvReader(bytes, separator).read();
}

char csv_separator(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  return std::count(line.begin(), line.end(), ';') > std::count(line.begin(), line.end(), ',')
             ? ';'
             : ',';
}

std::string csv_field(const std::string& text, char separator) {
  const std::string special = std::string("\"\r\n") + separator;
  if (text.find_first_of(special) == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_text(const std::string& text, char separator) {
  const std::string safe = printable(text);
  const bool formula =
      !safe.empty() && std::string("=+-@\t").find(safe[0]) != std::string::npos;
  return csv_field((formula ? "'" : "") + safe, separator);
}

std::string csv_line(const std::vector<std::string>& fields, char separator) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    line += (i == 0 ? "" : std::string(1, separator)) + fields[i];
  return line + "\r\n";
}

}  // namespace meshgrade
