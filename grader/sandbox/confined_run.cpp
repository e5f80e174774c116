#include "grader/sandbox/confined_run.h"

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <optional>

#include "grader/base/errors.h"
#include "grader/base/process_tree.h"
#include "grader/base/text.h"
#include "grader/sandbox/lent_user.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void add(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// The bounds of one run as words for the launcher and for bwrap.
class Confining {
 public:
  Confining(const Sandbox& sandbox, const Command& command, const Bounds& bounds)
      : sandbox_(sandbox), command_(command), bounds_(bounds) {}

  /// @param report  the descriptor by which the launcher tells that the program was started
  Words arguments(const std::optional<uid_t>& user, int report) const {
    const bool namespaces = sandbox_.layer == Layer::kNamespaces;
    Words words{sandbox_.launcher};
    if (user) add(words, {"--user", std::to_string(*user)});
    if (namespaces) {
      add(words, {"--"});
      add(words, mounts());
      add(words, {sandbox_.launcher});
    } else {
      add(words, {"--supervise", "yes"});
    }
    add(words, {"--report", std::to_string(report)});
    add(words, limits());
    if (sandbox_.bounds_files) add(words, files());
    if (sandbox_.filters_calls) add(words, {"--calls", "few"});
    add(words, {"--"});
    add(words, command_.arguments);
    return words;
  }

  Words environment() const {
    Words words{"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C.UTF-8", "CCACHE_DISABLE=1"};
    if (bounds_.writes_folder) words.push_back("TMPDIR=" + command_.folder.string());
    for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
      const char* value = std::getenv(name);
      if (value != nullptr) words.push_back(std::string(name) + "=" + value);
    }
    return words;
  }

 private:
  std::vector<fs::path> readable() const {
    std::vector<fs::path> paths = bounds_.readable;
    paths.insert(paths.end(), sandbox_.readable.begin(), sandbox_.readable.end());
    return paths;
  }

  /// A new world with nothing in it but what is named here.
  Words mounts() const {
    Words words{sandbox_.bwrap,  "--unshare-user",       "--unshare-ipc",
                "--unshare-pid", "--unshare-net",        "--unshare-uts",
                "--new-session", "--unshare-cgroup-try", "--die-with-parent"};
    for (const fs::path& path : system_paths(bounds_.compiles)) {
      if (fs::is_symlink(path)) {
        add(words, {"--symlink", fs::read_symlink(path), path});
      } else {
        add(words, {"--ro-bind", path, path});
      }
    }
    for (const fs::path& device : harmless_devices())
      add(words, {"--dev-bind", device, device});
    for (const fs::path& path : readable())
      add(words, {"--ro-bind", path, path});
    add(words, {"--ro-bind", sandbox_.launcher, sandbox_.launcher});
    if (bounds_.reads_processes) add(words, {"--proc", "/proc"});
    const fs::path& folder = command_.folder;
    add(words, {bounds_.writes_folder ? "--bind" : "--ro-bind", folder, folder});
    add(words, {"--remount-ro", "/", "--chdir", folder, "--"});
    return words;
  }

  Words limits() const {
    Words words;
    const auto limit = [&](const char* name, std::uint64_t value) {
      if (value > 0) add(words, {name, std::to_string(value)});
    };
    limit("--cpu", bounds_.cpu_seconds);
    limit("--memory", bounds_.memory_bytes);
    limit("--file", bounds_.file_bytes);
    limit("--open-files", bounds_.open_files);
    if (bounds_.processes > 0) limit("--processes", most_processes());
    return words;
  }

  /// What the system refuses to exceed. It only refuses: leave room to see that there are too
  /// many. 0 if it does not count: it lets root have as many as they like.
  std::uint64_t most_processes() const {
    if (sandbox_.counts_processes) return bounds_.processes + kRoomForProcesses;
    if (::geteuid() == 0) return 0;
    const std::size_t others = processes_of_user(::geteuid());
    return others == 0 ? 0 : others + bounds_.processes + kRoomForOthers;
  }

  Words files() const {
    Words words{"--signals", "own"};
    for (const fs::path& path : system_paths(bounds_.compiles))
      add(words, {bounds_.compiles ? "--run" : "--read", path});
    for (const fs::path& path : loaders())
      add(words, {"--run", path});
    for (const fs::path& device : harmless_devices())
      add(words, {"--write", device});
    for (const fs::path& path : bounds_.readable)
      add(words, {"--read", path});
    for (const fs::path& path : sandbox_.readable)
      add(words, {"--run", path});
    if (bounds_.reads_processes) add(words, {"--read", "/proc"});
    add(words, {bounds_.writes_folder ? "--write" : "--run", command_.folder});
    return words;
  }

 public:
  /// Processes of the sandbox itself, with some to spare.
  static constexpr std::uint64_t kRoomForProcesses = 8;
  /// What the user's other programs may start meanwhile, where the system counts these, too.
  static constexpr std::uint64_t kRoomForOthers = 1000;

 private:
  const Sandbox& sandbox_;
  const Command& command_;
  const Bounds& bounds_;
};

std::string read_text(int file) {
  char buffer[1024];
  const ssize_t size = ::pread(file, buffer, sizeof buffer, 0);
  return {buffer, static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

/// What is known of a start that failed without a word.
std::string silent_end(const ProcessResult& result) {
  if (result.signal == 0) {
    return "it ended with exit status " + std::to_string(result.status) + " and said nothing";
  }
  return std::string("it was ended by a signal (") + ::strsignal(result.signal) +
         ") before it began: the machine has no memory left, or another program ended it";
}

/// A program that was not confined as promised has not been run.
void require_start(const std::string& report, const std::string& program,
                   const ProcessResult& result) {
  if (report == "started\n" || (report.empty() && result.stopped())) return;
  const std::string said = printable(report + result.output);
  throw GraderError("the sandbox cannot start " + program + ": " +
                    (said.empty() ? silent_end(result) : said));
}

}  // namespace

ProcessResult run_confined(const Sandbox& sandbox, Command command, const Bounds& bounds) {
  const Confining confining(sandbox, command, bounds);
  command.environment = confining.environment();
  if (bounds.processes > 0) {
    command.most_processes =
        static_cast<std::size_t>(bounds.processes + Confining::kRoomForProcesses / 2);
  }
  if (sandbox.layer == Layer::kNone) return run_process(command);
  std::optional<LentUser> user;
  std::optional<LentFolder> folder;
  if (sandbox.other_user) {
    user.emplace();
    folder.emplace(command.folder, *user);
  }
  const FileDescriptor report = make_scratch_file();
  const std::string program = command.arguments.at(0);
  command.arguments = confining.arguments(user ? std::optional(user->number()) : std::nullopt,
                                          3 + static_cast<int>(command.shared_files.size()));
  command.shared_files.push_back(report.get());
  command.ends_its_own = sandbox.layer != Layer::kNamespaces;
  ProcessResult result = run_process(command);
  require_start(read_text(report.get()), program, result);
  return result;
}

}  // namespace meshgrade
