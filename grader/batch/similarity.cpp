#include "grader/batch/similarity.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/submission/course_files.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTool = "sim_c++";

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

std::string strip(const std::string& text, const std::set<std::string>& known) {
  std::string rest;
  for (const std::string& line : split_lines(text)) {
    if (known.count(without_space(line)) == 0) rest += line + "\n";
  }
  return rest;
}

/// Writes the text of each hand-in to a file named by its number. @return the list for the tool
std::string write_texts(const Roster& roster, const Submission& skeleton,
                        const SimilarityOptions& options, const fs::path& folder,
                        std::vector<std::string>& notes) {
  const std::set<std::string> known = lines_of(skeleton);
  std::string list;
  for (std::size_t i = 0; i < roster.hand_ins.size(); ++i) {
    std::string text;
    try {
      const Submission submission = take_submission(roster.hand_ins[i], options.rules);
      for (const auto* files : {&submission.sources, &submission.headers}) {
        for (const SourceFile& file : *files) {
          if (!is_as_handed_out(file)) text += strip(file.text, known);
        }
      }
    } catch (const UserError& error) {
      notes.push_back(roster.hand_ins[i].key + " is not compared: " + error.what());
      continue;
    }
    const std::string name = std::to_string(i) + ".cpp";
    write_file_safely(folder / name, text);
    list += name + "\n";
  }
  return list;
}

std::string run_tool(const SimilarityOptions& options, const fs::path& folder,
                     const std::string& list) {
  Command command;
  command.arguments = {kTool,
                       "-p",
                       "-e",
                       "-a",
                       "-s",
                       "-T",
                       "-r" + std::to_string(options.least_tokens),
                       "-t" + std::to_string(std::max(1, options.least_percent)),
                       "-i"};
  command.folder = folder;
  command.input = list;
  command.kept_output = std::size_t{1} << 28U;
  command.time_limit = std::chrono::hours(1);
  ProcessResult result;
  try {
    result = run_process(command);
  } catch (const GraderError&) {
    throw UserError(
        "comparing takes the program sim_c++, which is not installed: it is in the "
        "package similarity-tester of Debian 12 and of Debian testing; Debian 13 "
        "does not have it");
  }
  if (!result.ok()) {
    throw GraderError(std::string(kTool) +
                      " failed: " + printable(result.output.substr(0, 500)));
  }
  return result.output;
}

}  // namespace

std::string without_skeleton(const std::string& text, const Submission& skeleton) {
  return strip(text, lines_of(skeleton));
}

std::vector<SimilarPair> find_similar(const Roster& roster, const Submission& skeleton,
                                      const SimilarityOptions& options,
                                      std::vector<std::string>& notes) {
  const ScratchFolder folder;
  const std::string list = write_texts(roster, skeleton, options, folder.path(), notes);
  static const std::regex form("([0-9]+)\\.cpp consists for ([0-9]+) % of ([0-9]+)\\.cpp.*");
  std::map<std::pair<std::size_t, std::size_t>, SimilarPair> pairs;
  for (const std::string& line : split_lines(run_tool(options, folder.path(), list))) {
    std::smatch found;
    if (!std::regex_match(line, found, form)) continue;
    const std::size_t a = std::stoul(found[1]);
    const std::size_t b = std::stoul(found[3]);
    const auto [low, high] = std::minmax(a, b);
    SimilarPair& pair = pairs[{low, high}];
    pair.first = roster.hand_ins.at(low).key;
    pair.second = roster.hand_ins.at(high).key;
    (a == low ? pair.of_first : pair.of_second) = std::stoi(found[2]);
  }
  std::vector<SimilarPair> sorted;
  for (const auto& [numbers, pair] : pairs)
    sorted.push_back(pair);
  std::stable_sort(
      sorted.begin(), sorted.end(),
      [](const SimilarPair& a, const SimilarPair& b) { return a.most() > b.most(); });
  return sorted;
}

}  // namespace meshgrade
