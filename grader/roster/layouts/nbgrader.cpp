// nbgrader: submitted/<student>/<assignment>/, with the time in timestamp.txt.

#include <fstream>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

fs::path submitted_in(const fs::path& folder) {
  return folder.filename() == "submitted" ? folder : folder / "submitted";
}

bool recognise_nbgrader(const fs::path& folder) {
  return is_real_folder(submitted_in(folder));
}

/// The one assignment that there is.
std::string only_assignment(const fs::path& submitted) {
  std::set<std::string> names;
  for (const fs::path& student : entries_of(submitted)) {
    if (!is_real_folder(student)) continue;
    for (const fs::path& entry : entries_of(student)) {
      if (is_real_folder(entry)) names.insert(entry.filename().string());
    }
  }
  if (names.size() == 1) return *names.begin();
  throw UserError(submitted.string() + ": there " +
                  (names.empty() ? "is no assignment here"
                                 : "are several assignments here: " +
                                       printable(join({names.begin(), names.end()}, ", ")) +
                                       "; choose one with --part"));
}

std::string timestamp_in(const fs::path& folder) {
  std::string line;
  if (is_real_file(folder / "timestamp.txt")) {
    std::ifstream stream(folder / "timestamp.txt");
    std::getline(stream, line);
  }
  return printable(line.substr(0, 100));
}

void read_nbgrader(const fs::path& folder, const std::string& assignment, Roster& roster) {
  const fs::path submitted = submitted_in(folder);
  const std::string name = assignment.empty() ? only_assignment(submitted) : assignment;
  for (const fs::path& student : entries_of(submitted)) {
    const std::string id = student.filename().string();
    if (is_real_folder(student / name)) {
      roster.hand_ins.push_back(
          {id, {{id, "", ""}}, {{student / name, name}}, timestamp_in(student / name), false});
    } else {
      roster.left_out.push_back({id, "has nothing for the assignment " + printable(name)});
    }
  }
}

}  // namespace

Layout nbgrader_layout() {
  return {"nbgrader", "the folder of an nbgrader course", recognise_nbgrader, read_nbgrader};
}

}  // namespace meshgrade
