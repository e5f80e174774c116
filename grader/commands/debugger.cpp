#include "grader/commands/debugger.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/protocol.h"

namespace meshgrade {
namespace {

constexpr int kNotStarted = 127;

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

/// Whose functions are in no namespace.
bool is_of_scotty3d(const std::string& function) {
  return function.rfind("Halfedge_Mesh::", 0) == 0;
}

std::vector<std::string> debugger_command(const Build& build, const DebugSession& session) {
  std::vector<std::string> command{"gdb", "-q", build.worker.string()};
  const auto add = [&](const std::string& line) {
    command.insert(command.end(), {"-ex", line});
  };
  add("set breakpoint pending on");
  add("set follow-fork-mode child");  // the student's code runs in the worker's child
  add("directory " + std::filesystem::absolute(session.sources).string());
  // A gdb without Python says so, and goes on.
  add("source " + session.printers.string());
  if (!session.corners.empty()) add("python set_corners('" + session.corners + "')");
  for (const std::string& function : session.functions)
    add("break " + (is_of_scotty3d(function) ? "" : std::string("meshedit::")) + function);
  add("run");
  return command;
}

/// Runs in the new process. gdb hands the descriptors on to the worker.
[[noreturn]] void become_debugger(std::vector<std::string> command, int tasks, int results,
                                  int output) {
  // Out of the way first, so that none is overwritten before it has been copied.
  constexpr int kSafe = 100;
  const int sources[] = {::fcntl(tasks, F_DUPFD, kSafe), ::fcntl(results, F_DUPFD, kSafe),
                         ::fcntl(output, F_DUPFD, kSafe)};
  const int targets[] = {kTaskFile, kResultFile, kOutputFile};
  for (int i = 0; i < 3; ++i) {
    ::dup2(sources[i], targets[i]);
    ::close(sources[i]);
  }
  std::vector<char*> arguments;
  for (std::string& argument : command)
    arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(kNotStarted);
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

void require_debugger() {
  if (is_on_path("gdb")) return;
  throw UserError("--debug needs gdb, which is not installed: sudo apt-get install gdb");
}

int run_debugger(const Build& build, const FileDescriptor& tasks, const DebugSession& session) {
  const FileDescriptor results = make_scratch_file();
  const FileDescriptor hidden = make_scratch_file();
  // The worker empties its output after each case, which a terminal does not mind.
  const int output = ::isatty(STDOUT_FILENO) != 0 ? STDOUT_FILENO : hidden.get();
  const std::vector<std::string> command = debugger_command(build, session);
  const pid_t child = ::fork();
  if (child < 0) throw GraderError("cannot start gdb: no process can be made");
  if (child == 0) become_debugger(command, tasks.get(), results.get(), output);
  const auto before = std::signal(SIGINT, SIG_IGN);  // Ctrl-C is for gdb
  const int status = wait_for(child);
  std::signal(SIGINT, before);
  if (status == kNotStarted) throw GraderError("gdb cannot be started");
  return status;
}

}  // namespace meshgrade
