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

/// "flip e3, split e5, subdivide 2"
std::string example_of(const std::vector<ViewVerb>& verbs) {
  std::vector<std::string> steps;
  for (const ViewVerb& verb : verbs) {
    if (verb.picked == 1 && steps.size() < 2)
      steps.push_back(verb.word + " " + element_name(verb.picks, steps.empty() ? 3 : 5));
  }
  const auto whole = std::find_if(verbs.begin(), verbs.end(),
                                  [](const ViewVerb& verb) { return verb.subdivides; });
  if (whole != verbs.end()) steps.push_back(whole->word + " 2");
  return join(steps, ", ");
}

/// "flip, split and subdivide": each word once.
std::string list_of_words(const std::vector<ViewVerb>& verbs) {
  std::vector<std::string> words;
  for (const ViewVerb& verb : verbs) {
    if (std::find(words.begin(), words.end(), verb.word) == words.end())
      words.push_back(verb.word);
  }
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : join(words, ", ") + " and " + last;
}

/// An element by its name, "e3".
struct Named {
  ElementKind kind;
  Ref number;
};

std::optional<Named> element_of(const std::string& word) {
  if (word.size() < 2) return {};
  const std::optional<Ref> number = number_of<Ref>(word.substr(1));
  if (!number || *number >= kBoundaryBit) return {};
  if (word[0] == 'v') return Named{ElementKind::kVertex, *number};
  if (word[0] == 'e') return Named{ElementKind::kEdge, *number};
  if (word[0] == 'f') return Named{ElementKind::kFace, *number};
  return {};
}

/// Reads one step after the other.
class StepReader {
 public:
  explicit StepReader(const std::vector<ViewVerb>& verbs) : verbs_(verbs) {}

  std::vector<ViewOperation> read(const std::string& text) {
    for (const std::string& part : split_at(text, ',')) {
      words_ = words_of(part);
      ++number_;
      add_step();
    }
    return std::move(steps_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw UserError("--steps: step " + std::to_string(number_) + ", \"" +
                    printable(join(words_, " ")) + "\", " + why + "; for example --steps \"" +
                    example_of(verbs_) + "\"");
  }

  void add_step() {
    if (words_.empty()) refuse("is empty");
    const auto same = [&](const ViewVerb& verb) { return verb.word == words_[0]; };
    const auto first = std::find_if(verbs_.begin(), verbs_.end(), same);
    if (first == verbs_.end()) refuse("is not one of " + list_of_words(verbs_));
    first->picked == 0 ? add_whole(*first) : add_picked(*first);
  }

  void add_whole(const ViewVerb& verb) {
    const auto times = words_.size() == 1 ? 1 : number_of<std::size_t>(words_[1]);
    if (words_.size() > 2 || !times || *times == 0 || *times > kMostSubdivisions) {
      refuse("must say how often: \"" + verb.word + "\" or a number up to " +
             plural(kMostSubdivisions, "time"));
    }
    steps_.insert(steps_.end(), *times, {verb.exercise, verb.picks, {}});
  }

  void add_picked(const ViewVerb& first) {
    std::vector<Named> named;
    for (std::size_t i = 1; i < words_.size(); ++i) {
      const std::optional<Named> element = element_of(words_[i]);
      if (element) named.push_back(*element);
    }
    const ViewVerb* verb =
        named.empty() ? nullptr : find_verb(verbs_, first.word, named[0].kind);
    if (verb == nullptr || named.size() + 1 != words_.size() || named.size() != verb->picked ||
        named.back().kind != verb->picks)
      refuse(must_name(first));
    ViewOperation operation{verb->exercise, verb->picks, {}};
    for (const Named& element : named)
      operation.picked.push_back(element.number);
    steps_.push_back(std::move(operation));
  }

  /// "must name one edge, as e3"
  std::string must_name(const ViewVerb& verb) const {
    const std::string kinds = picked_by_word(verbs_, verb.word);
    const std::string example = element_name(verb.picks, 3);
    if (verb.picked == 1) return "must name one " + kinds + ", as " + example;
    const std::string several = kinds == "vertex" ? "vertices" : kinds + "s";
    return "must name two " + several + ", as " + example + " " + element_name(verb.picks, 7);
  }

  const std::vector<ViewVerb>& verbs_;
  std::vector<std::string> words_;
  std::size_t number_ = 0;
  std::vector<ViewOperation> steps_;
};

}  // namespace

std::vector<ViewOperation> parse_steps(const std::string& text,
                                       const std::vector<ViewVerb>& verbs) {
  std::vector<ViewOperation> steps = StepReader(verbs).read(text);
  const auto subdivisions =
      static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), subdivides));
  if (subdivisions > kMostSubdivisions || steps.size() > kMostSteps) {
    throw UserError("--steps: at most " + std::to_string(kMostSteps) + " steps, and at most " +
                    std::to_string(kMostSubdivisions) +
                    " subdivisions among them: each makes four faces of one");
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
