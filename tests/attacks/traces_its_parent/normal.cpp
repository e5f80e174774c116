// Attaches to the process that watches over it, and writes into it.
#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/uio.h>
#include <unistd.h>

#include "attack.h"

void attack() {
  expect_refusal("ptrace", ::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr) == 0);
  char byte = 0;
  iovec here{&byte, 1};
  iovec there{reinterpret_cast<void*>(&attack), 1};
  expect_refusal("process_vm_readv",
                 ::process_vm_readv(::getppid(), &here, 1, &there, 1, 0) >= 0);
  char name[64];
  std::snprintf(name, sizeof name, "/proc/%d/mem", ::getppid());
  expect_refusal("mem of the parent", ::open(name, O_RDWR) >= 0);
  expect_refusal("mem of init", ::open("/proc/1/mem", O_RDWR) >= 0);
}
