#include "grader/base/job_pool.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>

#include "grader/base/errors.h"
#include "grader/base/interrupt.h"
#include "grader/base/process.h"
#include "grader/base/process_parent.h"
#include "grader/base/wire.h"

namespace meshgrade {
namespace {

constexpr int kStopIsAskedEvery = 200;  // milliseconds

struct JobResult {
  std::uint64_t job = 0;
  bool ok = false;
  std::string bytes;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(job, ok, bytes);
  }
};

/// The next job, counted by all processes together.
class SharedCounter {
 public:
  SharedCounter() {
    void* memory = ::mmap(nullptr, sizeof(Value), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw GraderError("no memory to share between processes");
    value_ = new (memory) Value(0);
  }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  ~SharedCounter() { ::munmap(value_, sizeof(Value)); }

  std::size_t take() { return (*value_)++; }
  std::size_t peek() const { return *value_; }

 private:
  using Value = std::atomic<std::size_t>;
  static_assert(Value::is_always_lock_free, "processes cannot share a lock");
  Value* value_;
};

void write_message(int file, const std::string& message) {
  const std::string bytes = to_wire(static_cast<std::uint64_t>(message.size())) + message;
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t size = ::write(file, bytes.data() + done, bytes.size() - done);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) ::_exit(1);
    done += static_cast<std::size_t>(size);
  }
}

/// An interrupt from the keyboard goes to all processes; what becomes of it is for the parent
/// to say. A handler, not SIG_IGN: programs that are started from here must not inherit it.
void leave_interrupts_to_the_parent() {
  struct sigaction nothing {};
  nothing.sa_handler = [](int) {};
  nothing.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &nothing, nullptr);
  ::signal(SIGTERM, SIG_DFL);
  ::signal(SIGHUP, SIG_DFL);
}

/// One process that takes jobs, and what it has written so far.
struct Helper {
  pid_t process = -1;
  FileDescriptor output;
  std::string bytes;
  std::size_t job = 0;  ///< under way, if busy
  bool busy = false;
};

class Pool {
 public:
  Pool(std::size_t count, const JobPool& asked)
      : count_(count), asked_(asked), has_ended_(count, false) {
    const std::size_t most = std::max(1U, asked.processes);
    for (std::size_t i = 0; i < std::min(most, count); ++i)
      helpers_.push_back(start(static_cast<unsigned>(i)));
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    for (Helper& helper : helpers_) {
      if (helper.process < 0) continue;
      ::kill(helper.process, SIGKILL);
      reap(helper);
    }
  }

  bool wait() {
    while (is_open()) {
      if (asked_.stop && asked_.stop()) return false;
      if (interruption() != 0) throw Interrupted{interruption()};
      std::vector<pollfd> files;
      for (const Helper& helper : helpers_)
        files.push_back({helper.output.get(), POLLIN, 0});  // a closed one, -1, is passed over
      ::poll(files.data(), files.size(), kStopIsAskedEvery);
      for (std::size_t i = 0; i < helpers_.size(); ++i) {
        if (files[i].revents != 0) serve(static_cast<unsigned>(i));
      }
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if (!has_ended_[i]) tell({i, false, "its process died before it had begun"});
    }
    return true;
  }

 private:
  Helper start(unsigned number) {
    int ends[2];
    if (::pipe(ends) != 0) throw GraderError("cannot make a pipe");
    FileDescriptor read_end(ends[0]);
    FileDescriptor write_end(ends[1]);
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process < 0) throw GraderError("cannot start a process");
    if (process == 0) {
      die_with(parent);
      leave_interrupts_to_the_parent();
      take_jobs(number, write_end.get());
    }
    Helper helper;
    helper.process = process;
    helper.output = std::move(read_end);
    return helper;
  }

  /// Says which job it begins, so that its death can be told from whose it is.
  [[noreturn]] void take_jobs(unsigned number, int output) {
    for (std::size_t i = counter_.take(); i < count_; i = counter_.take()) {
      write_message(output, to_wire(static_cast<std::uint64_t>(i)));
      JobResult result{i, false, {}};
      try {
        result.bytes = asked_.work(i, number);
        result.ok = true;
      } catch (const std::exception& error) {
        result.bytes = error.what();
      }
      write_message(output, to_wire(result));
    }
    ::_exit(0);
  }

  bool is_open() const {
    return std::any_of(helpers_.begin(), helpers_.end(),
                       [](const Helper& helper) { return helper.output.get() >= 0; });
  }

  void serve(unsigned number) {
    Helper& helper = helpers_[number];
    char buffer[1U << 16U];
    const ssize_t size = ::read(helper.output.get(), buffer, sizeof buffer);
    if (size < 0 && errno == EINTR) return;
    if (size > 0) {
      helper.bytes.append(buffer, static_cast<std::size_t>(size));
      take_messages(helper);
      return;
    }
    const int status = reap(helper);
    if (!helper.busy) return;
    const JobEnd died{helper.job, false, death_of(status)};
    // The next jobs are not to suffer from this one.
    helpers_[number] = counter_.peek() < count_ ? start(number) : Helper();
    tell(died);
  }

  void tell(const JobEnd& end) {
    has_ended_[end.job] = true;
    asked_.ended(end);
  }

  void take_messages(Helper& helper) {
    constexpr std::size_t kHead = sizeof(std::uint64_t);
    while (helper.bytes.size() >= kHead) {
      const auto size = from_wire<std::uint64_t>(helper.bytes.substr(0, kHead));
      if (helper.bytes.size() - kHead < size) return;
      const std::string message = helper.bytes.substr(kHead, size);
      helper.bytes.erase(0, kHead + size);
      helper.busy = !helper.busy;
      if (helper.busy) {
        helper.job = from_wire<std::uint64_t>(message);
      } else {
        const auto result = from_wire<JobResult>(message);
        tell({result.job, result.ok, result.bytes});
      }
    }
  }

  static std::string death_of(int status) {
    if (WIFSIGNALED(status)) {
      return std::string("its process died: ") + ::strsignal(WTERMSIG(status));
    }
    return "its process ended with status " + std::to_string(WEXITSTATUS(status));
  }

  /// Waits for the end of a process that is ending.
  static int reap(Helper& helper) {
    int status = 0;
    helper.output = FileDescriptor();
    while (::waitpid(helper.process, &status, 0) < 0 && errno == EINTR) {
    }
    helper.process = -1;
    return status;
  }

  std::size_t count_;
  const JobPool& asked_;
  std::vector<bool> has_ended_;
  SharedCounter counter_;
  std::vector<Helper> helpers_;
};

}  // namespace

bool do_jobs(std::size_t count, const JobPool& pool) {
  return Pool(count, pool).wait();
}

std::vector<std::string> run_jobs(std::size_t count, unsigned jobs,
                                  const std::function<std::string(std::size_t)>& work,
                                  const std::function<void(std::size_t)>& finished) {
  std::vector<std::string> results(count);
  std::size_t done = 0;
  JobPool pool;
  pool.processes = jobs;
  pool.work = [&](std::size_t job, unsigned /*process*/) { return work(job); };
  pool.ended = [&](const JobEnd& end) {
    if (!end.ok) throw GraderError(end.text);
    results[end.job] = end.text;
    finished(++done);
  };
  do_jobs(count, pool);
  return results;
}

}  // namespace meshgrade
