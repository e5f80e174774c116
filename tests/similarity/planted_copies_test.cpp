// A made class of 200, each with a right solution of their own, and ten of them with a copy of
// somebody's work that was made to look different: the ten pairs stand above all others. And
// solutions that were written apart have less than half in common.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "grader/base/random.h"
#include "grader/base/safe_file.h"
#include "grader/mutants/variants.h"
#include "grader/similarity/similarity.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kSourceFolder = MESHGRADE_SOURCE_DIR;

using Files = std::vector<SourceFile>;

Files files_in(const fs::path& folder) {
  Files files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp")
      files.push_back({entry.path().filename().string(), read_whole_file(entry.path())});
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.name < b.name; });
  return files;
}

Files own_solution(std::uint64_t seed) {
  Files files = files_in(kSourceFolder / "tests" / "mutants" / "textbook");
  for (SourceFile& file : files) {
    Random random(seed, file.name);
    file.text = make_variant(file.text, random);
  }
  return files;
}

Files changed(Files files, const std::function<std::string(const std::string&)>& change) {
  for (SourceFile& file : files)
    file.text = change(file.text);
  return files;
}

/// Every name that is not behind a dot, an arrow or "::" and is no keyword or type.
std::string with_new_names(const std::string& text) {
  static const std::regex name(R"(([^\w.:>]|^)([a-z][a-z_0-9]*)\b(?=\s*[,;=)+*\-\[]))");
  return std::regex_replace(text, name, "$1$2_of_mine");
}

std::string commented(const std::string& text) {
  return std::regex_replace(text, std::regex("\\n"), "  // as I see it\n");
}

std::string squeezed(const std::string& text) {
  return std::regex_replace(std::regex_replace(text, std::regex("\\n +"), "\n"),
                            std::regex(" = "), "   =\n ");
}

/// The text before the namespace's first function, and each function.
std::vector<std::string> pieces(const std::string& text) {
  std::vector<std::string> found;
  std::size_t at = 0;
  for (std::size_t end = text.find("\n}\n"); end != std::string::npos;
       end = text.find("\n}\n", at)) {
    found.push_back(text.substr(at, end + 3 - at));
    at = end + 3;
  }
  found.push_back(text.substr(at));
  return found;
}

std::string reordered(const std::string& text) {
  std::vector<std::string> parts = pieces(text);
  std::reverse(parts.begin(), parts.end());
  std::string all;
  for (const std::string& part : parts)
    all += part;
  return all;
}

Files merged(const Files& files) {
  std::string all;
  for (const SourceFile& file : files)
    all += file.text;
  return {{"homework.cpp", all}};
}

Files split(const Files& files) {
  Files parts;
  for (const SourceFile& file : files) {
    for (const std::string& piece : pieces(file.text))
      parts.push_back({"part" + std::to_string(parts.size()) + ".cpp", piece});
  }
  return parts;
}

Files half(const Files& theirs, const Files& own) {
  Files files = own;
  for (std::size_t i = 0; i < files.size(); i += 2)
    files[i] = theirs[i];
  return files;
}

/// How the ten make a copy of somebody's files look like their own.
std::vector<std::function<Files(const Files&, const Files&)>> disguises() {
  return {
      [](const Files& f, const Files&) { return changed(f, commented); },
      [](const Files& f, const Files&) { return changed(f, with_new_names); },
      [](const Files& f, const Files&) { return changed(f, reordered); },
      [](const Files& f, const Files&) { return split(f); },
      [](const Files& f, const Files&) { return merged(f); },
      [](const Files& f, const Files& own) { return half(f, own); },
      [](const Files& f, const Files&) { return changed(f, squeezed); },
      [](const Files& f, const Files&) {
        return changed(changed(f, with_new_names), reordered);
      },
      [](const Files& f, const Files&) { return merged(changed(f, commented)); },
      [](const Files& f, const Files& own) { return half(changed(f, with_new_names), own); },
  };
}

SharedCode compare(std::vector<HandInText> texts) {
  const Submission skeleton = find_submission(kSourceFolder / "student_skeleton", {});
  return {std::move(texts), skeleton.sources, SimilarityOptions().least_tokens};
}

TEST(PlantedCopies, StandAboveEveryOtherPairOfAClass) {
  constexpr std::size_t kClass = 200;
  std::vector<HandInText> texts;
  for (std::size_t i = 0; i < kClass; ++i)
    texts.push_back({"student" + std::to_string(i), own_solution(i)});
  std::set<std::pair<std::size_t, std::size_t>> planted;
  for (const auto& disguise : disguises()) {
    const std::size_t from = 15 * planted.size();
    const std::size_t to = from + 7;
    texts[to].files = disguise(texts[from].files, texts[to].files);
    planted.insert({from, to});
  }
  const auto pairs = compare(std::move(texts)).pairs(1);
  ASSERT_GT(pairs.size(), planted.size());
  std::set<std::pair<std::size_t, std::size_t>> top;
  for (std::size_t i = 0; i < planted.size(); ++i)
    top.insert({pairs[i].first_at, pairs[i].second_at});
  EXPECT_EQ(top, planted);
  EXPECT_GT(pairs[planted.size() - 1].rank(), pairs[planted.size()].rank());
}

TEST(UnrelatedSolutions, HaveLessThanHalfInCommon) {
  std::vector<HandInText> texts{{"reference", files_in(kSourceFolder / "reference")}};
  for (const char* style : {"textbook", "singles", "turned", "arrays", "floats"})
    texts.push_back({style, files_in(kSourceFolder / "tests" / "mutants" / style)});
  for (const char* year : {"of_2016", "since_2020", "one_point"})
    texts.push_back({year, files_in(kSourceFolder / "tests" / "dropin" / "homework" / year)});
  for (const SimilarPair& pair : compare(std::move(texts)).pairs(1))
    EXPECT_LE(pair.most(), 50) << pair.first << " and " << pair.second;
}

}  // namespace
}  // namespace meshgrade
