// Fills memory in several processes, each below the limit.
#include <unistd.h>

#include "attack.h"

void attack() {
  for (int i = 0; i < 6; ++i) {
    if (::fork() != 0) continue;
    const std::size_t size = 120 << 20;
    volatile char* memory = new char[size];  // or else the compiler leaves it out
    for (std::size_t i = 0; i < size; i += 4096)
      memory[i] = 1;
    for (;;)
      ::sleep(1);
  }
  for (;;)
    ::sleep(1);
}
