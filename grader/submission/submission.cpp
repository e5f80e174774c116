#include "grader/submission/submission.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/submission/archive.h"
#include "grader/submission/dialect.h"
#include "grader/submission/scotty3d_files.h"
#include "grader/submission/text_encoding.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

bool has_ending(const fs::path& file, const std::set<std::string>& endings) {
  return endings.count(file.extension().string()) != 0;
}

std::vector<fs::path> list(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    entries.push_back(it->path());
  }
  if (error) throw UserError(folder.string() + ": cannot be read: " + error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_hidden(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.empty() || name[0] == '.' || name == "__MACOSX";
}

/// Archives often wrap everything in one more folder.
fs::path unwrap(fs::path folder) {
  for (int depth = 0; depth < 4; ++depth) {
    std::vector<fs::path> folders;
    for (const fs::path& entry : list(folder)) {
      if (is_hidden(entry)) continue;
      if (!fs::is_directory(fs::symlink_status(entry))) return folder;
      folders.push_back(entry);
    }
    if (folders.size() != 1) return folder;
    folder = folders[0];
  }
  return folder;
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(path, error));
}

bool holds_homework(const fs::path& folder) {
  const auto holds = [&](const char* name) {
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(folder / name, error));
  };
  return holds("student_code.cpp") || holds("halfedge-local.cpp") ||
         holds("halfedge-global.cpp") || holds("meshedit.cpp") || holds("meshEdit.cpp");
}

/// The folders in these folders, but for those that hold what is not the student's.
std::vector<fs::path> folders_in(const std::vector<fs::path>& folders) {
  static const std::set<std::string> others{"CGL", "ext", "build", "deps", "docs"};
  std::vector<fs::path> found;
  for (const fs::path& folder : folders) {
    std::error_code error;  // what cannot be read is nobody's homework
    for (fs::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
      const std::string name = it->path().filename().string();
      if (is_hidden(name) || others.count(name) != 0 || !is_folder(it->path())) continue;
      found.push_back(it->path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The whole project of a course has the homework in src/ or below, and may lie in a folder
/// beside others, such as that of the report.
fs::path enter_course_project(const fs::path& folder) {
  constexpr int kMostDepth = 3;
  constexpr std::size_t kMostFolders = 200;
  if (holds_homework(folder)) return folder;
  // Scotty3D has main.cpp beside the last two.
  for (const char* name : {"src", "student", "geometry"}) {
    if (is_folder(folder / name) && holds_homework(folder / name)) return folder / name;
  }
  const std::vector<fs::path> here = list(folder);
  if (std::any_of(here.begin(), here.end(), is_source_name)) return folder;
  std::vector<fs::path> level{folder};
  for (int depth = 0; depth < kMostDepth; ++depth) {
    level = folders_in(level);
    if (level.size() > kMostFolders) return folder;
    const auto is_it = [](const fs::path& f) { return holds_homework(f); };
    const auto found = std::count_if(level.begin(), level.end(), is_it);
    if (found == 1) return *std::find_if(level.begin(), level.end(), is_it);
    if (found > 1) return folder;
  }
  return folder;
}

/// As compilers read it, or a note why it is left out.
bool read_text(std::string bytes, const std::string& name, Submission& submission,
               std::string& text) {
  const TextEncoding encoding = encoding_of(bytes);
  if (encoding == TextEncoding::kUtf32) {
    submission.notes.push_back(name +
                               " is left out: it is saved as UTF-32, which no compiler "
                               "reads; save it as UTF-8");
    return false;
  }
  if (encoding == TextEncoding::kBytes) {
    text = std::move(bytes);
    return true;
  }
  submission.notes.push_back(name +
                             " is saved as UTF-16 and read as UTF-8 here; your own compiler "
                             "will not read it: save it as UTF-8");
  text = utf16_to_utf8(bytes, encoding);
  return true;
}

/// The file's text, or a note why it is left out.
bool read_file(const fs::path& file, const SubmissionRules& rules, Submission& submission,
               std::string& text) {
  const std::string name = printable(file.filename().string());
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) {
    submission.notes.push_back(name + " is left out: not an ordinary file");
    return false;
  }
  if (fs::file_size(file, error) > std::uintmax_t{rules.file_kb} * 1024 || error) {
    submission.notes.push_back(name + " is left out: larger than " +
                               std::to_string(rules.file_kb) + " KB");
    return false;
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream.is_open() || stream.bad()) {
    submission.notes.push_back(name + " is left out: it cannot be read");
    return false;
  }
  return read_text(bytes.str(), name, submission, text);
}

/// Names go to the compiler and into messages: only plain ones are taken.
bool has_plain_name(const fs::path& file) {
  const std::string name = file.filename().string();
  return !name.empty() && name[0] != '-' && name.size() < 100 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '-' || c == '+';
         });
}

void add_file(const fs::path& file, const SubmissionRules& rules, Submission& submission) {
  const bool source = is_source_name(file);
  if (!source && !is_header_name(file)) return;
  const std::string name = printable(file.filename().string());
  if (!has_plain_name(file)) {
    submission.notes.push_back(name +
                               " is left out: its name may hold only letters, digits, _ . - +");
    return;
  }
  if (!source && !rules.headers) {
    submission.notes.push_back(name + " is left out: this assignment takes no headers");
    return;
  }
  if (submission.sources.size() + submission.headers.size() >= rules.files) {
    submission.notes.push_back(name + " is left out: more than " + std::to_string(rules.files) +
                               " files");
    return;
  }
  std::string text;
  if (!read_file(file, rules, submission, text)) return;
  (source ? submission.sources : submission.headers).push_back({name, std::move(text)});
}

void add_path(const fs::path& path, const SubmissionRules& rules, int archives,
              Submission& submission);

/// Of what is in an archive, only the names matter, except for the files that are looked at.
Take choose_from_archive(const fs::path& name) {
  if (std::any_of(name.begin(), name.end(), is_hidden)) return Take::kNothing;
  const bool looked_at = is_source_name(name) || is_header_name(name) || is_archive_name(name);
  return looked_at ? Take::kWhole : Take::kNameOnly;
}

void add_archive(const fs::path& archive, const SubmissionRules& rules, int archives,
                 Submission& submission) {
  constexpr int kMostArchives = 2;
  const std::string name = printable(archive.filename().string());
  if (archives == kMostArchives) {
    throw UserError(name + ": an archive in an archive in an archive is not opened");
  }
  const ScratchFolder folder;
  const auto notes =
      unpack_archive(archive, folder.path(), ArchiveLimits(), choose_from_archive);
  submission.notes.insert(submission.notes.end(), notes.begin(), notes.end());
  add_path(folder.path(), rules, archives + 1, submission);
}

/// Archives beside C++ files are something else; a single one without any is the work itself.
void add_archives(const std::vector<fs::path>& found, const SubmissionRules& rules,
                  int archives, Submission& submission) {
  if (found.size() == 1 && submission.sources.empty()) {
    submission.notes.push_back("taken from " + printable(found[0].filename().string()));
    add_archive(found[0], rules, archives, submission);
    return;
  }
  for (const fs::path& archive : found) {
    submission.notes.push_back(printable(archive.filename().string()) + " is left out: " +
                               (submission.sources.empty() ? "one of several archives"
                                                           : "there are C++ files beside it"));
  }
}

void note_unknown_archive(const fs::path& file, Submission& submission) {
  if (!has_ending(file, {".rar", ".arj", ".lzh", ".ace", ".Z", ".lz4"})) return;
  submission.notes.push_back(printable(file.filename().string()) + " is left out: of " +
                             "archives, " + kArchiveKinds + " can be opened");
}

/// The header that students of Scotty3D add members to lies in another folder of the project
/// until Spring 2022.
void add_header_elsewhere(const fs::path& folder, const SubmissionRules& rules,
                          Submission& submission) {
  const fs::path geometry = folder.parent_path() / "geometry";
  std::error_code error;
  if (folder.filename() != "student" || !is_folder(geometry) ||
      !fs::is_regular_file(fs::symlink_status(geometry / "halfedge.h", error))) {
    return;
  }
  add_file(geometry / "halfedge.h", rules, submission);
}

/// The number of files is limited: homework goes before the rest, and before meshEdit.cpp,
/// which is a student's in one course and handed out beside student_code.cpp in the other.
void first_those_that_count(std::vector<fs::path>& files) {
  const auto rest = std::stable_partition(files.begin(), files.end(), [](const fs::path& file) {
    return file.stem() == "student_code";
  });
  std::stable_partition(rest, files.end(), [](const fs::path& file) {
    return is_scotty3d_homework_name(file.filename().string());
  });
}

void add_folder(const fs::path& path, const SubmissionRules& rules, int archives,
                Submission& submission) {
  const fs::path top = unwrap(path);
  const fs::path folder = enter_course_project(top);
  if (archives == 0) submission.folder = folder;
  std::vector<fs::path> found;
  std::vector<fs::path> files = list(folder);
  first_those_that_count(files);
  for (const fs::path& file : files) {
    std::error_code error;
    if (is_hidden(file)) continue;
    add_file(file, rules, submission);
    const bool regular = fs::is_regular_file(fs::symlink_status(file, error));
    if (regular && is_archive_name(file)) found.push_back(file);
    if (regular) note_unknown_archive(file, submission);
  }
  if (folder != top) add_header_elsewhere(folder, rules, submission);
  add_archives(found, rules, archives, submission);
}

/// Adds what is in a folder, an archive, or a single file; `archives` have been opened already.
void add_path(const fs::path& path, const SubmissionRules& rules, int archives,
              Submission& submission) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    add_folder(path, rules, archives, submission);
  } else if (is_archive_name(path)) {
    add_archive(path, rules, archives, submission);
  } else {
    add_file(path, rules, submission);
    note_unknown_archive(path, submission);
  }
}

}  // namespace

bool is_berkeleys(Dialect dialect) {
  return dialect == Dialect::kCourse2016 || dialect == Dialect::kCourse2017 ||
         dialect == Dialect::kCourse2020;
}

bool is_scotty3d(Dialect dialect) {
  return dialect == Dialect::kScotty3d || dialect == Dialect::kScotty3d2020;
}

bool is_source_name(const fs::path& file) {
  return has_ending(file, {".cpp", ".cc", ".cxx"});
}

bool is_header_name(const fs::path& file) {
  return has_ending(file, {".h", ".hpp", ".hh"});
}

std::vector<const SourceFile*> own_files(const Submission& submission) {
  std::vector<const SourceFile*> files;
  for (const auto* list : {&submission.sources, &submission.headers}) {
    for (const SourceFile& file : *list)
      files.push_back(&file);
  }
  return files;
}

Submission find_submission(const fs::path& path, const SubmissionRules& rules) {
  std::error_code error;
  if (!fs::exists(fs::status(path, error))) {
    throw UserError(path.string() + ": there is no such file or folder");
  }
  Submission submission;
  submission.name = fs::weakly_canonical(path, error).filename().string();
  submission.folder = fs::is_directory(path, error) ? path : path.parent_path();
  add_path(path, rules, 0, submission);
  settle_dialect(submission);
  if (submission.dialect == Dialect::kMeshedit &&
      is_first_scotty3d_homework(submission.sources)) {
    throw UserError(path.string() +
                    ": homework for Carnegie Mellon's Scotty3D of 2015 to 2019 (namespace "
                    "CMU462) is not graded, only that of Fall 2020 and later is");
  }
  if (submission.sources.empty()) {
    throw UserError(path.string() + ": no C++ source file (.cpp) to grade here" +
                    (submission.notes.empty() ? "" : "; " + submission.notes[0]));
  }
  return submission;
}

}  // namespace meshgrade
