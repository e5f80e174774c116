#include "grader/files/bezier_file.h"

#include <charconv>
#include <string>

#include "grader/base/safe_file.h"
#include "grader/files/file_bytes.h"
#include "grader/files/text_scanner.h"

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

std::size_t read_count(TextScanner& scanner, const std::string& what, std::uint32_t least,
                       std::uint32_t most) {
  const std::uint32_t count = scanner.next_index("the number of " + what);
  if (count < least || count > most) {
    scanner.refuse(std::to_string(count) + " " + what + "; give " + std::to_string(least) +
                   " to " + std::to_string(most));
  }
  return count;
}

std::size_t words_on_line(TextScanner ahead) {
  std::size_t n_words = 0;
  while (!ahead.next_word().empty())
    ++n_words;
  return n_words;
}

ControlNet read_net(TextScanner& scanner, std::size_t patch) {
  const std::string name = "patch " + std::to_string(patch);
  ControlNet net{4, 4, {}};
  scanner.require_line(name);
  if (words_on_line(scanner) == 2) {
    net.rows = read_count(scanner, "rows", 2, kMostPoints);
    net.cols = read_count(scanner, "columns", 2, kMostPoints);
    scanner.require_line("row 0 of " + name);
  }
  for (std::size_t row = 0; row < net.rows; ++row) {
    if (row > 0) scanner.require_line("row " + std::to_string(row) + " of " + name);
    for (std::size_t col = 0; col < net.cols; ++col) {
      net.points.push_back(scanner.next_point("a coordinate of point " + std::to_string(col) +
                                              " in row " + std::to_string(row) + " of " +
                                              name));
    }
    scanner.end_line();
  }
  return net;
}

void refuse_more(TextScanner& scanner, const std::string& what) {
  if (scanner.next_line()) {
    scanner.refuse("more lines than the number of " + what + " at the top; mend the number");
  }
}

}  // namespace

std::vector<ControlNet> read_bez(const std::filesystem::path& file) {
  const std::string text = read_bytes(file);
  TextScanner scanner(file, text);
  scanner.require_line("the number of patches");
  const std::size_t n_patches = read_count(scanner, "patches", 1, kMostPatches);
  scanner.end_line();
  std::vector<ControlNet> patches;
  for (std::size_t p = 0; p < n_patches; ++p)
    patches.push_back(read_net(scanner, p));
  refuse_more(scanner, "patches");
  return patches;
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
  const std::string text = read_bytes(file);
  TextScanner scanner(file, text);
  scanner.require_line("the number of control points");
  const std::size_t n_points = read_count(scanner, "control points", 2, kMostPoints);
  scanner.end_line();
  std::vector<Point2> points;
  for (std::size_t k = 0; k < n_points; ++k) {
    const std::string name = "point " + std::to_string(k);
    scanner.require_line(name);
    const double x = scanner.next_number("x of " + name);
    const double y = scanner.next_number("y of " + name);
    points.push_back({x, y});
    scanner.end_line();
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
