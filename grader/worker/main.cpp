// The worker: runs student code on the tasks that the grader gives it.
//
// Theory of operation. The worker forks one child, which runs the tasks in order and writes
// down what the student's code leaves behind. When a task kills the child, the parent writes
// down how, and forks a new child that goes on with the next task. So a task costs a fork only
// when the one before it went wrong. A function that never ends would cost the time limit in
// every task: a family of tasks with too many of them is given up. Nothing in this process
// knows a right answer.

#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "grader/base/process_parent.h"
#include "grader/base/protocol.h"
#include "grader/worker/child.h"
#include "grader/worker/patience.h"
#include "grader/worker/result_file.h"

namespace meshgrade {
namespace {

std::string read_whole_file(int file) {
  std::string bytes;
  char buffer[65536];
  for (ssize_t n = 0; (n = ::read(file, buffer, sizeof buffer)) > 0;) {
    bytes.append(buffer, static_cast<std::size_t>(n));
  }
  return bytes;
}

/// Waits until the child has died, or has spent too long on one task and was killed.
/// @return true if it was killed
bool watch(pid_t child, int life_line, const TaskList& list, const Patience& patience,
           const SharedState& shared) {
  for (;;) {
    const std::uint32_t task = shared.tasks_done;
    const std::uint32_t limit =
        task < list.tasks.size() ? patience.wall_limit(list.tasks[task]) : 1000;
    pollfd death{life_line, POLLIN, 0};
    const int ready = ::poll(&death, 1, static_cast<int>(limit));
    if (ready > 0) return false;
    if (ready == 0 && shared.tasks_done == task) {
      ::kill(child, SIGKILL);
      return true;
    }
  }
}

Ending classify(int status, bool overdue, const SharedState& shared) {
  const int signal = shared.signal;
  if (overdue || signal == SIGPROF || signal == SIGXCPU) return Ending::kOutOfTime;
  if (signal != 0) return Ending::kSignal;
  if (WIFEXITED(status)) return Ending::kExit;
  if (WTERMSIG(status) == SIGXFSZ) return Ending::kOutputLimit;
  if (WTERMSIG(status) == SIGXCPU) return Ending::kOutOfTime;
  return Ending::kSignal;
}

/// Writes down how the child died, in its place.
Ending record_death(const TaskList& list, SharedState& shared, int status, bool overdue) {
  // What the child was writing when it died is not a whole frame: nothing of it may stay.
  const auto written = static_cast<off_t>(shared.result_size.load());
  if (::ftruncate(kResultFile, written) != 0) std::exit(kWorkerFailedStatus);
  EndFrame frame;
  frame.task = shared.tasks_done;
  frame.ending = classify(status, overdue, shared);
  const Ending ending = frame.ending;
  frame.code = shared.signal != 0  ? shared.signal.load()
               : WIFEXITED(status) ? WEXITSTATUS(status)
                                   : WTERMSIG(status);
  const std::uint32_t depth = std::min<std::uint32_t>(shared.stack_size, 64);
  frame.stack.assign(shared.stack, shared.stack + depth);
  write_end(std::move(frame), shared, list.result_bytes);
  return ending;
}

/// A child; asked for again for a while where the user's processes that are just ending still
/// count.
pid_t fork_patiently() {
  constexpr useconds_t kPause = 50'000;
  for (int tries = 0; tries < 60; ++tries) {
    const pid_t child = ::fork();
    if (child >= 0 || errno != EAGAIN) return child;
    ::usleep(kPause);
  }
  return -1;
}

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "worker: %s: %s\n", what, std::strerror(errno));
  std::exit(kWorkerFailedStatus);
}

/// Runs tasks in one child, from the first that is not done. @return false if all are done
bool run_some(const TaskList& list, Patience& patience, SharedState& shared) {
  int life_line[2];
  if (::pipe(life_line) != 0) fail("cannot make a pipe");
  shared.signal = 0;
  shared.stack_size = 0;
  const std::uint32_t first = shared.tasks_done;
  const pid_t worker = ::getpid();
  const pid_t child = fork_patiently();
  if (child < 0) fail("cannot start a process");
  if (child == 0) {
    die_with(worker, kWorkerFailedStatus);  // nobody would be left to watch over the time
    ::close(life_line[0]);
    run_tasks(list, patience, shared);
  }
  ::close(life_line[1]);
  const bool overdue = watch(child, life_line[0], list, patience, shared);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(life_line[0]);
  if (shared.tasks_done >= list.tasks.size()) return false;
  const bool recorded = WIFEXITED(status) && WEXITSTATUS(status) == kTaskRecordedStatus;
  if (recorded && !overdue && shared.tasks_done > first) {
    if (shared.last_ending == Ending::kOutOfMemory)
      patience.note_out_of_memory(list.tasks[shared.tasks_done - 1]);
    return true;
  }
  const Task& task = list.tasks[shared.tasks_done];
  if (record_death(list, shared, status, overdue) == Ending::kOutOfTime) {
    patience.note_timeout(task);
  }
  return shared.tasks_done < list.tasks.size();
}

/// @return false if there is none that makes sense
bool read_task_list(TaskList& list) {
  try {
    list = from_wire<TaskList>(read_whole_file(kTaskFile));
  } catch (const WireError& error) {
    std::fprintf(stderr, "worker: %s\n", error.what());
    return false;
  }
  ::close(kTaskFile);
  return list.version == kProtocolVersion;
}

// Nothing on the way to the student's code catches exceptions: one that finds no handler comes
// to the terminate handler with its stack still there.
int run_worker() {
  TaskList list;
  if (!read_task_list(list)) return kWorkerFailedStatus;
  void* memory = ::mmap(nullptr, sizeof(SharedState), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) fail("cannot share memory");
  auto* shared = ::new (memory) SharedState;
  if (list.tasks.empty()) return 0;
  prepare_backtraces();
  Patience patience;
  while (run_some(list, patience, *shared) && shared->tasks_done < list.tasks.size()) {
  }
  return 0;
}

}  // namespace
}  // namespace meshgrade

int main() {
  return meshgrade::run_worker();
}
