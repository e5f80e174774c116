#include "grader/files/ply_body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are swapped from that");

/// An element is a line: a missing number is never taken from the next.
class TextBody : public PlyBody {
 public:
  explicit TextBody(const TextScanner& scanner) : scanner_(scanner) {}

  void begin_element(const std::string& name) override {
    scanner_.require_line(name);
    name_ = name;
  }
  double next(const PlyScalar& type, const PlyProperty& property) override {
    double number = 0;
    std::int64_t whole = 0;
    if (type.is_float) {
      return scanner_.try_number(number) ? number
                                         : scanner_.next_number(property.name + " of " + name_);
    }
    return static_cast<double>(scanner_.try_integer(whole)
                                   ? whole
                                   : scanner_.next_integer(property.name + " of " + name_));
  }
  void skip(const PlyScalar& type) override {
    if (!scanner_.next_word().empty()) return;
    scanner_.refuse("the line ends where a number of type " + std::string(type.name) +
                    " should follow; in a PLY text each element is one line");
  }
  void end_element(ReadingNotes& notes) override {
    if (!scanner_.has_word()) return;
    notes.left_out("number behind the properties of its line's element",
                   "numbers behind the properties of their lines' elements", place(),
                   scanner_.count_words());
  }
  void end(ReadingNotes& notes) override {
    while (scanner_.next_line()) {
      notes.left_out("line behind the last element", "lines behind the last element", place());
    }
  }
  std::string place() const override { return scanner_.place(); }

 private:
  TextScanner scanner_;
  std::string name_;  // of the element
};

class BinaryBody : public PlyBody {
 public:
  BinaryBody(std::filesystem::path file, std::string_view bytes, std::size_t begin,
             bool is_big_endian)
      : file_(std::move(file)), bytes_(bytes), at_(begin), is_big_endian_(is_big_endian) {}

  void begin_element(const std::string& name) override {
    element_at_ = at_;
    name_ = name;
  }
  double next(const PlyScalar& type, const PlyProperty& property) override {
    const double number = read(type);
    if (type.is_float && !(std::abs(number) <= std::numeric_limits<float>::max())) {
      refuse_file(file_, place(),
                  property.name + " of " + name_ + " is not a finite number up to 3.4e38");
    }
    return number;
  }
  void skip(const PlyScalar& type) override { take(type.size); }
  void end_element(ReadingNotes&) override {}
  void end(ReadingNotes& notes) override {
    const std::string_view rest = bytes_.substr(at_);
    if (rest.size() <= 2 && rest.find_first_not_of("\r\n") == rest.npos) return;
    notes.left_out("byte behind the last element", "bytes behind the last element",
                   "byte " + std::to_string(at_), rest.size());
  }
  std::string place() const override { return "byte " + std::to_string(element_at_); }

 private:
  template <typename Number>
  static double as(const std::array<unsigned char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof(number));
    return static_cast<double>(number);
  }

  const char* take(std::size_t size) {
    if (bytes_.size() - at_ < size) {
      refuse_file(file_, "byte " + std::to_string(at_),
                  "the file ends in the middle of its data; it is cut off");
    }
    const char* data = bytes_.data() + at_;
    at_ += size;
    return data;
  }

  double read(const PlyScalar& type) {
    std::array<unsigned char, 8> raw{};
    std::memcpy(raw.data(), take(type.size), type.size);
    if (is_big_endian_) {
      std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(type.size));
    }
    if (type.is_float) return type.size == 4 ? as<float>(raw) : as<double>(raw);
    if (type.size == 1) return type.is_signed ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
    if (type.size == 2) return type.is_signed ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
    return type.is_signed ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
  }

  std::filesystem::path file_;
  std::string_view bytes_;
  std::size_t at_;
  std::size_t element_at_ = 0;
  std::string name_;  // of the element
  bool is_big_endian_;
};

/// Where lines end with CR alone, an LF behind the header is the first of the data.
std::size_t begin_of_data(std::string_view bytes, std::size_t behind_header) {
  const std::size_t first_end = bytes.find_first_of("\r\n");
  const bool is_cr_alone =
      bytes.substr(first_end, 1) == "\r" && bytes.substr(first_end, 2) != "\r\n";
  return is_cr_alone && bytes[behind_header - 1] == '\n' ? behind_header - 1 : behind_header;
}

}  // namespace

std::unique_ptr<PlyBody> open_ply_body(const std::filesystem::path& file,
                                       std::string_view bytes, PlyEncoding encoding,
                                       const TextScanner& scanner) {
  if (encoding == PlyEncoding::kText) return std::make_unique<TextBody>(scanner);
  return std::make_unique<BinaryBody>(file, bytes, begin_of_data(bytes, scanner.offset()),
                                      encoding == PlyEncoding::kBigEndian);
}

}  // namespace meshgrade
