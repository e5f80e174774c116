#include "grader/base/process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include "grader/base/cancel.h"
#include "grader/base/errors.h"
#include "grader/base/interrupt.h"
#include "grader/base/process_parent.h"
#include "grader/base/process_tree.h"

namespace meshgrade {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) {
  throw GraderError(what + ": " + std::strerror(errno));
}

struct Pipe {
  FileDescriptor read_end;
  FileDescriptor write_end;
};

Pipe make_pipe() {
  int ends[2];
  if (::pipe(ends) != 0) fail("cannot make a pipe");
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  ::fcntl(ends[1], F_SETFD, FD_CLOEXEC);
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

/// Runs in the new process, between fork and exec: only async-signal-safe calls.
[[noreturn]] void become(const Command& command, char* const* argv, char* const* environment,
                         int input, int output, int failure, pid_t parent) {
  ::setpgid(0, 0);
  die_with(parent);
  // Out of the way first, so that no descriptor is overwritten before it has been copied.
  constexpr int kSafe = 100;
  ::dup2(input, kSafe);
  ::dup2(output, kSafe + 1);
  const int shared = static_cast<int>(command.shared_files.size());
  for (int i = 0; i < shared; ++i) {
    ::dup2(command.shared_files[static_cast<std::size_t>(i)], kSafe + 2 + i);
  }
  ::dup2(failure, kSafe + 2 + shared);
  ::dup2(kSafe, STDIN_FILENO);
  ::dup2(kSafe + 1, STDOUT_FILENO);
  ::dup2(kSafe + 1, STDERR_FILENO);
  for (int i = 0; i < shared; ++i)
    ::dup2(kSafe + 2 + i, 3 + i);
  const int last = 3 + shared;
  ::dup2(kSafe + 2 + shared, last);
  ::fcntl(last, F_SETFD, FD_CLOEXEC);
  ::close_range(static_cast<unsigned>(last) + 1, ~0U, 0);
  if (command.folder.empty() || ::chdir(command.folder.c_str()) == 0) {
    if (environment != nullptr) environ = const_cast<char**>(environment);
    ::execvp(argv[0], argv);
  }
  // An exit status would not do: the program itself may end with any.
  const char failed = 1;
  ::_exit(static_cast<int>(::write(last, &failed, 1)));
}

class Running {
 public:
  Running(pid_t child, FileDescriptor output, const Command& command)
      : child_(child), output_(std::move(output)), command_(command) {}

  ProcessResult wait() {
    while (read_some()) {
    }
    const int status = wait_for_end();
    ::kill(-child_, SIGKILL);  // what it may have left behind
    if (WIFSIGNALED(status)) result_.signal = WTERMSIG(status);
    if (WIFEXITED(status)) result_.status = WEXITSTATUS(status);
    return std::move(result_);
  }

 private:
  static constexpr std::chrono::milliseconds kBetweenLooks{5};
  static constexpr std::chrono::milliseconds kNoticesInterrupts{50};
  static constexpr std::chrono::seconds kTimeToEndItsOwn{5};

  /// Whether a limit is reached; looks at memory and processes too, but not all the time.
  bool reached_limit() {
    const auto now = Clock::now();
    result_.timed_out = result_.timed_out || now >= deadline_;
    if (watches_use() && now >= next_look_ && !result_.stopped()) {
      const TreeUse use = use_of_tree(child_);
      result_.too_many_processes =
          command_.most_processes > 0 && use.processes > command_.most_processes;
      result_.out_of_memory = !result_.too_many_processes && command_.most_memory > 0 &&
                              use.memory > command_.most_memory;
      next_look_ = now + kBetweenLooks;
    }
    return result_.stopped() || interruption() != 0 || is_cancelled();
  }

  bool watches_use() const { return command_.most_memory > 0 || command_.most_processes > 0; }

  void stop() {
    const auto now = Clock::now();
    if (stopped_at_ == Clock::time_point{}) stopped_at_ = now;
    if (command_.ends_its_own && now < stopped_at_ + kTimeToEndItsOwn) {
      ::kill(child_, SIGTERM);
    } else {
      ::kill(-child_, SIGKILL);
    }
  }

  /// A program may go on for as long as it likes after it has closed its output.
  int wait_for_end() {
    int status = 0;
    auto pause = std::chrono::microseconds(50);
    for (;;) {
      if (reached_limit()) stop();
      const pid_t ended = ::waitpid(child_, &status, WNOHANG);
      if (ended == child_ || (ended < 0 && errno != EINTR)) return status;
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, std::chrono::microseconds(5000));
    }
  }

  /// Waits for output. @return false when the program has ended or a limit is reached
  bool read_some() {
    if (reached_limit()) return false;
    auto patience =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now());
    patience = std::min(patience, watches_use() ? kBetweenLooks : kNoticesInterrupts);
    pollfd ready{output_.get(), POLLIN, 0};
    const int count = ::poll(&ready, 1, static_cast<int>(patience.count()) + 1);
    if (count < 0) return errno == EINTR;
    if (count == 0) return true;
    char buffer[16384];
    const ssize_t size = ::read(output_.get(), buffer, sizeof buffer);
    if (size < 0) return errno == EINTR;
    if (size == 0) return false;
    take(std::string_view(buffer, static_cast<std::size_t>(size)));
    return true;
  }

  void take(std::string_view output) {
    written_ += output.size();
    result_.too_much_output = command_.most_output > 0 && written_ > command_.most_output;
    const std::size_t room = command_.kept_output - result_.output.size();
    result_.output.append(output.substr(0, room));
  }

  pid_t child_;
  FileDescriptor output_;
  const Command& command_;
  Clock::time_point deadline_ = Clock::now() + command_.time_limit;
  Clock::time_point next_look_ = Clock::now() + kBetweenLooks;
  Clock::time_point stopped_at_;
  std::uint64_t written_ = 0;
  ProcessResult result_;
};

/// Pointers to these texts, as exec wants them.
std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts)
    pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (fd_ >= 0) ::close(fd_);
}

FileDescriptor make_scratch_file() {
  std::string name = (std::filesystem::temp_directory_path() / "meshgrade-XXXXXX").string();
  const int fd = ::mkstemp(name.data());
  if (fd < 0) fail("cannot make a temporary file in " + name);
  ::unlink(name.c_str());
  ::fcntl(fd, F_SETFD, FD_CLOEXEC);
  return FileDescriptor(fd);
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "meshgrade-XXXXXX").string();
  count_leftovers(1);
  if (::mkdtemp(name.data()) == nullptr) {
    count_leftovers(-1);
    fail("cannot make a temporary folder in " + name);
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  count_leftovers(-1);
}

ProcessResult run_process(const Command& command) {
  FileDescriptor input = make_scratch_file();
  if (::write(input.get(), command.input.data(), command.input.size()) !=
          static_cast<ssize_t>(command.input.size()) ||
      ::lseek(input.get(), 0, SEEK_SET) != 0) {
    fail("cannot write a temporary file");
  }
  Pipe output = make_pipe();
  const std::vector<char*> argv = pointers_to(command.arguments);
  std::vector<char*> environment;
  if (command.environment) environment = pointers_to(*command.environment);
  Pipe failure = make_pipe();
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) fail("cannot start " + command.arguments.at(0));
  if (child == 0) {
    become(command, argv.data(), environment.empty() ? nullptr : environment.data(),
           input.get(), output.write_end.get(), failure.write_end.get(), parent);
  }
  output.write_end = FileDescriptor();
  failure.write_end = FileDescriptor();
  char failed = 0;
  const bool started = ::read(failure.read_end.get(), &failed, 1) <= 0;
  ProcessResult result = Running(child, std::move(output.read_end), command).wait();
  if (interruption() != 0) throw Interrupted{interruption()};
  if (is_cancelled()) throw Cancelled{};
  if (!started) {
    throw GraderError("cannot run " + command.arguments.at(0) + ": is it installed?");
  }
  return result;
}

}  // namespace meshgrade
