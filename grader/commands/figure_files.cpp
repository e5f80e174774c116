#include "grader/commands/figure_files.h"

#include <cctype>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/commands/context.h"
#include "grader/report/svg_figure.h"

namespace meshgrade {
namespace {

constexpr std::size_t kLongestName = 100;

/// The id of a case as a plain word: "edge_split:boundary/7" becomes "edge_split_boundary_7".
/// `taken` keeps the words apart.
std::string plain_word(const std::string& case_id, std::set<std::string>& taken) {
  std::string word;
  for (char c : case_id.substr(0, kLongestName)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 && c > 0;
    word += plain || c == '-' ? c : '_';
  }
  std::string unique = word;
  for (int i = 2; !taken.insert(unique).second; ++i)
    unique = word + "-" + std::to_string(i);
  return unique;
}

}  // namespace

FigureFolder::FigureFolder(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::path part = folder; !part.empty() && part != part.parent_path();
       part = part.parent_path()) {
    if (std::filesystem::exists(part, error)) break;
    made_.push_back(part);
  }
  if (folder.empty()) return;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error)) {
    throw UserError(folder.string() + ": cannot be made a folder for the pictures");
  }
}

FigureFolder::~FigureFolder() {
  std::error_code not_empty;
  for (const std::filesystem::path& folder : made_)
    std::filesystem::remove(folder, not_empty);
}

std::size_t write_figures(Report& report, const std::filesystem::path& folder) {
  std::set<std::string> taken;
  std::size_t count = 0;
  for (ExerciseReport& exercise : report.exercises) {
    for (CaseReport& judged : exercise.cases) {
      if (pictured_finding(judged) == nullptr) continue;
      const std::string word = plain_word(judged.id, taken);
      judged.figure = word + ".svg";
      write_file_safely(folder / judged.figure, to_svg(judged, word));
      ++count;
    }
  }
  return count;
}

}  // namespace meshgrade
