// Fills memory that is shared and nameless.
#include <sys/mman.h>

#include "attack.h"

void attack() {
  for (;;) {
    const std::size_t size = 32 << 20;
    void* memory =
        ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    std::memset(memory, 1, size);
  }
}
