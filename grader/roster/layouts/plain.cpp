#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"
#include "grader/submission/archive.h"
#include "grader/submission/submission.h"

// A folder in which each folder, archive or C++ file is somebody's work, named after them.

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// "bob" for bob.cpp and bob.tar.gz.
std::string without_ending(const fs::path& file) {
  const fs::path stem = file.stem();
  return (stem.extension() == ".tar" ? stem.stem() : stem).string();
}

bool recognise_plain(const fs::path& /*folder*/) {
  return true;
}

void read_plain(const fs::path& folder, const std::string& /*assignment*/, Roster& roster) {
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    if (is_real_folder(entry)) {
      roster.hand_ins.push_back({name, {{name, "", ""}}, {{entry, name}}, "", false});
    } else if (is_real_file(entry) && (is_source_name(name) || is_archive_name(name))) {
      const std::string id = without_ending(entry.filename());
      roster.hand_ins.push_back({id, {{id, "", ""}}, {{entry, name}}, "", false});
    } else {
      roster.left_out.push_back({name, "neither a folder nor an archive nor a C++ file"});
    }
  }
}

}  // namespace

Layout plain_layout() {
  return {"plain", "a folder, archive or file for each student", recognise_plain, read_plain};
}

}  // namespace meshgrade
