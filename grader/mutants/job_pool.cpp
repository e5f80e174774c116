#include "grader/mutants/job_pool.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/wire.h"

namespace meshgrade {
namespace {

using Work = std::function<std::string(std::size_t)>;

struct JobResult {
  std::uint64_t job = 0;
  bool failed = false;
  std::string bytes;  ///< the result, or what went wrong

  template <class Wire>
  void transfer(Wire& wire) {
    wire(job, failed, bytes);
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

 private:
  using Value = std::atomic<std::size_t>;
  static_assert(Value::is_always_lock_free, "processes cannot share a lock");
  Value* value_;
};

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t size = ::write(file, bytes.data() + done, bytes.size() - done);
    if (size <= 0) ::_exit(1);
    done += static_cast<std::size_t>(size);
  }
}

[[noreturn]] void take_jobs(std::size_t count, const Work& work, SharedCounter& counter,
                            int output) {
  for (std::size_t i = counter.take(); i < count; i = counter.take()) {
    JobResult result{i, false, {}};
    try {
      result.bytes = work(i);
    } catch (const std::exception& error) {
      result.failed = true;
      result.bytes = error.what();
    }
    const std::string bytes = to_wire(result);
    write_all(output, to_wire(static_cast<std::uint64_t>(bytes.size())) + bytes);
  }
  ::_exit(0);
}

/// One process that takes jobs, and what it has written so far.
struct Helper {
  pid_t process = -1;
  FileDescriptor output;
  std::string bytes;
};

Helper start_helper(std::size_t count, const Work& work, SharedCounter& counter) {
  int ends[2];
  if (::pipe(ends) != 0) throw GraderError("cannot make a pipe");
  FileDescriptor read_end(ends[0]);
  FileDescriptor write_end(ends[1]);
  const pid_t process = ::fork();
  if (process < 0) throw GraderError("cannot start a process");
  if (process == 0) take_jobs(count, work, counter, write_end.get());
  return {process, std::move(read_end), {}};
}

/// Moves whole results out of what a helper has written.
void take_results(Helper& helper, std::vector<std::string>& results, std::size_t& done) {
  constexpr std::size_t kHead = sizeof(std::uint64_t);
  while (helper.bytes.size() >= kHead) {
    const auto size = from_wire<std::uint64_t>(helper.bytes.substr(0, kHead));
    if (helper.bytes.size() - kHead < size) return;
    const auto result = from_wire<JobResult>(helper.bytes.substr(kHead, size));
    helper.bytes.erase(0, kHead + size);
    if (result.failed) throw GraderError(result.bytes);
    results.at(result.job) = result.bytes;
    ++done;
  }
}

/// @return false when the helper has closed its end
bool read_some(Helper& helper) {
  char buffer[1U << 16U];
  const ssize_t size = ::read(helper.output.get(), buffer, sizeof buffer);
  if (size <= 0) return false;
  helper.bytes.append(buffer, static_cast<std::size_t>(size));
  return true;
}

void wait_for_all(std::vector<Helper>& helpers, std::vector<std::string>& results,
                  const std::function<void(std::size_t)>& finished) {
  std::size_t done = 0;
  std::vector<bool> open(helpers.size(), true);
  while (std::count(open.begin(), open.end(), true) > 0) {
    std::vector<pollfd> files;
    for (std::size_t i = 0; i < helpers.size(); ++i) {
      files.push_back({open[i] ? helpers[i].output.get() : -1, POLLIN, 0});
    }
    ::poll(files.data(), files.size(), -1);
    for (std::size_t i = 0; i < helpers.size(); ++i) {
      if (files[i].revents == 0) continue;
      open[i] = read_some(helpers[i]);
      take_results(helpers[i], results, done);
    }
    finished(done);
  }
  if (done < results.size()) throw GraderError("a process that graded died");
}

}  // namespace

std::vector<std::string> run_jobs(std::size_t count, unsigned jobs, const Work& work,
                                  const std::function<void(std::size_t)>& finished) {
  SharedCounter counter;
  std::vector<Helper> helpers;
  for (std::size_t i = 0; i < std::min<std::size_t>(std::max(1U, jobs), count); ++i)
    helpers.push_back(start_helper(count, work, counter));
  std::vector<std::string> results(count);
  std::exception_ptr error;
  try {
    wait_for_all(helpers, results, finished);
  } catch (...) {
    error = std::current_exception();
  }
  for (Helper& helper : helpers) {
    helper.output = FileDescriptor();  // who still works meets a closed pipe
    ::waitpid(helper.process, nullptr, 0);
  }
  if (error) std::rethrow_exception(error);
  return results;
}

}  // namespace meshgrade
