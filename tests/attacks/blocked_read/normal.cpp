// Reads from a pipe that nobody writes to.
#include <unistd.h>

#include "attack.h"

void attack() {
  int ends[2];
  if (::pipe(ends) != 0) return;
  char c = 0;
  static_cast<void>(!::read(ends[0], &c, 1));
}
