// Moodle, "Download all submissions": folders <full name>_<id>_assignsubmission_file[_] (the
// last
// "_" until 4.1), or without folders <full name>_<id>_assignsubmission_file_<file>. A text that
// was typed in is ..._assignsubmission_onlinetext[_]/onlinetext.html. The id is that of the
// grading worksheet, "Participant <id>"; with blind marking the name is "Participant" as well.

#include <algorithm>
#include <optional>

#include "grader/base/pattern.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

struct MoodleName {
  std::string student;
  std::string id;
  std::string file;  ///< empty for a folder
};

std::optional<MoodleName> parse_moodle_name(const std::string& name) {
  const std::string mark = "_assignsubmission_";
  const std::size_t at = name.rfind(mark);
  if (at == std::string::npos) return std::nullopt;
  static const Pattern person("(.*)_([0-9]+)");
  static const Pattern kind("(file|onlinetext)(_(.*))?");
  const std::string before = name.substr(0, at);
  const std::string after = name.substr(at + mark.size());
  Pattern::Groups who;
  Pattern::Groups what;
  if (!person.matches(before, who) || !kind.matches(after, what)) {
    return std::nullopt;
  }
  MoodleName parsed{who[1], who[2], what[3]};
  std::replace(parsed.student.begin(), parsed.student.end(), '_', ' ');
  return parsed;
}

bool is_moodle_name(const std::string& name) {
  return parse_moodle_name(name).has_value();
}

bool recognise_moodle(const fs::path& folder) {
  return most_names_match(folder, is_moodle_name);
}

void read_moodle(const fs::path& folder, const std::string& /*assignment*/, Roster& roster) {
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    const auto parsed = parse_moodle_name(name);
    if (!parsed) {
      roster.left_out.push_back({name, "its name is not one that Moodle gives"});
      continue;
    }
    HandIn& hand_in = find_or_add(roster, parsed->student + "_" + parsed->id,
                                  {parsed->id, parsed->student, ""});
    if (is_real_folder(entry)) {
      for (const fs::path& part : entries_of(entry))
        hand_in.parts.push_back({part, part.filename().string()});
    } else {
      hand_in.parts.push_back({entry, parsed->file.empty() ? name : parsed->file});
    }
  }
}

}  // namespace

Layout moodle_layout() {
  return {"moodle", "the submissions of a Moodle assignment", recognise_moodle, read_moodle};
}

}  // namespace meshgrade
