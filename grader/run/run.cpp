#include "grader/run/run.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/run/kept_outcomes.h"
#include "grader/run/result_reader.h"
#include "grader/run/symbolizer.h"
#include "grader/sandbox/confined_run.h"
#include "meshedit/fault.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMegabyte = 1U << 20U;

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t size = ::write(file, bytes.data() + done, bytes.size() - done);
    if (size <= 0) throw GraderError("cannot write a temporary file: is the disk full?");
    done += static_cast<std::size_t>(size);
  }
  ::lseek(file, 0, SEEK_SET);
}

std::string read_all(int file, std::uint64_t most) {
  std::string bytes;
  const off_t size = ::lseek(file, 0, SEEK_END);
  if (size <= 0) return bytes;
  bytes.resize(static_cast<std::size_t>(
      std::min<std::uint64_t>(static_cast<std::uint64_t>(size), most)));
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t part =
        ::pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (part <= 0) break;
    done += static_cast<std::size_t>(part);
  }
  bytes.resize(done);
  return bytes;
}

/// Numbers for the lists of functions that cases call, from 0 in the order of their first
/// cases.
std::vector<std::uint32_t> numbers_of_calls(const std::vector<const Case*>& cases) {
  std::map<std::vector<std::string>, std::uint32_t> numbers;
  std::vector<std::uint32_t> calls;
  for (const Case* c : cases) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    calls.push_back(numbers.try_emplace(c->calls, next).first->second);
  }
  return calls;
}

/// The number of the family of each case, from 0 in the order of their first cases.
std::vector<std::uint32_t> families_of(const std::vector<const Case*>& cases) {
  std::map<std::pair<std::string, std::vector<std::string>>, std::uint32_t> numbers;
  std::vector<std::uint32_t> families;
  for (const Case* c : cases) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    families.push_back(
        numbers.try_emplace({c->exercise + "/" + c->group, c->calls}, next).first->second);
  }
  return families;
}

/// The processor time of a case, in milliseconds: the whole limit is for the largest meshes,
/// and a fifth of it is hundreds of times what a good solution needs in the others.
std::uint32_t cpu_limit(const Case& c, const Limits& limits) {
  constexpr std::uint64_t kLeast = 250;
  constexpr std::uint64_t kStepsPerMillisecond = 10'000;
  const std::uint64_t share = std::max(kLeast, std::uint64_t{limits.case_cpu_ms} / 5);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(
      limits.case_cpu_ms, share + c.step_budget / kStepsPerMillisecond));
}

TaskList make_tasks(const std::vector<const Case*>& cases, const Limits& limits,
                    Company company) {
  TaskList list;
  list.alone = company == Company::kAlone;
  list.memory_bytes = limits.memory_mb * kMegabyte;
  list.result_bytes = limits.result_mb * kMegabyte;
  list.output_bytes = limits.output_mb * kMegabyte;
  const std::vector<std::uint32_t> families = families_of(cases);
  const std::vector<std::uint32_t> calls = numbers_of_calls(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = *cases[i];
    list.tasks.push_back({c.exercise, c.input, c.step_budget, cpu_limit(c, limits),
                          limits.case_wall_ms, families[i], calls[i]});
  }
  return list;
}

/// The text of an exception goes where one line is expected.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return printable(text.substr(0, 400));
}

Outcome to_outcome(TaskResult task) {
  Outcome outcome;
  outcome.ending = task.end.ending;
  outcome.fault_kind = task.end.fault_kind;
  outcome.code = task.end.code;
  outcome.subject = one_line(std::move(task.end.subject));
  outcome.steps = std::move(task.steps);
  outcome.interrupted = std::move(task.end.interrupted);
  outcome.output = printable(task.end.output);
  outcome.output_bytes = task.end.output_bytes;
  return outcome;
}

/// For the first task that the result file says nothing about.
Outcome unfinished(const ProcessResult& worker) {
  Outcome outcome;
  outcome.lost = true;
  outcome.ending = worker.timed_out            ? Ending::kOutOfTime
                   : worker.out_of_memory      ? Ending::kOutOfMemory
                   : worker.too_many_processes ? Ending::kTooManyProcesses
                   : worker.too_much_output    ? Ending::kOutputLimit
                   : worker.signal != 0        ? Ending::kSignal
                                               : Ending::kExit;
  outcome.code = worker.signal != 0 ? worker.signal : worker.status;
  outcome.subject = worker.timed_out ? "the time for all cases together was used up"
                                     : "the program ended before this case";
  return outcome;
}

void remove_all(std::string& text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) {
    text.erase(at, part.size());
  }
}

/// "HalfedgeMesh::flipEdge" out of the compiler's name with namespaces and parameters.
std::string short_name(std::string function) {
  remove_all(function, "(anonymous namespace)::");
  remove_all(function, "meshedit::");
  remove_all(function, "Course");  // how a drop-in's own class is called behind the scenes
  return function.substr(0, function.find('('));
}

/// A frame in a file of the student's, whose names the compiler was given without a folder; "~"
/// begins those of stand-ins. Some of the shared headers' code is told as if it stood in the
/// file that includes it.
bool is_students(const StackFrame& frame) {
  return frame.file.rfind("./", 0) == 0 && frame.file.rfind("./~", 0) != 0 &&
         frame.function.rfind("meshedit::detail::", 0) != 0 &&
         frame.function.rfind("meshedit::Handle<", 0) != 0;
}

/// Code of neither the worker nor a shared library: the student's, or what it is compiled with.
bool is_compiled_in(const StackFrame& frame) {
  return !frame.file.empty() && frame.function.rfind("meshgrade::", 0) != 0;
}

/// Where the checks of a standard library end in a trap (libc++'s hardening) or in a function
/// of their own that aborts (libstdc++ before GCC 12), the place tells that it was one of them.
void recognise_library_check(const std::vector<StackFrame>& innermost, Outcome& outcome) {
  if (outcome.ending != Ending::kSignal) return;
  const std::string& function = innermost[0].function;
  const bool trapped =
      (outcome.code == SIGILL || outcome.code == SIGTRAP) && function.rfind("std::", 0) == 0;
  const bool aborted =
      outcome.code == SIGABRT && function.rfind("std::__replacement_assert", 0) == 0;
  if (!trapped && !aborted) return;
  outcome.ending = Ending::kLibraryCheck;
  outcome.subject = "in " + innermost[aborted && innermost.size() > 1 ? 1 : 0].function;
}

/// Where a function that is not written stops is of no use to anybody.
bool needs_stack(const EndFrame& end) {
  return end.ending != Ending::kFault ||
         end.fault_kind != static_cast<std::uint32_t>(meshedit::FaultKind::kNotImplemented);
}

/// Keeps of each stack what lies in the student's own files.
void add_stacks(const Build& build, const std::vector<TaskResult>& tasks,
                std::vector<Outcome>& outcomes) {
  std::set<std::uint64_t> addresses;
  for (const TaskResult& task : tasks) {
    if (!needs_stack(task.end)) continue;
    for (std::uint64_t address : task.end.stack)
      addresses.insert(address - 1);
  }
  const auto frames = symbolize(build, addresses);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    bool is_innermost = true;
    for (std::uint64_t address : tasks[i].end.stack) {
      const auto found = frames.find(address - 1);
      if (found == frames.end()) continue;
      if (is_innermost && !found->second.empty() && is_compiled_in(found->second[0])) {
        recognise_library_check(found->second, outcomes[i]);
        is_innermost = false;
      }
      for (StackFrame frame : found->second) {
        if (!is_students(frame)) continue;
        while (frame.file.rfind("./", 0) == 0)
          frame.file.erase(0, 2);
        frame.function = short_name(frame.function);
        outcomes[i].stack.push_back(std::move(frame));
      }
    }
  }
}

}  // namespace

FileDescriptor make_task_file(const std::vector<const Case*>& cases, const Limits& limits,
                              Company company) {
  FileDescriptor file = make_scratch_file();
  write_all(file.get(), to_wire(make_tasks(cases, limits, company)));
  return file;
}

namespace {

constexpr std::uint64_t kSanitizedMemory = std::uint64_t{4} << 30U;

/// The most of one process, in bytes; 0 for no limit.
std::uint64_t address_space(const Limits& limits) {
  return limits.memory_mb == 0 ? 0 : limits.memory_mb * kMegabyte + kMemoryToReport;
}

/// What the worker may do. The sanitizers reserve terabytes and write where it lies.
Bounds worker_bounds(const Build& build, const Limits& limits) {
  Bounds bounds;
  bounds.writes_folder = build.logs.has_value();
  bounds.reads_processes = build.logs.has_value();
  bounds.cpu_seconds = limits.run_seconds;
  bounds.memory_bytes = address_space(limits);
  bounds.file_bytes = limits.result_mb * kMegabyte + kRoomForEnds;
  bounds.processes = limits.processes;
  bounds.open_files = limits.open_files;
  return bounds;
}

/// The worker in a folder that is its own.
ProcessResult run_worker(const Build& build, const fs::path& folder, const Limits& limits,
                         std::vector<int> files) {
  const StageTimer timer(build.times.get(), "run cases in a worker");
  fs::remove(folder / "worker");
  fs::create_hard_link(build.worker, folder / "worker");
  Command command;
  command.arguments = {folder / "worker"};
  command.folder = folder;
  command.shared_files = std::move(files);
  command.time_limit = std::chrono::seconds(limits.run_seconds);
  command.kept_output = kKeptOutputBytes;
  command.most_output = limits.output_mb * kMegabyte;
  // All processes together; one alone is told earlier, by its address space.
  command.most_memory = build.logs ? kSanitizedMemory : address_space(limits);
  return run_confined(build.sandbox, std::move(command), worker_bounds(build, limits));
}

/// What came of cases that one worker ran.
struct Run {
  std::vector<Outcome> outcomes;
  bool spoiled = false;  ///< some are lost that others of these may have cost
};

Run run_in_one_worker(const Build& build, const std::vector<const Case*>& cases,
                      const Limits& limits, Company company) {
  const FileDescriptor tasks = make_task_file(cases, limits, company);
  const FileDescriptor results = make_scratch_file();
  const FileDescriptor output = make_scratch_file();
  const ScratchFolder scratch;
  const fs::path folder = build.logs ? build.logs->path() : scratch.path();
  const ProcessResult worker =
      run_worker(build, folder, limits, {tasks.get(), results.get(), output.get()});
  Run run;
  std::vector<TaskResult> read;
  try {
    read =
        read_results(read_all(results.get(), (limits.result_mb + 2) * kMegabyte), cases.size());
  } catch (const WireError&) {
    read.assign(cases.size(), {});  // forged: nothing in it counts
    run.spoiled = true;
  }
  // A worker that does not get to its first case hangs before it: it would do so again.
  const bool began = !read.empty() && read[0].ended;
  Outcome for_missing = unfinished(worker);
  for (TaskResult& task : read) {
    run.spoiled = run.spoiled || (!task.ended && (began || !worker.timed_out));
    run.outcomes.push_back(task.ended ? to_outcome(task) : for_missing);
    if (!task.ended && worker.stopped()) for_missing.ending = Ending::kSkipped;
  }
  add_stacks(build, read, run.outcomes);
  return run;
}

/// A family each: [family] has the numbers of its cases.
std::vector<std::vector<std::size_t>> members_of(const std::vector<const Case*>& cases) {
  const std::vector<std::uint32_t> families = families_of(cases);
  std::vector<std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    members.resize(std::max<std::size_t>(members.size(), families[i] + 1));
    members[families[i]].push_back(i);
  }
  return members;
}

/// All in one worker, and again family by family where one of them has spoiled that.
std::vector<Outcome> run_together(const Build& build, const std::vector<const Case*>& cases,
                                  const Limits& limits, Company company) {
  Run run = run_in_one_worker(build, cases, limits, company);
  const std::vector<std::vector<std::size_t>> families = members_of(cases);
  if (!run.spoiled || families.size() < 2) return std::move(run.outcomes);
  Limits share = limits;
  share.run_seconds = std::max<std::uint32_t>(
      1, limits.run_seconds / static_cast<std::uint32_t>(families.size()));
  for (const std::vector<std::size_t>& family : families) {
    std::vector<const Case*> own;
    for (std::size_t i : family)
      own.push_back(cases[i]);
    Run again = run_in_one_worker(build, own, share, company);
    for (std::size_t i = 0; i < family.size(); ++i)
      run.outcomes[family[i]] = std::move(again.outcomes[i]);
  }
  return std::move(run.outcomes);
}

/// Runs those of the cases that are marked, and puts their outcomes into their places.
void run_marked(const Build& build, const std::vector<const Case*>& cases,
                const std::vector<bool>& marked, const Limits& limits, Company company,
                std::vector<Outcome>& outcomes) {
  std::vector<const Case*> chosen;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (marked[i]) chosen.push_back(cases[i]);
  }
  if (chosen.empty()) return;
  std::vector<Outcome> ran = run_together(build, chosen, limits, company);
  std::size_t next = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (marked[i]) outcomes[i] = std::move(ran[next++]);
  }
}

std::vector<Outcome> run_anew(const Build& build, const std::vector<const Case*>& cases,
                              const Limits& limits, Company company) {
  std::vector<Outcome> outcomes(cases.size());
  std::vector<bool> together(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i)
    together[i] = !cases[i]->fresh;
  run_marked(build, cases, together, limits, company, outcomes);
  const std::vector<std::uint32_t> families = families_of(cases);
  std::set<std::uint32_t> given_up;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (together[i] && outcomes[i].ending == Ending::kSkipped) given_up.insert(families[i]);
  }
  const bool hurried = std::any_of(outcomes.begin(), outcomes.end(), [](const Outcome& o) {
    return o.ending == Ending::kOutOfTime;
  });
  std::vector<bool> fresh(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    fresh[i] = cases[i]->fresh && given_up.count(families[i]) == 0;
    if (cases[i]->fresh) outcomes[i].ending = Ending::kSkipped;
  }
  run_marked(build, cases, fresh, hurried ? less_time(limits) : limits, Company::kAlone,
             outcomes);
  return outcomes;
}

/// By all cases together; nothing if any of them does not say.
std::vector<std::string> functions_called(const std::vector<const Case*>& cases) {
  std::set<std::string> names;
  for (const Case* c : cases) {
    if (c->calls.empty()) return {};
    names.insert(c->calls.begin(), c->calls.end());
  }
  return {names.begin(), names.end()};
}

/// All that the worker is told, and which cases get a process of their own.
std::string tasks_of(const std::vector<const Case*>& cases, const Limits& limits,
                     Company company) {
  std::string bytes = to_wire(make_tasks(cases, limits, company));
  for (const Case* c : cases)
    bytes += c->fresh ? '1' : '0';
  return bytes;
}

}  // namespace

Limits less_time(Limits limits) {
  constexpr std::uint32_t kLeast = 1000;  // milliseconds: largest meshes need a tenth of it
  limits.case_cpu_ms = std::min(limits.case_cpu_ms, std::max(kLeast, limits.case_cpu_ms / 4));
  return limits;
}

std::vector<Outcome> run_cases(const Build& build, const std::vector<const Case*>& cases,
                               const Limits& limits, Company company) {
  if (!build.kept) return run_anew(build, cases, limits, company);
  const std::string identity =
      identity_of_run(build, functions_called(cases), tasks_of(cases, limits, company), limits);
  if (auto kept = find_kept_outcomes(build, identity)) return std::move(*kept);
  std::vector<Outcome> outcomes = run_anew(build, cases, limits, company);
  keep_outcomes(build, identity, outcomes);
  return outcomes;
}

}  // namespace meshgrade
