#include "grader/batch/batch.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "grader/base/digest.h"
#include "grader/base/errors.h"
#include "grader/base/job_pool.h"
#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// With less room than this, a compiler fails for want of it, and a student would be blamed.
constexpr std::uintmax_t kLeastRoom = std::uintmax_t{128} << 20U;

constexpr std::chrono::seconds kPatience{3};
constexpr const char* kTemporary = ".tmp";

/// What a job says to the process that started it.
struct StepMessage {
  std::uint32_t status = 0;
  bool kept = false;
  bool again = false;
  double points = 0.0;
  double max_points = 0.0;
  std::string reason;
  std::string broken;  ///< why the whole batch cannot go on

  template <class Wire>
  void transfer(Wire& wire) {
    wire(status, kept, again, points, max_points, reason, broken);
  }
};

/// Makes the folder and locks it. The lock ends with the process, however it ends.
FileDescriptor lock_results(const fs::path& folder) {
  make_folder(folder);
  FileDescriptor lock(
      ::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (lock.get() < 0) throw UserError(folder.string() + ": cannot be written to");
  // The processes of a batch that was killed hold the lock until they have noticed it.
  const auto patience = std::chrono::steady_clock::now() + kPatience;
  while (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (std::chrono::steady_clock::now() < patience) continue;
    throw UserError(folder.string() + ": another batch is writing its results here; wait for " +
                    "it, or choose another folder");
  }
  return lock;
}

std::string fingerprint_of(const Submission& submission, const std::string& identity) {
  Digest digest;
  digest.add(identity).add(submission.name).add(join(submission.notes, "\n"));
  for (const auto* files : {&submission.sources, &submission.headers,
                            &submission.course_sources, &submission.course_headers}) {
    digest.add(std::to_string(files->size()));
    for (const SourceFile& file : *files)
      digest.add(file.name).add(file.text);
  }
  return digest.hex();
}

bool holds(const Result& before, const std::string& fingerprint) {
  return before.status == ResultStatus::kGraded && before.fingerprint == fingerprint;
}

class Batch {
 public:
  Batch(const Roster& roster, const Grading& grading, const BatchFolder& folder,
        const BatchOptions& options)
      : roster_(roster),
        grading_(grading),
        folder_(folder.path()),
        options_(options),
        store_(folder.store()) {}

  bool run() {
    if (!run_all(options_.chosen)) return false;
    // What took its process with it gets a second one.
    is_second_run_ = true;
    std::vector<std::size_t> died;
    for (const auto& [hand_in, reason] : died_)
      died.push_back(hand_in);
    return run_all(died);
  }

 private:
  bool run_all(const std::vector<std::size_t>& hand_ins) {
    JobPool pool;
    pool.processes = options_.jobs;
    pool.work = [&](std::size_t job, unsigned slot) {
      return to_wire(do_hand_in(roster_.hand_ins[hand_ins[job]], slot));
    };
    pool.ended = [&](const JobEnd& end) { take(hand_ins[end.job], end); };
    pool.stop = options_.stop;
    return do_jobs(hand_ins.size(), pool);
  }

  /// In a process of its own.
  StepMessage do_hand_in(const HandIn& hand_in, unsigned slot) const {
    StepMessage message;
    try {
      const Result result = get_result(hand_in, slot, message);
      message.status = static_cast<std::uint32_t>(result.status);
      if (result.report) {
        message.points = result.report->points;
        message.max_points = result.report->max_points;
      }
      if (result.status != ResultStatus::kGraded && !message.again) {
        message.reason = result.reason;
      }
    } catch (const UserError& error) {
      message.broken = error.what();
    }
    return message;
  }

  Result get_result(const HandIn& hand_in, unsigned slot, StepMessage& message) const {
    Result result;
    result.key = hand_in.key;
    Submission submission;
    try {
      submission = take_submission(hand_in, grading_.rules);
    } catch (const UserError& error) {
      result.status = ResultStatus::kUngradable;
      result.reason = printable(error.what());
      save(result);
      return result;
    }
    result.fingerprint = fingerprint_of(submission, grading_.identity);
    Result before = store_.load(hand_in.key);
    message.kept = !options_.force && holds(before, result.fingerprint);
    if (message.kept) return before;
    message.reason = before.reason;
    std::optional<std::string> text = grade(submission, slot, result);
    if (result.status == ResultStatus::kGraderError) {
      message.again = true;
      message.reason = result.reason;
      text = grade(submission, slot, result);
    }
    finish(result, text);
    return result;
  }

  /// @return the report for people, where it tells of a fault of the grader
  std::optional<std::string> grade(const Submission& submission, unsigned slot,
                                   Result& result) const {
    require_room();
    result.report.reset();
    result.reason.clear();
    try {
      result.report = grading_.grade(submission, slot);
      result.status = ResultStatus::kGraded;
    } catch (const UserError&) {
      throw;  // about the assignment: the same for everybody
    } catch (const std::exception& error) {
      result.status = ResultStatus::kGraderError;
      result.reason = printable(error.what());
    }
    if (result.report && result.report->has_grader_error()) {
      result.status = ResultStatus::kGraderError;
      result.reason = "the grader failed in one of the cases; see its report.txt";
      return grading_.to_text(*result.report);
    }
    return std::nullopt;
  }

  void finish(Result& result, const std::optional<std::string>& text) const {
    if (text) return save(result, *text);
    if (result.report && grading_.add_files) {
      grading_.add_files(*result.report, store_.make_folder(result.key));
    }
    require_room();
    save(result);
  }

  void save(const Result& result) const {
    save(result, result.report
                     ? grading_.to_text(*result.report)
                     : std::string(status_name(result.status)) + ": " + result.reason + "\n");
  }

  /// The report of a fault of the grader is not kept: nobody's points come from it.
  void save(Result result, const std::string& text) const {
    if (result.status != ResultStatus::kGraded) result.report.reset();
    store_.save(result, text);
  }

  void require_room() const {
    std::error_code error;
    const fs::space_info space = fs::space(folder_, error);
    if (error || space.available >= kLeastRoom) return;
    throw UserError(
        folder_.string() +
        ": the disk is nearly full; what is graded is safe. Make room, and the same "
        "command goes on");
  }

  /// Back in the process that waits.
  void take(std::size_t hand_in, const JobEnd& end) {
    BatchStep step;
    step.hand_in = hand_in;
    StepMessage message;
    if (!end.ok && !is_second_run_) {
      died_[hand_in] = printable(end.text);
      return;
    }
    if (end.ok) {
      message = from_wire<StepMessage>(end.text);
    } else {
      message.status = static_cast<std::uint32_t>(ResultStatus::kGraderError);
      message.reason = printable(end.text);
      Result result;
      result.key = roster_.hand_ins[step.hand_in].key;
      result.status = ResultStatus::kGraderError;
      result.reason = message.reason;
      save(result);
    }
    if (!message.broken.empty()) throw UserError(message.broken);
    step.status = static_cast<ResultStatus>(message.status);
    step.kept = message.kept;
    step.again = message.again || is_second_run_;
    step.points = message.points;
    step.max_points = message.max_points;
    step.reason = is_second_run_ ? died_.at(hand_in) : message.reason;
    options_.progress(step);
  }

  const Roster& roster_;
  const Grading& grading_;
  const fs::path& folder_;
  const BatchOptions& options_;
  ResultStore store_;
  std::map<std::size_t, std::string> died_;  ///< hand-ins whose process died, and how
  bool is_second_run_ = false;
};

}  // namespace

BatchFolder::BatchFolder(const fs::path& folder)
    : folder_(folder), lock_(lock_results(folder_)) {
  const char* before = std::getenv("TMPDIR");
  if (before != nullptr) temporary_before_ = before;
  clear();
  const fs::path temporary = folder_ / kTemporary;
  make_folder(temporary);
  fs::permissions(temporary, fs::perms(0711));
  // Started by root, submissions run as other users, who could not come to where they run.
  if (::geteuid() == 0 && !is_open_to_others(temporary)) return;
  ::setenv("TMPDIR", fs::absolute(temporary).c_str(), 1);
}

BatchFolder::~BatchFolder() {
  clear();
  if (temporary_before_.empty()) {
    ::unsetenv("TMPDIR");
  } else {
    ::setenv("TMPDIR", temporary_before_.c_str(), 1);
  }
}

void BatchFolder::clear() const {
  std::error_code ignored;
  fs::remove_all(folder_ / kTemporary, ignored);
}

std::vector<std::size_t> choose_hand_ins(const Roster& roster,
                                         const std::vector<std::string>& names) {
  std::vector<std::size_t> chosen;
  std::set<std::string> unknown(names.begin(), names.end());
  for (std::size_t i = 0; i < roster.hand_ins.size(); ++i) {
    const HandIn& hand_in = roster.hand_ins[i];
    bool named = unknown.erase(hand_in.key) != 0 ||
                 std::find(names.begin(), names.end(), hand_in.key) != names.end();
    for (const Person& person : hand_in.people) {
      if (std::find(names.begin(), names.end(), person.id) == names.end()) continue;
      named = true;
      unknown.erase(person.id);
    }
    if (named || names.empty()) chosen.push_back(i);
  }
  if (unknown.empty()) return chosen;
  throw UserError("there is no hand-in of \"" + *unknown.begin() +
                  "\"; --list shows whose there are");
}

std::map<std::string, std::string> pending_hand_ins(const Roster& roster,
                                                    const Grading& grading,
                                                    const ResultStore& store,
                                                    const BatchOptions& options) {
  std::map<std::string, std::string> pending;
  for (std::size_t i : options.chosen) {
    const HandIn& hand_in = roster.hand_ins[i];
    try {
      const std::string fingerprint =
          fingerprint_of(take_submission(hand_in, grading.rules), grading.identity);
      if (options.force || !holds(store.load(hand_in.key), fingerprint))
        pending[hand_in.key] = fingerprint;
    } catch (const UserError&) {
      continue;  // ungradable: that is quickly said, and not here
    }
  }
  return pending;
}

bool run_batch(const Roster& roster, const Grading& grading, const BatchFolder& folder,
               const BatchOptions& options) {
  return Batch(roster, grading, folder, options).run();
}

}  // namespace meshgrade
