#include "grader/worker/child.h"

#include <execinfo.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "grader/cases/view_input.h"
#include "grader/worker/exercises.h"
#include "grader/worker/polygon_view.h"
#include "grader/worker/view_task.h"
#include "meshedit/fault.h"

namespace meshgrade {
namespace {

constexpr int kDepth = 64;

/// What the handlers of faults and signals need to know: they have no other way to learn it.
struct Running {
  const TaskList* list = nullptr;
  SharedState* shared = nullptr;
  Recorder* recorder = nullptr;
};
Running running;

std::vector<std::uint64_t> call_stack() {
  void* frames[kDepth];
  const int depth = ::backtrace(frames, kDepth);
  std::vector<std::uint64_t> stack;
  for (int i = 0; i < depth; ++i)
    stack.push_back(reinterpret_cast<std::uintptr_t>(frames[i]));
  return stack;
}

void run_exercise(const std::string& exercise, WireReader& input, Recorder& recorder) {
#define MESHGRADE_EXERCISE(name) \
  if (exercise == #name) return run_##name(input, recorder);
#include "exercise_list.inc"
#define MESHGRADE_LOCAL_OPERATION(name) MESHGRADE_EXERCISE(name)
#include "local_operation_list.inc"
#undef MESHGRADE_LOCAL_OPERATION
#undef MESHGRADE_EXERCISE
  throw WireError("no such exercise: " + exercise);
}

void run_asked(const Task& task, Recorder& recorder) {
  WireReader input(task.input);
  if (task.exercise == kViewTask) return run_view(input, recorder);
  if (task.exercise == kPolygonViewTask) return run_polygon_view(input, recorder, run_exercise);
  run_exercise(task.exercise, input, recorder);
}

[[noreturn]] void end_task(EndFrame frame) {
  meshedit::detail::steps_left = INT64_MAX;
  frame.task = running.shared->tasks_done;
  write_end(std::move(frame), *running.shared, running.list->result_bytes);
  ::_exit(kTaskRecordedStatus);
}

/// Completes the frame with what was done until now.
[[noreturn]] void interrupt_task(EndFrame frame) {
  meshedit::detail::steps_left = INT64_MAX;
  frame.stack = call_stack();
  frame.interrupted = running.recorder->interrupted_state();
  end_task(std::move(frame));
}

[[noreturn]] void on_fault(const meshedit::Fault& fault) {
  EndFrame frame;
  frame.ending = Ending::kFault;
  frame.fault_kind = static_cast<std::uint32_t>(fault.kind);
  frame.subject = fault.subject;
  interrupt_task(std::move(frame));
}

[[noreturn]] void on_terminate() {
  EndFrame frame;
  frame.ending = Ending::kException;
  frame.stack = call_stack();
  try {
    if (std::current_exception()) {
      std::rethrow_exception(std::current_exception());
    } else {
      frame.subject = "std::terminate was called";
    }
  } catch (const std::exception& error) {
    frame.subject = error.what();
  } catch (...) {
    frame.subject = "an exception that is no std::exception";
  }
  end_task(std::move(frame));
}

/// The soft limit is what the student may use; the hard one, of all tasks, leaves room to say
/// that it was reached.
void limit_memory(std::uint64_t bytes, std::uint64_t of_all_tasks) {
  if (bytes == 0) return;
  const rlimit limit{static_cast<rlim_t>(bytes),
                     static_cast<rlim_t>(of_all_tasks) + kMemoryToReport};
  ::setrlimit(RLIMIT_AS, &limit);
}

/// What is printed goes to a file. The soft limit is what one task may print; results may be
/// larger.
void limit_files(std::uint64_t bytes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// No limit for files but the hard one while this lives.
class LargeFiles {
 public:
  LargeFiles() {
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit_after_ = limit.rlim_cur;
    limit_files(RLIM_INFINITY);
  }
  LargeFiles(const LargeFiles&) = delete;
  LargeFiles& operator=(const LargeFiles&) = delete;
  ~LargeFiles() { limit_files(limit_after_); }

 private:
  rlim_t limit_after_ = RLIM_INFINITY;
};

/// Handles of files that are opened and never closed.
bool has_no_file_left() {
  const int file = ::dup(kOutputFile);
  if (file >= 0) ::close(file);
  return file < 0 && errno == EMFILE;
}

[[noreturn]] void on_out_of_memory() {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_AS, &limit);
  std::set_new_handler(nullptr);
  EndFrame frame;
  frame.ending = Ending::kOutOfMemory;
  frame.stack = call_stack();
  end_task(std::move(frame));
}

/// Notes where the code was and dies. Only async-signal-safe calls: backtrace() is one once it
/// has been called before.
void on_signal(int signal) {
  void* frames[kDepth];
  const int depth = ::backtrace(frames, kDepth);
  for (int i = 0; i < depth; ++i) {
    running.shared->stack[i] = reinterpret_cast<std::uintptr_t>(frames[i]);
  }
  // Frame 0 is this handler, 1 the way back from it, and 2 the instruction itself, which unlike
  // a return address must not be counted back from.
  if (depth > 2) ++running.shared->stack[2];
  running.shared->stack_size = static_cast<std::uint32_t>(depth);
  running.shared->signal = signal;
  ::_exit(kSignalNotedStatus);
}

void catch_signals() {
  // A stack of its own for the handler: an endless recursion has used up the other.
  static char stack[1U << 16U];
  stack_t alternate{};
  alternate.ss_sp = stack;
  alternate.ss_size = sizeof stack;
  ::sigaltstack(&alternate, nullptr);
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  for (int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGPROF}) {
    ::sigaction(signal, &action, nullptr);
  }
}

void set_timer(std::uint32_t milliseconds) {
  itimerval timer{};
  timer.it_value.tv_sec = milliseconds / 1000;
  timer.it_value.tv_usec = static_cast<suseconds_t>(milliseconds % 1000) * 1000;
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

void run_task(const Task& task, const Patience& patience) {
  Recorder recorder;
  running.recorder = &recorder;
  meshedit::detail::steps_left = static_cast<std::int64_t>(task.step_budget);
  const std::uint64_t memory = running.list->memory_bytes;
  limit_memory(patience.memory_limit(task, memory), memory);
  set_timer(patience.cpu_limit(task));
  EndFrame frame;
  try {
    run_asked(task, recorder);
  } catch (const WireError& error) {  // nothing of the student's throws this
    frame.ending = Ending::kWorkerFailed;
    frame.subject = error.what();
  }
  set_timer(0);
  meshedit::detail::steps_left = INT64_MAX;
  if (has_no_file_left()) frame.ending = Ending::kTooManyFiles;
  frame.task = running.shared->tasks_done;
  write_end(std::move(frame), *running.shared, running.list->result_bytes);
}

void skip_task() {
  EndFrame frame;
  frame.task = running.shared->tasks_done;
  frame.ending = Ending::kSkipped;
  write_end(std::move(frame), *running.shared, running.list->result_bytes);
}

std::string frame_bytes(FrameKind kind, const std::string& payload) {
  WireWriter writer;
  writer(kind);
  return writer.take() + payload;
}

}  // namespace

void prepare_backtraces() {
  call_stack();
}

void library_check_failed(const std::string& what) {
  if (running.recorder == nullptr) return;
  EndFrame frame;
  frame.ending = Ending::kLibraryCheck;
  frame.subject = what;
  interrupt_task(std::move(frame));
}

void Recorder::write_step(const std::string& bytes) {
  const StepFrame frame{running.shared->tasks_done, bytes};
  const LargeFiles large;
  if (append_frame(kResultFile, *running.shared, frame_bytes(FrameKind::kStep, to_wire(frame)),
                   running.list->result_bytes)) {
    return;
  }
  EndFrame end;
  end.ending = Ending::kOutputLimit;
  end_task(std::move(end));
}

void write_end(EndFrame frame, SharedState& shared, std::uint64_t limit) {
  std::cout.flush();
  std::fflush(nullptr);
  struct stat printed {};
  ::fstat(kOutputFile, &printed);
  frame.output_bytes = static_cast<std::uint64_t>(printed.st_size);
  frame.output.resize(std::min<std::size_t>(frame.output_bytes, kKeptOutputBytes));
  const ssize_t kept = ::pread(kOutputFile, frame.output.data(), frame.output.size(), 0);
  frame.output.resize(kept > 0 ? static_cast<std::size_t>(kept) : 0);
  if (::ftruncate(kOutputFile, 0) != 0) frame.output.clear();
  const LargeFiles large;
  const std::uint64_t room = limit + kRoomForEnds;
  if (!append_frame(kResultFile, shared, frame_bytes(FrameKind::kEnd, to_wire(frame)), room)) {
    frame.interrupted.clear();
    append_frame(kResultFile, shared, frame_bytes(FrameKind::kEnd, to_wire(frame)), room);
  }
  shared.last_ending = frame.ending;
  ++shared.tasks_done;
}

namespace {

/// Whether the next task runs in this process, too. Not where it gets less memory: what others
/// before it have kept is none of its business.
bool goes_on(const TaskList& list, const Patience& patience, const SharedState& shared) {
  return !list.alone && shared.tasks_done < list.tasks.size() &&
         !patience.is_hungry(list.tasks[shared.tasks_done]);
}

}  // namespace

void run_tasks(const TaskList& list, const Patience& patience, SharedState& shared) {
  running = {&list, &shared, nullptr};
  ::fcntl(kOutputFile, F_SETFL, O_APPEND);
  ::dup2(kOutputFile, STDOUT_FILENO);
  ::dup2(kOutputFile, STDERR_FILENO);
  ::setvbuf(stdout, nullptr, _IOLBF, 1U << 12U);
  catch_signals();
  std::set_terminate(on_terminate);
  std::set_new_handler(on_out_of_memory);
  meshedit::detail::fault_handler = on_fault;
  limit_files(list.output_bytes);
  do {
    const Task& task = list.tasks[shared.tasks_done];
    if (patience.is_used_up(task.family)) {
      skip_task();
    } else {
      run_task(task, patience);
    }
  } while (goes_on(list, patience, shared));
  ::_exit(kTaskRecordedStatus);
}

}  // namespace meshgrade
