#include "grader/view/picture_request.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/text.h"

namespace meshgrade {
namespace {

constexpr int kLeastSide = 64;
constexpr int kMostSide = 4096;

/// The whole text as a number.
template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::vector<std::string> split_at(const std::string& text, char mark) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == mark) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

[[noreturn]] void refuse_step(std::size_t number, const std::vector<std::string>& words,
                              const std::string& why) {
  throw UserError("--steps: step " + std::to_string(number) + ", \"" +
                  printable(join(words, " ")) + "\", " + why +
                  "; for example --steps \"flip e3, split e5, subdivide 2\"");
}

/// The number in "e3".
std::optional<Ref> edge_of(const std::string& word) {
  if (word.size() < 2 || word[0] != 'e') return std::nullopt;
  const std::optional<Ref> edge = number_of<Ref>(word.substr(1));
  return edge && *edge < kBoundaryBit ? edge : std::nullopt;
}

void add_step(std::size_t number, const std::vector<std::string>& words,
              std::vector<ViewOperation>& steps) {
  if (words.empty()) refuse_step(number, words, "is empty");
  if (words[0] == "subdivide") {
    const auto times = words.size() == 1 ? 1 : number_of<std::size_t>(words[1]);
    if (words.size() > 2 || !times || *times == 0 || *times > kMostSubdivisions) {
      refuse_step(number, words,
                  "must say how often: \"subdivide\" or a number up to " +
                      plural(kMostSubdivisions, "time"));
    }
    steps.insert(steps.end(), *times, {ViewKind::kSubdivide, kUnsetRef});
    return;
  }
  if (words[0] != "flip" && words[0] != "split") {
    refuse_step(number, words, "is not one of flip, split and subdivide");
  }
  const std::optional<Ref> edge = words.size() == 2 ? edge_of(words[1]) : std::nullopt;
  if (!edge) refuse_step(number, words, "must name one edge, as e3");
  steps.push_back({words[0] == "flip" ? ViewKind::kFlip : ViewKind::kSplit, *edge});
}

}  // namespace

std::vector<ViewOperation> parse_steps(const std::string& text) {
  std::vector<ViewOperation> steps;
  std::size_t number = 0;
  for (const std::string& part : split_at(text, ','))
    add_step(++number, words_of(part), steps);
  const auto subdivisions = static_cast<std::size_t>(std::count_if(
      steps.begin(), steps.end(),
      [](const ViewOperation& operation) { return operation.kind == ViewKind::kSubdivide; }));
  if (subdivisions > kMostSubdivisions || steps.size() > kMostSteps) {
    throw UserError("--steps: at most " + std::to_string(kMostSteps) + " steps, and at most " +
                    std::to_string(kMostSubdivisions) +
                    " subdivisions among them: each makes four triangles of one");
  }
  return steps;
}

Camera parse_camera(const std::string& text) {
  const std::vector<std::string> parts = split_at(text, ',');
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const std::optional<double> number = number_of<double>(join(words_of(part), " "));
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  Camera camera;
  const bool whole = numbers.size() == parts.size() && (parts.size() == 2 || parts.size() == 3);
  if (whole) {
    camera.azimuth = numbers[0];
    camera.elevation = numbers[1];
    if (numbers.size() == 3) camera.distance = numbers[2];
  }
  if (!whole || std::fabs(camera.azimuth) > 360.0 || std::fabs(camera.elevation) > 90.0 ||
      camera.distance < 1.1 || camera.distance > 50.0) {
    throw UserError("--camera: \"" + printable(text) +
                    "\" is not azimuth,elevation[,distance]: degrees from -360 to 360, degrees "
                    "from -90 to 90, and 1.1 to 50 times half the mesh's diagonal; for example "
                    "--camera 45,30 or --camera 45,30,4");
  }
  return camera;
}

PictureSize parse_size(const std::string& text) {
  const std::vector<std::string> parts = split_at(text, 'x');
  const auto side = [&](std::size_t i) {
    const std::optional<int> number =
        i < parts.size() ? number_of<int>(parts[i]) : std::nullopt;
    return number && *number >= kLeastSide && *number <= kMostSide ? *number : 0;
  };
  const PictureSize size{side(0), side(1)};
  if (parts.size() != 2 || size.width == 0 || size.height == 0) {
    throw UserError("--size: \"" + printable(text) + "\" is not WIDTHxHEIGHT, " +
                    std::to_string(kLeastSide) + " to " + std::to_string(kMostSide) +
                    " pixels each; for example --size 960x720");
  }
  return size;
}

}  // namespace meshgrade
