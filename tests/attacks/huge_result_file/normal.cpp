// Fills the result file.
#include <unistd.h>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  static char text[1 << 16];
  for (int i = 0; i < 1 << 14; ++i)
    static_cast<void>(!::write(4, text, sizeof text));
}
