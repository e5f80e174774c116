// Prints a gigabyte before main.
#include "attack.h"

namespace {
struct Early {
  Early() {
    static char text[1 << 16];
    std::memset(text, 'x', sizeof text);
    for (int i = 0; i < 1 << 14; ++i)
      std::fwrite(text, 1, sizeof text, stderr);
  }
} early;
}  // namespace

void attack() {}
