#include "grader/grade/handle_references.h"

#include <algorithm>
#include <set>

#include "grader/base/text.h"
#include "grader/submission/code_only.h"

namespace meshgrade {
namespace {

/// Fewer wrong pointers than this need no such explanation.
constexpr std::size_t kManyPointers = 3;

/// The word that ends before `end`, with space between; empty if there is none.
std::string word_before(const std::string& line, std::size_t end) {
  while (end > 0 && line[end - 1] == ' ')
    --end;
  std::size_t begin = end;
  while (begin > 0 && is_word_character(line[begin - 1]))
    --begin;
  return line.substr(begin, end - begin);
}

/// True if a name and "=" follow: something is declared and given a value.
bool declares(const std::string& line, std::size_t at) {
  const auto skip = [&](auto is_skipped) {
    const std::size_t begin = at;
    while (at < line.size() && is_skipped(line[at]))
      ++at;
    return at > begin;
  };
  const auto is_space = [](char c) { return c == ' '; };
  skip(is_space);
  if (!skip(is_word_character)) return false;
  skip(is_space);
  return at < line.size() && line[at] == '=' && line.compare(at, 2, "==") != 0;
}

bool reads_pointer(const std::string& line) {
  const auto calls = [&](const char* function) {
    return line.find(function) != std::string::npos;
  };
  return calls("->next()") || calls("->twin()") || calls("->vertex()") || calls("->edge()") ||
         calls("->face()") || calls("->halfedge()");
}

bool has_reference(const std::string& line) {
  static const std::set<std::string> handles{"HalfedgeIter", "HalfedgeCIter", "VertexIter",
                                             "VertexCIter",  "EdgeIter",      "EdgeCIter",
                                             "FaceIter",     "FaceCIter"};
  for (std::size_t at = line.find('&'); at != std::string::npos; at = line.find('&', at + 1)) {
    if (!declares(line, at + 1)) continue;
    const std::string type = word_before(line, at);
    if (handles.count(type) != 0 || (type == "auto" && reads_pointer(line))) return true;
  }
  return false;
}

bool has_many_wrong_pointers(const JudgedExercise& exercise) {
  return std::any_of(exercise.cases.begin(), exercise.cases.end(), [](const JudgedCase& c) {
    const auto& findings = c.judgement.findings;
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
      return finding.pointers.wrong.size() >= kManyPointers;
    });
  });
}

}  // namespace

std::string find_handle_reference(const std::string& source) {
  const std::vector<std::string> lines = split_lines(code_only(source));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!has_reference(lines[i])) continue;
    const std::size_t begin = lines[i].find_first_not_of(" \t");
    const std::string text = lines[i].substr(begin, lines[i].find(';') - begin);
    return "line " + std::to_string(i + 1) + ": " + printable(text);
  }
  return {};
}

void note_handle_references(const Submission& submission,
                            const std::vector<std::string>& functions,
                            JudgedExercise& exercise) {
  if (!has_many_wrong_pointers(exercise)) return;
  for (const SourceFile* file : own_files(submission)) {
    const bool is_its_file =
        std::any_of(functions.begin(), functions.end(), [&](const std::string& function) {
          return file->text.find(function) != std::string::npos;
        });
    const std::string reference =
        is_its_file ? find_handle_reference(file->text) : std::string();
    if (reference.empty()) continue;
    exercise.notes.push_back(
        file->name + ", " + reference +
        ": with the & this is the mesh's own pointer under another name, and changes when that "
        "pointer is set; without the & it keeps its value");
    return;
  }
}

}  // namespace meshgrade
