// Canvas, "Download Submissions": a flat folder of <name>[_LATE]_<user id>_<file id>_<file>.
// The name is that of the gradebook ("Last, First") in lower case without anything but letters;
// with anonymous grading it is [LATE_]anon_<id>_<file id>_<file>. A text that was typed in ends
// in _text.html, a link in _link.html.

#include <optional>

#include "grader/base/pattern.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

struct CanvasName {
  std::string student;
  std::string id;
  std::string file;
  bool late = false;
};

std::optional<CanvasName> parse_canvas_name(const std::string& name) {
  static const Pattern anonymous("(LATE_)?anon_(LATE_)?([A-Za-z0-9]+)_([0-9]+)_(.+)");
  static const Pattern named("(.*?)(_LATE)?_([0-9]+)_([0-9]+)_(.+)");
  static const Pattern typed("(.*?)(_LATE)?_([0-9]+)_(text|link)\\.html");
  Pattern::Groups found;
  if (anonymous.matches(name, found)) {
    return CanvasName{"anon", found[3], found[5], !found[1].empty() || !found[2].empty()};
  }
  if (named.matches(name, found)) {
    return CanvasName{found[1], found[3], found[5], !found[2].empty()};
  }
  if (typed.matches(name, found)) {
    return CanvasName{found[1], found[3], found[4] + ".html", !found[2].empty()};
  }
  return std::nullopt;
}

bool is_canvas_name(const std::string& name) {
  return parse_canvas_name(name).has_value();
}

bool recognise_canvas(const fs::path& folder) {
  return most_names_match(folder, is_canvas_name);
}

/// Canvas puts -1, -2 before the ending of a file that is handed in again.
std::string without_count(const std::string& file) {
  static const Pattern counted("(.+)-[0-9]{1,3}(\\.[A-Za-z0-9.]+)");
  return counted.replaced(file, "$1$2");
}

/// The count goes where that leaves all names of the hand-in different.
void drop_counts(HandIn& hand_in) {
  for (Part& part : hand_in.parts) {
    const std::string name = without_count(part.name);
    bool taken = false;
    for (const Part& other : hand_in.parts)
      taken = taken || (&other != &part && without_count(other.name) == name);
    if (!taken) part.name = name;
  }
}

void read_canvas(const fs::path& folder, const std::string& /*assignment*/, Roster& roster) {
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    const auto parsed = parse_canvas_name(name);
    if (!parsed || !is_real_file(entry)) {
      roster.left_out.push_back({name, "its name is not one that Canvas gives"});
      continue;
    }
    HandIn& hand_in = find_or_add(roster, parsed->student + "_" + parsed->id,
                                  {parsed->id, parsed->student, ""});
    hand_in.late = hand_in.late || parsed->late;
    hand_in.parts.push_back({entry, parsed->file});
  }
  for (HandIn& hand_in : roster.hand_ins)
    drop_counts(hand_in);
}

}  // namespace

Layout canvas_layout() {
  return {"canvas", "the submissions of a Canvas assignment", recognise_canvas, read_canvas};
}

}  // namespace meshgrade
