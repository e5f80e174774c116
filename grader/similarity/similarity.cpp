#include "grader/similarity/similarity.h"

#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/submission/course_files.h"

namespace meshgrade {
namespace {

std::string without_space(const std::string& line) {
  std::string text;
  for (char c : line) {
    if (c != ' ' && c != '\t' && c != '\r') text += c;
  }
  return text;
}

/// Lines too short to be anybody's, as "}", stay: without them nothing fits together.
std::set<std::string> lines_of(const Submission& skeleton) {
  constexpr std::size_t kTelling = 4;
  std::set<std::string> lines;
  for (const auto* files : {&skeleton.sources, &skeleton.headers}) {
    for (const SourceFile& file : *files) {
      for (const std::string& line : split_lines(file.text)) {
        const std::string text = without_space(line);
        if (text.size() >= kTelling) lines.insert(text);
      }
    }
  }
  return lines;
}

/// The text with blanks in place of lines that are known.
std::string blank(std::string text, const std::set<std::string>& known) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (known.count(without_space(text.substr(begin, end - begin))) != 0)
      text.replace(begin, end - begin, end - begin, ' ');
    begin = end + 1;
  }
  return text;
}

std::vector<SourceFile> files_of(const Submission& submission) {
  std::vector<SourceFile> files = submission.sources;
  files.insert(files.end(), submission.headers.begin(), submission.headers.end());
  return files;
}

}  // namespace

SharedCode read_for_comparison(const Roster& roster, const Submission& skeleton,
                               const SimilarityOptions& options,
                               std::vector<std::string>& notes) {
  const std::set<std::string> known = lines_of(skeleton);
  std::vector<HandInText> texts;
  for (const HandIn& hand_in : roster.hand_ins) {
    try {
      HandInText text{hand_in.key, {}};
      for (const SourceFile& file : files_of(take_submission(hand_in, options.rules))) {
        if (!is_as_handed_out(file)) text.files.push_back({file.name, blank(file.text, known)});
      }
      texts.push_back(std::move(text));
    } catch (const UserError& error) {
      notes.push_back(hand_in.key + " is not compared: " + error.what());
    }
  }
  return {std::move(texts), files_of(skeleton), options.least_tokens};
}

std::string without_skeleton(std::string text, const Submission& skeleton) {
  return blank(std::move(text), lines_of(skeleton));
}

}  // namespace meshgrade
