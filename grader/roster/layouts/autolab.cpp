// Autolab, "Download all submissions": a flat folder of <email>_<version>_<file>. The file with
// the highest version counts; annotated_... are copies with a grader's remarks.

#include <algorithm>
#include <map>
#include <optional>

#include "grader/base/pattern.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

struct AutolabName {
  std::string email;
  int version = 0;
  std::string file;
};

std::optional<AutolabName> parse_autolab_name(const std::string& name) {
  // An address may hold "_" before the "@", and none after it.
  static const Pattern form("(.+@[^_@]+)_([0-9]{1,8})_(.+)");
  Pattern::Groups found;
  if (name.rfind("annotated_", 0) == 0 || !form.matches(name, found)) {
    return std::nullopt;
  }
  return AutolabName{found[1], std::stoi(found[2]), found[3]};
}

bool is_autolab_name(const std::string& name) {
  return parse_autolab_name(name).has_value();
}

bool recognise_autolab(const fs::path& folder) {
  return most_names_match(folder, is_autolab_name);
}

void read_autolab(const fs::path& folder, const std::string& /*assignment*/, Roster& roster) {
  std::map<std::string, int> last;
  for (const fs::path& entry : entries_of(folder)) {
    const auto parsed = parse_autolab_name(entry.filename().string());
    if (parsed) last[parsed->email] = std::max(last[parsed->email], parsed->version);
  }
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    const auto parsed = parse_autolab_name(name);
    if (!parsed || !is_real_file(entry)) {
      roster.left_out.push_back({name, name.rfind("annotated_", 0) == 0
                                           ? "a copy with remarks"
                                           : "its name is not one that Autolab gives"});
    } else if (parsed->version != last[parsed->email]) {
      roster.left_out.push_back({name, "there is a later version"});
    } else {
      HandIn& hand_in = find_or_add(roster, parsed->email, {parsed->email, "", parsed->email});
      hand_in.parts.push_back({entry, parsed->file});
    }
  }
}

}  // namespace

Layout autolab_layout() {
  return {"autolab", "the submissions of an Autolab assessment", recognise_autolab,
          read_autolab};
}

}  // namespace meshgrade
