#include "grader/roster/roster.h"

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>

#include "grader/base/digest.h"
#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/roster/layouts/layouts.h"
#include "grader/roster/listing.h"
#include "grader/submission/archive.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const Layout& find_layout(const std::string& name) {
  std::vector<std::string> names;
  for (const Layout& layout : layouts()) {
    if (layout.name == name) return layout;
    names.emplace_back(layout.name);
  }
  throw UserError("there is no layout \"" + name + "\"; there are " + join(names, ", "));
}

/// The folder that is alone in a folder, as archives often have it.
std::optional<fs::path> only_folder_in(const fs::path& folder) {
  const std::vector<fs::path> entries = entries_of(folder);
  if (entries.size() != 1 || !is_real_folder(entries[0])) return std::nullopt;
  return entries[0];
}

/// Of a plain folder nobody can tell a class from a single student, but several folders or
/// archives without a C++ file beside them are a class.
bool looks_like_a_class(const fs::path& folder) {
  std::size_t hand_ins = 0;
  for (const fs::path& entry : entries_of(folder)) {
    if (is_source_name(entry)) return false;
    hand_ins += is_real_folder(entry) || is_archive_name(entry) ? 1 : 0;
  }
  return hand_ins > 1;
}

struct Place {
  const Layout* layout;
  fs::path folder;
};

/// Which layout it is, and in which folder: this one, or the only one within.
Place find_place(const fs::path& folder, const std::string& name) {
  const std::optional<fs::path> inner = only_folder_in(folder);
  for (const Layout& layout : layouts()) {
    if (!name.empty() && &layout != &find_layout(name)) continue;
    if (&layout == &layouts().back()) break;
    if (layout.recognise(folder)) return {&layout, folder};
    if (inner && layout.recognise(*inner)) return {&layout, *inner};
  }
  const Layout& layout = name.empty() ? layouts().back() : find_layout(name);
  return {&layout, inner && looks_like_a_class(*inner) ? *inner : folder};
}

/// Two hand-ins of one key get a number each: nobody's work is lost.
void make_keys_unique(std::vector<HandIn>& hand_ins) {
  std::set<std::string> taken;
  for (HandIn& hand_in : hand_ins) {
    const std::string key = printable(hand_in.key.empty() ? "unnamed" : hand_in.key);
    hand_in.key = key;
    for (int i = 2; !taken.insert(hand_in.key).second; ++i)
      hand_in.key = key + " (" + std::to_string(i) + ")";
    if (hand_in.people.empty()) hand_in.people.push_back({hand_in.key, "", ""});
  }
}

void copy_parts(const HandIn& hand_in, const fs::path& folder) {
  for (const Part& part : hand_in.parts) {
    std::error_code error;
    fs::path name = fs::path(part.name).filename();
    if (name.empty() || name == "." || name == "..") name = "unnamed";
    while (fs::exists(folder / name, error))
      name = "again_" + name.string();
    fs::copy(part.path, folder / name,
             fs::copy_options::recursive | fs::copy_options::copy_symlinks, error);
    if (error) {
      throw GraderError(part.path.string() + ": cannot be copied: " + error.message());
    }
  }
}

}  // namespace

bool is_noise(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.empty() || name[0] == '.' || name == "__MACOSX" || name == "Thumbs.db" ||
         name == "desktop.ini";
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (!is_noise(it->path()) && !it->is_symlink(error)) entries.push_back(it->path());
  }
  if (error) throw UserError(folder.string() + ": cannot be read: " + error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_real_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(path, error));
}

bool is_real_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(path, error));
}

HandIn& find_or_add(Roster& roster, const std::string& key, const Person& person) {
  for (HandIn& hand_in : roster.hand_ins) {
    if (hand_in.key == key) return hand_in;
  }
  roster.hand_ins.push_back({key, {person}, {}, "", false});
  return roster.hand_ins.back();
}

bool most_names_match(const fs::path& folder, bool (*matches)(const std::string& name)) {
  std::size_t matching = 0;
  const std::vector<fs::path> entries = entries_of(folder);
  for (const fs::path& entry : entries)
    matching += matches(entry.filename().string()) ? 1 : 0;
  return matching > 0 && 2 * matching >= entries.size();
}

const std::vector<Layout>& layouts() {
  static const std::vector<Layout> all{
      gradescope_layout(), moodle_layout(),           autolab_layout(), canvas_layout(),
      nbgrader_layout(),   github_classroom_layout(), plain_layout()};
  return all;
}

Roster read_roster(const fs::path& folder, const RosterOptions& options) {
  if (!fs::is_directory(folder)) {
    throw UserError(folder.string() + (fs::exists(folder)
                                           ? ": is neither a folder nor an archive"
                                           : ": there is no such folder"));
  }
  const Place place = find_place(folder, options.layout);
  Roster roster;
  roster.layout = place.layout->name;
  place.layout->read(place.folder, options.assignment, roster);
  std::stable_sort(roster.hand_ins.begin(), roster.hand_ins.end(),
                   [](const HandIn& a, const HandIn& b) { return a.key < b.key; });
  make_keys_unique(roster.hand_ins);
  for (Omission& left : roster.left_out)
    left.what = printable(left.what);
  if (roster.hand_ins.empty()) {
    throw UserError(folder.string() + ": nothing was handed in here, read as layout \"" +
                    roster.layout + "\"" +
                    (roster.left_out.empty() ? ""
                                             : "; for example, " + roster.left_out[0].what +
                                                   " is left out: " + roster.left_out[0].why));
  }
  return roster;
}

Submission take_submission(const HandIn& hand_in, const SubmissionRules& rules) {
  if (hand_in.parts.empty()) throw UserError("nothing was handed in");
  const Part& first = hand_in.parts[0];
  const bool as_it_is = hand_in.parts.size() == 1 && first.path.filename() == first.name;
  std::optional<ScratchFolder> copies;
  if (!as_it_is) copy_parts(hand_in, copies.emplace().path());
  const fs::path& path = as_it_is ? first.path : copies->path();
  try {
    Submission submission = find_submission(path, rules);
    submission.name = hand_in.key;
    return submission;
  } catch (const UserError& error) {
    // Students read it: where it lies here is not for them.
    const std::string message = error.what();
    const std::string prefix = path.string() + ": ";
    throw UserError(message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message);
  }
}

std::string safe_file_name(const std::string& key) {
  constexpr std::size_t kLongest = 80;
  std::string name;
  for (char c : key) {
    const bool safe = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                      std::string("._-@").find(c) != std::string::npos;
    name += safe ? c : '_';
  }
  const bool is_plain = name == key && name.size() <= kLongest && !name.empty() &&
                        name[0] != '.' && name[0] != '-' && name.back() != '.';
  if (is_plain) return name;
  // No plain name has a tilde: the two kinds cannot meet.
  name = name.substr(0, kLongest - 20);
  if (!name.empty() && (name[0] == '.' || name[0] == '-')) name[0] = '_';
  return name + "~" + sha256(key).substr(0, 16);
}

}  // namespace meshgrade
