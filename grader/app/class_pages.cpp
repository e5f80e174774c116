#include "grader/app/class_pages.h"

#include <map>
#include <nlohmann/json.hpp>

#include "grader/app/context.h"
#include "grader/base/safe_file.h"
#include "grader/batch/result_store.h"
#include "grader/report/html_report.h"

namespace meshgrade {

void write_class_pages(const ClassResults& results, const std::filesystem::path& folder) {
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
  write_file_safely(folder / "class.html", class_to_html(value, links, page));
}

}  // namespace meshgrade
