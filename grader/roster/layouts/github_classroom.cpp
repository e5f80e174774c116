// GitHub Classroom, `gh classroom clone student-repos`: a folder <assignment>-submissions with
// a repository for each student or team, mostly called <assignment>-<user>. A grades.csv beside
// them (`gh classroom assignment-grades`) tells more.

#include <map>

#include "grader/base/csv.h"
#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGrades = "grades.csv";

/// "flip" for flip-submissions; empty for other names.
std::string slug_of(const fs::path& folder) {
  const std::string ending = "-submissions";
  const std::string name = folder.filename().string();
  if (name.size() <= ending.size() || name.substr(name.size() - ending.size()) != ending) {
    return {};
  }
  return name.substr(0, name.size() - ending.size());
}

bool recognise_github_classroom(const fs::path& folder) {
  std::size_t repositories = 0;
  std::size_t folders = 0;
  const std::string slug = slug_of(folder);
  for (const fs::path& entry : entries_of(folder)) {
    if (!is_real_folder(entry)) continue;
    const std::string name = entry.filename().string();
    ++folders;
    const bool cloned = fs::exists(fs::symlink_status(entry / ".git"));
    repositories += cloned || (!slug.empty() && name.rfind(slug + "-", 0) == 0) ? 1 : 0;
  }
  return repositories > 0 && 2 * repositories >= folders;
}

struct Listed {
  Person person;
  std::string submitted_at;
};

/// The rows of grades.csv by the name of the repository.
std::multimap<std::string, Listed> read_grades(const fs::path& file) {
  std::multimap<std::string, Listed> all;
  const std::vector<CsvRecord> records = read_csv(read_whole_file(file));
  if (records.empty()) return all;
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < records[0].size(); ++i)
    columns[records[0][i].text] = i;
  const auto field = [&](const CsvRecord& record, const char* name) {
    const auto column = columns.find(name);
    if (column == columns.end() || column->second >= record.size()) return std::string();
    return record[column->second].text;
  };
  for (std::size_t i = 1; i < records.size(); ++i) {
    const std::string user = field(records[i], "github_username");
    if (user.empty()) continue;
    all.insert({field(records[i], "student_repository_name"),
                {{user, field(records[i], "roster_identifier"), ""},
                 field(records[i], "submission_timestamp")}});
  }
  return all;
}

void read_github_classroom(const fs::path& folder, const std::string& /*assignment*/,
                           Roster& roster) {
  std::multimap<std::string, Listed> grades;
  if (is_real_file(folder / kGrades)) grades = read_grades(folder / kGrades);
  const std::string start = slug_of(folder) + "-";
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    if (name == kGrades) continue;
    if (!is_real_folder(entry)) {
      roster.left_out.push_back({name, "not a repository"});
      continue;
    }
    HandIn hand_in{name, {}, {{entry, name}}, "", false};
    const auto rows = grades.equal_range(name);
    for (auto row = rows.first; row != rows.second; ++row) {
      hand_in.people.push_back(row->second.person);
      hand_in.submitted_at = row->second.submitted_at;
    }
    if (hand_in.people.empty()) {
      const bool named = start.size() > 1 && name.rfind(start, 0) == 0;
      hand_in.people.push_back({named ? name.substr(start.size()) : name, "", ""});
    }
    roster.hand_ins.push_back(std::move(hand_in));
  }
}

}  // namespace

Layout github_classroom_layout() {
  return {"github-classroom", "the repositories of a GitHub Classroom assignment",
          recognise_github_classroom, read_github_classroom};
}

}  // namespace meshgrade
