#include "grader/submission/submission.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/submission/dialect.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

bool has_ending(const fs::path& file, const std::set<std::string>& endings) {
  return endings.count(file.extension().string()) != 0;
}

bool is_source(const fs::path& file) {
  return has_ending(file, {".cpp", ".cc", ".cxx"});
}
bool is_header(const fs::path& file) {
  return has_ending(file, {".h", ".hpp", ".hh"});
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

/// The whole project of Berkeley's course has the homework in src/.
fs::path enter_course_project(const fs::path& folder) {
  std::error_code error;
  const fs::path inner = folder / "src";
  const bool is_project = !fs::exists(folder / "student_code.cpp", error) &&
                          fs::is_directory(fs::symlink_status(inner, error)) &&
                          fs::exists(inner / "student_code.cpp", error);
  return is_project ? inner : folder;
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
  text = bytes.str();
  return true;
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
  const bool source = is_source(file);
  if (!source && !is_header(file)) return;
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

}  // namespace

Submission find_submission(const fs::path& path, const SubmissionRules& rules) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw UserError(path.string() + ": there is no such file or folder");
  Submission submission;
  submission.name = fs::weakly_canonical(path, error).filename().string();
  if (fs::is_directory(status)) {
    submission.folder = enter_course_project(unwrap(path));
    for (const fs::path& file : list(submission.folder)) {
      if (!is_hidden(file)) add_file(file, rules, submission);
    }
  } else {
    submission.folder = path.parent_path();
    add_file(path, rules, submission);
  }
  settle_dialect(submission);
  if (submission.sources.empty()) {
    throw UserError(path.string() + ": no C++ source file (.cpp) to grade here" +
                    (submission.notes.empty() ? "" : "; " + submission.notes[0]));
  }
  return submission;
}

}  // namespace meshgrade
