#include "grader/commands/class_pages.h"

#include <map>
#include <nlohmann/json.hpp>

#include "grader/base/safe_file.h"
#include "grader/batch/result_store.h"
#include "grader/commands/context.h"
#include "grader/report/html_report.h"
#include "grader/similarity/similarity.h"
#include "grader/similarity/similarity_page.h"

namespace meshgrade {
namespace {

constexpr const char* kSimilarPage = "similar.html";
constexpr std::size_t kPairsSideBySide = 20;

}  // namespace

SimilarGroups write_similar_page(const Roster& roster, const Assignment& assignment,
                                 const std::filesystem::path& folder) {
  std::vector<std::string> notes;  // of what cannot be read the results tell as well
  SimilarityOptions how;
  how.rules = assignment.submission;
  const SharedCode code = read_for_comparison(
      roster, find_submission(source_folder() / "student_skeleton", assignment.submission), how,
      notes);
  const std::vector<SimilarPair> pairs = code.pairs(1);
  write_file_safely(folder / kSimilarPage, similarity_page(code, pairs, kPairsSideBySide));
  return groups_of(pairs, kGroupPercent);
}

void write_class_pages(const ClassResults& results, const SimilarGroups& similar,
                       const std::filesystem::path& folder) {
  const std::string page = viewer_page();
  const ResultStore store = result_store(folder);
  std::map<std::string, std::string> links;
  for (const ClassRow& row : results.rows) {
    const Result result = store.load(row.key);
    if (!result.report) continue;
    const std::filesystem::path file = store.folder_of(row.key) / kStudentPage;
    // Graded before without pages: what was kept of that has no picture.
    if (!std::filesystem::exists(file))
      write_file_safely(file, to_html(student_view(*result.report), page));
    links[row.key] = file.lexically_relative(folder).generic_string();
  }
  const auto value = nlohmann::ordered_json::parse(to_json(results));
  const nlohmann::ordered_json alike{
      {"page", kSimilarPage}, {"groups", similar}, {"percent", kGroupPercent}};
  write_file_safely(folder / "class.html", class_to_html(value, links, alike, page));
}

}  // namespace meshgrade
