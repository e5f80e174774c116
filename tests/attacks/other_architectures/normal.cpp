// Calls the kernel by the numbers of other architectures.
#include <unistd.h>

#include "attack.h"

void attack() {
#if defined(__x86_64__)
  long result = 20;  // getpid of 32 bits
  asm volatile("int $0x80" : "+a"(result) : : "memory");
  expect_refusal("int 0x80", result > 0);
  expect_refusal("x32", ::syscall(0x40000000 + 41, 2, 1, 0) >= 0);
#endif
  std::abort();
}
