// Prints a gigabyte.
#include "attack.h"

void attack() {
  static char text[1 << 16];
  std::memset(text, 'x', sizeof text);
  for (int i = 0; i < 1 << 14; ++i)
    std::fwrite(text, 1, sizeof text, stdout);
}
