#include "grader/base/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace meshgrade {
namespace {

// Signal handlers may touch these.
std::atomic<int> came{0};
std::atomic<int> leftovers{0};
static_assert(std::atomic<int>::is_always_lock_free);

void end_at_once(int signal) {
  ::signal(signal, SIG_DFL);
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, signal);
  ::raise(signal);
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void take(int signal) {
  if (leftovers == 0 || came != 0) end_at_once(signal);
  came = signal;
}

}  // namespace

void end_in_order_when_interrupted() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = take;
    action.sa_flags = SA_RESTART;  // poll, in which run_process waits, returns all the same
    ::sigaction(signal, &action, nullptr);
  }
}

int interruption() {
  return came;
}

void end_by(const Interrupted& interrupted) {
  end_at_once(interrupted.signal);
  ::_exit(128 + interrupted.signal);
}

void count_leftovers(int change) {
  leftovers += change;
}

}  // namespace meshgrade
