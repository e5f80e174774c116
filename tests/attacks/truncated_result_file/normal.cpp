// Cuts off what was written so far.
#include <unistd.h>

#define WRONG_ANSWER
#include "attack.h"

void attack() {
  static_cast<void>(!::ftruncate(4, 0));
}
