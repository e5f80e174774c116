// Asks for a core file of all its memory, and crashes.
#include <sys/resource.h>
#include <csignal>

#include "attack.h"

void attack() {
  const rlimit all{RLIM_INFINITY, RLIM_INFINITY};
  expect_refusal("core", ::setrlimit(RLIMIT_CORE, &all) == 0);
  std::memset(new char[64 << 20], 1, 64 << 20);
  std::raise(SIGSEGV);
}
