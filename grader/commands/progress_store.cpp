#include "grader/commands/progress_store.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/commands/context.h"

namespace meshgrade {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ExerciseProgress, verdict, points, max_points,
                                                extra_points, max_extra_points, checked_at,
                                                hints)

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

fs::path absolute_name(const fs::path& submission) {
  std::error_code error;
  fs::path name = fs::weakly_canonical(fs::absolute(submission, error), error);
  if (error) return submission;
  if (!name.has_filename()) name = name.parent_path();  // "homework/" is "homework"
  return name;
}

/// FNV-1a: two submissions of the same name in different places get different files.
std::uint64_t hash(const std::string& text) {
  std::uint64_t value = 14695981039346656037ULL;
  for (unsigned char c : text)
    value = (value ^ c) * 1099511628211ULL;
  return value;
}

Json read_json(const fs::path& file) {
  std::ifstream stream(file);
  Json value = Json::parse(stream, nullptr, false);
  return value.is_object() ? value : Json::object();
}

std::int64_t now() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(since_1970).count();
}

}  // namespace

fs::path ProgressStore::file_of(const fs::path& submission) const {
  char digits[24];
  std::snprintf(digits, sizeof digits, "-%016llx",
                static_cast<unsigned long long>(hash(submission.string())));
  return folder_ / (submission.filename().string() + digits + ".json");
}

SubmissionProgress ProgressStore::load(const fs::path& submission) const {
  SubmissionProgress progress;
  progress.submission = absolute_name(submission);
  if (folder_.empty()) return progress;
  try {
    const Json value = read_json(file_of(progress.submission));
    progress.exercises = value.value("exercises", std::map<std::string, ExerciseProgress>());
  } catch (const Json::exception&) {
    progress.exercises.clear();  // somebody else's file: as good as none
  }
  return progress;
}

void ProgressStore::save(const SubmissionProgress& progress) const {
  if (folder_.empty()) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  const Json value{{"submission", progress.submission.string()},
                   {"exercises", progress.exercises}};
  write_file_safely(file_of(progress.submission),
                    value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void ProgressStore::remember(const fs::path& submission, const Report& report) const {
  if (folder_.empty()) return;
  SubmissionProgress progress = load(submission);
  for (const ExerciseReport& exercise : report.exercises) {
    ExerciseProgress& kept = progress.exercises[exercise.name];
    kept = {verdict_name(exercise.verdict),
            exercise.points,
            exercise.max_points,
            exercise.extra_points,
            exercise.max_extra_points,
            now(),
            kept.hints};
  }
  save(progress);
  write_file_safely(folder_ / "last", progress.submission.string() + "\n");
  write_file_safely(folder_ / "home", source_folder().string() + "\n");
}

std::optional<fs::path> ProgressStore::last_submission() const {
  std::ifstream stream(folder_ / "last");
  std::string name;
  if (folder_.empty() || !std::getline(stream, name) || name.empty()) return std::nullopt;
  return name;
}

ProgressStore personal_store() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) {
    return ProgressStore(fs::path(state) / "meshgrade");
  }
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return ProgressStore({});
  return ProgressStore(fs::path(home) / ".local" / "state" / "meshgrade");
}

void remember_or_warn(const fs::path& submission, const Report& report) {
  try {
    personal_store().remember(submission, report);
  } catch (const UserError& error) {
    std::cerr << "note: this check is not remembered for `meshgrade list`: " << error.what()
              << "\n";
  }
}

fs::path given_or_last(const std::string& given, const ProgressStore& store) {
  if (!given.empty() && !fs::exists(given)) {
    throw UserError(given + ": there is no such file or folder");
  }
  if (!given.empty()) return given;
  const std::optional<fs::path> last = store.last_submission();
  if (last && fs::exists(*last)) return *last;
  throw UserError(last ? last->string() + ", which was checked last, is gone: name a submission"
                       : "nothing was checked yet: name a submission, for example my_homework");
}

}  // namespace meshgrade
