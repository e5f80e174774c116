#include "grader/sandbox/launcher/supervisor.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "grader/sandbox/launcher/options.h"

namespace meshgrade::launcher {
namespace {

constexpr int kStopped = 124;  // nobody looks at it: whoever sends SIGTERM knows why

sigset_t watched_signals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGCHLD);
  ::sigaddset(&signals, SIGTERM);
  return signals;
}

/// @return true and how the program ended, or false if this is to stop
bool wait_for_program(pid_t program, int& status) {
  const sigset_t signals = watched_signals();
  for (;;) {
    for (pid_t ended; (ended = ::waitpid(-1, &status, WNOHANG)) > 0;) {
      if (ended == program) return true;
    }
    int signal = 0;
    if (::sigwait(&signals, &signal) == 0 && signal == SIGTERM) return false;
  }
}

/// Ends everything of this user. Only a process of that user can say "all but me".
void kill_user(uid_t user) {
  const pid_t killer = ::fork();
  if (killer == 0) {
    if (::setreuid(user, user) == 0) ::kill(-1, SIGKILL);
    ::_exit(0);
  }
  if (killer > 0) ::waitpid(killer, nullptr, 0);
}

/// Ends the children; theirs become children of this process then.
void kill_children() {
  const std::string me = std::to_string(::getpid());
  const std::string name = "/proc/" + me + "/task/" + me + "/children";
  std::FILE* list = std::fopen(name.c_str(), "re");
  if (list == nullptr) return;
  for (int child = 0; std::fscanf(list, "%d", &child) == 1;)
    ::kill(child, SIGKILL);
  std::fclose(list);
}

/// Goes on until no child is left: as a subreaper this process inherits every orphan.
void sweep(const std::optional<std::uint64_t>& user) {
  for (;;) {
    if (user) {
      kill_user(static_cast<uid_t>(*user));
    } else {
      kill_children();
    }
    pid_t ended = 0;
    while ((ended = ::waitpid(-1, nullptr, WNOHANG)) > 0) {
    }
    if (ended < 0 && errno == ECHILD) return;
    ::usleep(500);
  }
}

[[noreturn]] void end_like(int status) {
  if (WIFSIGNALED(status)) {
    ::signal(WTERMSIG(status), SIG_DFL);
    ::kill(::getpid(), WTERMSIG(status));
    sigset_t all;
    ::sigfillset(&all);
    ::sigprocmask(SIG_UNBLOCK, &all, nullptr);
  }
  ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : kStopped);
}

void adopt_orphans() {
#ifdef __linux__
  if (::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0) refuse("cannot adopt orphans");
#endif
}

}  // namespace

void end_with_parent(int signal) {
#ifdef __linux__
  if (::prctl(PR_SET_PDEATHSIG, signal, 0, 0, 0) != 0) refuse("cannot follow the parent");
#else
  (void)signal;
#endif
}

void supervise(const std::optional<std::uint64_t>& user) {
  const sigset_t signals = watched_signals();
  sigset_t before;
  ::sigprocmask(SIG_BLOCK, &signals, &before);
  adopt_orphans();
  end_with_parent(SIGTERM);
  const pid_t program = ::fork();
  if (program < 0) refuse("cannot make a process");
  if (program == 0) {
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    ::setsid();
    return;
  }
  // Whoever reads the output waits until all have closed it.
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::dup2(nowhere, stream);
  int status = 0;
  const bool ended = wait_for_program(program, status);
  if (!ended) ::kill(program, SIGKILL);
  ::kill(-program, SIGKILL);  // the rest of its group, where orphans cannot be adopted
  sweep(user);
  if (!ended) ::_exit(kStopped);
  end_like(status);
}

}  // namespace meshgrade::launcher
