// Makes the output huge by writing far behind its end.
#include <unistd.h>

#include "attack.h"

void attack() {
  static_cast<void>(!::pwrite(5, "x", 1, 1L << 40));
  static_cast<void>(!::ftruncate(4, 1L << 40));
}
