#include "grader/files/bezier_file.h"

#include <charconv>
#include <string>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"
#include "grader/files/utf8_text.h"

namespace meshgrade {
namespace {

constexpr std::uint32_t kMostPatches = 100000;
constexpr std::uint32_t kMostPoints = 64;  // of a curve, or of one side of a net

template <typename Point>
void append_point(std::string& text, const Point& point) {
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), point[axis]);
    if (axis > 0) text += ' ';
    text.append(digits.data(), end.ptr);
  }
}

std::size_t read_number_of(TextScanner& scanner, const std::string& what, std::uint32_t least,
                           std::uint32_t most) {
  const std::uint32_t count = scanner.next_index("the number of " + what);
  if (count < least || count > most) {
    scanner.refuse(std::to_string(count) + " " + what + "; give " + std::to_string(least) +
                   " to " + std::to_string(most));
  }
  return count;
}

std::string point_name(std::size_t row, std::size_t col, const std::string& patch) {
  return "point " + std::to_string(col) + " in row " + std::to_string(row) + " of " + patch;
}

/// A net with a row on each line, and its size in front unless it is 4 x 4.
ControlNet read_net_by_lines(TextScanner& scanner, std::size_t patch) {
  const std::string name = "patch " + std::to_string(patch);
  ControlNet net{4, 4, {}};
  scanner.require_line(name);
  if (scanner.count_words() == 2) {
    net.rows = read_number_of(scanner, "rows", 2, kMostPoints);
    net.cols = read_number_of(scanner, "columns", 2, kMostPoints);
    scanner.require_line("row 0 of " + name);
  }
  for (std::size_t row = 0; row < net.rows; ++row) {
    if (row > 0) scanner.require_line("row " + std::to_string(row) + " of " + name);
    for (std::size_t col = 0; col < net.cols; ++col) {
      net.points.push_back(scanner.next_point("a coordinate of " + point_name(row, col, name)));
    }
    scanner.end_line();
  }
  return net;
}

/// A 4 x 4 net whose numbers stand on any lines.
ControlNet read_net_by_words(TextScanner& scanner, std::size_t patch) {
  ControlNet net{4, 4, {}};
  for (std::size_t k = 0; k < net.rows * net.cols; ++k) {
    const std::string name = "a coordinate of " + point_name(k / net.cols, k % net.cols,
                                                             "patch " + std::to_string(patch));
    Point3 point{};
    for (double& coordinate : point) {
      scanner.require_word(name);
      coordinate = scanner.next_number(name);
    }
    net.points.push_back(point);
  }
  return net;
}

std::size_t count_words_to_the_end(TextScanner scanner) {
  std::size_t n_words = scanner.count_words();
  while (scanner.next_line())
    n_words += scanner.count_words();
  return n_words;
}

void refuse_more(TextScanner& scanner, const std::string& what) {
  if (scanner.has_word() || scanner.next_line()) {
    scanner.refuse("more numbers than the number of " + what + " at the top; mend the number");
  }
}

std::vector<ControlNet> read_patches(TextScanner scanner, std::size_t n_patches,
                                     ControlNet (*read_net)(TextScanner&, std::size_t)) {
  std::vector<ControlNet> patches;
  for (std::size_t p = 0; p < n_patches; ++p)
    patches.push_back(read_net(scanner, p));
  refuse_more(scanner, "patches");
  return patches;
}

}  // namespace

std::vector<ControlNet> read_bez(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  const Utf8Text text(bytes);
  TextScanner scanner(file, text.view());
  scanner.require_line("the number of patches");
  const std::size_t n_patches = read_number_of(scanner, "patches", 1, kMostPatches);
  const bool has_line_of_its_own = !scanner.has_word();
  const bool may_be_by_words = count_words_to_the_end(scanner) == n_patches * 4 * 4 * 3;
  if (!has_line_of_its_own && !may_be_by_words) scanner.end_line();
  try {
    if (has_line_of_its_own) return read_patches(scanner, n_patches, read_net_by_lines);
  } catch (const UserError&) {
    if (!may_be_by_words) throw;
  }
  return read_patches(scanner, n_patches, read_net_by_words);
}

void write_bez(const std::filesystem::path& file, const std::vector<ControlNet>& patches) {
  std::string text = std::to_string(patches.size()) + "\n";
  for (const ControlNet& net : patches) {
    if (net.rows != 4 || net.cols != 4) {
      text += std::to_string(net.rows) + " " + std::to_string(net.cols) + "\n";
    }
    for (std::size_t row = 0; row < net.rows; ++row) {
      for (std::size_t col = 0; col < net.cols; ++col) {
        append_point(text, net.at(row, col));
        text += col + 1 < net.cols ? "  " : "\n";
      }
    }
  }
  write_file_safely(file, text);
}

std::vector<Point2> read_bzc(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  const Utf8Text text(bytes);
  TextScanner scanner(file, text.view());
  scanner.require_line("the number of control points");
  const std::size_t n_points = read_number_of(scanner, "control points", 2, kMostPoints);
  std::vector<Point2> points;
  for (std::size_t k = 0; k < n_points; ++k) {
    const auto coordinate = [&](const std::string& axis) {
      const std::string name = axis + " of point " + std::to_string(k);
      scanner.require_word(name);
      return scanner.next_number(name);
    };
    const double x = coordinate("x");
    points.push_back({x, coordinate("y")});
  }
  refuse_more(scanner, "control points");
  return points;
}

void write_bzc(const std::filesystem::path& file, const std::vector<Point2>& points) {
  std::string text = std::to_string(points.size()) + "\n";
  for (const Point2& point : points) {
    append_point(text, point);
    text += '\n';
  }
  write_file_safely(file, text);
}

}  // namespace meshgrade
