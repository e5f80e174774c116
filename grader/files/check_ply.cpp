#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>

#include "grader/files/checked_input.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"

namespace meshgrade {
namespace {

static_assert(std::endian::native == std::endian::little, "the plain form is little-endian");

struct Scalar {
  std::string_view name;
  std::size_t size;
  bool is_float;
  bool is_signed;
};

constexpr std::array<Scalar, 16> kScalars = {{{"char", 1, false, true},
                                              {"int8", 1, false, true},
                                              {"uchar", 1, false, false},
                                              {"uint8", 1, false, false},
                                              {"short", 2, false, true},
                                              {"int16", 2, false, true},
                                              {"ushort", 2, false, false},
                                              {"uint16", 2, false, false},
                                              {"int", 4, false, true},
                                              {"int32", 4, false, true},
                                              {"uint", 4, false, false},
                                              {"uint32", 4, false, false},
                                              {"float", 4, true, true},
                                              {"float32", 4, true, true},
                                              {"double", 8, true, true},
                                              {"float64", 8, true, true}}};

struct Property {
  std::string name;
  Scalar type{};
  std::optional<Scalar> list_size;
};

struct Element {
  std::string name;
  std::uint32_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { kText, kLittleEndian, kBigEndian };

struct Header {
  Encoding encoding = Encoding::kText;
  std::vector<Element> elements;
};

Scalar read_scalar(TextScanner& scanner) {
  const std::string_view word = scanner.next_word();
  const auto found = std::find_if(kScalars.begin(), kScalars.end(),
                                  [&](const Scalar& scalar) { return scalar.name == word; });
  if (found == kScalars.end()) scanner.refuse(in_quotes(word) + " is no PLY number type");
  return *found;
}

Property read_property(TextScanner& scanner) {
  Property property;
  TextScanner ahead = scanner;
  if (ahead.next_word() == "list") {
    scanner.next_word();
    property.list_size = read_scalar(scanner);
    if (property.list_size->is_float) scanner.refuse("a list's length must be a whole number");
  }
  property.type = read_scalar(scanner);
  property.name = scanner.next_word();
  return property;
}

Encoding read_encoding(TextScanner& scanner) {
  scanner.require_line("the line 'format ...'");
  if (scanner.next_word() != "format") scanner.refuse("the line 'format ...' should be here");
  const std::string_view word = scanner.next_word();
  if (word == "ascii") return Encoding::kText;
  if (word == "binary_little_endian") return Encoding::kLittleEndian;
  if (word == "binary_big_endian") return Encoding::kBigEndian;
  scanner.refuse(in_quotes(word) + " is no PLY encoding");
}

Header read_header(TextScanner& scanner) {
  scanner.require_line("the word ply");
  if (const auto word = scanner.next_word(); word != "ply" && word != "PLY") {
    scanner.refuse(in_quotes(word) + " where the word ply should be; is it another format?");
  }
  Header header;
  header.encoding = read_encoding(scanner);
  for (;;) {
    scanner.require_line("'end_header'");
    const std::string_view keyword = scanner.next_word();
    if (keyword == "end_header") return header;
    if (keyword == "element") {
      Element element;
      element.name = scanner.next_word();
      element.count = scanner.next_index("the number of elements");
      header.elements.push_back(std::move(element));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword != "comment" && keyword != "obj_info") {
      scanner.refuse(in_quotes(keyword) + " does not belong in a PLY header");
    }
  }
}

/// Gives the numbers of the body one by one, and their place for messages.
class Body {
 public:
  virtual ~Body() = default;
  virtual double next(const Scalar& type) = 0;
  virtual std::string place() const = 0;
};

class TextBody : public Body {
 public:
  explicit TextBody(const TextScanner& scanner) : scanner_(scanner) {}

  double next(const Scalar& type) override {
    if (!scanner_.has_word()) scanner_.require_line("more numbers");
    if (type.is_float) return scanner_.next_number("a coordinate");
    return static_cast<double>(scanner_.next_integer("a whole number"));
  }
  std::string place() const override { return scanner_.place(); }

 private:
  TextScanner scanner_;
};

class BinaryBody : public Body {
 public:
  BinaryBody(std::filesystem::path file, std::string_view bytes, std::size_t begin,
             bool is_big_endian)
      : file_(std::move(file)), bytes_(bytes), at_(begin), is_big_endian_(is_big_endian) {}

  double next(const Scalar& type) override {
    if (bytes_.size() - at_ < type.size) {
      refuse_file(file_, place(), "the file ends in the middle of its data; it is cut off");
    }
    std::array<unsigned char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, type.size);
    if (is_big_endian_) {
      std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(type.size));
    }
    at_ += type.size;
    if (type.is_float) return type.size == 4 ? as<float>(raw) : as<double>(raw);
    if (type.size == 1) return type.is_signed ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
    if (type.size == 2) return type.is_signed ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
    return type.is_signed ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
  }
  std::string place() const override { return "byte " + std::to_string(at_); }

 private:
  template <typename Number>
  static double as(const std::array<unsigned char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof(number));
    return static_cast<double>(number);
  }

  std::filesystem::path file_;
  std::string_view bytes_;
  std::size_t at_;
  bool is_big_endian_;
};

template <typename Number>
void append_raw(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof(number));
  bytes.append(raw.data(), raw.size());
}

std::vector<double> next_values(Body& body, const Property& property) {
  const double count = property.list_size ? body.next(*property.list_size) : 1;
  std::vector<double> values;
  for (double k = 0; k < count; ++k)
    values.push_back(body.next(property.type));
  return values;
}

void check_vertex(const std::filesystem::path& file, Body& body, const Element& element,
                  CheckedInput& input) {
  Point3 point{};
  for (const Property& property : element.properties) {
    const std::vector<double> values = next_values(body, property);
    const bool is_coordinate =
        property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
    if (!is_coordinate || values.empty()) continue;
    if (!(std::abs(values[0]) <= std::numeric_limits<float>::max())) {
      refuse_file(file, body.place(),
                  "vertex v" + std::to_string(input.exact_positions.size()) +
                      " has a coordinate that is not a finite number up to 3.4e38");
    }
    point[static_cast<std::size_t>(property.name[0] - 'x')] = values[0];
  }
  for (const double coordinate : point)
    append_raw(input.bytes, coordinate);
  input.exact_positions.push_back(point);
}

bool is_corner_list(const Property& property) {
  return property.list_size && !property.type.is_float &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

void check_face(const std::filesystem::path& file, Body& body, const Element& element,
                std::size_t face, CheckedInput& input) {
  std::vector<std::uint32_t> corners;
  const std::string place = body.place();
  for (const Property& property : element.properties) {
    const std::vector<double> values = next_values(body, property);
    if (!is_corner_list(property)) continue;
    for (const double value : values) {
      corners.push_back(value < 0 ? std::numeric_limits<std::uint32_t>::max()
                                  : static_cast<std::uint32_t>(value));
    }
  }
  check_polygon(file, place, face, corners, input.exact_positions.size(), 0);
  append_raw(input.bytes, static_cast<std::int32_t>(corners.size()));
  for (const std::uint32_t v : corners)
    append_raw(input.bytes, static_cast<std::int32_t>(v));
}

/// Vertices must come before faces, with x, y, z and a list of corners. Returns how many
/// elements to read: what follows the faces is of no interest.
std::size_t check_elements(const TextScanner& scanner, const Header& header) {
  const auto has_property = [](const Element& element, const auto& wanted) {
    return std::any_of(element.properties.begin(), element.properties.end(), wanted);
  };
  bool has_vertices = false;
  for (std::size_t k = 0; k < header.elements.size(); ++k) {
    const Element& element = header.elements[k];
    if (element.name == "vertex") {
      for (const std::string axis : {"x", "y", "z"}) {
        if (!has_property(element, [&](const Property& p) { return p.name == axis; })) {
          scanner.refuse("the vertices have no property " + axis);
        }
      }
      if (has_vertices) scanner.refuse("two elements are called vertex");
      has_vertices = true;
    }
    if (element.name != "face") continue;
    if (!has_vertices) scanner.refuse("the faces come before the vertices");
    if (!has_property(element, is_corner_list)) {
      scanner.refuse("the faces have no list vertex_indices");
    }
    return k + 1;
  }
  scanner.refuse("the header names no element face; only surfaces are read");
}

std::string plain_header(std::size_t n_vertices, std::size_t n_faces) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(n_vertices) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(n_faces) + "\nproperty list int int vertex_indices\nend_header\n";
}

std::unique_ptr<Body> open_body(const std::filesystem::path& file, std::string_view bytes,
                                Encoding encoding, const TextScanner& scanner) {
  if (encoding == Encoding::kText) return std::make_unique<TextBody>(scanner);
  return std::make_unique<BinaryBody>(file, bytes, scanner.offset(),
                                      encoding == Encoding::kBigEndian);
}

}  // namespace

CheckedInput check_ply(const std::filesystem::path& file, std::string_view bytes) {
  TextScanner scanner(file, bytes);
  const Header header = read_header(scanner);
  const std::size_t n_elements = check_elements(scanner, header);
  const auto body = open_body(file, bytes, header.encoding, scanner);

  CheckedInput input;
  input.is_binary = true;
  for (std::size_t k = 0; k < n_elements; ++k) {
    const Element& element = header.elements[k];
    if (element.properties.empty()) continue;
    for (std::uint32_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex") {
        check_vertex(file, *body, element, input);
      } else if (element.name == "face") {
        check_face(file, *body, element, i, input);
      } else {
        for (const Property& property : element.properties)
          next_values(*body, property);
      }
    }
  }
  input.n_faces = header.elements[n_elements - 1].count;
  input.bytes.insert(0, plain_header(input.exact_positions.size(), input.n_faces));
  return input;
}

}  // namespace meshgrade
